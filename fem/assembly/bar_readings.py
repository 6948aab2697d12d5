r"""Load vectors that read the section forces of a bar of a squirrel cage from a displacement.

Nothing loads a bar between its ends: its axial force N and torque T are the same all along it, its moments
straight lines. So means over the bar, with weights w that vanish at both ends,

.. math:: N = \int \sigma_x\,w\,dV, \quad M_n = \int \sigma_x (n - n_0)\,w\,dV, \quad
          M_t = \int \sigma_x\,t\,w\,dV, \quad T = \int (t\,\sigma_{xn} - (n - n_0)\,\sigma_{xt})\,w\,dV

are exact for feet of any shape, and stay away from the stress at the feet.

Source
------
Equilibrium of a bar that is loaded at its ends only; derived here.
"""

from math import pi

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly.elasticity import lame_constants, strain
from fem.mesh.solid import MILLIMETRES
from fem.parts.bar_section import bar_section
from fem.parts.squirrel_cage import SquirrelCage

MEAN = 30.0  # over the integral of xi^2 (1 - xi)^2 from 0 to 1
SLOPE = 840.0  # over that of (xi - 1/2)^2 xi^2 (1 - xi)^2


def bar_readings(space, cage: SquirrelCage, half: bool) -> NDArray:
    """Load vectors (unknowns, 6) of the bar at azimuth 0, (unknowns, 12) with bars at both ends [N/m, N m/m].

    They are N, M_n at the ring and at the flange, M_t at both, T about +x, signs as in
    `fem.squirrel_cage.bar_forces`. With `half` the mesh holds half of that bar only, t >= 0, and a field that
    is its own mirror image (the first three), or the negative of it (the last three).
    """
    return np.hstack([_at_end(space, cage, half, end) for end in cage.ends])


def _at_end(space, cage: SquirrelCage, half: bool, end: int) -> NDArray:
    """Load vectors (unknowns, 6) of the bar at one end of the ring, with x from there."""
    length, start = cage.bar_length * MILLIMETRES, cage.end_distance(end) * MILLIMETRES
    xi = (end * ngs.x - start) / length
    bump = xi**2 * (1 - xi) ** 2
    mean, slope = MEAN * bump, SLOPE * (xi - 0.5) * bump
    n, t = ngs.z / MILLIMETRES - bar_section(cage).centre, ngs.y / MILLIMETRES
    v = space.TestFunction()
    lame, shear = lame_constants(cage.elastic.youngs_modulus, cage.elastic.poisson_ratio)
    e = MILLIMETRES * strain(v)
    tension = 2 * shear * e[0, 0] + lame * ngs.Trace(e)
    twist = end * 2 * shear * (t * e[0, 2] - n * e[0, 1])
    near, far = mean - slope / 2, mean + slope / 2
    forms = (
        tension * mean, tension * n * near, tension * n * far, tension * t * near, tension * t * far,
        twist * mean,
    )  # fmt: skip
    # forms are integrated over the length in millimetres of a section in square ones
    nearest = ngs.IfPos((pi / cage.bars) ** 2 - ngs.atan2(ngs.y, ngs.z) ** 2, 1.0, 0.0)  # bar at azimuth 0
    scale = (2.0 if half else nearest) / (length * MILLIMETRES**2)
    if cage.two_sided:
        scale = scale * ngs.IfPos(end * ngs.x, 1.0, 0.0)
    where = ngs.dx(definedon=space.mesh.Materials("bars"))
    vectors = [ngs.LinearForm(scale * form * where).Assemble().vec.FV().NumPy().copy() for form in forms]
    return np.stack(vectors, axis=1)
