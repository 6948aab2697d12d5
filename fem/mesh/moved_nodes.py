r"""Meshes of one part with their nodes moved, so that they fill another of the same kind.

A mesh of its own has other elements, with which answers scatter by about 1e-3. Moved nodes keep the elements,
so that answers are smooth in every dimension,

.. math:: x' = f(x), \quad r' = g(r), \quad t' = h(t)

each piecewise linear between the faces of the part, t beside the middle of the nearest bar. The map is given
at the vertices and is linear in each element: kinks inside elements do no harm there.

Source
------
Shape derivatives on a mesh that follows the boundary; the map between faces is derived here.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.mesh.solid import MILLIMETRES
from fem.parts.material import ImpossiblePart
from fem.parts.squirrel_cage import SquirrelCage

ONE = 1e-9  # [m] below it two faces are one


@dataclass(frozen=True, kw_only=True)
class Faces:
    """Where the faces of a part lie; parts of one kind have them in the same order."""

    x: Sequence[float]  # [m] of planes across the axis, and of the ends of the loaded band
    radii: Sequence[float]  # [m] of cylinders about the axis
    flanks: Sequence[float] = ()  # [m] of planes beside the middle of a bar
    bars: int = 1  # on the whole circle


def cage_faces(cage: SquirrelCage, length: float) -> Faces:
    """Faces of a squirrel cage, those where fillets end, too, with a loaded band of `length` [m]."""
    inner, (low, high), side = cage.raceway_diameter / 2, cage.bar_radii, cage.bar_width / 2
    x = [*cage.sides, -length / 2, length / 2, *(x for x, _ in cage.outline)]
    for end in cage.ends:
        foot = cage.end_distance(end)
        stop = foot + cage.bar_length
        places = foot, foot + cage.fillet, stop - cage.fillet, stop, stop + cage.flange_length
        x += [end * place for place in places]
    radii = [inner, low - cage.fillet, low, high, high + cage.fillet, inner + cage.thickness]
    radii += [radius for _, radius in cage.outline]
    return Faces(x=x, radii=radii, flanks=(side, side + cage.fillet), bars=cage.bars)


def move_nodes(mesh: ngs.Mesh, before: Faces, after: Faces) -> None:
    """Move the nodes of a mesh [mm] in place, from the faces of its part to those of another.

    The mesh is in space, x along the axis, or of axial sections, y the radius.
    Raises `ImpossiblePart` if faces that are one would come apart, or others would meet.
    """
    places = vertex_places(mesh)
    mesh.SetDeformation(_deformation(mesh, places, *_moved(places, before, after)))


def unmoved(places: NDArray, before: Faces, after: Faces) -> NDArray:
    """Where places (n, dimensions) [m] of the moved part were, but for what elements do between their nodes.

    Raises `ImpossiblePart` as for `move_nodes`.
    """
    return _moved(places, after, before)[0]


def _moved(places: NDArray, before: Faces, after: Faces) -> tuple[NDArray, NDArray]:
    """Places (n, dimensions) [m] moved with the faces, and their turn (n) about the axis [rad]."""
    x, across = places[:, 0], places[:, 1:]
    radius = np.linalg.norm(across, axis=1)
    moved_radius = _stretched(radius, before.radii, after.radii)
    moved, turn = (moved_radius / radius)[:, None] * across, np.zeros_like(radius)
    if places.shape[1] == 3:
        azimuth = np.arctan2(*across.T)
        moved_azimuth = _turned(azimuth, (radius, moved_radius), (before, after))
        moved = moved_radius[:, None] * np.stack([np.sin(moved_azimuth), np.cos(moved_azimuth)], axis=1)
        turn = moved_azimuth - azimuth
    return np.column_stack([_stretched(x, before.x, after.x), moved]), turn


def _deformation(mesh: ngs.Mesh, places: NDArray, moved: NDArray, turn: NDArray) -> ngs.GridFunction:
    """Shift [mm] of curved elements from that of their vertices and its turn (vertices) about the axis [rad].

    Growth and turn are linear in each element and act on curved coordinates: round faces stay round.
    """
    across = places[:, 1:]
    growth = np.linalg.norm(moved[:, 1:], axis=1) / np.linalg.norm(across, axis=1) - 1
    smooth = growth[:, None] * across
    grown, turned = (_linear(mesh, each[:, None]) for each in (growth, turn))
    field = [grown * coordinate for coordinate in (ngs.y, ngs.z)[: mesh.dim - 1]]
    if mesh.dim == 3:
        smooth += turn[:, None] * across[:, ::-1] * [1.0, -1.0]
        field = [field[0] + turned * ngs.z, field[1] - turned * ngs.y]
    rest = moved - places
    rest[:, 1:] -= smooth
    deformation = ngs.GridFunction(ngs.VectorH1(mesh, order=mesh.GetCurveOrder() + 1))
    linear = _linear(mesh, MILLIMETRES * rest)
    for number, more in enumerate((0.0, *field)):  # one by one: together they take three times as long
        deformation.components[number].Set(linear[number] + more)
    return deformation


def _linear(mesh: ngs.Mesh, values: NDArray):
    """Field that is linear in each element, from its values (vertices, components)."""
    components = values.shape[1]
    space = ngs.H1(mesh, order=1)
    field = ngs.GridFunction(space**components if components > 1 else space)
    field.vec.FV().NumPy()[:] = values.T.ravel()
    return field


def vertex_places(mesh: ngs.Mesh) -> NDArray:
    """Places (vertices, dimensions) [m] of the vertices of a mesh, where they are moved to."""
    places = mesh.ngmesh.Coordinates()
    if mesh.deformation is not None:  # whose first unknowns are those of the vertices
        shifts = [part.vec.FV().NumPy()[: len(places)] for part in mesh.deformation.components]
        places = places + np.stack(shifts, axis=1)
    return places / MILLIMETRES


def _turned(azimuth: NDArray, radii: tuple[NDArray, NDArray], faces: tuple[Faces, Faces]) -> NDArray:
    """Azimuths (n) [rad] of nodes whose radii change; the middles of bars and slots stay."""
    pitch = 2 * np.pi / faces[0].bars
    bar = pitch * np.round(azimuth / pitch)
    beside = np.abs(azimuth - bar)
    old, new = ([0.0, *each.flanks] for each in faces)
    t = _stretched(np.minimum(radii[0] * np.sin(beside), old[-1]), old, new)
    edge = [_angle(side, radius) for side, radius in zip((old[-1], new[-1]), radii, strict=True)]
    in_slot = pitch / 2 - (pitch / 2 - beside) * (pitch / 2 - edge[1]) / (pitch / 2 - edge[0])
    return bar + np.sign(azimuth - bar) * np.where(beside <= edge[0], _angle(t, radii[1]), in_slot)


def _angle(side: NDArray | float, radius: NDArray) -> NDArray:
    """Azimuth [rad] of places beside the middle of a bar."""
    return np.arcsin(np.clip(side / radius, 0.0, 1.0))


def _stretched(places: NDArray, before: Sequence[float], after: Sequence[float]) -> NDArray:
    """Places (n) [m] between faces after these have moved."""
    order = np.argsort(before, kind="stable")
    old, new = np.array(before)[order], np.array(after)[order]
    one, apart = np.diff(old) <= ONE, np.diff(new)
    if (np.abs(apart[one]) > ONE).any() or (apart[~one] <= ONE).any():
        raise ImpossiblePart("faces that lie in one plane or cylinder would come apart, or others meet")
    kept = np.append(True, ~one)
    return np.interp(places, old[kept], new[kept])
