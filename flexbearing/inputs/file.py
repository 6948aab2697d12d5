"""Plain files within a size: pipes and devices, which may have no end, are never opened."""

import os
import stat
from pathlib import Path

_OPEN = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_BINARY", 0)


class Unreadable(ValueError):
    """A file that cannot be read; the message completes a sentence that names it."""


def content(path: Path, most: int) -> bytes:
    """Content of a file.

    Parameters
    ----------
    path : Path
        of a plain file, or a link to one
    most : int
        bytes that its format allows; more are not read

    Returns
    -------
    bytes

    Raises
    ------
    Unreadable
        where there is no such file, or it is no plain one, or larger
    """
    try:
        require_plain(path)
        with os.fdopen(os.open(path, _OPEN), "rb") as file:
            about = os.fstat(file.fileno())
            if not stat.S_ISREG(about.st_mode):  # it was replaced meanwhile
                raise Unreadable("is no plain file")
            found = file.read(most + 1) if about.st_size <= most else None
    except OSError as problem:
        raise Unreadable(f"cannot be read: {problem.strerror}") from problem
    if found is None or len(found) > most:
        raise Unreadable(f"is larger than {_size(most)}")
    return found


def text(path: Path, most: int) -> str:
    """Text of a file, see `content`; without the mark at the beginning that some editors leave.

    Raises
    ------
    Unreadable
        also where it is not UTF-8
    """
    found = content(path, most)
    try:
        return found.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        raise Unreadable(
            f"is not text in UTF-8 (byte {found[problem.start]:#04x} at {problem.start}); save it as UTF-8"
        ) from None


def require_plain(path: Path) -> None:
    """Refuse what is not there, and what is no plain file.

    Raises
    ------
    Unreadable
        saying which
    """
    try:
        mode = path.stat().st_mode
    except FileNotFoundError:
        raise Unreadable("there is no such file") from None
    except OSError as problem:
        raise Unreadable(f"cannot be read: {problem.strerror}") from problem
    except ValueError:  # a NUL in the name
        raise Unreadable("no file can have this name") from None
    if stat.S_ISDIR(mode):
        raise Unreadable("is a folder, no file")
    if not stat.S_ISREG(mode):
        raise Unreadable("is no plain file but a pipe or a device, which may have no end")


def is_folder(path: Path) -> bool:
    """Whether there is a folder; false for a name that nothing can have, which `content` refuses."""
    try:
        return path.is_dir()
    except (OSError, ValueError):  # too long; a NUL in it
        return False


def is_plain(path: Path) -> bool:
    """Whether there is a plain file; false for a name that nothing can have."""
    try:
        require_plain(path)
    except Unreadable:
        return False
    return True


def _size(count: int) -> str:
    for unit, size in (("GiB", 2**30), ("MiB", 2**20), ("KiB", 2**10)):
        if count >= size:
            return f"{count / size:.4g} {unit}"
    return f"{count} bytes"
