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
from fem.parts.rings import SquirrelCage
from fem.raceway.bar_response import is_mirrored

NEGLIGIBLE = 1e-13  # part of the largest load pattern that is rounding


@dataclass(frozen=True)
class HalfPitch:
    """Half a pitch as a sparse matrix, the inner unknowns of the elements condensed."""

    space: ngs.FESpace
    form: Any  # ngsolve.BilinearForm, the inner unknowns of the elements condensed
    stiffness: sparse.csr_array  # (unknowns, unknowns) [N/m], whole
    owner: NDArray  # (unknowns,) groups of elements (`static_condensation.owners`); 0 clamped or condensed
    cut: NDArray  # (3, places) unknowns of the slot's face that stand for x, r and t
    middle: NDArray  # (3, places) unknowns x, y = t and z = r of the bar's middle plane
    turn: sparse.csr_array  # (unknowns, unknowns) from x, r, t on the cut to x, y, z; orthogonal
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
    def of(cls, schur: NDArray, places: int, share: NDArray) -> "CutStiffness":
        """From the stiffness at the face, bordered by patterns and readings with their signs turned."""
        force = slice(places, places + len(share))
        bar = slice(places + len(share), None)
        return cls(
            stiffness=schur[:places, :places], coupling=-schur[:places, force],
            compliance=-schur[force, force], share=share,
            bar_by_cut=-schur[bar, :places], bar_by_forces=-schur[bar, force],
        )  # fmt: skip


@dataclass(frozen=True)
class ReducedHalfPitch:
    """Half a pitch as its cut sees it, and the way back to its inside."""

    cut: CutStiffness
    patterns: NDArray  # (unknowns, patterns) load vectors of unit q
    inside: Substructure


