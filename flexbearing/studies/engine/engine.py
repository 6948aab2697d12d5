"""What every engine does."""

from collections.abc import Callable, Iterator
from typing import Any, Protocol

from flexbearing.program.interpreter import Died
from flexbearing.program.processes import Done


class EngineLost(Died):
    """What computes the calls of an engine is gone: no call is at fault."""


class Engine(Protocol):
    """Calls a function for one argument after the other, here or elsewhere."""

    workers: int  # calls that run at the same time

    def submit(self, function: Callable[[Any], Any], argument: Any) -> None:
        """Have a function called; both can be pickled."""
        ...

    def as_completed(self) -> Iterator[Done]:
        """Yield the end of each call, also of those submitted meanwhile; ends when none is left."""
        ...

    def close(self) -> None:
        """Stop all that still runs, and every process that was started."""
        ...
