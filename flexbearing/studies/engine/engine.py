"""What every engine does."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, Protocol


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


class NoWorkers(RuntimeError):
    """Worker processes end as soon as they are started."""


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
        """Stop whatever still runs, and every process that was started."""
        ...