def assembled_half_pitch(cage: SquirrelCage, mesh: ngs.Mesh, order: int) -> HalfPitch:
    """Assemble half a pitch.

    Parameters
    ----------
    cage : SquirrelCage
        ring, bars and flange
    mesh : ngsolve.Mesh
        from `fem.mesh.half_pitch`
    order : int
        of the displacement

    Returns
    -------
    HalfPitch
    """
    space = ngs.VectorH1(mesh, order=order, dirichlet="clamped")
    form = assembled_form(space, cage)
    dofs = space.FreeDofs(coupling=True)
    free = np.array([dofs[k] for k in range(space.ndof)])
    elements = [np.array(element.dofs) for element in space.Elements(ngs.VOL)]
    centres = np.array([np.mean([mesh[v].point for v in e.vertices], axis=0) for e in mesh.Elements(ngs.VOL)])
    owner = np.where(free, owners(elements, centres, space.ndof), 0)
    cut = _unknowns(space, "cut", free)
    turn = _turn(cut, pi / cage.bars, space.ndof)
    return HalfPitch(
        space=space, form=form, stiffness=sparse.csr_array(turn.T @ stiffness(form) @ turn), owner=owner,
        cut=cut, middle=_unknowns(space, "middle", free), turn=turn, readings=turn.T @ readings(form, cage),
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
    """Reduce half a pitch to its face in the slot.

    Parameters
    ----------
    half : HalfPitch
        from `assembled_half_pitch`
    band : fem.assembly.roller_loads.Band
        quadrature on its part of the raceway
    length : float
        l, axial length of the loaded band [m]
    axial_modes : int
        M, number of axial modes
    highest : int
        N, the highest harmonic
    symmetric : bool
        loads like cos(n phi) and fields that are their own mirror image; else like sin(n phi)

    Returns
    -------
    ReducedHalfPitch

    Raises
    ------
    NotSolved
        if half a pitch floats
    """
    count = highest + 1, axial_modes
    vectors = half.turn.T @ harmonic_loads(band, length, count, symmetric)
    return reduced_under(half, *_patterns(vectors, count), symmetric)


def reduced_under(half: HalfPitch, patterns: NDArray, share: NDArray, symmetric: bool) -> ReducedHalfPitch:
    """Reduce half a pitch under given load vectors.

    Parameters
    ----------
    half : HalfPitch
        from `assembled_half_pitch`
    patterns : array (unknowns, patterns)
        load vectors of unit q, x, r, t on the cut
    share : array (patterns, ...)
        forces q that make up the loads
    symmetric : bool
        loads and fields that are their own mirror image; else the negative of it

    Returns
    -------
    ReducedHalfPitch

    Raises
    ------
    NotSolved
        if half a pitch floats
    """
    size, count = patterns.shape
    owner = half.owner.copy()
    owner[half.cut] = 0
    owner[half.middle[[1]] if symmetric else half.middle[[0, 2]]] = 0
    reading = half.readings[:, is_mirrored(half.readings.shape[1]) == symmetric]
    border, width = sparse.coo_array(np.hstack([patterns, reading])), count + reading.shape[1]
    kept = np.concatenate([half.cut.ravel(), size + np.arange(width)])
    blocks = [[half.stiffness, -border], [-border.T, None]]
    bordered = sparse.coo_array(sparse.block_array(blocks, format="coo"))
    inside = eliminate(bordered, np.append(owner, np.zeros(width, dtype=int)), kept)
    return ReducedHalfPitch(CutStiffness.of(inside.schur, half.cut.size, share), patterns, inside)


def imbalance(half: HalfPitch, reduced: ReducedHalfPitch, displacement: NDArray, forces: NDArray) -> NDArray:
    """Forces that are left when the whole half pitch follows its face.

    Parameters
    ----------
    half : HalfPitch
        the sparse matrix
    reduced : ReducedHalfPitch
        its reduction
    displacement : array (3 places, columns)
        u of the face [m]
    forces : array (patterns, columns)
        q [N]

    Returns
    -------
    array (unknowns, columns)
        K u - F q [N], zero where a plane or a clamp holds; on the face it is the force f
    """
    u = interior(half, reduced, displacement, forces)
    left = half.stiffness @ u - reduced.patterns @ forces
    carried = np.zeros(half.space.ndof, dtype=bool)
    carried[reduced.inside.order[reduced.inside.order < half.space.ndof]] = True
    left[~carried] = 0.0
    return left


def interior(half: HalfPitch, reduced: ReducedHalfPitch, displacement: NDArray, forces: NDArray) -> NDArray:
    """Displacement of the whole half pitch from that of its face.

    Parameters
    ----------
    half, reduced, displacement, forces
        as for `imbalance`

    Returns
    -------
    array (unknowns, columns)
        [m] x, r, t on the face and x, y, z elsewhere; inner unknowns of the elements are zero
    """
    unread = np.zeros((len(reduced.cut.bar_by_cut), forces.shape[1]))
    return reduced.inside.interior(np.vstack([displacement, forces, unread]))[: half.space.ndof]


def in_whole(half: HalfPitch, displacement: NDArray) -> NDArray:
    """Displacements with the inner unknowns of the elements.

    Parameters
    ----------
    half : HalfPitch
        from `assembled_half_pitch`
    displacement : array (unknowns, columns)
        from `interior` [m]

    Returns
    -------
    array (unknowns, columns)
        [m] along x, y, z everywhere
    """
    whole = half.turn @ displacement
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


def _turn(cut: NDArray, azimuth: float, size: int) -> sparse.csr_array:
    """Cartesian from cylindrical components on a plane through the axis; r replaces y and t replaces z."""
    _, y, z = cut
    itself = np.ones(size)
    itself[y], itself[z] = np.sin(azimuth), -np.sin(azimuth)
    crosswise = np.full(y.size, np.cos(azimuth))
    places = np.concatenate([np.arange(size), y, z]), np.concatenate([np.arange(size), z, y])
    return sparse.csr_array((np.concatenate([itself, crosswise, crosswise]), places), shape=(size, size))


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
