"""What may be changed: numbers between realistic ends, counted in realistic steps, and graded choices."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import copysign
from typing import Any

from flexbearing.case import Head
from flexbearing.case.key_ranges import range_of
from flexbearing.derivatives.keys import Key, given_keys
from flexbearing.runs.plausible import graded

CONDITIONS = "operation.", "life."  # keys of what a designer is given: in no pair


@dataclass(frozen=True)
class Lever:
    """A key that holds a number."""

    key: Key
    low: float  # SI
    high: float

    @property
    def given(self) -> bool:
        """Whether it is a condition, which a designer does not choose."""
        return self.key.path.startswith(CONDITIONS)

    def end(self, sign: float) -> float:
        """Steps up to the last value of one side."""
        return abs((self.high if sign > 0 else self.low) - self.key.value) / self.step

    def up_to(self, steps: float, sign: float) -> "Lever":
        """The same that ends after some steps to one side."""
        last = self.key.value + copysign(steps * self.step, sign)
        return replace(self, high=last) if sign > 0 else replace(self, low=last)

    @property
    def step(self) -> float:
        """A realistic step, in SI units."""
        return self.key.realistic_step * self.key.size

    def words(self, steps: float) -> str:
        """The value so many steps away, as a case has it."""
        return f"{float(f'{self._value(steps):.12g}')!r} {self.key.unit}".strip()

    def shown(self, steps: float) -> str:
        """The same with four digits."""
        return f"{self._value(steps):.4g} {self.key.unit}".strip()

    def _value(self, steps: float) -> float:
        return self.key.stated + steps * self.key.realistic_step


@dataclass(frozen=True)
class Choice:
    """Another choice of a graded key."""

    key: str
    words: str  # of it
    before: str  # that of the case
    settings: tuple[str, ...]
    steps: int


@dataclass(frozen=True)
class Move:
    """Levers that change together: so many steps of each for every step of the move."""

    parts: tuple[tuple[Lever, float], ...]
    choice: Choice | None = None  # that is taken first

    def end(self) -> float:
        """Steps until the last lever is at its end."""
        return max(lever.end(weight) / abs(weight) for lever, weight in self.parts)

    def up_to(self, steps: float) -> "Move":
        """The same whose levers end after so many steps."""
        return replace(
            self, parts=tuple((lever.up_to(steps, weight), weight) for lever, weight in self.parts)
        )

    def changes(self, steps: float) -> Iterator[tuple[Lever, float]]:
        """Levers with the steps of each, which stops at its end."""
        for lever, weight in self.parts:
            yield lever, copysign(min(steps * abs(weight), lever.end(weight)), weight)

    def settings(self, steps: float) -> tuple[str, ...]:
        """Settings of the case after so many steps."""
        moved = (f"{lever.key.path}={lever.words(own)}" for lever, own in self.changes(steps))
        return (*(self.choice.settings if self.choice else ()), *moved)


def levers(case: Head) -> list[Lever]:
    """Numbers that the case states and somebody designs or knows."""
    found = []
    for key in given_keys(case):
        interval = range_of(key.path).interval(key.value, key.si_unit)
        if interval is None or (key.value == 0.0 and key.si_unit == "rad/s"):  # a ring at standstill stays
            continue
        low, high = max(interval[0], key.above), min(interval[1], key.below)
        if low < key.value or key.value < high:
            found.append(Lever(key, min(low, key.value), max(high, key.value)))
    return found


def choices(case: Any) -> list[list[Choice]]:
    """Other choices of each graded key, with their distance in the list of choices."""
    found = []
    for each in graded(case, every=True):
        words = [other.words for other in each.others]
        before = _value(case, each.key)
        place = words.index(before) if before in words else None
        found.append(
            [
                Choice(
                    each.key, other.words, before, other.settings, 1 if place is None else abs(number - place)
                )
                for number, other in enumerate(each.others)
                if number != place
            ]
        )
    return found


def _value(case: Any, path: str) -> str:
    for name in path.split("."):
        case = getattr(case, name)
    return str(case)
