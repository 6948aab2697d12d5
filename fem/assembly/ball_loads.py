r"""Loads of balls on the groove of a solid: normal Gaussian patches at stations, which also read it.

Ball j presses station k along the normals of the groove with a pressure

.. math:: p_{jk} \propto \frac{1}{R}\,
          e^{-(R_k^2 (\varphi - \varphi_j)^2 + r^2 (\alpha - \alpha_k)^2)/2\sigma^2}

R being the distance from the axis, :math:`R_k` that of the station, r the radius of the groove. It is divided
so that it reads a rigid motion along the normal at the station, as `fem.raceway.stations` on a section.

Source
------
The patch of `fem.section.revolved_body.station_modes` and its Fourier series, summed; derived here.
"""

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from fem.assembly.roller_loads import REACH, Band
from fem.errors import NotSolved
from fem.parts.groove import BallPatches, Groove
from fem.parts.material import in_mm

UNRESOLVED = 5e-2  # allowed relative error of the integral of a patch: 2 % are cut off two widths from an end


def ball_forces(band: Band, groove: Groove, patches: BallPatches) -> sparse.csc_array:
    """Load vectors (unknowns, Z K) of unit forces [N/N] on an outer groove, ball by ball.

    Raises `NotSolved` if the band is too coarse for the patches.
    """
    alpha = np.arctan2(band.x, band.radii - groove.centre_radius)
    places = [(phi, station) for phi in patches.azimuths for station in patches.stations.angles]
    pressure = sparse.hstack([_pressure(band, groove, patches, alpha, *each) for each in places], "csr")
    normal = np.sin(alpha), np.cos(alpha) * np.sin(band.azimuth), np.cos(alpha) * np.cos(band.azimuth)
    x, y, z = (sparse.csr_array(pressure * part[:, None]) for part in normal)
    return sparse.csc_array(band.along_x.T @ x + band.forces(y, z))


def _pressure(
    band: Band, groove: Groove, patches: BallPatches, alpha: NDArray, phi: float, station: float
) -> sparse.csr_array:
    """Pressure [Pa/N] of a unit force at an azimuth and a contact angle [rad], sparse (points, 1)."""
    width, outer = patches.width, groove.centre_radius + groove.radius * np.cos(station)
    turn = np.angle(np.exp(1j * (band.azimuth - phi)))
    near = np.flatnonzero(np.hypot(outer * turn, groove.radius * (alpha - station)) < REACH * width)
    turn, off = turn[near], alpha[near] - station
    gauss = np.exp(-((outer * turn / width) ** 2 + (groove.radius * off / width) ** 2) / 2) / band.radii[near]
    read = np.sum(gauss * np.cos(turn) * np.cos(off) * band.area[near])
    exact = 2 * np.pi * width**2 / outer * np.exp(-((width / outer) ** 2 + (width / groove.radius) ** 2) / 2)
    if not abs(read / exact - 1) <= UNRESOLVED:
        raise NotSolved(
            f"the integral of a patch is {read / exact - 1:.2g} wrong, allowed {UNRESOLVED:g}: "
            f"width {in_mm(width)} is too narrow for this mesh of the groove"
        )
    return sparse.csr_array((gauss / read, (near, np.zeros_like(near))), shape=(band.x.size, 1))
