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

    points: NDArray  # (triangles, 3, 3) [m] corners x, y, z before the load, outside when counter-clockwise
    displacement: NDArray  # (triangles, 3, 3) [m]
    von_mises: NDArray  # (triangles, 3) [Pa]


def skin(state: LoadedSolid, subdivisions: int = 6) -> Skin:
    """Triangulate the outside of a solid under its rollers, an element's edge in some subdivisions."""
    reference, corners = _triangles(subdivisions)
    rule = ngs.IntegrationRule(points=reference, weights=[1.0] * len(reference))
    mapped = state.mesh.MapToAllElements(rule, _outside(state.mesh))

    def at_corners(field):  # (triangles, 3, components)
        values = field(mapped)
        return values.reshape(-1, len(reference), values.shape[-1])[:, corners].reshape(
            -1, 3, values.shape[-1]
        )

    points = at_corners(ngs.CF((ngs.x, ngs.y, ngs.z))) / MILLIMETRES
    displacement, normal = at_corners(state.displacement), at_corners(ngs.specialcf.normal(3))
    stress = at_corners(ngs.BoundaryFromVolumeCF(von_mises(state.stress)).Compile())[..., 0]
    orientation = np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0])
    clockwise = np.einsum("ti,ti->t", orientation, normal.mean(axis=1)) < 0
    for values in (points, displacement, stress):
        values[clockwise] = values[clockwise][:, ::-1]
    return Skin(points=points, displacement=displacement, von_mises=stress)


def _outside(mesh: ngs.Mesh) -> ngs.Region:
    """Faces with a body on one side only."""
    region = mesh.Boundaries(".*")
    mask = region.Mask()
    for number in range(len(mask)):
        face = mesh.ngmesh.FaceDescriptor(number + 1)
        mask[number] = (face.domin == 0) != (face.domout == 0)
    return region


def _triangles(subdivisions: int) -> tuple[list[tuple[float, float]], NDArray]:
    """Points of a grid on the unit triangle, and the small triangles between them (n, 3)."""
    count = subdivisions
    grid = [(i, j) for i in range(count + 1) for j in range(count + 1 - i)]
    number = {point: k for k, point in enumerate(grid)}
    upright = [((i, j), (i + 1, j), (i, j + 1)) for i, j in grid if i + j < count]
    inverted = [((i + 1, j), (i + 1, j + 1), (i, j + 1)) for i, j in grid if i + j < count - 1]
    corners = np.array([[number[point] for point in triangle] for triangle in [*upright, *inverted]])
    return [(i / count, j / count) for i, j in grid], corners
