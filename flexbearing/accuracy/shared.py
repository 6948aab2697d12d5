"""Levels that cases between the same parts share, chosen at some of these cases."""

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

from flexbearing.accuracy.estimates import JUDGED, attributes, largest, require_resolved, unmet
from flexbearing.accuracy.ladder import Place, Selection, Unusable, climb_together
from flexbearing.accuracy.levels import ladders
from flexbearing.accuracy.trials import Trials, changes
from flexbearing.case.roller import Case
from flexbearing.program.threads import of_solids
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


def shared_levels(cases: Sequence[Case], report: Report) -> Levels:
    """Choose the levels of cases between the same parts."""
    target, choices = cases[0].accuracy.target, ladders(cases[0])
    assert target is not None
    trials = [Trials(case, choices, report) for case in cases]
    try:
        with ThreadPoolExecutor() as pool:
            if of_solids(cases[0].accuracy.threads) > 1:
                trials[0].foresee(pool)
            selections = climb_together([each.choice for each in choices], trials, changes, target, JUDGED)
        for selection in selections:
            require_resolved(selection)
    except Unusable as problem:
        return UsualLevels(str(problem))
    return SharedLevels(selections)
