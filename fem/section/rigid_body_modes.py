"""Bodies of revolution that are not held against some of their rigid motions.

Loads in balance need no hold. So such a body is held at as many single unknowns as it has loose motions,
where balanced loads leave no reaction: no spring, and nothing that a result could depend on.
"""

from dataclasses import replace
from math import isfinite

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly.harmonic_stiffness import HarmonicStiffness, compliances
from fem.mesh.axial_section import sections
from fem.mesh.solid import MILLIMETRES
from fem.parts.bolted_ring import BoltedRing
from fem.parts.boundary_conditions import Foundation, FreeMotions, Housing
from fem.parts.resolution import Resolution
from fem.parts.rings import MeshSize, OuterRing, RingOnShaft
from fem.section.revolved_body import Body, Springs, assembled


def body_of(
    part: OuterRing | RingOnShaft | BoltedRing, resolution: Resolution, mesh: MeshSize | None = None
) -> Body:
    """Assemble the sections of a part with the springs that it rests on.

    With `nodes_of` of the resolution the mesh of another part and band is taken, its nodes moved to these;
    with a `mesh` that of no other part, in these sizes.
    """
    length, rows = resolution.length, resolution.rows
    nodes_of = resolution.nodes_of if mesh is None else None
    support = part.support if isinstance(part, OuterRing) else None
    if isinstance(support, Housing):
        support = support.support
    springs = {}
    if isinstance(part, BoltedRing) and isfinite(part.normal_stiffness):
        springs["foundation"] = Springs(part.normal_stiffness, part.shear_stiffness, part.shear_stiffness)
    if isinstance(support, Foundation):
        springs["foundation"] = Springs(support.axial, support.radial, support.tangential)
    others = None if nodes_of is None else sections(nodes_of.part, nodes_of.length, nodes_of.rows)
    return assembled(sections(part, length, rows), part.materials, mesh or resolution.mesh, springs, others)


def responses(body: Body, free_motions: FreeMotions, loads: NDArray, last: int) -> NDArray:
    """Work of loads on their answers, for all harmonics 0 .. N.

    .. math:: W_n = G^T K(n)^{-1} G

    An array (N + 1, L, L) [m/N], symmetric, for N >= 3; for loads G (unknowns, L) [N/N] out of balance it has
    the reaction of the points that were held.
    Raises `NotSolved` if a solve fails.

    Source
    ------
    Linear algebra: work of unit loads on the displacements they cause.
    """
    first = 2 if free_motions.across else 1 if free_motions.axial or free_motions.turning else 0
    low = [loads.T @ held_on_points(body, free_motions, n).solve(n, loads) for n in range(first)]
    return np.concatenate(
        [*np.array(low)[:, None], compliances(body.stiffness.beginning_at(first), loads, last - first)]
    )


def held_on_points(body: Body, free_motions: FreeMotions, harmonic: int) -> HarmonicStiffness:
    """Hold a body at single points against its loose motions of one harmonic.

    Answers to balanced loads are true but for a rigid motion.
    """
    x = np.array([v.point[0] for v in body.space.mesh.vertices])
    ends = [ngs.NodeId(ngs.VERTEX, int(k)) for k in (x.argmin(), x.argmax())]
    held_components = []
    if harmonic == 0:
        held_components = [
            (k, ends[0]) for k, is_free in ((0, free_motions.axial), (2, free_motions.turning)) if is_free
        ]
    elif harmonic == 1 and free_motions.across:
        held_components = [(1, end) for end in ends]
    clamped = body.stiffness.clamped.copy()
    for component, node in held_components:
        number = body.space.Range(component).start + body.space.components[component].GetDofNrs(node)[0]
        clamped[number] = True
    return replace(body.stiffness, clamped=clamped)


def rigid_motions(body: Body) -> tuple[NDArray, NDArray]:
    r"""Unknowns of rigid motions (unknowns, 2) each for n = 0 and n = 1.

    .. math:: (1, 0, 0),\ (0, 0, r);\quad (0, 1, -1),\ (-r, x, -x)

    Source
    ------
    Flexibility method: compliances in harmonics, joined by equilibrium and compatibility; derived here.
    """
    x, r = ngs.x / MILLIMETRES, ngs.y / MILLIMETRES
    motions = []
    for displacements in ((1, 0, 0), (0, 0, r)), ((0, 1, -1), (-r, x, -x)):
        columns = []
        for displacement in displacements:
            values = ngs.GridFunction(body.space)
            for component, value in zip(values.components, displacement, strict=True):
                component.Set(ngs.CF(value))
            columns.append(values.vec.FV().NumPy().copy())
        motions.append(np.stack(columns, axis=1))
    return motions[0], motions[1]
