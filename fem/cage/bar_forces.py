"""Section forces of the bars of a squirrel cage, with the nominal stress that beam theory makes of them.

At a sharp foot of a bar the stress itself has no finite value; section forces have, on any mesh.
"""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray

from fem.mesh.solid import MILLIMETRES
from fem.parts.rings import ImpossiblePart, SquirrelCage
from fem.solid.fields import LoadedSolid

POINTS = 6  # of the Gauss rule along each side of a section
QUARTERS = (0.25, 0.75)  # of the bar: away from its feet, where plane sections stay plane


@dataclass(frozen=True, kw_only=True)
class BarForces:
    """What the bars carry at their two ends: at the ring, at the flange."""

    azimuths: NDArray  # (B,) [rad]
    axial: NDArray  # (B,) [N] tension positive
    radial_moment: NDArray  # (B, 2) [N m] bends the bar radially, positive: tension outside
    tangential_moment: NDArray  # (B, 2) [N m] bends it tangentially, positive: tension at larger azimuth
    length: float  # [m]
    stress: NDArray  # (B, 2) [Pa] largest nominal normal stress of the section, by magnitude

    @property
    def radial_shear(self) -> NDArray:
        """Outward force on the end at the ring (B,) [N]."""
        return (self.radial_moment[:, 1] - self.radial_moment[:, 0]) / self.length

    @property
    def tangential_shear(self) -> NDArray:
        """Force towards larger azimuth on the end at the ring (B,) [N]."""
        return (self.tangential_moment[:, 1] - self.tangential_moment[:, 0]) / self.length


def bar_forces(state: LoadedSolid) -> BarForces:
    r"""Section forces of all bars, and the nominal stress at the corners of their ends.

    .. math:: N = \int \sigma_x\,dA, \quad M_n = \int \sigma_x (n - n_0)\,dA, \quad
              M_t = \int \sigma_x t\,dA, \quad
              \sigma = \frac{N}{A} + \frac{M_n}{I_n}(n - n_0) + \frac{M_t}{I_t} t

    Nothing loads a bar between its ends, so moments are straight lines through those at a quarter and
    three quarters of its length.

    Parameters
    ----------
    state : LoadedSolid
        a squirrel cage under its rollers

    Returns
    -------
    BarForces

    Raises
    ------
    ImpossiblePart
        if the part has no bars

    Source
    ------
    Beam theory, e.g. Timoshenko, Strength of Materials, part I.

    Valid
    -----
    Bars a few times longer than thick; without the stress concentration of feet and fillets.
    """
    cage = state.part
    if not isinstance(cage, SquirrelCage):
        raise ImpossiblePart(f"{type(cage).__name__} has no bars")
    azimuths = 2 * np.pi * np.arange(cage.bars) / cage.bars
    t, n, area = _section(cage)
    A, centre = area.sum(), area @ n / area.sum()
    lever = np.stack([np.ones_like(t), n - centre, t])
    x = cage.width / 2 + np.array(QUARTERS) * cage.bar_length
    tension = _tension(state, x, azimuths, t, n)  # (B, 2, points)
    axial, *moments = np.moveaxis(tension @ (lever * area).T, -1, 0)
    near, far = (np.array([1.5, -0.5]), np.array([-0.5, 1.5]))
    radial, tangential = (np.stack([m @ near, m @ far], axis=1) for m in moments)
    inertia = (lever[1:] ** 2) @ area
    side = cage.bar_width / 2 * np.array([-1.0, 0.0, 1.0])
    corner_n, corner_t = np.concatenate(_sides(cage, side)) - centre, np.tile(side, 2)  # largest stress
    stress = (
        axial.mean(axis=1)[:, None, None] / A
        + radial[:, :, None] / inertia[0] * corner_n
        + tangential[:, :, None] / inertia[1] * corner_t
    )
    return BarForces(
        azimuths=azimuths, axial=axial.mean(axis=1), radial_moment=radial, tangential_moment=tangential,
        length=cage.bar_length, stress=np.abs(stress).max(axis=2),
    )  # fmt: skip


def _section(cage: SquirrelCage) -> tuple[NDArray, NDArray, NDArray]:
    """Gauss points t, n (points,) [m] of a bar at azimuth 0, tangential and radial, and weights [m^2]."""
    node, weight = leggauss(POINTS)
    t = cage.bar_width / 2 * node
    low, high = _sides(cage, t)
    half = (high - low) / 2
    n = (low + high)[:, None] / 2 + half[:, None] * node
    area = cage.bar_width / 2 * weight[:, None] * half[:, None] * weight
    return np.repeat(t, POINTS), n.ravel(), area.ravel()


def _sides(cage: SquirrelCage, t) -> tuple[NDArray, NDArray]:
    """Where a bar begins and ends radially [m], beside its middle by t [m]."""
    inner, outer = cage.bar_radii
    return np.sqrt(inner**2 - t**2), np.sqrt(outer**2 - t**2)


def _tension(state: LoadedSolid, x: NDArray, azimuths: NDArray, t: NDArray, n: NDArray) -> NDArray:
    """Axial stress (B, sections, points) [Pa]."""
    s, c = np.sin(azimuths)[:, None], np.cos(azimuths)[:, None]
    y, z = n * s + t * c, n * c - t * s  # (B, points)
    shape = len(azimuths), len(x), len(t)
    x, y, z = (np.broadcast_to(a, shape).ravel() * MILLIMETRES for a in (x[:, None], y[:, None], z[:, None]))
    return state.stress[0, 0](state.mesh(x, y, z)).reshape(shape)
