"""One call after the other in a process beside this one, whose death is the end of its call alone.

The process is a plain interpreter, which does not import the script that called, and needs no Dask. In a
session of its own it does not hear what a terminal sends; it ends with this process, however that ends.
"""

import os
import signal
import subprocess
import sys
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import suppress
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from threading import Thread
from typing import Any

from flexbearing.program.threads import environment
from flexbearing.program.workers import portable
from flexbearing.studies.engine.engine import Done, NoWorkers

_START = (
    "import sys; sys.path[:] = {path!r}; from flexbearing.studies.engine import apart; apart.serve({end})"
)


class Apart:
    """The engine of one job whose process may die, or whose times must not depend on this one."""

    workers = 1

    def __init__(self):
        self._waiting: deque[tuple[Callable[[Any], Any], Any]] = deque()
        self._process: subprocess.Popen | None = None
        self._calls: Connection

    def submit(self, function: Callable[[Any], Any], argument: Any) -> None:
        """Put a call into the queue; the process starts with the first one that is made."""
        self._waiting.append((function, argument))

    def as_completed(self) -> Iterator[Done]:
        """Call the functions in the order in which they were submitted."""
        while self._waiting:
            call = self._waiting.popleft()
            if self._process is None:
                self._start()
            try:
                self._calls.send(call)
                done = Done(call[1], *self._calls.recv())
            except (EOFError, ConnectionError):
                self._stop()
                done = Done(call[1], died=True)
            yield done

    def close(self) -> None:
        """Forget what was not called, and end the process with whatever it computes."""
        self._waiting.clear()
        self._stop()

    def _start(self) -> None:
        self._calls, theirs = Pipe()
        with theirs:
            self._process = subprocess.Popen(
                [sys.executable, "-c", _START.format(path=sys.path, end=theirs.fileno())],
                stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, env=environment(self.workers),
                pass_fds=[theirs.fileno()], start_new_session=True,
            )  # fmt: skip
        try:
            self._calls.recv()
        except EOFError as problem:
            raise NoWorkers("the worker process ends as soon as it is started") from problem

    def _stop(self) -> None:
        if self._process is None:
            return
        with suppress(ProcessLookupError):  # with what it started to mesh
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()
        if self._process.stdin:
            self._process.stdin.close()
        self._calls.close()
        self._process = None


def serve(end: int) -> None:
    """Answer calls in the process beside, until the other one is gone.

    Parameters
    ----------
    end : int
        file descriptor of this end of the connection
    """
    Thread(target=_end_with_caller, daemon=True).start()
    calls = Connection(end)
    calls.send("ready")
    while True:
        function, argument = calls.recv()
        try:
            answer = function(argument), None
        except Exception as problem:  # of one call, which must not end the others
            answer = None, portable(problem)
        calls.send(answer)


def _end_with_caller() -> None:
    sys.stdin.buffer.read()
    os.killpg(0, signal.SIGKILL)  # with what it started to mesh
