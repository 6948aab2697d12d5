"""One call after the other in this process."""

from collections import deque
from collections.abc import Callable, Iterator
from typing import Any

from flexbearing.program.worker_processes import Done, Processes


class Serial:
    """The engine of one job."""

    workers = 1

    def __init__(self):
        self._waiting: deque[tuple[Callable[[Any], Any], Any]] = deque()
        self._process = Processes(1)
        self._begins: Callable[[Any], None] = lambda argument: None
        self._suspected: Callable[[Any], bool] = lambda argument: False

    def guard(self, begins: Callable[[Any], None], suspected: Callable[[Any], bool]) -> None:
        """Have calls noted, and those that ended this process in a former run made in a process beside it."""
        self._begins, self._suspected = begins, suspected

    def submit(self, function: Callable[[Any], Any], argument: Any) -> None:
        """Put a call into the queue."""
        self._waiting.append((function, argument))

    def as_completed(self) -> Iterator[Done]:
        """Call the functions in the order in which they were submitted."""
        while self._waiting:
            function, argument = self._waiting.popleft()
            if self._suspected(argument):
                self._process.submit(function, argument)
                yield from self._process.as_completed()
                continue
            self._begins(argument)
            try:
                done = Done(argument, function(argument))
            except Exception as problem:  # of one task, which must not end the others
                done = Done(argument, raised=problem)
            yield done

    def close(self) -> None:
        """Forget what was not called."""
        self._waiting.clear()
        self._process.close()
