"""One writer for each output, known by host, process and start."""

import errno
import json
import logging
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from pathlib import Path
from time import sleep
from typing import Any

from flexbearing.files.atomic import NotStored, host
from flexbearing.files.destination import BadOutput

try:
    import fcntl
except ImportError:  # a system without locks of this kind
    fcntl = None

SUFFIX = ".lock"
_NO_LOCKS = {errno.ENOSYS, errno.EOPNOTSUPP, errno.ENOLCK, errno.EINVAL}
_SIGNATURE = {"host", "process", "started"}
_LONGEST = 4096  # bytes of a lock
_TRIALS, _PAUSE = 20, 0.01  # [s]
log = logging.getLogger(__name__)


@contextmanager
def lock(path: Path) -> Iterator[None]:
    """Be the only writer of a file.

    The operating system ends the lock with its process, however that ends, so that what a killed one left
    behind does not matter. The file beside the output says who holds it.

    Raises `BadOutput` naming process and host of the one who writes; a host other than this one cannot be
    asked whether its process still lives, so that its lock stays until somebody removes it; `NotStored` if
    there is no room for the lock.
    """
    place = path.with_name(path.name + SUFFIX)
    file = _held(place, path)
    try:
        yield
    finally:
        with suppress(OSError):
            place.unlink()  # before the lock ends: whoever waits for it finds another file here
        os.close(file)


def _held(place: Path, path: Path) -> int:
    """Descriptor of the lock, held and signed."""
    while True:
        try:
            file = os.open(place, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o666)
        except OSError as problem:
            raise BadOutput(f"{path}: no lock {place.name} beside it: {problem.strerror}.") from problem
        try:
            free = _locked(file, path)
            holder = _holder(file, place, wait=not free)
            if not free or holder.get("host", host()) != host():
                raise BadOutput(_occupied(path, place, holder))
            if _still(file, place):
                _sign(file, place, path)
                return file
        except BaseException:
            os.close(file)
            raise
        os.close(file)  # its holder removed it meanwhile


def _locked(file: int, path: Path) -> bool:
    """Whether the lock is ours now."""
    try:
        if fcntl is not None:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return True
    except BlockingIOError:
        return False
    except OSError as problem:
        if problem.errno not in _NO_LOCKS:
            raise
    log.warning("%s: no locks there: a second run to this file would not be noticed", path)
    return True


def _holder(file: int, place: Path, wait: bool) -> dict[str, Any]:
    """What the lock says of its holder; nothing when it was never signed."""
    text = b""
    for _ in range(_TRIALS if wait else 1):
        if text := os.pread(file, _LONGEST, 0).strip(b"\0"):
            break
        if wait:
            sleep(_PAUSE)  # it is being signed
    try:
        holder = json.loads(text or b"{}")
    except (ValueError, RecursionError):
        holder = None
    if not isinstance(holder, dict) or not holder.keys() <= _SIGNATURE:
        raise BadOutput(f"{place}: is in the way of the lock with that name, and is none; move it elsewhere.")
    return holder


def _still(file: int, place: Path) -> bool:
    """Whether the file that is locked still has its name."""
    with suppress(FileNotFoundError):
        return os.path.samestat(os.fstat(file), place.lstat())
    return False


def _sign(file: int, place: Path, path: Path) -> None:
    """Say in the lock whose it is; a full disk keeps no lock."""
    started = datetime.now(UTC).isoformat(timespec="seconds")
    text = json.dumps({"host": host(), "process": os.getpid(), "started": started})  # _SIGNATURE
    try:
        os.ftruncate(file, 0)
        os.pwrite(file, text.encode(), 0)
    except OSError as problem:
        place.unlink()
        raise NotStored(
            f"{path}: not written: no lock {place.name} beside it: {problem.strerror}. Free space there, or "
            "choose another place with -o."
        ) from problem


def _occupied(path: Path, place: Path, holder: dict[str, Any]) -> str:
    who = f"process {holder.get('process', 'unknown')} on {holder.get('host', host())}"
    words = f"{path} is being written by {who}, since {holder.get('started', 'a moment ago')}."
    if holder.get("host", host()) == host():
        return f"{words} Wait for it, or choose another name with -o."
    return f"{words} Wait for it, or, when that process has ended, remove {place}."
