r"""Roller loads on the raceway band: generalised forces to load vectors and back.

Roller j presses with :math:`p_m(s, x) = \frac{2m+1}{l} L_m(2x/l)\, g(s)` per unit generalised force,
g a Gaussian along the arc s = R (phi - phi_j) with unit integral, in the fixed direction
n_j = (0, sin phi_j, cos phi_j). A line load q(x) [N/m] has the generalised forces
:math:`F_m = \int q\,L_m(2x/l)\,dx` [N], F_0 its resultant and F_1 = 2 M/l with its moment M.
The same pattern reads displacements, so that w_m works on F_m.
"""

from dataclasses import dataclass
from functools import cached_property
from math import ceil

import ngsolve as ngs
import numpy as np
from ngsolve.comp import IntegrationRuleSpaceSurface
from numpy.polynomial import legendre
from numpy.typing import NDArray
from scipy import sparse

from fem.errors import NotSolved
from fem.mesh.solid import MILLIMETRES
from fem.parts.groove import BallPatches
from fem.parts.material import in_mm
from fem.parts.rings import MeshSize, Patches

REACH = 8.0  # standard deviations; a Gaussian has 1e-14 of its peak there
HIGHEST_ORDER = 15  # above it NGSolve 6.2.2608 pairs points and shape functions wrongly, in silence
UNRESOLVED = 1e-2  # allowed relative error of the integrals of a patch before they are normalised


@dataclass(frozen=True)
class Band:
    """The raceway band as weighted points, in SI units, with its link to the unknowns."""

    x: NDArray  # (points,) axial [m]
    azimuth: NDArray  # (points,) from z towards y [rad]
    area: NDArray  # (points,) quadrature weights [m^2]
    radii: NDArray  # (points,) distance from the axis [m]
    along_x: sparse.csr_array  # (points, unknowns) area times shape function of the x-displacement
    along_y: sparse.csr_array  # (points, unknowns) likewise for y
    along_z: sparse.csr_array  # (points, unknowns) likewise for z

    @cached_property
    def radius(self) -> float:
        """Mean distance from the axis [m]."""
        return float(np.average(self.radii, weights=self.area))

    def forces(self, y, z):
        """Load vectors [N] of tractions [Pa] on the band along y and z, both (points, ...), dense or sparse.

        Their product with a displacement [m] is the work of the traction.
        """
        return self.along_y.T @ y + self.along_z.T @ z


def band(space, raceway: str, order: int) -> Band:
    """Quadrature on the boundary `raceway` of a mesh in millimetres.

    It is exact for polynomials of `order` on a flat element.
    """
    points = IntegrationRuleSpaceSurface(space.mesh, order=order)
    dA = ngs.ds(definedon=space.mesh.Boundaries(raceway), intrules=points.GetIntegrationRules())
    q, u = points.TestFunction(), space.TrialFunction()

    def moments(field):  # a point's weight times the field there
        return ngs.LinearForm(field * q * dA).Assemble().vec.FV().NumPy().copy()

    def shapes(component):
        form = ngs.BilinearForm(trialspace=space, testspace=points)
        form += u.Trace()[component] * q * dA
        values, columns, starts = form.Assemble().mat.CSR()
        rows = sparse.csr_array((values, columns, starts), shape=(points.ndof, space.ndof))[inside]
        rows.eliminate_zeros()
        return rows / MILLIMETRES**2

    area = moments(ngs.CF(1))
    inside = area > 0
    x, y, z = (moments(c)[inside] / area[inside] / MILLIMETRES for c in (ngs.x, ngs.y, ngs.z))
    return Band(
        x=x, azimuth=np.arctan2(y, z), area=area[inside] / MILLIMETRES**2, radii=np.hypot(y, z),
        along_x=shapes(0), along_y=shapes(1), along_z=shapes(2),
    )  # fmt: skip


def quadrature_order(patches: Patches | BallPatches, mesh: MeshSize) -> int:
    """Order that resolves a Gaussian on elements of the raceway, as far as `HIGHEST_ORDER` allows."""
    return min(2 * mesh.order + ceil(5 * mesh.raceway_size / patches.width), HIGHEST_ORDER)


def roller_forces(band: Band, patches: Patches) -> sparse.csc_array:
    """Load vectors (unknowns, Z M) of unit generalised forces [N/N], which also read such displacements.

    Roller by roller; resultant and moments are exact on the mesh.
    Raises `NotSolved` if the band is too coarse for the Gaussian.
    """
    return sparse.csc_array(band.forces(*tractions(band, patches)))


def tractions(band: Band, patches: Patches) -> tuple[sparse.csr_array, sparse.csr_array]:
    """Tractions (points, Z M) of unit generalised forces along y and z [Pa/N], roller by roller.

    Raises `NotSolved` if the band is too coarse for the Gaussian.
    """
    columns = [_pressure(band, patches, phi) for phi in patches.azimuths]
    pressure = sparse.hstack(columns, format="csr")
    phi = np.repeat(patches.azimuths, patches.axial_modes)
    return pressure * np.sin(phi), pressure * np.cos(phi)


def _pressure(band: Band, patches: Patches, azimuth: float) -> sparse.csr_array:
    """Pressure [Pa/N] of the M unit patterns of one roller, sparse (points, M)."""
    arc = band.radius * np.angle(np.exp(1j * (band.azimuth - azimuth)))
    near = np.flatnonzero(np.abs(arc) < REACH * patches.width)
    gauss = np.exp(-((arc[near] / patches.width) ** 2) / 2) / (patches.width * np.sqrt(2 * np.pi))
    shapes = legendre.legvander(2 * band.x[near] / patches.length, patches.axial_modes - 1)
    unit = _normalised(shapes, gauss * band.area[near], patches)
    row = np.repeat(near, patches.axial_modes)
    column = np.tile(np.arange(patches.axial_modes), near.size)
    values = gauss[:, None] * unit
    return sparse.csr_array((values.ravel(), (row, column)), shape=(band.x.size, patches.axial_modes))


def _normalised(shapes: NDArray, weight: NDArray, patches: Patches) -> NDArray:
    """Combine L_m to patterns whose generalised forces on this quadrature are the unit matrix.

    On an exact quadrature the result is (2m + 1)/l L_m; the difference measures the quadrature.
    """
    gram = shapes.T @ (weight[:, None] * shapes)
    exact = patches.length / (2 * np.arange(patches.axial_modes) + 1)
    error = np.abs(gram - np.diag(exact)).max() / patches.length
    if not error <= UNRESOLVED:
        raise NotSolved(
            f"patch integrals are {error:.2g} wrong, allowed {UNRESOLVED:g}: "
            f"width {in_mm(patches.width)} is too narrow for this mesh of the raceway"
        )
    return shapes @ np.linalg.inv(gram)


def translation_forces(band: Band) -> NDArray:
    r"""Load vectors that read the mean rigid translation of the band.

    .. math:: t = G^{-1} \int u_r\,e\,dA, \quad G = \int e\,e^T dA, \quad e = (\sin\varphi, \cos\varphi)

    which is (2/A) times the integral on a whole circle, and exact for a rigid translation on any mesh.

    An array (unknowns, 2) [N/N] for y and z; as loads they are radial pressures of unit resultant, like
    cos(phi).

    Source
    ------
    Least-squares fit of a rigid motion to the displacement of the band; derived here.
    """
    e = np.stack([np.sin(band.azimuth), np.cos(band.azimuth)], axis=1)
    G = e.T @ (band.area[:, None] * e)
    pressure = e @ np.linalg.inv(G)
    return band.forces(pressure * e[:, :1], pressure * e[:, 1:])
