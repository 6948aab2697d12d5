"""Standard streams that a program can always write to, also when nobody reads them."""

import errno
import io
import os
import sys
from typing import Any, TextIO

from flexbearing.printable import printable


class _Tolerant(io.FileIO):
    """A descriptor whose first failure is kept, and that takes everything after it without writing."""

    def __init__(self, descriptor: int, *, closed: bool):
        super().__init__(descriptor, "w", closefd=False)
        self._closed_before = closed
        self.problem: OSError | None = None

    def write(self, data: Any, /) -> int:
        """Write as much as there is room for; nothing once it failed."""
        if self.problem is None:
            try:
                return self._written(data)
            except OSError as problem:
                self.problem = problem
        return len(data)

    def _written(self, data: Any) -> int:
        if self._closed_before:
            raise OSError(errno.EBADF, os.strerror(errno.EBADF))
        while (count := super().write(data)) is None:  # a pipe that does not block, and is full
            from select import select

            select([], [self], [])
        return count


class _Shown(io.TextIOWrapper):
    """A text stream that shows control characters instead of passing them on."""

    def write(self, text: str, /) -> int:
        """Write a text, made fit for a terminal."""
        super().write(printable(text))
        return len(text)


def terminal_errors() -> TextIO:
    """The error stream for what controls its terminal on purpose."""
    if not isinstance(sys.stderr, _Shown):
        return sys.stderr
    sys.stderr.flush()
    return _stream(sys.stderr, _Tolerant(2, closed=False), io.TextIOWrapper, line_buffering=True)


def prepare() -> None:
    """Make standard streams that never fail, and open closed ones where nothing is read.

    Without that the next file opened would get the number of a closed stream, and what libraries print.
    Streams that something else has put in place of the standard ones stay.
    """
    closed = [descriptor for descriptor in range(3) if _opened(descriptor)]
    if sys.stdout is sys.__stdout__:
        sys.stdout = _stream(sys.stdout, _Tolerant(1, closed=1 in closed), io.TextIOWrapper)
    if sys.stderr is sys.__stderr__:
        sys.stderr = _stream(sys.stderr, _Tolerant(2, closed=2 in closed), _Shown, line_buffering=True)


def lost_output() -> OSError | None:
    """Why some of the standard output did not arrive; None when all of it did, as far as known."""
    raw = getattr(getattr(sys.stdout, "buffer", None), "raw", None)
    if not isinstance(raw, _Tolerant):
        return None
    sys.stdout.flush()
    return raw.problem


def _opened(descriptor: int) -> bool:
    """Whether a descriptor was closed; then it is open now, and leads nowhere."""
    try:
        os.fstat(descriptor)
    except OSError:
        # It gets the lowest number that is free, and those below are taken.
        os.set_inheritable(os.open(os.devnull, os.O_RDWR), True)
        return True
    return False


def _stream(
    before: TextIO | None, raw: _Tolerant, kind: type[io.TextIOWrapper], line_buffering: bool = False
) -> TextIO:
    """A text stream like the one before, in whose encoding every character has a form."""
    return kind(
        io.BufferedWriter(raw),
        encoding=getattr(before, "encoding", "utf-8"),
        errors="backslashreplace",
        line_buffering=line_buffering or getattr(before, "line_buffering", False),
        write_through=getattr(before, "write_through", False),
    )
