r"""Ladders of levels, one for each choice, climbed until what a level leaves out is allowed.

Where each level leaves at most the part r of the error of the one before, the change between two
levels one after the other bounds the errors of both,

.. math:: e_k \le \frac{r}{1 - r}\,|y_k - y_{k-1}|, \quad e_k \le \frac{1}{1 - r}\,|y_k - y_{k+1}|

The first is used where the levels cost much: of two levels that are computed, the finer one is the answer.
The second may look at more than one richer level, as one alone may happen to give the same.
One choice moves at a time, and the errors of all choices add up.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import islice
from math import inf
from typing import Generic, TypeVar

Place = tuple[int, ...]  # a level of each choice
Changes = Mapping[str, float]  # by output


class Unusable(RuntimeError):
    """A level without a result; the message says why."""


@dataclass(frozen=True, kw_only=True)
class Choice:
    """Something that is resolved more or less finely."""

    name: str
    levels: tuple[str, ...]  # from the poorest to the richest, in words
    weight: float  # its part of the target over the sum of all weights
    above: float  # error of a level over its change to the next [-], >= 1
    below: float | None = None  # the same over its change from the one before [-]; None: that is not asked
    compared: int = 1  # richer levels that one is compared with, the largest change counts
    converging: int = 0  # first level of the sequence; those before leave something out altogether
    start: int = 0  # first level that may be taken
    last: int | None = None  # highest level that may be taken, those beyond only measure; None: any
    fixed_by: tuple[str, ...] = ()  # keys of the case that fix its highest level; none: it is chosen

    @property
    def highest(self) -> int:
        """Highest level that may be taken."""
        return len(self.levels) - 1 if self.last is None else self.last


@dataclass(frozen=True)
class Verdict:
    """What a choice costs in accuracy at the level that was taken."""

    choice: Choice
    level: int
    against: tuple[int, ...]  # levels that it was compared with; none where there is no other answer
    changes: Changes  # by output [-]
    allowed: float  # [-]
    judged: tuple[str, ...]  # outputs that the target is of
    unusable: Mapping[str, str] = field(default_factory=dict)  # levels without a result, and why

    @property
    def factor(self) -> float:
        """Error over change [-]; at the top, where there is no next level, that of the one before."""
        finer = any(level < self.level for level in self.against)
        return self.choice.below if finer and self.choice.below is not None else self.choice.above

    @property
    def estimate(self) -> dict[str, float]:
        """Estimated errors, by output; infinite where nothing could be compared."""
        if not self.against:
            return dict.fromkeys(self.judged, inf)
        return {name: self.factor * change for name, change in self.changes.items()}

    @property
    def excess(self) -> bool:
        """Whether an output that the target is of may be wrong by more than allowed."""
        return any(self.estimate.get(name, 0.0) > self.allowed for name in self.judged)


@dataclass(frozen=True)
class Selection:
    """The levels that were taken, and why."""

    place: Place
    verdicts: tuple[Verdict, ...]
    target: float

    @property
    def estimate(self) -> dict[str, float]:
        """Estimated errors of all choices together, by output."""
        names = {name: None for verdict in self.verdicts for name in verdict.estimate}
        return {name: sum(verdict.estimate.get(name, 0.0) for verdict in self.verdicts) for name in names}

    @property
    def met(self) -> bool:
        """Whether the outputs that the target is of are estimated to keep it."""
        judged = {name for verdict in self.verdicts for name in verdict.judged}
        return all(error <= self.target for name, error in self.estimate.items() if name in judged)


T = TypeVar("T")


@dataclass
class _Climb(Generic[T]):
    choices: Sequence[Choice]
    evaluate: Callable[[Place], T]
    changes: Callable[[T, T], Changes]
    target: float
    judged: tuple[str, ...]
    place: list[int]
    unusable: dict[tuple[int, int], str] = field(default_factory=dict)  # (choice, level) to why

    def verdict(self, k: int) -> Verdict:
        """Compare the level of a choice with the best of the others that has a result."""
        choice, level = self.choices[k], self.place[k]
        base = self.evaluate(tuple(self.place))
        allowed = self.target * choice.weight / sum(other.weight for other in self.choices)
        others: dict[int, T] = {}
        for levels in _compared(choice, level):
            others = others or dict(islice(self._answers(k, levels), choice.compared))
        largest: dict[str, float] = {}
        for other in others.values():
            for name, change in self.changes(base, other).items():
                largest[name] = max(change, largest.get(name, 0.0))
        unusable = {choice.levels[n]: why for (at, n), why in self.unusable.items() if at == k}
        return Verdict(choice, level, tuple(others), largest, allowed, self.judged, unusable)

    def _answers(self, k: int, levels: Iterable[int]) -> Iterator[tuple[int, T]]:
        """Levels of a choice that have a result, with it."""
        for level in levels:
            answer = self._answer(k, level)
            if answer is not None:
                yield level, answer

    def _answer(self, k: int, level: int) -> T | None:
        if (k, level) in self.unusable:
            return None
        try:
            return self.evaluate((*self.place[:k], level, *self.place[k + 1 :]))
        except Unusable as problem:
            self.unusable[k, level] = str(problem)
            return None

    def rise(self, k: int) -> bool:
        """Climb one choice as far as needed; returns whether it moved."""
        before = self.place[k]
        while self.verdict(k).excess:
            above = self._next(k)
            if above is None:
                break
            self.place[k] = above
        return self.place[k] != before

    def _next(self, k: int) -> int | None:
        """The next level with an answer; the first of a sequence is only to judge the second by."""
        choice, level = self.choices[k], self.place[k]
        first = choice.converging + (choice.below is not None)
        above = range(max(level + 1, min(first, choice.highest)), choice.highest + 1)
        return next((n for n, _ in self._answers(k, above)), None)


def _compared(choice: Choice, level: int) -> tuple[Iterable[int], Iterable[int]]:
    """Levels to compare one with, those first that tell most: the poorer or the richer ones."""
    richer = range(level + 1, len(choice.levels))
    poorer = range(level - 1, choice.converging - 1, -1)
    return (poorer, richer) if choice.below is not None else (richer, poorer)


def climb(
    choices: Sequence[Choice],
    evaluate: Callable[[Place], T],
    changes: Callable[[T, T], Changes],
    target: float,
    judged: tuple[str, ...],
) -> Selection:
    """Take the poorest levels whose estimated errors keep their parts of the target.

    Raises `Unusable` if the poorest levels together have no result.

    Valid
    -----
    Levels that converge as their factors say. All choices are looked at again until none of them moves, as
    one may matter more when another has moved.
    """
    state = _Climb(choices, evaluate, changes, target, judged, [choice.start for choice in choices])
    while any([state.rise(k) for k in range(len(choices))]):
        pass
    verdicts = tuple(state.verdict(k) for k in range(len(choices)))
    return Selection(tuple(state.place), verdicts, target)


def climb_together(
    choices: Sequence[Choice],
    evaluates: Sequence[Callable[[Place], T]],
    changes: Callable[[T, T], Changes],
    target: float,
    judged: tuple[str, ...],
) -> tuple[Selection, ...]:
    """Take the poorest levels that keep the target for each of several problems with the same choices.

    Each problem climbs from where the one before it ended, until none of them moves any more.

    Raises `Unusable` if a problem has no result at the poorest levels, or at those where it begins.
    """
    if len(evaluates) == 1:
        return (climb(choices, evaluates[0], changes, target, judged),)
    start, place, selections = None, tuple(choice.start for choice in choices), []
    while place != start:
        start, selections = place, []
        for evaluate in evaluates:
            begun = [replace(choice, start=level) for choice, level in zip(choices, place, strict=True)]
            selections.append(climb(begun, evaluate, changes, target, judged))
            place = selections[-1].place
    return tuple(selections)
