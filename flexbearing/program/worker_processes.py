"""Calls that worker processes answer as they become free, each at the end of a pipe of its own."""

import ctypes
import sys
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from multiprocessing.connection import wait
from typing import Any

from flexbearing.program.interpreter import Died, Interpreter, NeverStarted

STARTS = 5  # of each process that end before it takes a call, until no more are tried
KEPT, AS_ONE = 2**26, 2**24  # bytes that stay when they are freed, and of an array that is given back alone
_TRIM_THRESHOLD, _MMAP_THRESHOLD = -1, -3  # of malloc.h


@dataclass(frozen=True)
class Done:
    """The end of one call."""

    argument: Any  # what was submitted
    answer: Any = None  # of the function
    raised: Exception | None = None  # by the function, instead of an answer
    died: bool = False  # its worker ended without a word

    @property
    def problem(self) -> str:
        """What the function raised, in words; empty where there is an answer."""
        return f"{type(self.raised).__name__}: {self.raised}" if self.raised else ""


class Processes:
    """Worker processes, up to a number as many as there are calls; one that dies is replaced."""

    def __init__(self, workers: int, ahead: str | None = None):
        """Start no process yet: the first call does."""
        self.workers, self._ahead = workers, ahead
        self._waiting: deque[tuple[Callable[[Any], Any], Any]] = deque()
        self._processes: dict[Any, Interpreter] = {}  # by what is waited for
        self._free: list[Interpreter] = []
        self._running: dict[Interpreter, Any] = {}  # arguments
        self._failed_starts = 0

    def start(self) -> None:
        """Start all processes, before there are calls."""
        self._start(self.workers)

    def submit(self, function: Callable[[Any], Any], argument: Any) -> None:
        """Have a function called by whichever process is free; both can be pickled."""
        self._waiting.append((function, argument))
        self._hand_out()

    def as_completed(self) -> Iterator[Done]:
        """Yield calls as they end, also those submitted meanwhile; ends when none is left."""
        while self._waiting or self._running:
            ends = [self._end_of_call(self._processes[each]) for each in wait(list(self._processes))]
            self._hand_out()  # whoever looks at an end keeps no process waiting
            yield from filter(None, ends)

    def close(self) -> None:
        """Forget what was not called, and end the processes with all that they compute."""
        self._waiting.clear()
        self._running.clear()
        for process in [*self._processes.values()]:
            self._remove(process)

    def _hand_out(self) -> None:
        while self._waiting and self._free:
            process, (function, argument) = self._free.pop(), self._waiting.popleft()
            self._running[process] = argument
            process.send(function, argument)
        self._start(min(self.workers, len(self._waiting) + len(self._running)))

    def _start(self, count: int) -> None:
        for _ in range(count - len(self._processes)):
            process = Interpreter(self.workers, self._ahead)
            self._processes[process.calls] = process

    def _end_of_call(self, process: Interpreter) -> Done | None:
        """The end of what a process computed; nothing where it did not, as it has just started."""
        if process not in self._running:
            return self._started(process)
        argument = self._running.pop(process)
        try:
            done = Done(argument, *process.answer())
        except Died:
            self._remove(process)
            return Done(argument, died=True)
        self._free.append(process)
        self._failed_starts = 0
        return done

    def _started(self, process: Interpreter) -> None:
        try:
            process.await_start()
        except NeverStarted:
            self._remove(process)
            self._failed_starts += 1
            if self._failed_starts > STARTS * self.workers:
                raise
        else:
            self._free.append(process)

    def _remove(self, process: Interpreter) -> None:
        del self._processes[process.calls]
        if process in self._free:
            self._free.remove(process)
        process.end()


@cache
def keep_freed() -> bool:
    """Let this process keep some freed memory from now on."""
    if not sys.platform.startswith("linux"):
        return False
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None)
    if mallopt is None:  # another C library
        return False
    return all([mallopt(_TRIM_THRESHOLD, KEPT), mallopt(_MMAP_THRESHOLD, AS_ONE)])
