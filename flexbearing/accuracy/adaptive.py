"""The levels at which a roller case keeps the accuracy asked for."""

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np

from flexbearing.accuracy.ladder import Selection, Unusable, Verdict, climb
from flexbearing.accuracy.levels import ladders
from flexbearing.accuracy.trials import Trial, Trials, changes
from flexbearing.case.roller import Case
from flexbearing.coupling import RacewayPair
from flexbearing.program.threads import of_solids
from flexbearing.progress import Report
from quasidynamic import Equilibrium, RollerBearing
from quasidynamic.note import Note, danger, information

JUDGED = ("roller_load", "life")  # outputs that the target is of


@dataclass(frozen=True)
class AdaptiveResolution:
    """A case at the levels that its target asks for."""

    selection: Selection
    trial: Trial  # at these levels
    model: RollerBearing

    @property
    def rings(self) -> RacewayPair:
        """The parts as they are resolved."""
        return self.trial.rings

    def attributes(self) -> dict[str, Any]:
        """What the result file says of levels and errors."""
        return {
            "choices": {verdict.choice.name: _record(verdict) for verdict in self.selection.verdicts},
            "error_estimate": {
                "target": self.selection.target,
                "met": self.selection.met,
                **{
                    name: error if np.isfinite(error) else None
                    for name, error in self.selection.estimate.items()
                },
            },
        }

    def notes(self, end: Equilibrium) -> Iterator[Note]:
        """What a reader must know: parts that are left rigid, a target that is not met, another end state."""
        for verdict in self.selection.verdicts:
            if verdict.choice.levels[verdict.level] == "rigid":
                yield information(
                    "rigid-part",
                    f"{verdict.choice.name}: left rigid, as its deflection changes loads and life by "
                    f"less than the target allows it ({_percent(verdict.allowed)})",
                )
        if not self.selection.met:
            yield danger("unmet-target", _unmet(self.selection))
        away = np.abs(end.forces[..., 0] - self.trial.loads).max() / self.trial.loads.max()
        if not away <= self.selection.target:
            yield danger(
                "several-equilibria",
                f"accuracy.target: the loads of this solution differ by {_percent(away)} from those that "
                "the errors were estimated at: there are several equilibria, and the estimate is of another",
            )


def adaptive_resolution(case: Case, report: Report) -> AdaptiveResolution:
    """Choose the levels of a case that has a target.

    Parameters
    ----------
    case : Case
        roller bearing
    report : Report
        hears of the parts that are condensed

    Returns
    -------
    AdaptiveResolution

    Raises
    ------
    Unusable
        if there is no answer at the coarsest levels
    """
    assert case.accuracy.target is not None
    report.stage("levels for the accuracy asked for", None)
    choices = ladders(case)
    trials = Trials(case, choices, report)
    with ThreadPoolExecutor() as pool:
        if of_solids(case.accuracy.threads) > 1:
            trials.foresee(pool)
        selection = climb(
            [ladder.choice for ladder in choices], trials, changes, case.accuracy.target, JUDGED
        )
    for verdict in selection.verdicts:
        name, level = verdict.choice.name, verdict.choice.levels[verdict.level]
        if verdict.choice.converging > verdict.level and verdict.excess:
            # A part is rigid where that hardly matters, never because its own levels have no answer.
            raise Unusable("; ".join(dict.fromkeys(verdict.unusable.values())))
        report.stage(f"{name}: {level}", None)
    return AdaptiveResolution(selection, trials(selection.place), trials.model(selection.place))


def _record(verdict: Verdict) -> dict[str, Any]:
    """One choice as JSON can hold it."""
    choice = verdict.choice
    return {
        "level": choice.levels[verdict.level],
        "fixed": choice.last is not None and verdict.level == choice.highest,
        "compared_with": [choice.levels[level] for level in verdict.against],
        "changes": dict(verdict.changes),
        "factor": verdict.factor,
        "allowed": verdict.allowed,
        "unusable": dict(verdict.unusable),
    }


def _unmet(selection: Selection) -> str:
    """What the errors are and what makes them."""
    errors = " and ".join(
        f"{_percent(selection.estimate[name])} of the {words}"
        for name, words in zip(JUDGED, ("largest load", "life"), strict=True)
        if name in selection.estimate
    )
    worst = max(
        selection.verdicts,
        key=lambda verdict: max(verdict.estimate.get(name, 0.0) for name in JUDGED),
    )
    choice = worst.choice
    fixed = ", which the case fixes" if worst.level == choice.highest and choice.last is not None else ""
    return (
        f"accuracy.target of {_percent(selection.target)} is not met: the estimated errors are {errors}, "
        f"most of it from {choice.name} ({choice.levels[worst.level]}{fixed})"
    )


def _percent(share: float) -> str:
    return f"{100 * share:.2g} %"
