"""The balance of one case, its elastic raceways included, over the logarithm of its load or speed."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.operating_points import OperatingPoints
from quasidynamic.balance.rollers.unknowns import CAGE, TILT_Z, Unknowns, Y, Z
from quasidynamic.solve.arclength import LinearisedEquations
from quasidynamic.solve.rollers import bordered_system
from quasidynamic.solve.rollers.newton import bounded

Compliance = tuple[NDArray | None, NDArray | None]
# Compliance (Z, M, Z, M) [m/N] of both raceways near roller forces (2, Z, M) [N], and their deviations
# (2, Z, M) [m] at no load when that tangent is followed back; None where there are none.
Tangents = Callable[[NDArray], tuple[Compliance, NDArray | None]]

DIFFERENCE = 1e-5  # of the parameter
RESIDUAL_TOLERANCE = 1e-10  # residual, of the reference force or of the largest roller load if that is larger
RING_SIZE = 30.0  # scaled ring displacement that counts like a slip of one: 0.6 % of a roller's diameter
TILT_SIZE = 10.0  # the same for tilts: 10 milliradians


def between(
    balance: BearingBalance, compliance: Compliance, deviation: NDArray | None = None
) -> BearingBalance:
    """The same balance between raceways of a compliance (Z, M, Z, M) [m/N] and a shape at no load [m]."""
    size = balance.layout.rollers * balance.roller.axial_modes
    inner, outer = (None if matrix is None else matrix.reshape(size, size) for matrix in compliance)
    return replace(balance, compliance=(inner, outer), deviation=deviation)


def slip_weight(balance: BearingBalance) -> NDArray:
    """Weights (N): slip of the cage, mean slip of the spins, ring; approaches and films follow these."""
    weight = np.zeros(balance.layout.size)
    weight[[Y, Z]] = RING_SIZE**-2
    weight[TILT_Z:CAGE] = TILT_SIZE**-2
    weight[CAGE] = 1.0
    weight[balance.layout.field(-1)] = 1.0 / balance.layout.rollers
    return weight


@dataclass(frozen=True)
class ParametricBalance:
    """Balance of one case; a parameter says which operating point it is.

    Deviations among the unknowns of elastic raceways are whole ones, those at no load included.
    """

    balance: BearingBalance
    points: Callable[[float], OperatingPoints]  # of one case
    tangents: Tangents | None = None  # of raceways that are not rigid

    @property
    def weight(self) -> NDArray:
        """Weights (N) of `slip_weight`."""
        return slip_weight(self.balance)

    def balance_at(self, parameter: float) -> BearingBalance:
        """Balance at a parameter."""
        return replace(self.balance, points=self.points(parameter))

    def near(self, state: NDArray, parameter: float) -> tuple[BearingBalance, NDArray]:
        """Balance at a parameter with raceways that are linear near a state (N); the state in its terms."""
        balance = self.balance_at(parameter)
        if self.tangents is None:
            return balance, state
        force = balance.evaluate(state[None]).state.contact.force[:, :, 0]
        linear = between(balance, *self.tangents(np.moveaxis(force, 1, -1)))
        if linear.deviation is None:
            return linear, state
        whole = balance.unpack(state[None])
        by_load = whole.deviation - np.moveaxis(linear.deviation, -1, 1)[:, :, None]
        return linear, linear.pack(whole._replace(deviation=by_load))[0]

    def at(self, state: NDArray, parameter: float) -> LinearisedEquations:
        """Scaled residual and its derivatives."""
        balance, near = self.near(state, parameter)
        system = balance.evaluate(near[None])
        by_parameter = (
            self._forces(balance, near, parameter + DIFFERENCE)
            - self._forces(balance, near, parameter - DIFFERENCE)
        ) / (2 * DIFFERENCE * balance.scales.residual[0])
        return LinearisedEquations(
            residual=system.residual[0],
            by_parameter=by_parameter,
            solve=lambda right: bordered_system.solve(balance, system, right[None])[0],
            converged=bool(np.abs(system.residual).max() <= RESIDUAL_TOLERANCE * system.loading[0]),
        )

    def _forces(self, balance: BearingBalance, state: NDArray, parameter: float) -> NDArray:
        """Residual (N) in SI units."""
        balance = replace(balance, points=self.points(parameter))
        return (balance.evaluate(state[None]).residual * balance.scales.residual)[0]

    def bounded(self, before: NDArray, after: NDArray) -> NDArray:
        """Keep films and approaches of a step positive."""
        return bounded(self.balance, before[None], after[None])[0]


def residuals(balance: BearingBalance, unknowns: Unknowns) -> NDArray:
    """Residuals (C, N) in SI units of C cases at the same unknowns of one case.

    Scales depend on load and speed: only in SI units do residuals of different cases compare.
    """
    scaled = balance.layout.joined(unknowns) / balance.scales.unknown
    return balance.evaluate(scaled).residual * balance.scales.residual


def moved_unknowns(balance: BearingBalance, system: Linearisation, by_parameter: NDArray) -> NDArray:
    r"""Derivatives of the unknowns of an equilibrium by P parameters.

    .. math:: \frac{dx}{dp} = -J^{-1} \frac{\partial F}{\partial p}

    J are those at the equilibrium of one case, `by_parameter` (N, P) derivatives of the residuals at fixed
    unknowns, and all are in SI units; not a number where the matrix is singular, as on a fold.

    Source
    ------
    The implicit function theorem; one elimination serves all parameters.

    Valid
    -----
    On the side of a contact switch on which the derivatives J were taken.
    """
    right = -by_parameter / balance.scales.residual[0][:, None]
    return bordered_system.solve(balance, system, right[None])[0] * balance.scales.unknown[0][:, None]


def slice_approaches(balance: BearingBalance, scaled: NDArray) -> NDArray:
    """Approaches (C, 2, Z, K) [m] of the slices of rollers to both raceways, negative in a gap."""
    raceways = balance.roller.raceways
    approach = raceways.slices.spread(balance.approach(balance.unpack(scaled)).swapaxes(0, 1))
    return (approach - raceways.drop).transpose(2, 1, 3, 0)


def nearest_switch(approach: NDArray, by_parameter: NDArray) -> NDArray:
    """Smallest change of each parameter (P) after which some slice opens or closes, linearly, >= 0."""
    with np.errstate(divide="ignore", invalid="ignore"):
        change = np.abs(approach / by_parameter)
    return np.where(np.isnan(change), np.inf, change).min(axis=1)
