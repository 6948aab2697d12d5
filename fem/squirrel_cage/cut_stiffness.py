r"""Half a pitch of a squirrel cage, reduced to its face in the middle of the slot.

A field that is its own mirror image in the middle plane of the bar, or the negative of it, is known
from half a pitch: the plane holds the displacement t across it, or those along it. The face in the
slot keeps its displacements u in the directions x, r, t; with generalised forces q on the raceway

.. math:: S u - G q = f, \quad w = G^T u + C q

gives the force f on that face and the generalised displacement w.

Source
------
Cyclic symmetry with a plane of symmetry in each sector; derived here.
"""

from dataclasses import dataclass
from math import pi
from typing import Any

import ngsolve as ngs
import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray
from scipy import sparse

from fem.assembly import roller_loads
from fem.assembly.bar_readings import bar_readings
from fem.assembly.elasticity import elastic_energy
from fem.assembly.static_condensation import Substructure, eliminate, owners
from fem.parts.squirrel_cage import SquirrelCage
from fem.raceway.bar_response import is_mirrored

NEGLIGIBLE = 1e-13  # part of the largest load pattern that is rounding


@dataclass(frozen=True)
class HalfPitch:
    """Half a pitch as a sparse matrix, the inner unknowns of the elements condensed."""

    space: ngs.FESpace
    form: Any  # ngsolve.BilinearForm, the inner unknowns of the elements condensed
    stiffness: sparse.csr_array  # (unknowns, unknowns) [N/m], whole, along x, y, z everywhere
    owner: NDArray  # (unknowns,) groups of elements (`static_condensation.owners`); 0 clamped or condensed
    cut: NDArray  # (3, places) unknowns x, y and z of the slot's face
    middle: NDArray  # (3, places) unknowns x, y = t and z = r of the bar's middle plane
    turn: NDArray  # (3 places, 3 places) from x, r, t on the cut to x, y, z; orthogonal
    readings: NDArray  # (unknowns, 6 or 12) section forces of bars, see `fem.assembly.bar_readings`


@dataclass(frozen=True)
class CutStiffness:
    """Half a pitch seen from its face in the slot, for one kind of mirror image."""

    stiffness: NDArray  # S (3 places, 3 places) [N/m]
    coupling: NDArray  # G (3 places, patterns) [-]
    compliance: NDArray  # C (patterns, patterns) [m/N]
    share: NDArray  # (patterns, N + 1, M) forces q that make up each harmonic and axial shape [N/N]
    bar_by_cut: NDArray  # (3 or 6, 3 places) section forces of the bar by u [N/m, N m/m]
    bar_by_forces: NDArray  # (3 or 6, patterns) the same by q [N/N, N m/N]

    @classmethod
    def of(cls, schur: NDArray, turn: NDArray, share: NDArray) -> "CutStiffness":
        """From the stiffness at the face along x, y, z, bordered by patterns and readings."""
        places, patterns = len(turn), len(share)
        force, bar = slice(places, places + patterns), slice(places + patterns, None)
        return cls(
            stiffness=turn.T @ schur[:places, :places] @ turn, coupling=-turn.T @ schur[:places, force],
            compliance=-schur[force, force], share=share,
            bar_by_cut=-schur[bar, :places] @ turn, bar_by_forces=-schur[bar, force],
        )  # fmt: skip


@dataclass(frozen=True)
class ReducedHalfPitch:
    """Half a pitch as its cut sees it, and the way back to its inside."""

    cut: CutStiffness
    patterns: NDArray  # (unknowns, patterns) load vectors of unit q
    inside: Substructure


