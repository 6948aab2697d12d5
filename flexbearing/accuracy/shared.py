"""Levels that cases between the same parts share, chosen at some of these cases."""

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

from flexbearing.accuracy.estimates import attributes, largest, require_resolved, unmet
from flexbearing.accuracy.family import LevelsOfFamily, T
from flexbearing.accuracy.ladder import Place, Selection, Unusable, climb_together
from flexbearing.progress import Report
from quasidynamic.note import Note, danger


@dataclass(frozen=True)
class SharedLevels:
    """Levels at which the cases that were looked at keep the target, as far as there are such levels."""

    selections: tuple[Selection, ...]  # of each of those cases, all at the same levels

    @property
    def place(self) -> Place:
        """A level of each choice."""
        return self.selections[0].place

    @property
    def estimate(self) -> Mapping[str, float]:
        """Largest estimated errors, by output."""
        return largest(self.selections)

    def notes(self) -> tuple[Note, ...]:
        """What every answer at these levels must say."""
        return tuple(unmet(self.selections))

    def attributes(self) -> dict[str, Any]:
        """What a result file says of levels and errors."""
        return attributes(self.selections)


@dataclass(frozen=True)
class UsualLevels:
    """Levels of cases for which none could be chosen: those without a target."""

    problem: str  # why
    place: None = None

    @property
    def estimate(self) -> Mapping[str, float]:
        """No error is estimated."""
        return {}

    def notes(self) -> tuple[Note, ...]:
        """What every answer at these levels must say."""
        words = "required accuracy: nothing could be chosen or estimated, so the usual levels are used: "
        return (danger("unmet-target", f"{words}{self.problem}", {"accuracy.target": ""}),)

    def attributes(self) -> dict[str, Any]:
        """What a result file says of levels and errors."""
        return {"choices": {}, "error_estimate": {}}


Levels = SharedLevels | UsualLevels


def shared_levels(cases: Sequence[Any], family: LevelsOfFamily, report: Report) -> Levels:
    """Choose the levels of cases between the same parts."""
    try:
        selections, _ = chosen(cases, family, report)
    except Unusable as problem:
        return UsualLevels(str(problem))
    return SharedLevels(selections)


def chosen(
    cases: Sequence[Any], family: LevelsOfFamily[T], report: Report
) -> tuple[tuple[Selection, ...], list[T]]:
    """Levels of cases between the same parts, and what was solved at them.

    Raises `Unusable` if there is no answer at the coarsest levels.
    """
    target, ladders = cases[0].accuracy.target, family.ladders(cases[0])
    trials = [family.trials(case, ladders, report) for case in cases]
    choices = [each.choice for each in ladders]
    with ThreadPoolExecutor() as pool:
        if family.begin:
            family.begin(trials[0], pool)
        selections = climb_together(choices, trials, family.changes, target, family.judged)
    for selection in selections:
        require_resolved(selection)
    return selections, trials
