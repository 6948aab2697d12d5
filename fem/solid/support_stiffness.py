"""Stiffness with which a part holds its raceway, taken as one rigid band."""

from dataclasses import dataclass

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly import roller_loads
from fem.assembly.factorisation import threads
from fem.mesh.solid import MILLIMETRES
from fem.solid.factored_solid import FactoredSolid

AXES = ("x", "y", "z", "about y", "about z")


@dataclass(frozen=True)
class SupportStiffness:
    """Mean motions of the raceway under unit forces and moments, in the order of `AXES`."""

    compliance: NDArray  # (5, 5) [m/N, m/(N m), rad/N, rad/(N m)] symmetric

    @property
    def stiffness(self) -> NDArray:
        """Forces and moments that keep all but one motion at zero (5, 5) [N/m, N/rad, N m/m, N m/rad]."""
        return np.linalg.inv(self.compliance)

    @property
    def radial(self) -> float:
        """Radial force over translation, mean of y and z; free to tilt [N/m]."""
        return float(2 / (self.compliance[1, 1] + self.compliance[2, 2]))

    @property
    def tilting(self) -> float:
        """Moment over tilt, mean of both directions; free to move [N m/rad]."""
        return float(2 / (self.compliance[3, 3] + self.compliance[4, 4]))

    @property
    def axial(self) -> float:
        """Axial force over translation [N/m]."""
        return float(1 / self.compliance[0, 0])


def support_stiffness(solid: FactoredSolid) -> SupportStiffness:
    """Stiffness of what holds a raceway, its band a rigid body on average.

    .. math:: C = P^T K^{-1} P

    with load patterns P that also read the motions, see `motion_forces`.

    Raises `NotSolved` if a residual is too large.

    Source
    ------
    Linear algebra: work of unit loads on the displacements they cause.
    """
    with threads(solid.thread_number):
        patterns = motion_forces(solid.space, solid.band)
        shifts = np.stack([solid.stiffness.solve(pattern) for pattern in patterns.T], axis=1)
    compliance = patterns.T @ shifts
    return SupportStiffness((compliance + compliance.T) / 2)


def motion_forces(space, band: roller_loads.Band) -> NDArray:
    r"""Load vectors that read the mean rigid motion of the band.

    .. math:: t_x = \frac{1}{A} \int u_x\,dA, \quad
              \theta_y = \frac{\int (z u_x - x u_z)\,dA}{\int (x^2 + z^2)\,dA}, \quad
              \theta_z = \frac{\int (x u_y - y u_x)\,dA}{\int (x^2 + y^2)\,dA}

    and translations across by radial pressures like sin and cos,
    `fem.assembly.roller_loads.translation_forces`. A moment thus comes by tractions that turn the band as a
    whole: rollers, which only press, also twist the section of a thin ring, and that is part of their
    compliance.

    An array (unknowns, 5) [N/N, N/(N m)] in the order of `AXES`, on the boundary "raceway" of a mesh in
    millimetres; exact for rigid motions as far as the curved mesh is round.

    Source
    ------
    Least-squares fit of a rigid motion to the displacement of the band; derived here.
    """
    x, y, z = ngs.x / MILLIMETRES, ngs.y / MILLIMETRES, ngs.z / MILLIMETRES
    axial, about_y, about_z = ((1, 0, 0), (z, 0, -x), (-y, x, 0))
    along, *tilts = (_pattern(space, ngs.CF(motion)) for motion in (axial, about_y, about_z))
    return np.column_stack([along, roller_loads.translation_forces(band), *tilts])


def _pattern(space, motion) -> NDArray:
    """Load vector that reads how much of a motion the raceway has."""
    raceway = space.mesh.Boundaries("raceway")
    share = motion * space.TestFunction().Trace() * ngs.ds(definedon=raceway)
    size = ngs.Integrate(motion * motion, space.mesh, definedon=raceway)
    return ngs.LinearForm(share).Assemble().vec.FV().NumPy() / size