def assembled_half_pitch(cage: SquirrelCage, mesh: ngs.Mesh, order: int) -> HalfPitch:
    """Assemble half a pitch on a mesh from `fem.mesh.half_pitch`, with displacements of some order."""
    space = ngs.VectorH1(mesh, order=order, dirichlet="clamped")
    form = assembled_form(space, cage)
    dofs = space.FreeDofs(coupling=True)
    free = np.array([dofs[k] for k in range(space.ndof)])
    elements = [np.array(element.dofs) for element in space.Elements(ngs.VOL)]
    centres = np.array([np.mean([mesh[v].point for v in e.vertices], axis=0) for e in mesh.Elements(ngs.VOL)])
    owner = np.where(free, owners(elements, centres, space.ndof), 0)
    cut = _unknowns(space, "cut", free)
    return HalfPitch(
        space=space, form=form, stiffness=stiffness(form), owner=owner, cut=cut,
        middle=_unknowns(space, "middle", free), turn=_turn(cut.shape[1], pi / cage.bars),
        readings=readings(form, cage),
    )  # fmt: skip


def assembled_form(space: ngs.FESpace, cage: SquirrelCage) -> Any:
    """Elastic energy on half a pitch as its nodes are now, the inner unknowns of the elements condensed."""
    u, v = space.TnT()
    form = ngs.BilinearForm(space, symmetric=True, condense=True)
    form += elastic_energy(space.mesh, cage.materials)(u, v)
    return form.Assemble()


def stiffness(form: Any) -> sparse.csr_array:
    """Matrix (unknowns, unknowns) of an assembled form [N/m], along x, y, z everywhere."""
    values, columns, starts = form.mat.CSR()
    return sparse.csr_array((values, columns, starts), shape=(form.space.ndof, form.space.ndof))


def readings(form: Any, cage: SquirrelCage) -> NDArray:
    """Load vectors (unknowns, 6 or 12) that read the bars, along x, y, z everywhere."""
    return _condensed(form, bar_readings(form.space, cage, half=True))


def reduced_to_cut(
    half: HalfPitch, band: roller_loads.Band, length: float, axial_modes: int, highest: int, symmetric: bool
) -> ReducedHalfPitch:
    """Reduce half a pitch to its face in the slot, under loads on a band of `length` [m].

    They are axial modes in harmonics 0 .. `highest`. Symmetric are loads like cos(n phi) and fields that are
    their own mirror image; the others are like sin(n phi).
    Raises `NotSolved` if half a pitch floats.
    """
    count = highest + 1, axial_modes
    return reduced_under(half, *_patterns(harmonic_loads(band, length, count, symmetric), count), symmetric)


def reduced_under(half: HalfPitch, patterns: NDArray, share: NDArray, symmetric: bool) -> ReducedHalfPitch:
    """Reduce half a pitch under load vectors (unknowns, patterns) of unit q.

    `share` (patterns, ...) are the forces q that make up the loads; loads and fields are their own mirror
    image if `symmetric`, else the negative of it.
    Raises `NotSolved` if half a pitch floats.
    """
    owner = half.owner.copy()
    owner[half.cut] = 0
    owner[half.middle[[1]] if symmetric else half.middle[[0, 2]]] = 0
    reading = half.readings[:, is_mirrored(half.readings.shape[1]) == symmetric]
    inside = eliminate(half.stiffness, np.hstack([patterns, reading]), owner, half.cut.ravel())
    return ReducedHalfPitch(CutStiffness.of(inside.schur, half.turn, share), patterns, inside)


def imbalance(
    half: HalfPitch, reduced: ReducedHalfPitch, displacement: NDArray, forces: NDArray
) -> tuple[NDArray, NDArray]:
    """Forces that are left when the whole half pitch follows its face.

    The face is displaced by u (3 places, columns) [m] under q (patterns, columns) [N]. Inside, K u - F q
    (unknowns, columns) [N] along x, y, z, zero on the face and where a plane or a clamp holds; on the face
    the force f (3 places, columns) [N] along x, r, t.
    """
    u = interior(half, reduced, displacement, forces)
    left = half.stiffness @ u - reduced.patterns @ forces
    inside = np.zeros_like(left)
    inside[reduced.inside.eliminated] = left[reduced.inside.eliminated]
    return inside, half.turn.T @ left[half.cut.ravel()]


