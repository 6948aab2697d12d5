"""Plain files within a size: pipes and devices, which may never end, are never opened."""

import os
import re
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from io import BufferedReader, BytesIO, TextIOWrapper
from pathlib import Path
from typing import NamedTuple

LONGEST_LINE = 2**16  # characters of a line of another program
_CONTROL = re.compile(r"[\x00-\x08\x0b\x0e-\x1f\x7f]")  # but for tabs, ends of lines and of pages
_OPEN = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)


class Unreadable(ValueError):
    """A file that cannot be read; the message completes a sentence that names it."""

    def __init__(self, words: str, path: Path | None = None):
        super().__init__(words)
        self.path = path  # where it was a file


class Stamp(NamedTuple):
    """A file at a time: it is read again where the rest has changed."""

    path: Path
    changed: int  # [ns]
    size: int  # bytes


@contextmanager
def opened(path: Path) -> Iterator[BufferedReader]:
    """Open a plain file for reading.

    Raises `Unreadable` where there is no such file, or it is no plain one, or cannot be read.
    """
    try:
        stamp(path)
        with os.fdopen(os.open(path, _OPEN), "rb") as file:
            if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):  # it was replaced meanwhile
                raise Unreadable("is no plain file", path)
            yield file
    except OSError as problem:
        raise Unreadable(f"cannot be read: {problem.strerror}", path) from problem


def content(path: Path, most: int) -> bytes:
    """Content of a file.

    Raises `Unreadable` as `opened`, and where it is larger.
    """
    with opened(path) as file:
        found = file.read(most + 1) if os.fstat(file.fileno()).st_size <= most else None
        if found is None or len(found) > most:
            raise Unreadable(f"is larger than {size(most)}", path)
    return found


def text(path: Path, most: int) -> str:
    """Text of a file, see `content`; without the mark at the beginning that some editors leave.

    Raises `Unreadable` also where it is not UTF-8, or has control characters.
    """
    found = content(path, most)
    try:
        text = found.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        place = f"byte {found[problem.start]:#04x} at {problem.start}"
        raise Unreadable(f"is not text in UTF-8 ({place}); save it as UTF-8", path) from None
    if control := _CONTROL.search(text):
        place = f"{control[0]!r} at {control.start()}"
        raise Unreadable(f"is no text: it has a control character, {place}", path)
    return text


def lines(path: Path, most: int) -> Iterator[str]:
    """Lines of a file of another program, see `content`; its comments may have any encoding.

    Raises `Unreadable` also where a line is longer than `LONGEST_LINE`.
    """
    file = TextIOWrapper(BytesIO(content(path, most)), encoding="latin-1")
    number = 0
    while line := file.readline(LONGEST_LINE):
        number += 1
        if len(line) == LONGEST_LINE:
            raise Unreadable(f"has more than {LONGEST_LINE} characters in line {number}", path)
        yield line


def stamp(path: Path) -> Stamp:
    """What says that a plain file has changed.

    Raises `Unreadable` for what is not there, and for what is no plain file.
    """
    try:
        about = path.stat()
    except FileNotFoundError:
        raise Unreadable("there is no such file", path) from None
    except OSError as problem:
        raise Unreadable(f"cannot be read: {problem.strerror}", path) from problem
    except ValueError:  # a NUL in the name
        raise Unreadable("no file can have this name", path) from None
    if stat.S_ISDIR(about.st_mode):
        raise Unreadable("is a folder, no file", path)
    if not stat.S_ISREG(about.st_mode):
        raise Unreadable("is no plain file but a pipe or a device, which may be endless", path)
    return Stamp(path, about.st_mtime_ns, about.st_size)


def is_folder(path: Path) -> bool:
    """Whether there is a folder; false for a name that nothing can have, which `content` refuses."""
    try:
        return path.is_dir()
    except (OSError, ValueError):  # too long; a NUL in it
        return False


def is_plain(path: Path) -> bool:
    """Whether there is a plain file; false for a name that nothing can have."""
    try:
        stamp(path)
    except Unreadable:
        return False
    return True


def size(count: int) -> str:
    """Write a number of bytes, 65536 as 64 KiB."""
    for unit, of_unit in (("GiB", 2**30), ("MiB", 2**20), ("KiB", 2**10)):
        if count >= of_unit:
            return f"{count / of_unit:.4g} {unit}"
    return f"{count} bytes"


CASE = 2**16  # one with every key and a note to each has some 15 kB; tomllib takes up to 0.05 s
POINTS = 2**20
DRAWING = 2**26  # rings with their seats take up to some millions
REXS = 2**25
ARCHIVE = 2**22  # some 100 000 members, whose list alone takes 50 MB
VARIANTS = 2**26  # a million rows of five numbers
TABLE = 2**28  # a million rows of some twenty numbers
MATRIX = 2**29  # some ten million entries
RESULT = 2**32

FORMATS = {
    "a case, a study, an optimisation or a profile of jobs (TOML)": CASE,
    "the points of a profile (CSV)": POINTS,
    "a model of a gearbox (REXS)": REXS,
    "the same as an archive (ZIP)": ARCHIVE,
    "a STEP drawing": DRAWING,
    "variants or a duty cycle of a study (CSV)": VARIANTS,
    "the table of a study (CSV or Parquet)": TABLE,
    "a stiffness matrix or its mesh": MATRIX,
    "a result (HDF5)": RESULT,
}


def sizes() -> str:
    """Limits of all formats as a sentence of documents."""
    return "; ".join(f"{name} {size(most)}" for name, most in FORMATS.items())
