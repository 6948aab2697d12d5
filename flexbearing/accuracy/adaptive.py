"""The levels at which a case keeps the accuracy requested."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Generic

import numpy as np
from numpy.typing import NDArray

from flexbearing.accuracy.estimates import attributes, percent, unmet
from flexbearing.accuracy.family import LevelsOfFamily, T
from flexbearing.accuracy.ladder import Place, Selection
from flexbearing.accuracy.shared import chosen
from flexbearing.progress import Report
from quasidynamic.note import Note, danger, information


@dataclass(frozen=True)
class AdaptiveResolution(Generic[T]):
    """A case at the levels that its target requires."""

    selection: Selection
    trials: T

    @property
    def place(self) -> Place:
        """A level of each choice."""
        return self.selection.place

    @property
    def trial(self) -> Any:
        """The end state at these levels."""
        return self.trials(self.place)

    def attributes(self) -> dict[str, Any]:
        """What the result file says of levels and errors."""
        return attributes([self.selection])

    def notes(self, loads: NDArray) -> Iterator[Note]:
        """What a reader must know: parts that are left rigid, a target that is not met, another end state.

        Loads (2, Z) [N] are those of the end state.
        """
        for verdict in self.selection.verdicts:
            if verdict.choice.levels[verdict.level] == "rigid":
                yield information(
                    "rigid-part",
                    f"{verdict.choice.name}: left rigid, as its deflection changes loads and life by "
                    f"less than the target allows it ({percent(verdict.allowed)})",
                )
        yield from unmet([self.selection])
        away = np.abs(loads - self.trial.loads).max() / self.trial.loads.max()
        if not away <= self.selection.target:
            yield danger(
                "several-equilibria",
                f"required accuracy: the loads of this solution differ by {percent(away)} from those that "
                "the errors were estimated at: there are several equilibria, and the estimate is of another",
                {"accuracy.target": ""},
            )


def adaptive_resolution(case: Any, family: LevelsOfFamily[T], report: Report) -> AdaptiveResolution[T]:
    """Choose the levels of a case that has a target.

    Raises `Unusable` if there is no answer at the coarsest levels.
    """
    report.stage("levels for the required accuracy", None)
    (selection,), (trials,) = chosen([case], family, report)
    for verdict in selection.verdicts:
        report.stage(f"{verdict.choice.name}: {verdict.choice.levels[verdict.level]}", None)
    return AdaptiveResolution(selection, trials)
