"""The balance of one case as equations that depend on the logarithm of its load or speed."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.operating_points import OperatingPoints
from quasidynamic.balance.rollers.unknowns import CAGE, TILT_Z, Y, Z
from quasidynamic.solve.arclength import LinearisedEquations
from quasidynamic.solve.rollers import bordered_system
from quasidynamic.solve.rollers.step_bounds import bounded

DIFFERENCE = 1e-5  # of the parameter
RESIDUAL_TOLERANCE = 1e-10  # residual, of the reference force or of the largest roller load if that is larger
RING_SIZE = 30.0  # scaled ring displacement that counts like a slip of one: 0.6 % of a roller's diameter
TILT_SIZE = 10.0  # the same for tilts: 10 milliradians


@dataclass(frozen=True)
class ParametricBalance:
    """Balance of one case between rigid raceways; a parameter says which operating point it is."""

    balance: BearingBalance
    points: Callable[[float], OperatingPoints]  # of one case

    @property
    def weight(self) -> NDArray:
        """Weights (N): slip of the cage, mean slip of the spins, ring; approaches and films follow these."""
        weight = np.zeros(self.balance.layout.size)
        weight[[Y, Z]] = RING_SIZE**-2
        weight[TILT_Z:CAGE] = TILT_SIZE**-2
        weight[CAGE] = 1.0
        weight[self.balance.layout.field(-1)] = 1.0 / self.balance.layout.rollers
        return weight

    def balance_at(self, parameter: float) -> BearingBalance:
        """Balance at a parameter."""
        return replace(self.balance, points=self.points(parameter))

    def at(self, state: NDArray, parameter: float) -> LinearisedEquations:
        """Scaled residual and its derivatives."""
        balance = self.balance_at(parameter)
        system = balance.evaluate(state[None])
        by_parameter = (
            self._forces(state, parameter + DIFFERENCE) - self._forces(state, parameter - DIFFERENCE)
        ) / (2 * DIFFERENCE * balance.scales.residual[0])
        return LinearisedEquations(
            residual=system.residual[0],
            by_parameter=by_parameter,
            solve=lambda right: bordered_system.solve(balance, system, right[None])[0],
            converged=bool(np.abs(system.residual).max() <= RESIDUAL_TOLERANCE * system.loading[0]),
        )

    def _forces(self, state: NDArray, parameter: float) -> NDArray:
        """Residual (N) in SI units."""
        balance = self.balance_at(parameter)
        return (balance.evaluate(state[None]).residual * balance.scales.residual)[0]

    def bounded(self, before: NDArray, after: NDArray) -> NDArray:
        """Keep films and approaches of a step positive."""
        return bounded(self.balance, before[None], after[None])[0]
