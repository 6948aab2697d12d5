"""A folder of limited size that keeps condensed rings, shared by all runs of a user.

A file appears complete or not at all, and is only ever replaced by an equal one, so that processes need
not wait for each other. What cannot be read or written is noted and computed again.
"""

import os
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from tempfile import NamedTemporaryFile
from typing import TypeVar

from flexbearing.cache.archive import Damaged, packed, unpacked
from flexbearing.cache.key import digest

VARIABLE = "FLEXBEARING_CACHE"  # of the environment: a folder, or "off"
OFF = "off"
LIMIT = 500_000_000  # bytes
SUFFIX = ".ring"
UNFINISHED = ".part"
ABANDONED = 3600.0  # [s] after which an unfinished file has no writer any more

Value = TypeVar("Value")
Note = Callable[[str], None]


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

    def cached(self, parts: object, compute: Callable[[], Value], note: Note) -> Value:
        """What was computed from the same data before, or what is computed now.

        Parameters
        ----------
        parts : object
            all data that enter, see `flexbearing.cache.key.digest`; the code enters by itself
        compute : callable ()
            makes a dataclass of arrays, see `flexbearing.cache.archive.packed`
        note : callable (text)
            told in a line where the value comes from, if not computed, and what was wrong with the folder

        Returns
        -------
        object
            of `compute`
        """
        if self.folder is None:
            return compute()
        path = self.folder / f"{digest(parts)}{SUFFIX}"
        kept = _kept(path, note)
        if kept is not None:
            note("taken from the cache")
            return kept
        value = compute()
        self._keep(path, packed(value), note)
        return value

    def entries(self) -> list[Entry]:
        """Rings in the folder, the one used last first."""
        entries = []
        for path in self.folder.glob(f"*{SUFFIX}") if self.folder else ():
            with suppress(FileNotFoundError):  # another process has just removed it
                state = path.stat()
                entries.append(Entry(path, state.st_size, state.st_mtime))
        return sorted(entries, key=lambda entry: entry.used, reverse=True)

    @property
    def size(self) -> int:
        """Sum of all rings [bytes]."""
        return sum(entry.size for entry in self.entries())

    def clear(self) -> int:
        """Remove all rings; returns how many there were."""
        entries = self.entries()
        for entry in entries:
            _remove(entry.path)
        self._remove_abandoned()
        return len(entries)

    def _keep(self, path: Path, data: bytes, note: Note) -> None:
        if len(data) > self.limit:
            note(f"not kept: {len(data)} bytes are more than the whole cache may have, {self.limit}")
            return
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            _write(path, data)
        except OSError as problem:
            note(f"the cache {path.parent} cannot be written: {problem.strerror}")
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
        for path in self.folder.glob(f"*{UNFINISHED}") if self.folder else ():
            with suppress(FileNotFoundError):
                if time.time() - path.stat().st_mtime > ABANDONED:
                    _remove(path)


def configured(folder: str | None = None, limit: int = LIMIT) -> Cache:
    """The cache that a user wants.

    Parameters
    ----------
    folder : str or None
        "off" or a folder; None leaves it to the environment variable `FLEXBEARING_CACHE`, and without
        that to the system's folder for such files
    limit : int
        bytes

    Returns
    -------
    Cache
    """
    choice = folder or os.environ.get(VARIABLE)
    if choice == OFF:
        return Cache(None, limit)
    if choice:
        return Cache(Path(choice).expanduser(), limit)
    from platformdirs import user_cache_path

    return Cache(user_cache_path("flexbearing", appauthor=False) / "rings", limit)


def listing(cache: Cache) -> str:
    """The content of a cache as text, a line for each ring and one for all.

    Parameters
    ----------
    cache : Cache
        whatever it holds

    Returns
    -------
    str
    """
    if cache.folder is None:
        return f"the cache is off ({VARIABLE})\n"
    entries = cache.entries()
    lines = [f"{entry.name}  {entry.size / 1e6:8.3f} MB  used {_date(entry.used)}" for entry in entries]
    total = sum(entry.size for entry in entries)
    whole = f"{len(entries)} rings, {total / 1e6:.3f} MB of {cache.limit / 1e6:g} MB in {cache.folder}"
    return "\n".join([*lines, whole]) + "\n"


def _date(seconds: float) -> str:
    return time.strftime("%Y-%m-%d %H:%M", time.localtime(seconds))


def _kept(path: Path, note: Note):
    """The value in a file, or None; a damaged file is removed."""
    try:
        value = unpacked(path.read_bytes())
    except FileNotFoundError:
        return None
    except OSError as problem:
        note(f"the cache {path.parent} cannot be read: {problem.strerror}")
        return None
    except Damaged:
        note(f"{path} was damaged; it is removed and the ring computed again")
        _remove(path)
        return None
    with suppress(OSError):  # a folder that may only be read: then its owner decides what goes
        os.utime(path)
    return value


def _write(path: Path, data: bytes) -> None:
    """Write a file so that nobody ever sees a part of it."""
    with NamedTemporaryFile(dir=path.parent, suffix=UNFINISHED, delete=False) as file:
        try:
            file.write(data)
            file.close()
            Path(file.name).replace(path)
        except BaseException:
            file.close()
            _remove(Path(file.name))
            raise


def _remove(path: Path) -> None:
    with suppress(FileNotFoundError, PermissionError):  # gone already, or read by someone else now
        path.unlink()
