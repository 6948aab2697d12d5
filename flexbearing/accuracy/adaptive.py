"""The levels at which a roller case keeps the accuracy requested."""

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np

from flexbearing.accuracy.estimates import JUDGED, attributes, percent, require_resolved, unmet
from flexbearing.accuracy.ladder import Selection, climb
from flexbearing.accuracy.levels import ladders
from flexbearing.accuracy.trials import Trial, Trials, changes
from flexbearing.case.roller import Case
from flexbearing.coupling import RacewayPair
from flexbearing.program.threads import of_solids
from flexbearing.progress import Report
from quasidynamic import Equilibrium, RollerBearing
from quasidynamic.note import Note, danger, information


@dataclass(frozen=True)
class AdaptiveResolution:
    """A case at the levels that its target requires."""

    selection: Selection
    trial: Trial  # at these levels
    model: RollerBearing

    @property
    def rings(self) -> RacewayPair:
        """The parts as they are resolved."""
        return self.trial.rings

    def attributes(self) -> dict[str, Any]:
        """What the result file says of levels and errors."""
        return attributes([self.selection])

    def notes(self, end: Equilibrium) -> Iterator[Note]:
        """What a reader must know: parts that are left rigid, a target that is not met, another end state."""
        for verdict in self.selection.verdicts:
            if verdict.choice.levels[verdict.level] == "rigid":
                yield information(
                    "rigid-part",
                    f"{verdict.choice.name}: left rigid, as its deflection changes loads and life by "
                    f"less than the target allows it ({percent(verdict.allowed)})",
                )
        yield from unmet([self.selection])
        away = np.abs(end.forces[..., 0] - self.trial.loads).max() / self.trial.loads.max()
        if not away <= self.selection.target:
            yield danger(
                "several-equilibria",
                f"required accuracy: the loads of this solution differ by {percent(away)} from those that "
                "the errors were estimated at: there are several equilibria, and the estimate is of another",
                {"accuracy.target": ""},
            )


def adaptive_resolution(case: Case, report: Report) -> AdaptiveResolution:
    """Choose the levels of a case that has a target.

    Raises `Unusable` if there is no answer at the coarsest levels.
    """
    assert case.accuracy.target is not None
    report.stage("levels for the required accuracy", None)
    choices = ladders(case)
    trials = Trials(case, choices, report)
    with ThreadPoolExecutor() as pool:
        if of_solids(case.accuracy.threads) > 1:
            trials.foresee(pool)
        selection = climb(
            [ladder.choice for ladder in choices], trials, changes, case.accuracy.target, JUDGED
        )
    require_resolved(selection)
    for verdict in selection.verdicts:
        report.stage(f"{verdict.choice.name}: {verdict.choice.levels[verdict.level]}", None)
    return AdaptiveResolution(selection, trials(selection.place), trials.model(selection.place))
