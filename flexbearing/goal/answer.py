"""What reaches a wanted life, and what does not."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import isfinite, nan
from typing import Any

from rich.console import RenderableType
from rich.text import Text

from flexbearing.goal.target import Target
from flexbearing.printable import excerpt
from flexbearing.report.html.document import Table
from flexbearing.report.output import laid_out
from flexbearing.report.sections import titled


@dataclass(frozen=True)
class Changed:
    """A key with its value before and after."""

    key: str
    before: str
    after: str
    shown: tuple[str, str]  # both, numbers with four digits


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
        return laid_out(sections(self)).rstrip()

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


DIGITS = 4
LONGEST = 120  # characters of a reason


def sections(goal: Goal) -> Iterator[RenderableType]:
    """Changes that reach it, the pair, changes that do not."""
    target, changes = goal.target, goal.changes
    yield Text(goal.title, style="bold")
    yield Text(f"{target.name} {_life(target.before, target)}; wanted {_life(target.wanted, target)}\n")
    others = [each for each in changes if not each.reaches]
    groups = {
        "one change": [each for each in changes if each.reaches],
        "two changes": [goal.pair] if goal.pair else [],
        "cannot, comes to": others,
    }
    for name, group in groups.items():
        yield from titled("", _table(name, group, target))
    yield from (Text(f"  {each.name}: {excerpt(each.limit, LONGEST)}") for each in others if each.limit)
    if goal.weak:
        yield Text(f"  less than 1 %: {', '.join(goal.weak)}")


def _table(heading: str, changes: Sequence[Change], target: Target) -> Table:
    rows = []
    for change in changes:
        for number, each in enumerate(change.keys):
            ends = ("", "") if number else (f"{change.steps:.2g}", _life(change.life, target))
            rows.append((each.key, *each.shown, *ends))
    return Table((heading, "from", "to", "steps", "life"), tuple(rows))


def _life(life: float, target: Target) -> str:
    rounded = float(f"{life:.{DIGITS}g}")
    return f"{rounded:,.0f} {target.unit}" if rounded >= 10**DIGITS else f"{rounded:g} {target.unit}"
