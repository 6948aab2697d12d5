"""Derivatives of a design's outputs: those at the equilibrium where there are some, else differences."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from flexbearing.optimise.evaluations import Evaluations, NotComputed, Point
from flexbearing.optimise.goals import DesignProblem, Numbers
from flexbearing.optimise.variables import Variable

STEP = 1e-3  # of the range of a variable
MESHED = 2e-2  # the same where another ring is meshed: outputs are smooth to some 1e-4 then
EXACT, CENTRAL, ONE_SIDED = "derivatives at the equilibrium", "central differences", "one-sided differences"


@dataclass
class Gradients:
    """Derivatives of the designs of a problem, and how each was found."""

    evaluations: Evaluations
    how: dict[str, str] = field(default_factory=dict)  # by the names of variables
    meshed: dict[str, bool] = field(default_factory=dict)  # whether another ring is meshed for a step

    @property
    def variables(self) -> tuple[Variable, ...]:
        """K of them."""
        return self.evaluations.problem.variables

    @property
    def wanted(self) -> DesignProblem:
        """What is searched."""
        evaluations = self.evaluations
        return DesignProblem(self.variables, evaluations.problem.search, evaluations.goal, evaluations.bounds)

    def values(self, points: Sequence[Point]) -> list[Numbers | NotComputed]:
        """Outputs of designs."""
        return self.evaluations.at(points)

    def at(self, point: Point) -> Numbers:
        """Outputs of a design with their derivatives by the shares of the variables.

        Raises `NotComputed` where the design, or one beside it on either side, has no result.
        """
        (numbers,) = self.evaluations.at([point])
        if isinstance(numbers, NotComputed):
            raise numbers
        columns = self._exact(point)
        rest = [each for each in self.variables if each.name not in columns]
        columns |= self._differences(point, rest, numbers)
        slopes = {
            text: np.array([columns[each.name][text] for each in self.variables]).T for text in numbers.values
        }
        return Numbers(numbers.values, slopes)

    def _exact(self, point: Point) -> dict[str, dict[str, NDArray]]:
        """Derivatives at the equilibrium, of the variables that have some."""
        keys = [
            each.key
            for each in self.variables
            if each.entry is None and each.key not in self.evaluations.refused
        ]
        found = self.evaluations.slopes(point, keys) if keys else {}
        columns = {}
        for each, value in zip(self.variables, point, strict=True):
            if each.entry is None and each.key in found:
                scale = each.size * each.by_share(value)
                columns[each.name] = {text: slope * scale for text, slope in found[each.key].items()}
                self.how.setdefault(each.name, EXACT)
        return columns

    def _differences(
        self, point: Point, wanted: Sequence[Variable], middle: Numbers
    ) -> dict[str, dict[str, NDArray]]:
        """Differences by the shares of some variables, all their designs side by side."""
        if not wanted:
            return {}
        stencils = [self._stencil(each, point) for each in wanted]
        designs = [
            self._moved(point, each, step)
            for each, steps in zip(wanted, stencils, strict=True)
            for step in steps
        ]
        answers = iter(self.evaluations.at(designs))
        columns = {}
        for each, steps in zip(wanted, stencils, strict=True):
            ends = {step: next(answers) for step in steps}
            known = {step: end for step, end in ends.items() if isinstance(end, Numbers)}
            if not known:
                raise NotComputed(str(next(iter(ends.values()))))
            columns[each.name] = self._column(each, point, middle, known)
        return columns

    def _column(
        self, variable: Variable, point: Point, middle: Numbers, known: dict[float, Numbers]
    ) -> dict[str, NDArray]:
        """Difference over the span of the designs that have a result."""
        there = point[self.variables.index(variable)]
        shares = {
            step: variable.share(self._moved(point, variable, step)[self.variables.index(variable)])
            for step in known
        }
        if len(known) == 2:
            (one, first), (other, last) = known.items()
            span, ends = shares[other] - shares[one], (first, last)
            self.how.setdefault(variable.name, CENTRAL)
        else:
            ((one, last),) = known.items()
            span, ends = shares[one] - variable.share(there), (middle, last)
            self.how.setdefault(variable.name, ONE_SIDED)
        return {text: (ends[1].values[text] - ends[0].values[text]) / span for text in middle.values}

    def _stencil(self, variable: Variable, point: Point) -> tuple[float, ...]:
        """Steps of the share, to both sides; to one where another ring would be meshed, or at a bound."""
        share = variable.share(point[self.variables.index(variable)])
        inward = -1.0 if share > 0.5 else 1.0
        if variable.name not in self.meshed:
            beside = self._moved(point, variable, inward * STEP)
            here, there = self.evaluations.rings([point, beside])
            self.meshed[variable.name] = here != there
        if self.meshed[variable.name]:
            return (inward * MESHED,)
        return (-STEP, STEP) if STEP <= share <= 1 - STEP else (inward * STEP,)

    def _moved(self, point: Point, variable: Variable, step: float) -> Point:
        place = self.variables.index(variable)
        value = variable.value(variable.share(point[place]) + step)
        return (*point[:place], value, *point[place + 1 :])
