"""Derivatives of an equilibrium by parameters: implicit differentiation, nothing is solved again."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.unknowns import Unknowns
from quasidynamic.solve.rollers import bordered_system


def residuals(balance: BearingBalance, unknowns: Unknowns) -> NDArray:
    """Residuals (C, N) in SI units of C cases at the same unknowns of one case.

    Scales depend on load and speed: only in SI units do residuals of different cases compare.
    """
    scaled = balance.layout.joined(unknowns) / balance.scales.unknown
    return balance.evaluate(scaled).residual * balance.scales.residual


def moved_unknowns(balance: BearingBalance, system: Linearisation, by_parameter: NDArray) -> NDArray:
    r"""Derivatives of the unknowns of an equilibrium by P parameters.

    .. math:: \frac{dx}{dp} = -J^{-1} \frac{\partial F}{\partial p}

    Parameters
    ----------
    balance : BearingBalance
        of one case
    system : Linearisation
        its derivatives J at the equilibrium
    by_parameter : array (N, P)
        derivatives of the residuals at fixed unknowns, both in SI units

    Returns
    -------
    array (N, P)
        in SI units; not a number where the matrix is singular, as on a fold

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
    """Approaches (C, 2, Z, K) [m] of the slices of rollers to both raceways, negative in a gap.

    Parameters
    ----------
    balance : BearingBalance
        of C cases
    scaled : array (C, N)
        unknowns
    """
    raceways = balance.roller.raceways
    approach = raceways.slices.spread(balance.approach(balance.unpack(scaled)).swapaxes(0, 1))
    return (approach - raceways.drop).transpose(2, 1, 3, 0)


def nearest_switch(approach: NDArray, by_parameter: NDArray) -> NDArray:
    """Smallest change of each parameter (P) after which some slice opens or closes, linearly, >= 0.

    Parameters
    ----------
    approach : array (n)
        of slices [m]
    by_parameter : array (P, n)
        its derivatives
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        change = np.abs(approach / by_parameter)
    return np.where(np.isnan(change), np.inf, change).min(axis=1)
