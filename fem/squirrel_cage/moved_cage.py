r"""A squirrel cage whose faces have moved a little, by the fields of the cage that was meshed.

The work of loads on their answers, W = G^T K^-1 G, is stationary in the fields u:

.. math:: W' = G'^T u + u^T G' - u^T K' u + O(|K' - K|^2)

So derivatives of all answers need one elimination and, for each change of shape, the assembly of K' and G'.
Section forces of the bars are answers, too, of loads that read them. The fields of all harmonics and phases
are nearly dependent: a small basis holds them.

Source
------
Principle of minimum potential energy; shape derivatives on moved nodes, derived here.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly import roller_loads
from fem.assembly.factorisation import threads
from fem.mesh.half_pitch import half_pitch
from fem.mesh.moved_nodes import cage_faces, move_nodes
from fem.parts.resolution import Resolution
from fem.parts.rings import MeshSize
from fem.parts.squirrel_cage import SquirrelCage
from fem.raceway.bar_response import BarResponse, is_mirrored
from fem.raceway.harmonics import Responses
from fem.squirrel_cage.cut_stiffness import (
    HalfPitch,
    ReducedHalfPitch,
    assembled_form,
    harmonic_loads,
    interior,
    readings,
    stiffness,
)
from fem.squirrel_cage.half_pitch_cage import all_phases, phase_solution, phases, reduced, ties
from fem.stages import Stage

MIRROR_IMAGES = (True, False)  # fields that are their own, and those that are the negative of it
NEGLIGIBLE = 1e-9  # part of the largest field that the basis leaves out, by the root of its energy


@dataclass(frozen=True)
class CageFields:
    """Half a pitch of a cage with its displacements under all loads of every phase."""

    half: HalfPitch
    mesh: ngs.Mesh  # whose nodes are moved for a while by `near_responses`
    bases: list[NDArray]  # (unknowns, r) orthonormal in energy, of each of `MIRROR_IMAGES`
    factors: list[list[NDArray]]  # (r, loads and readings) of each, phase by phase


@dataclass(frozen=True)
class MovedHalf:
    """Stiffness and loads of the moved half pitch on the basis, for one kind of mirror images."""

    stiffness: NDArray  # (r, r) [N/m]
    loads: NDArray  # (r, N + 1, M) [-]
    readings: NDArray  # (r, all readings) zero for those of the other kind

    def work(self, fields: NDArray, harmonics: NDArray, *, symmetric: bool) -> NDArray:
        """Work of all loads and readings of a phase on their answers (r, loads and readings)."""
        signs = np.ones(len(harmonics)) if symmetric else np.sign(harmonics)
        loads = self.loads[:, np.abs(harmonics)] * signs[:, None]
        work = np.hstack([loads.reshape(len(loads), -1), self.readings]).T @ fields
        return work + work.T - fields.T @ self.stiffness @ fields


def near_responses(cage: SquirrelCage, resolution: Resolution, last: int, stage: Stage) -> Responses:
    """Answers of the raceway of a cage that differs little from that of `resolution.nodes_of`.

    They are those of `fem.squirrel_cage.half_pitch_cage.cage_responses`, without errors.
    Raises `NotSolved` if the cage of `resolution.nodes_of` cannot be solved, `ImpossiblePart` if faces that
    are one would come apart.

    Valid
    -----
    Errors grow with the square of the change: for differences about the cage of `resolution.nodes_of`.
    """
    other = resolution.nodes_of
    assert other is not None
    with threads(1), stage("factor"):
        known = _fields_of(other.part, other.length, resolution.mesh, resolution.axial_modes, last)
    with threads(1), stage("condense"):
        faces = cage_faces(other.part, other.length), cage_faces(cage, resolution.length)
        move_nodes(known.mesh, *faces)
        try:
            halves = _moved(known, cage, resolution, last)
        finally:
            known.mesh.UnsetDeformation()

        def answered(phase: int, harmonics: NDArray) -> NDArray:
            each = zip(halves, known.factors[phase], MIRROR_IMAGES, strict=True)
            works = [half.work(fields, harmonics, symmetric=own) for half, fields, own in each]
            return np.sum(works, axis=0)[:, : harmonics.size * resolution.axial_modes]

        readings = known.half.readings.shape[1]
        response, in_bars = all_phases(answered, cage.bars, (last, resolution.axial_modes), readings)
    bars = BarResponse(cage.bars, in_bars, None)
    return Responses(response, known.half.space.ndof, known.mesh.ne, bar_response=bars)


@lru_cache(maxsize=1)  # changes of one cage come one after the other
def _fields_of(
    cage: SquirrelCage, length: float, mesh_size: MeshSize, axial_modes: int, last: int
) -> CageFields:
    mesh = half_pitch(cage, length, mesh_size)
    resolution = Resolution(length=length, axial_modes=axial_modes, mesh_size=mesh_size)
    half, halves = reduced(cage, mesh, mesh_size.order, resolution, last)
    loaded = [_loaded(halves, *phase) for phase in phases(cage.bars, last)]
    bases, factors = [], []
    for reduction, each in zip(halves, zip(*loaded, strict=True), strict=True):
        faces, forces = zip(*each, strict=True)
        *basis, of_all = _basis(reduction, np.hstack(faces), np.hstack(forces))
        bases.append(interior(half, reduction, *basis))
        factors.append(np.split(of_all, np.cumsum([face.shape[1] for face in faces])[:-1], axis=1))
    return CageFields(half, mesh, bases, [list(each) for each in zip(*factors, strict=True)])


def _loaded(
    halves: Sequence[ReducedHalfPitch], theta: float, harmonics: NDArray
) -> list[tuple[NDArray, NDArray]]:
    """Displacements of the face and forces, as `interior` takes them, of all fields of a phase, by kind."""
    cuts = [each.cut for each in halves]
    forces, z = phase_solution(cuts, theta, harmonics, with_readings=True)
    loaded, first = [], forces[0].shape[1]
    for cut, tie, q in zip(cuts, ties(cuts, theta), forces, strict=True):
        patterns, own = len(q), len(cut.bar_by_cut)
        values = np.zeros((patterns + own, z.shape[1]))
        values[:patterns, : q.shape[1]] = q
        values[patterns:, first : first + own] = np.eye(own)
        loaded.append((tie[:, None] * z, values))
        first += own
    return loaded


def _basis(reduction: ReducedHalfPitch, faces: NDArray, forces: NDArray) -> tuple[NDArray, NDArray, NDArray]:
    r"""Displacements of the face and forces of a basis (.., r) of fields (.., n), and their factors (r, n).

    The basis is orthonormal in energy, which follows from displacements u of the face and forces q, as
    fields without forces are orthogonal to those that leave the face where it is:

    .. math:: \int \sigma : \varepsilon\,dV = u^T S u + q^T C q
    """
    places = len(faces)
    roots = _root(reduction.cut.stiffness), _root(-reduction.inside.schur[places:, places:])
    weighted = np.vstack([root @ values for root, values in zip(roots, (faces, forces), strict=True)])
    sizes = np.linalg.norm(weighted, axis=0)
    sizes[sizes == 0.0] = 1.0  # of loads that the other kind of mirror images carries alone
    _, values, mix = np.linalg.svd(weighted / sizes, full_matrices=False)
    rank = np.count_nonzero(values > NEGLIGIBLE * values[0])
    parts = mix[:rank].T / values[:rank] / sizes[:, None]
    return faces @ parts, forces @ parts, values[:rank, None] * mix[:rank] * sizes


def _root(matrix: NDArray) -> NDArray:
    """R with R^T R = A, of units that may differ; patterns that reach the face alone leave C singular."""
    scale = np.sqrt(np.diag(matrix).clip(min=0.0))
    scale[scale == 0.0] = 1.0
    values, vectors = np.linalg.eigh(matrix / np.outer(scale, scale))
    return np.sqrt(values.clip(min=0.0))[:, None] * vectors.T * scale


def _moved(known: CageFields, cage: SquirrelCage, resolution: Resolution, last: int) -> list[MovedHalf]:
    """The moved half pitch on the known fields, for both kinds of mirror images."""
    half, count = known.half, (last + 1, resolution.axial_modes)
    form = assembled_form(half.space, cage)
    matrix, read = stiffness(form), readings(form, cage)
    band = roller_loads.band(half.space, "raceway", roller_loads.HIGHEST_ORDER)
    own = is_mirrored(read.shape[1])
    first = np.argsort(~own, kind="stable")  # those of the first kind first
    moved = []
    for basis, symmetric in zip(known.bases, MIRROR_IMAGES, strict=True):
        loads = basis.T @ harmonic_loads(band, resolution.length, count, symmetric)
        moved.append(
            MovedHalf(
                stiffness=basis.T @ (matrix @ basis),
                loads=loads.reshape(-1, *count),
                readings=(basis.T @ read * (own == symmetric))[:, first],
            )
        )
    return moved
