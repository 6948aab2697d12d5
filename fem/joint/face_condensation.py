"""A body of revolution as felt at the faces where it touches another one.

Tractions on a face are polynomials along its meridian, given at Gauss points. A face has its own
directions: pressure, the tangent along the meridian, the tangent along the circumference. A free body
keeps its rigid motions as such, see `fem.section.rigid_body_modes`.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import ngsolve as ngs
import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from fem.mesh.solid import MILLIMETRES
from fem.parts.boundary_conditions import FreeMotions
from fem.parts.material import ImpossiblePart
from fem.section.expansion import Along, heating, rotation
from fem.section.raceway_shapes import balancing
from fem.section.revolved_body import Body, legendre_polynomials
from fem.section.rigid_body_modes import held_on_points, responses, rigid_motions

FREE = FreeMotions(axial=True, turning=True, across=True)
FLAT = 1e-12  # mean square deviation of an edge from its place, over the square of its length


@dataclass(frozen=True, kw_only=True)
class ContactFace:
    """An edge along which two bodies can touch."""

    edge: str
    component: int  # that pressure has: 0 axial, 1 radial
    sign: float  # of that component, where pressure pushes the outer body
    points: int  # A, Gauss points along the meridian

    def __post_init__(self):
        if self.points < 2:
            raise ImpossiblePart(f"points = {self.points!r} on the face {self.edge!r}; allowed is 2 or more")


@dataclass(frozen=True)
class FacePoints:
    """Gauss points of all faces, one face after the other."""

    face: NDArray  # (A,) of int
    x: NDArray  # (A,) [m]
    radius: NDArray  # (A,) [m]
    weight: NDArray  # (A,) [m^2] area per radian


@dataclass(frozen=True)
class CondensedBody:
    """What a body answers at L = 3 A face directions and M raceway modes.

    At every point, pressure comes first, then the tangents along meridian and circumference.
    The last goes with the sine where the others go with the cosine.
    """

    points: FacePoints
    compliance: NDArray  # (N + 1, L + M, L + M) [m/N] per force per radian
    beyond: NDArray  # (K, M, M) [m/N] of the raceway, harmonics N + 1 .. N + K
    axisymmetric: NDArray  # (L + M, 4) [m] per free expansion, kg/m^3 rad^2/s^2, N of push; by the variation
    motions: NDArray  # (2, L + M, 2) of a free body; n = 0: axial [-], turn [m]; n = 1: shift [-], tilt [m]
    unknowns: int
    elements: int


def condense_body(
    body: Body,
    faces: tuple[ContactFace, ...],
    last: int,
    raceway: tuple[NDArray, int] | None = None,
    pushed: str | None = None,
    variations: Mapping[str, Along] | None = None,
) -> CondensedBody:
    r"""Compliance of a body at its faces and its raceway, harmonic by harmonic.

    .. math:: C_n = G^T K(n)^{-1} G, \quad g_a(v) = \frac{1}{w_a} \int \ell_a v_k\,r\,ds, \quad
              w_a = \int \ell_a\,r\,ds

    Clamps hold the body against these loads. They follow its expansion by heat or rotation, as a shaft that
    goes on beyond them.

    A body of which nothing is clamped is free. Shapes that read an axial motion, those of a groove, hold it
    along its axis evenly around the groove. Harmonics of the tractions go up to `last`, >= 3; `raceway` has
    the load vectors (unknowns, M) of its shapes, and their highest harmonic. An axial push along +x
    is evenly spread over the edge `pushed`. Variations are free expansions along the axis by the name of a
    body; other bodies have none.
    Raises `ImpossiblePart` if an edge is missing, if a face is neither a cylinder nor a plane, or if a
    variation ends inside; `NotSolved` if a solve fails.

    Source
    ------
    Flexibility method: compliances in harmonics, joined by equilibrium and compatibility; derived here.

    Valid
    -----
    Small displacement; the body of one material.
    """
    points, face_loads = zip(*(_face_basis(body, k, face) for k, face in enumerate(faces)), strict=True)
    unknowns, stiffness = body.stiffness.unknowns, body.stiffness
    raceway_loads, highest = raceway or (np.empty((unknowns, 0)), last)
    G = np.hstack([*face_loads, raceway_loads])
    clamped = stiffness.clamped.any()
    free_motions = FreeMotions() if clamped else FREE
    beyond = np.empty((0, *raceway_loads.shape[1:] * 2))
    if highest > last:
        beyond = responses(body, free_motions, raceway_loads, highest)[last + 1 :]
    unclamped = replace(body, stiffness=replace(stiffness, clamped=np.zeros_like(stiffness.clamped)))
    loads = _axisymmetric_loads(body, pushed, variations or {})
    expanded = held_on_points(unclamped, FREE, 0).solve(0, loads)
    compliance, axisymmetric = responses(body, free_motions, G, last), G.T @ expanded
    motions = np.array([G.T @ rigid for rigid in rigid_motions(body)])
    of_raceway = np.arange(G.shape[1]) >= G.shape[1] - raceway_loads.shape[1]
    if motions[0, of_raceway, 0].any():  # shapes of a groove
        held = balancing(motions[0, :, :1], of_raceway)
        compliance[0] = held.T @ compliance[0] @ held
        axisymmetric, motions[0] = held.T @ axisymmetric, held.T @ motions[0]
    return CondensedBody(
        points=FacePoints(*(np.concatenate(column) for column in zip(*points, strict=True))),
        compliance=compliance,
        beyond=beyond,
        axisymmetric=axisymmetric,
        motions=motions[:, :, : 0 if clamped else 2],
        unknowns=unknowns,
        elements=body.space.mesh.ne,
    )


def _face_basis(body: Body, number: int, face: ContactFace) -> tuple[tuple[NDArray, ...], NDArray]:
    """Gauss points of one face, and the load vectors of unit forces there (unknowns, 3 A)."""
    section = body.space.mesh
    if face.edge not in section.GetBoundaries():
        raise ImpossiblePart(
            f"no edge is named {face.edge!r}; there are {sorted(set(section.GetBoundaries()))}"
        )
    where = ngs.ds(definedon=section.Boundaries(face.edge), bonus_intorder=face.points)
    cylinder = face.component == 1
    along, across = (ngs.x, ngs.y) if cylinder else (ngs.y, ngs.x)
    length = ngs.Integrate(ngs.CF(1) * where, section)
    middle, level = (ngs.Integrate(c * where, section) / length for c in (along, across))
    if ngs.Integrate((across - level) ** 2 * where, section) > FLAT * length**3:
        raise ImpossiblePart(
            f"the face {face.edge!r} bends or is inclined; allowed is a cylinder about the axis or a plane "
            "at right angles to it"
        )
    xi, gauss = legendre.leggauss(face.points)
    s = (middle + xi * length / 2) / MILLIMETRES
    constant = np.full_like(s, level / MILLIMETRES)
    x, r = (s, constant) if cylinder else (constant, s)
    # l_a(xi) = sum over m of (m + 1/2) gauss_a L_m(xi_a) L_m(xi), by their discrete orthogonality
    lagrange = legendre.legvander(xi, face.points - 1) * (np.arange(face.points) + 0.5) * gauss[:, None]
    weight = gauss * length / MILLIMETRES / 2 * r
    v = body.space.TestFunction()
    shapes = legendre_polynomials(2 * (along - middle) / length, face.points)
    directions = ((face.component, face.sign), (1 - face.component, 1.0), (2, 1.0))
    loads = [
        np.stack([body.load(sign * L * v[k] * ngs.y / MILLIMETRES**2 * where) for L in shapes], axis=1)
        @ lagrange.T / weight
        for k, sign in directions
    ]  # fmt: skip
    return (np.full(face.points, number), x, r, weight), np.stack(loads, axis=2).reshape(len(loads[0]), -1)


def _axisymmetric_loads(body: Body, pushed: str | None, variations: Mapping[str, Along]) -> NDArray:
    """Load vectors per radian of unit expansion, density and speed, push; of the variation (unknowns, 4)."""
    names = body.space.mesh.GetMaterials()
    unit = dict.fromkeys(names, 1.0)
    push, varied = np.zeros((2, body.stiffness.unknowns))
    if varying := {name: variations[name] for name in names if name in variations}:
        varied = heating(body, varying)
    if pushed is not None:
        where = ngs.ds(definedon=body.space.mesh.Boundaries(pushed))
        push = body.load(body.space.TestFunction()[0] * ngs.y * where)
        push /= 2 * np.pi * ngs.Integrate(ngs.y * where, body.space.mesh)
    return np.stack([heating(body, unit), rotation(body, unit, 1.0), push, varied], axis=1)