def interior(half: HalfPitch, reduced: ReducedHalfPitch, displacement: NDArray, forces: NDArray) -> NDArray:
    """Displacement (unknowns, columns) [m] of the whole half pitch along x, y, z from that of its face.

    Arguments are those of `imbalance`. Forces q may have unit readings of the bars as further rows; inner
    unknowns of the elements are zero.
    """
    kept = np.zeros((len(reduced.inside.schur), forces.shape[1]))
    kept[: half.cut.size] = half.turn @ displacement
    kept[half.cut.size :][: len(forces)] = forces
    return reduced.inside.interior(kept)


def in_whole(half: HalfPitch, displacement: NDArray) -> NDArray:
    """Displacements of `interior` [m] with the inner unknowns of the elements."""
    whole = displacement.copy()
    vector = half.form.mat.CreateColVector()
    for k, values in enumerate(whole.T):
        vector.FV().NumPy()[:] = values
        whole[:, k] += (half.form.harmonic_extension * vector).Evaluate().FV().NumPy()
    return whole


def _condensed(form, vectors: NDArray) -> NDArray:
    """Load vectors (unknowns, columns) with what they have on inner unknowns of the elements passed on."""
    condensed = np.empty_like(vectors)
    vector = form.mat.CreateColVector()
    for k, values in enumerate(vectors.T):
        vector.FV().NumPy()[:] = values
        condensed[:, k] = (vector + form.harmonic_extension_trans * vector).Evaluate().FV().NumPy()
    return condensed


def _unknowns(space, boundary: str, free: NDArray) -> NDArray:
    """Free unknowns on a boundary (3, places), the components x, y and z of each shape function."""
    scalar = np.array(list(space.components[0].GetDofs(space.mesh.Boundaries(boundary))))
    first = np.flatnonzero(scalar)
    unknowns = np.array([space.Range(k).start for k in range(3)])[:, None] + first
    return unknowns[:, free[unknowns].all(axis=0)]


def _turn(places: int, azimuth: float) -> NDArray:
    """Cartesian from cylindrical components x, r, t on a plane through the axis."""
    s, c = np.sin(azimuth), np.cos(azimuth)
    return np.kron([[1.0, 0.0, 0.0], [0.0, s, c], [0.0, c, -s]], np.eye(places))


def harmonic_loads(
    band: roller_loads.Band, length: float, count: tuple[int, int], symmetric: bool
) -> NDArray:
    """Load vectors (unknowns, harmonics x shapes) of all harmonics and axial shapes, along x, y, z."""
    wave = (np.cos if symmetric else np.sin)(np.outer(band.azimuth, np.arange(count[0])))
    m = np.arange(count[1])
    shape = legendre.legvander(2 * band.x / length, m[-1]) * (2 * m + 1) / length
    pressure = (wave[:, :, None] * shape[:, None]).reshape(band.x.size, -1) / (2 * pi * band.radius)
    y, z = np.sin(band.azimuth)[:, None], np.cos(band.azimuth)[:, None]
    return band.forces(pressure * y, pressure * z)


def _patterns(vectors: NDArray, count: tuple[int, int]) -> tuple[NDArray, NDArray]:
    """Load vectors (unknowns, patterns) that span those of all harmonics and shapes; their shares.

    On one pitch the harmonics are nearly dependent, so that far fewer patterns span them.
    """
    loaded = np.flatnonzero(vectors.any(axis=1))
    basis, size, mix = np.linalg.svd(vectors[loaded], full_matrices=False)
    rank = np.count_nonzero(size > NEGLIGIBLE * size[0])
    patterns = np.zeros((len(vectors), rank))
    patterns[loaded] = basis[:, :rank]
    return patterns, (size[:rank, None] * mix[:rank]).reshape(rank, *count)
