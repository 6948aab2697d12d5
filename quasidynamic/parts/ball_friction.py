"""Friction coefficient of slow balls, measured against contact pressure."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import ImpossiblePart


@dataclass(frozen=True, kw_only=True)
class FrictionCurve:
    """Coulomb coefficients at some peak pressures, straight lines between them."""

    pressures: tuple[float, ...]  # [Pa] peak Hertz pressure, growing
    coefficients: tuple[float, ...]  # [-]

    def __post_init__(self):
        if not self.pressures or len(self.pressures) != len(self.coefficients):
            raise ImpossiblePart("friction: as many coefficients as pressures are needed, one at least")
        if not np.all(np.diff((0.0, *self.pressures)) > 0.0):
            raise ImpossiblePart(f"friction.pressures = {self.pressures} must be above zero and grow")
        if not all(0.0 < coefficient < float("inf") for coefficient in self.coefficients):
            raise ImpossiblePart(f"friction.coefficients = {self.coefficients} must be above zero")

    def at(self, pressure: NDArray) -> NDArray:
        """Coefficient [-] at a peak pressure [Pa]; outside the range that of its end, see `outside`."""
        return np.interp(pressure, self.pressures, self.coefficients)

    def outside(self, pressure: NDArray) -> NDArray:
        """Where a peak pressure [Pa] lies outside the measured range; nowhere for a single coefficient."""
        if len(self.pressures) == 1:
            return np.zeros(np.shape(pressure), bool)
        return (pressure < self.pressures[0]) | (pressure > self.pressures[-1])


def constant_friction(coefficient: float) -> FrictionCurve:
    """One coefficient [-] at any pressure."""
    return FrictionCurve(pressures=(1.0,), coefficients=(coefficient,))
