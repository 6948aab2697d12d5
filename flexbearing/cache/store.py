"""A folder of limited size that keeps condensed rings, shared by all runs of a user.

A file appears complete or not at all, and is only ever replaced by an equal one, so that processes need
not wait for each other. What cannot be read or written is noted and computed again. An entry is a regular
file: a link in its place is not followed, since the cache makes none, and it may lead to what never ends.
"""

import os
import re
import stat
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from flexbearing.cache.archive import Damaged, packed, unpacked
from flexbearing.cache.forms import WrongForm
from flexbearing.cache.key import digest
from flexbearing.cache.recent import recent, remember
from flexbearing.files import NotStored, write

VARIABLE = "FLEXBEARING_CACHE"  # of the environment: a folder, or "off"
OFF = "off"
LIMIT = 500_000_000  # bytes
SUFFIX = ".ring"
ABANDONED = 3600.0  # [s] after which an unfinished file has no writer any more
_ENTRY = re.compile(r"[0-9a-f]{64}\.ring")
_UNFINISHED = re.compile(_ENTRY.pattern + r"\.[\w-]+-\d+-[0-9a-f]{8}\.tmp")  # of `flexbearing.files.write`
# neither follow a link nor wait for a pipe; the names are not those of every system
_OPEN = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)

Value = TypeVar("Value")
Note = Callable[[str], None]
_listening: list[list[str]] = []


@dataclass(frozen=True)
class Entry:
    """One condensed ring on disk."""

    path: Path
    size: int  # bytes
    used: float  # [s since 1970] last time

    @property
    def name(self) -> str:
        """First characters of the digest, enough to tell it from others."""
        return self.path.stem[:12]


@dataclass(frozen=True)
class Cache:
    """Condensed rings in a folder."""

    folder: Path | None  # None: nothing is kept
    limit: int = LIMIT  # bytes; the rings that were used longest ago go first

    def cached(
        self,
        kind: str,
        parts: object,
        compute: Callable[[], Value],
        note: Note,
        fits: Callable[[Value], bool] = lambda kept: True,
    ) -> Value:
        """What was computed from the same data before, or what is computed now."""
        if self.folder is None:
            return compute()
        path = self.folder / f"{digest(parts)}{SUFFIX}"
        known = recent(path)
        kept = known if known is not None and fits(known) else self._kept(path, kind, fits, note)
        if kept is not None:
            remember(path, kept)
            note("taken from the cache")
            return kept
        value = compute()
        self._keep(path, kind, value, note)
        return value

    def holds(self, parts: object) -> bool:
        """Whether there is a file for some data, readable or not."""
        return self.folder is not None and (self.folder / f"{digest(parts)}{SUFFIX}").exists()

    def entries(self) -> list[Entry]:
        """Rings in the folder, the one used last first; none where it cannot be read."""
        entries = []
        for path in self._files(_ENTRY):
            with suppress(OSError):  # another process has just removed it
                state = path.lstat()
                if stat.S_ISREG(state.st_mode):
                    entries.append(Entry(path, state.st_size, state.st_mtime))
        return sorted(entries, key=lambda entry: entry.used, reverse=True)

    @property
    def size(self) -> int:
        """Sum of all rings [bytes]."""
        return sum(entry.size for entry in self.entries())

    def clear(self) -> int:
        """Remove all rings and nothing else; returns how many there were."""
        removed = [_remove(entry.path) for entry in self.entries()]
        self._remove_abandoned()
        return removed.count(None)

    def _files(self, names: re.Pattern) -> list[Path]:
        """Whatever has a name of a form."""
        with suppress(OSError):  # no folder yet, or none that can be read
            return (
                [path for path in self.folder.iterdir() if names.fullmatch(path.name)] if self.folder else []
            )
        return []

    def _kept(self, path: Path, kind: str, fits: Callable[[Value], bool], note: Note) -> Value | None:
        """The value in a file, or None; a damaged file is removed."""
        try:
            value = unpacked(path.stem, kind, _content(path, self.limit))
            if not fits(value):
                raise Damaged("made from another part")
        except FileNotFoundError:
            return None
        except (Damaged, OSError) as problem:
            _give_up(path, problem, note)
            return None
        return value

    def _keep(self, path: Path, kind: str, value: object, note: Note) -> None:
        try:
            data = packed(path.stem, kind, value)
        except WrongForm as problem:
            note(f"not kept: {problem}")
            return
        if len(data) > self.limit:
            note(f"not kept: {len(data)} bytes are more than the whole cache may have, {self.limit}")
            return
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            write(path, data, lasting=False)  # the digest says what the disk did not keep
        except (OSError, NotStored) as problem:
            words = f"the cache {path.parent} cannot be written: {_reason(problem)}"
            note(words)
            for complaints in _listening:
                complaints.append(words)
            remember(path, value)  # else every variant of a study would compute it again
            return
        self._shrink()

    def _shrink(self) -> None:
        """Remove what was used longest ago until the limit holds."""
        total = 0
        for entry in self.entries():
            total += entry.size
            if total > self.limit:
                _remove(entry.path)
        self._remove_abandoned()

    def _remove_abandoned(self) -> None:
        for path in self._files(_UNFINISHED):
            with suppress(OSError):
                if time.time() - path.lstat().st_mtime > ABANDONED:
                    path.unlink()


