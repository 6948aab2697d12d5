"""The rings that this process used last: as long as their files are the same, they are not read again.

A ring that found no room on the disk is remembered as well, as long as there is no file of it.
"""

import os
from collections import OrderedDict
from contextlib import suppress
from pathlib import Path
from threading import Lock
from typing import Any

MOST = 8  # rings of one or two bearings with their tables; a ring is below a megabyte, mostly
Stamp = tuple[int, int, int]

_rings: OrderedDict[Path, tuple[Stamp | None, Any]] = OrderedDict()  # by file, the one used last at the end
_guard = Lock()


def recent(path: Path) -> Any | None:
    """The ring of a file that has not changed since it was remembered; None where there is no such."""
    with _guard, suppress(KeyError):
        stamp, ring = _rings[path]
        if stamp == _stamp(path):
            _rings.move_to_end(path)
            return ring
        del _rings[path]
    return None


def remember(path: Path, ring: Any) -> None:
    """Keep a ring that was read from a file, or found no room in one; marks the file as used now."""
    with _guard:
        with suppress(OSError):  # a folder that may only be read: then its owner decides what goes
            os.utime(path)
        _rings[path] = _stamp(path), ring
        _rings.move_to_end(path)
        while len(_rings) > MOST:
            _rings.popitem(last=False)


def _stamp(path: Path) -> Stamp | None:
    """What distinguishes a file from another one of its name; None where there is none."""
    with suppress(OSError):
        state = path.lstat()
        return state.st_ino, state.st_size, state.st_mtime_ns
    return None
