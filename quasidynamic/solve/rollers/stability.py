"""Stability of an equilibrium: growth rates of small disturbances of cage and spins."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.unknowns import CAGE
from quasidynamic.solve.rollers import bordered_system
from quasidynamic.solve.rollers.pseudo_time import scaled_inertia


def growth_rates(balance: BearingBalance, system: Linearisation) -> NDArray:
    r"""Eigenvalues of cage and spins with their inertias, at an equilibrium of one case.

    Ring, approaches, tilts and films follow at once, as in pseudo-time: with the inertias M of cage
    and spins, and S what is left of the Jacobian J for them when everything else is eliminated,

    .. math:: M \dot x = S x,\qquad \lambda v = M^{-1} S v

    S is not formed: its inverse is the block of the inverse of J, so that the eigenvalues of
    (J^-1)_{dd} M are 1 / lambda. The equilibrium is stable when every real part is negative; one
    real eigenvalue passes through zero at a fold.

    Parameters
    ----------
    balance : BearingBalance
        of one case
    system : Linearisation
        at the equilibrium

    Returns
    -------
    array (Z + 1), complex
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
    unit = np.zeros((1, balance.layout.size, len(moving)))
    unit[0, moving, range(len(moving))] = 1.0
    inverse = bordered_system.solve(balance, system, unit)[0, moving]
    if not np.isfinite(inverse).all():
        return np.full(len(moving), np.nan, complex)
    return 1.0 / np.linalg.eigvals(inverse * scaled_inertia(balance)[0, moving]).astype(complex)
