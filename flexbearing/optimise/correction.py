r"""Designs of a cheap model, corrected so that at one of them outputs and derivatives are those of the case.

Of an output y_c of the cheap model, with y of the case of the same sign at the design s_0 (shares of the
ranges),

.. math:: y \approx y_c(s) \, \frac{y}{y_c}\bigg|_0
          \exp\left[\left(\frac{\nabla y}{y} - \frac{\nabla y_c}{y_c}\right)_0 \cdot (s - s_0)\right]

and otherwise the difference of both is added, to first order.

Source
------
Chang, Haftka, Giles and Kao (1991), NASA TM-104042: scaling by values and sensitivities; here of
logarithms, which keep the sign far from s_0.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from flexbearing.optimise.evaluations import NotComputed, Point
from flexbearing.optimise.goals import DesignProblem, Numbers
from flexbearing.optimise.search import Designs


@dataclass(frozen=True)
class Corrected:
    """A cheap model that is searched in place of the case."""

    cheap: Designs
    case: Designs  # whose goal and bounds are wanted
    point: Point  # of the design at which both agree
    there: Numbers  # of the case at that design; without slopes only values agree

    @property
    def wanted(self) -> DesignProblem:
        """What is searched: that of the case."""
        return self.case.wanted

    def values(self, points: Sequence[Point]) -> list[Numbers | NotComputed]:
        """Corrected outputs of designs."""
        found = self.cheap.values(points)
        return [
            each if isinstance(each, NotComputed) else self._corrected(point, each)
            for point, each in zip(points, found, strict=True)
        ]

    def at(self, point: Point) -> Numbers:
        """Corrected outputs of a design with their derivatives."""
        return self._corrected(point, self.cheap.at(point))

    def _corrected(self, point: Point, numbers: Numbers) -> Numbers:
        step, slopes = self._shares(point) - self._shares(self.point), {}
        values = {}
        for text, cheap in numbers.values.items():
            by = None if numbers.slopes is None else numbers.slopes[text]
            values[text], slopes[text] = self._corrections[text].applied(step, cheap, by)
        return Numbers(values, None if numbers.slopes is None else slopes)

    def _shares(self, point: Point) -> NDArray:
        return np.array([each.share(value) for each, value in zip(self.wanted.variables, point, strict=True)])

    @cached_property
    def _corrections(self) -> "dict[str, Correction]":
        """By the texts of outputs."""
        if self.there.slopes is None:
            (cheap,) = self.cheap.values([self.point])
            if isinstance(cheap, NotComputed):
                raise cheap
            unchanged = (1, len(self.wanted.variables))
            slopes = {text: (np.zeros(unchanged), np.zeros(unchanged)) for text in cheap.values}
        else:
            cheap = self.cheap.at(self.point)
            assert cheap.slopes is not None
            slopes = {text: (cheap.slopes[text], by_case) for text, by_case in self.there.slopes.items()}
        return {
            text: Correction.between(before, self.there.values[text], slopes[text])
            for text, before in cheap.values.items()
        }


@dataclass(frozen=True)
class Correction:
    """Of an output in R rows: its ratio or its difference, and the change of that by K shares."""

    alike: NDArray  # (R) whether both models have it, above zero or below: then their ratio counts
    size: NDArray  # (R) of the ratio or of the difference
    change: NDArray  # (R, K) of the ratio's logarithm, or of the difference

    @classmethod
    def between(cls, cheap: NDArray, case: NDArray, slopes: tuple[NDArray, NDArray]) -> "Correction":
        """What leads from values (R) of a cheap model to those of the case; slopes (R, K) of both."""
        alike = cheap * case > 0
        one, other = np.where(alike, cheap, 1.0), np.where(alike, case, 1.0)
        size = np.where(alike, other / one, case - cheap)
        change = np.where(
            alike[:, None], slopes[1] / other[:, None] - slopes[0] / one[:, None], slopes[1] - slopes[0]
        )
        return cls(alike, size, change)

    def applied(self, step: NDArray, values: NDArray, slopes: NDArray | None) -> tuple[NDArray, NDArray]:
        """Corrected values (R) and slopes (R, K) at a step (K) of the shares; NaN for slopes not given."""
        by = np.full(self.change.shape, np.nan) if slopes is None else slopes
        moved, several = self.change @ step, self.alike[:, None]
        factor = np.where(self.alike, self.size * np.exp(np.where(self.alike, moved, 0.0)), 1.0)
        by_ratio = factor[:, None] * (by + values[:, None] * self.change)
        corrected = np.where(self.alike, factor * values, values + self.size + moved)
        return corrected, np.where(several, by_ratio, by + self.change)
