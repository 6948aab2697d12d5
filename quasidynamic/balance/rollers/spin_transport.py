"""Torque that rollers take as they change their spin on the way around the bearing."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

CREEP = 1e-4  # of the spin in pure rolling: cage speed below which it hardly moves


class SpinTransport(NamedTuple):
    """Torque taken by the change of spin, with its derivatives."""

    torque: NDArray  # (C, Z) [N m]
    by_spin: NDArray  # (C, 1) [N m s]
    by_before: NDArray  # (C, 1) by the spin of the roller before, counted positive [N m s]
    by_after: NDArray  # (C, 1) by that of the roller after, counted positive [N m s]
    by_cage: NDArray  # (C, Z) [N m s]


def spin_transport(
    spin_drift: NDArray, cage_speed: NDArray, rolling_spin: NDArray, inertia: float
) -> SpinTransport:
    r"""Torque by which the spin of rollers changes while they travel from place to place.

    .. math:: M_j = J \omega_c \frac{d\omega}{d\varphi} \approx
              \frac{J Z}{2\pi} [\omega_c^+ (\omega_j - \omega_{j-1}) + \omega_c^- (\omega_j - \omega_{j+1})]

    with omega_c^(+/-) = (sqrt(omega_c^2 + s^2) +/- omega_c)/2, s = `CREEP` times the spin in pure rolling.
    Upwind, from the roller that was here before; where the cage hardly moves both neighbours count, so that
    nothing jumps when it turns back.

    Parameters
    ----------
    spin_drift : array (C, Z)
        spins less that of pure rolling [rad/s]
    cage_speed : array (C, 1)
        omega_c [rad/s]
    rolling_spin : array (C, 1)
        spin in pure rolling [rad/s]
    inertia : float
        J of a roller about its axis [kg m2]

    Returns
    -------
    SpinTransport

    Source
    ------
    Change of angular momentum along the path of the rollers, upwind differences; derived here.

    Valid
    -----
    First order in the pitch: spins are smeared over about a pitch at the ends of the loaded zone.
    """
    half = inertia * spin_drift.shape[1] / (4 * np.pi)
    size = np.sqrt(cage_speed**2 + (CREEP * rolling_spin) ** 2)
    before, after = half * (size + cage_speed), half * (size - cage_speed)
    around = np.concatenate([spin_drift[:, -1:], spin_drift, spin_drift[:, :1]], axis=1)
    change = around[:, 1:] - around[:, :-1]  # from each roller's neighbour before to the one after the last
    gained, lost = before * change[:, :-1], after * change[:, 1:]
    return SpinTransport(
        torque=gained - lost,
        by_spin=2 * half * size,
        by_before=before,
        by_after=after,
        by_cage=(gained + lost) / size,
    )
