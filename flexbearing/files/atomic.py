"""Files that appear whole or not at all."""

import os
import platform
import re
from contextlib import suppress
from pathlib import Path

UNFINISHED = ".part"  # of a whole file that says what is finished so far
_WRITING = ".tmp"  # of a file that may be torn
_PART = re.compile(rf"\.(?P<host>[\w-]+)-(?P<process>\d+)-[0-9a-f]{{8}}({UNFINISHED}|{_WRITING})")


class NotStored(RuntimeError):
    """A file could not be written; what had its name before is unchanged."""


def host() -> str:
    """Name of this host, as names of files can hold it."""
    return re.sub(r"[^\w-]", "-", platform.node()) or "unknown"


def part_name(path: Path, suffix: str = UNFINISHED) -> Path:
    """Name beside a file that no other process and no other call uses."""
    return path.with_name(f"{path.name}.{host()}-{os.getpid()}-{os.urandom(4).hex()}{suffix}")


def require_part(path: Path) -> None:
    """Make a file beside another and remove it: permissions and folders of the system say less.

    Raises `OSError` where none can be made.
    """
    part = part_name(path, _WRITING)
    part.open("xb").close()
    part.unlink()


def parts_of(path: Path) -> list[tuple[Path, str, int]]:
    """Unfinished files beside a file, also those that were being written when their process was killed."""
    parts = []
    with suppress(OSError):  # a folder that is not there has none
        for other in path.parent.iterdir():
            named = other.name.startswith(path.name) and _PART.fullmatch(other.name[len(path.name) :])
            if named:
                parts.append((other, named["host"], int(named["process"])))
    return sorted(parts, key=lambda part: _age(part[0]))


def write(path: Path, data: bytes, *, beside: Path | None = None, lasting: bool = True) -> None:
    """Write a file so that nobody ever sees a part of it.

    The bytes go to a name of their own, created exclusively, and are read again before they take the place
    of what was there.

    Raises `NotStored` naming the finished file and what to do; no part is left.
    """
    part = part_name(beside or path, _WRITING)
    try:
        with part.open("xb") as file:
            file.write(data)
            file.flush()
            if lasting:
                os.fsync(file.fileno())
        if part.read_bytes() != data:
            raise NotStored(f"{path}: the disk did not keep what was written; nothing was replaced.")
        part.replace(path)
        if lasting:
            _remove_abandoned(beside or path)
    except OSError as problem:
        _remove(part)
        raise NotStored(
            f"{beside or path}: not written: {problem.strerror or problem}. What had this name before is "
            "unchanged; free space there, or choose another place with -o."
        ) from problem
    except BaseException:  # an interrupt leaves no part behind
        _remove(part)
        raise


def _remove_abandoned(path: Path) -> None:
    """Remove torn files of the same output whose process was killed while it wrote them."""
    for part, where, process in parts_of(path):
        if part.suffix == _WRITING and where == host() and not _lives(process):
            _remove(part)


def _lives(process: int) -> bool:
    """Whether a process of this host is there; true where that cannot be known."""
    if os.name != "posix":
        return True
    try:
        os.kill(process, 0)  # asks without a signal
    except (ProcessLookupError, OverflowError):
        return False
    except OSError:  # of another account
        return True
    return True


def _remove(part: Path) -> None:
    with suppress(OSError):  # never made, or gone already
        part.unlink()


def _age(part: Path) -> float:
    with suppress(OSError):
        return -part.stat().st_mtime
    return 0.0
