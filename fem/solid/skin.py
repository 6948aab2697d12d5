"""The outside of a loaded solid as triangles, for pictures."""

from dataclasses import dataclass

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.mesh.solid import MILLIMETRES
from fem.solid.fields import LoadedSolid
from fem.solid.stress import von_mises


@dataclass(frozen=True, kw_only=True)
class Skin:
    """Triangles on the outside of a solid; vertices are repeated, stress may differ between neighbours."""

    places: NDArray  # (triangles, 3, 3) [m] corners x, y, z before the load, outside when counter-clockwise
    displacement: NDArray  # (triangles, 3, 3) [m]
    von_mises: NDArray  # (triangles, 3) [Pa]


def skin(state: LoadedSolid, parts: int = 3) -> Skin:
    """Triangulate the outside.

    Parameters
    ----------
    state : LoadedSolid
        a solid under its rollers
    parts : int
        an element's edge is cut into, >= 1

    Returns
    -------
    Skin
    """
    mesh = state.mesh
    outside = _outside(mesh)
    places, corners = _triangles(parts)
    points = mesh.MapToAllElements(ngs.IntegrationRule(points=places, weights=[1.0] * len(places)), outside)
    mises = ngs.BoundaryFromVolumeCF(von_mises(state.smooth_stress)).Compile()

    def read(field):  # (triangles, 3, ...)
        values = field(points)
        return values.reshape(-1, len(places), values.shape[-1])[:, corners].reshape(-1, 3, values.shape[-1])

    place = read(ngs.CF((ngs.x, ngs.y, ngs.z))) / MILLIMETRES
    shift, normal, stress = read(state.displacement), read(ngs.specialcf.normal(3)), read(mises)[..., 0]
    turned = np.cross(place[:, 1] - place[:, 0], place[:, 2] - place[:, 0])
    wrong = np.einsum("ti,ti->t", turned, normal.mean(axis=1)) < 0
    for values in (place, shift, stress):
        values[wrong] = values[wrong][:, ::-1]
    return Skin(places=place, displacement=shift, von_mises=stress)


def _outside(mesh: ngs.Mesh) -> ngs.Region:
    """Faces with a body on one side only."""
    region = mesh.Boundaries(".*")
    mask = region.Mask()
    for number in range(len(mask)):
        face = mesh.ngmesh.FaceDescriptor(number + 1)
        mask[number] = (face.domin == 0) != (face.domout == 0)
    return region


def _triangles(parts: int) -> tuple[list[tuple[float, float]], NDArray]:
    """Places on the unit triangle, and the small triangles between them (n, 3)."""
    grid = [(i, j) for i in range(parts + 1) for j in range(parts + 1 - i)]
    number = {place: k for k, place in enumerate(grid)}
    up = [((i, j), (i + 1, j), (i, j + 1)) for i, j in grid if i + j < parts]
    down = [((i + 1, j), (i + 1, j + 1), (i, j + 1)) for i, j in grid if i + j < parts - 1]
    corners = np.array([[number[place] for place in triangle] for triangle in [*up, *down]])
    return [(i / parts, j / parts) for i, j in grid], corners
