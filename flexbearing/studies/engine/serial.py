"""One call after the other in this process."""

from collections import deque
from collections.abc import Callable, Iterator
from typing import Any

from flexbearing.studies.engine.engine import Done


class Serial:
    """The engine of one job."""

    workers = 1

    def __init__(self):
        self._waiting: deque[tuple[Callable[[Any], Any], Any]] = deque()

    def submit(self, function: Callable[[Any], Any], argument: Any) -> None:
        """Put a call into the queue."""
        self._waiting.append((function, argument))

    def as_completed(self) -> Iterator[Done]:
        """Call the functions in the order in which they were submitted."""
        while self._waiting:
            function, argument = self._waiting.popleft()
            try:
                done = Done(argument, function(argument))
            except Exception as problem:  # of one task, which must not end the others
                done = Done(argument, problem=f"{type(problem).__name__}: {problem}")
            yield done

    def close(self) -> None:
        """Forget what was not called."""
        self._waiting.clear()