@contextmanager
def complaints() -> Iterator[list[str]]:
    """Collect why rings cannot be kept, while the block goes on; in any thread, as batches have some."""
    words: list[str] = []
    _listening.append(words)
    try:
        yield words
    finally:
        _listening[:] = [each for each in _listening if each is not words]


def configured(folder: str | None = None, limit: int = LIMIT) -> Cache:
    """The cache that a user wants."""
    choice = folder or os.environ.get(VARIABLE)
    if choice == OFF:
        return Cache(None, limit)
    if choice:
        folder_of_user = Path(choice)
        with suppress(RuntimeError):  # a user who does not exist: then a folder of this name
            folder_of_user = folder_of_user.expanduser()
        return Cache(folder_of_user, limit)
    from platformdirs import user_cache_path

    return Cache(user_cache_path("flexbearing", appauthor=False) / "rings", limit)


def listing(cache: Cache) -> str:
    """The content of a cache as text, a line for each ring and one for all."""
    if cache.folder is None:
        return f"the cache is off ({VARIABLE})\n"
    entries = cache.entries()
    lines = [f"{entry.name}  {entry.size / 1e6:8.3f} MB  used {_date(entry.used)}" for entry in entries]
    total = sum(entry.size for entry in entries)
    whole = f"{len(entries)} rings, {total / 1e6:.3f} MB of {cache.limit / 1e6:g} MB in {cache.folder}"
    return "\n".join([*lines, whole]) + "\n"


def _date(seconds: float) -> str:
    try:
        return time.strftime("%Y-%m-%d %H:%M", time.localtime(seconds))
    except (OverflowError, OSError, ValueError):  # a file can carry any date
        return "at no time"


def _content(path: Path, limit: int) -> bytes:
    """Bytes of a regular file, never more than the limit."""
    if not stat.S_ISREG(path.lstat().st_mode):
        raise Damaged("it is no file")
    with os.fdopen(os.open(path, _OPEN), "rb") as file:
        state = os.fstat(file.fileno())
        if not stat.S_ISREG(state.st_mode):  # it was replaced meanwhile
            raise Damaged("it is no file")
        if state.st_size > limit:
            raise Damaged(f"{state.st_size} bytes are more than the whole cache may have, {limit}")
        return file.read(state.st_size)


def _give_up(path: Path, problem: Exception, note: Note) -> None:
    """Remove what cannot be used, and tell."""
    kept = _remove(path)
    if kept is None:
        note(f"{path} was damaged ({_reason(problem)}); it is removed and the ring computed again")
    elif isinstance(problem, OSError):
        note(f"the cache {path.parent} cannot be read: {_reason(problem)}")
    else:
        note(
            f"{path} is damaged ({_reason(problem)}) and cannot be removed ({_reason(kept)}); "
            "the ring is computed again"
        )


def _remove(path: Path) -> OSError | None:
    """Remove a file; returns why it is still there."""
    try:
        path.unlink(missing_ok=True)
    except OSError as problem:
        return problem
    return None


def _reason(problem: BaseException) -> str:
    if isinstance(problem, NotStored) and problem.__cause__:
        problem = problem.__cause__
    return getattr(problem, "strerror", None) or str(problem)
