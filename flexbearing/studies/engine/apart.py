"""One call after the other in a process beside this one, whose death is the end of its call alone.

It needs no Dask.
"""

from collections import deque
from collections.abc import Callable, Iterator
from typing import Any

from flexbearing.program.interpreter import Died, Interpreter, NeverStarted
from flexbearing.studies.engine.engine import Done, NoWorkers


class Apart:
    """The engine of one job whose process may die, or whose times must not depend on this one."""

    workers = 1

    def __init__(self):
        self._waiting: deque[tuple[Callable[[Any], Any], Any]] = deque()
        self._process: Interpreter | None = None

    def submit(self, function: Callable[[Any], Any], argument: Any) -> None:
        """Put a call into the queue; the process starts with the first one that is made."""
        self._waiting.append((function, argument))

    def as_completed(self) -> Iterator[Done]:
        """Call the functions in the order in which they were submitted."""
        while self._waiting:
            function, argument = self._waiting.popleft()
            process = self._process or self._started()
            process.send(function, argument)
            try:
                done = Done(argument, *process.answer())
            except Died:
                self._stop()
                done = Done(argument, died=True)
            yield done

    def close(self) -> None:
        """Forget what was not called, and end the process with whatever it computes."""
        self._waiting.clear()
        self._stop()

    def _started(self) -> Interpreter:
        self._process = Interpreter(self.workers)
        try:
            self._process.await_start()
        except NeverStarted as problem:
            raise NoWorkers(str(problem)) from problem
        return self._process

    def _stop(self) -> None:
        if self._process:
            self._process.end()
        self._process = None
