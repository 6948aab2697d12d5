"""Stability of an equilibrium: growth rates of small disturbances of cage and spins."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.unknowns import CAGE
from quasidynamic.solve.rollers import bordered_system
from quasidynamic.solve.rollers.pseudo_time import scaled_inertia


def growth_rates(balance: BearingBalance, system: Linearisation) -> NDArray:
    r"""Eigenvalues of cage and spins with their inertias, at equilibria of C cases.

    Ring, approaches, tilts and films follow at once, as in pseudo-time: with the inertias M of cage
    and spins, and S what is left of the Jacobian J for them when everything else is eliminated,

    .. math:: M \dot x = S x,\qquad \lambda v = M^{-1} S v

    S is not formed: its inverse is the block of the inverse of J, so that the eigenvalues of
    (J^-1)_{dd} M are 1 / lambda. The equilibrium is stable when every real part is negative; one
    real eigenvalue passes through zero at a fold.

    Parameters
    ----------
    balance : BearingBalance
        of C cases
    system : Linearisation
        at their equilibria

    Returns
    -------
    array (C, Z + 1), complex
        growth rates [1/s], negative real parts decay; not a number where the Jacobian is singular

    Source
    ------
    Linearised motion about an equilibrium; derived here.

    Valid
    -----
    Steady state seen from the cage: rollers pass from azimuth to azimuth, and the spin at an azimuth
    changes. The ring has no mass here: whirling is left out.
    """
    moving = np.concatenate([[CAGE], np.arange(balance.layout.size)[balance.layout.field(-1)]])
    unit = np.zeros((len(balance.points), balance.layout.size, len(moving)))
    unit[:, moving, range(len(moving))] = 1.0
    inverse = bordered_system.solve(balance, system, unit)[:, moving]
    regular = np.isfinite(inverse).all(axis=(1, 2))
    by_rate = inverse[regular] * scaled_inertia(balance)[regular][:, None, moving]
    rates = np.full(inverse.shape[:2], np.nan, complex)
    rates[regular] = 1.0 / np.linalg.eigvals(by_rate).astype(complex)
    return rates
