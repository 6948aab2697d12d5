"""A change of one key or of two, and what a run with it gives."""

from dataclasses import dataclass
from math import nan


@dataclass(frozen=True)
class Changed:
    """A key with its value before and after."""

    key: str
    before: str
    after: str


@dataclass(frozen=True)
class Change:
    """Keys that change together, and what a run with them gives."""

    keys: tuple[Changed, ...]
    settings: tuple[str, ...]  # of the case
    steps: float  # realistic ones; of two keys the root of the sum of squares
    reaches: bool
    limit: str = ""  # why it goes no further, where it does not reach it
    life: float = nan  # of a run, in the unit of the goal

    @property
    def name(self) -> str:
        """Its keys."""
        return " and ".join(each.key for each in self.keys)
