"""Section forces of bars as integrals of the stress of a whole solid over two sections of each."""

import numpy as np
from numpy.polynomial.legendre import leggauss

from fem.parts.bar_section import bar_section
from fem.squirrel_cage.bar_forces import BarForces

POINTS = 6  # of the Gauss rule along each side of a section
QUARTERS = (0.25, 0.75)  # of the bar: away from its feet, where plane sections stay plane
MILLIMETRES = 1e3


def bars_of(state):
    """`BarForces` of a loaded solid: moments are straight lines through those at two sections."""
    cage = state.part
    azimuths = 2 * np.pi * np.arange(cage.bars) / cage.bars
    node, weight = leggauss(POINTS)
    side = cage.bar_width / 2 * node
    low, high = (np.sqrt(r**2 - side**2) for r in cage.bar_radii)
    half = (high - low) / 2
    n = ((low + high)[:, None] / 2 + half[:, None] * node).ravel()
    t = np.repeat(side, POINTS)
    area = (cage.bar_width / 2 * weight[:, None] * half[:, None] * weight).ravel()
    centre = area @ n / area.sum()
    x = cage.width / 2 + np.array(QUARTERS) * cage.bar_length
    s, c = np.sin(azimuths)[:, None], np.cos(azimuths)[:, None]
    y, z = n * s + t * c, n * c - t * s
    shape = len(azimuths), len(x), len(t)
    places = [np.broadcast_to(a, shape).ravel() * MILLIMETRES for a in (x[:, None], y[:, None], z[:, None])]
    sigma = state.stress(state.mesh(*places)).reshape(*shape, 3, 3)
    s, c = s[:, None], c[:, None]
    on_n, on_t = (sigma[..., 0, 1] * a + sigma[..., 0, 2] * b for a, b in ((s, c), (c, -s)))
    axial, radial, tangential = (sigma[..., 0, 0] @ (lever * area) for lever in (1 + 0 * t, n - centre, t))
    torque = (on_n * t - on_t * (n - centre)) @ area
    ends = np.array([[1.5, -0.5], [-0.5, 1.5]])
    return BarForces(
        azimuths=azimuths, axial=axial.mean(axis=1), radial_moment=radial @ ends,
        tangential_moment=tangential @ ends, torque=torque.mean(axis=1),
        length=cage.bar_length, section=bar_section(cage),
    )  # fmt: skip
