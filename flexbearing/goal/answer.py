"""What reaches a wanted life, and what does not."""

from dataclasses import dataclass
from math import isfinite, nan
from typing import Any

from flexbearing.goal.target import Target


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


@dataclass(frozen=True)
class Goal:
    """Changes of a case towards a wanted life, each verified by a run."""

    title: str
    target: Target
    changes: tuple[Change, ...]  # of one key; those that reach it first, the fewest steps first
    pair: Change | None  # of two keys, the fewest steps; None: none reaches it
    weak: tuple[str, ...]  # keys that hardly change the life

    def __getitem__(self, key: str) -> Change:
        """The change of one key."""
        for change in self.changes:
            if change.name == key:
                return change
        raise KeyError(f"{key}: levers are {', '.join(change.name for change in self.changes)}")

    def __repr__(self) -> str:
        from flexbearing.goal.page import text

        return text(self.title, self.target, self.changes, self.pair, self.weak)

    @property
    def reached(self) -> bool:
        """Whether a lever or a pair reaches it."""
        return bool(self.pair) or any(change.reaches for change in self.changes)

    def as_json(self) -> dict[str, Any]:
        """The whole as plain values."""
        target = self.target
        of = {"output": target.name, "unit": target.unit, "before": target.before, "wanted": target.wanted}
        return {"title": self.title, **of, "changes": self.records(), "weak": list(self.weak)}

    def records(self) -> list[dict[str, Any]]:
        """Every change as plain values, the pair last."""
        found = (*self.changes, *((self.pair,) if self.pair else ()))
        return [
            {
                "keys": {each.key: [each.before, each.after] for each in change.keys},
                "steps": change.steps,
                "reaches": change.reaches,
                "life": change.life if isfinite(change.life) else None,
                "limit": change.limit,
            }
            for change in found
        ]
