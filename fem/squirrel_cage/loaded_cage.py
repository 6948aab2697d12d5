r"""Displacement and stress of a squirrel cage under its rollers, from half a pitch of it.

Tractions are split into mirror images and phases; half a pitch answers each as in
`fem.squirrel_cage.half_pitch_cage`, and its answers make up the displacement of every half pitch. A whole
solid of such elements would have fifty times the unknowns.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from math import inf, pi

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError, cho_factor, cho_solve
from scipy.sparse import csr_array

from fem.assembly import roller_loads
from fem.assembly.factorisation import NotSolved, threads
from fem.mesh.half_pitch import half_pitch
from fem.mesh.moved_nodes import Faces, cage_faces
from fem.mesh.notches import notches
from fem.mesh.solid import MILLIMETRES
from fem.parts.resolution import Shape
from fem.parts.rings import MeshSize, Patches
from fem.parts.squirrel_cage import SquirrelCage
from fem.solid.extremes import Samples, cylinder_axes, in_axes
from fem.solid.lattice import Spread, hooke, located, spread, strain_of
from fem.squirrel_cage.cut_stiffness import (
    HalfPitch,
    ReducedHalfPitch,
    assembled_half_pitch,
    in_whole,
    interior,
    reduced_under,
)

FEET, IN_FILLET = 0.23, 0.8  # size of elements at the feet over the thickness of a bar, over a fillet
NEAR = 1e-6  # of a side, by which places stay inside


@dataclass(frozen=True, kw_only=True)
class LoadedCage:
    """A squirrel cage under roller forces, as half pitches: two a bar, that at larger azimuth first."""

    cage: SquirrelCage
    radius: float  # [m] of the raceway
    displacements: tuple[ngs.GridFunction, ngs.GridFunction]  # of the lower and the higher order, for values
    halves: tuple[
        NDArray, NDArray
    ]  # (2 bars, unknowns) [m] in the axes of the bar, mirrored at smaller azimuth
    moved: tuple[Faces, Faces] | None = None  # with which nodes of another mesh were moved, before and after

    _kept: dict[tuple[str, int], Spread] = field(default_factory=dict, compare=False)

    def pieces(self, body: str) -> Iterable[int]:
        """Every half pitch holds a part of every body."""
        return range(2 * self.cage.bars)

    def samples(
        self, body: str, piece: int, intervals: int, keys: NDArray | None = None, *, higher: bool = True
    ) -> Samples:
        """Samples of half a pitch, see `fem.solid.extremes.Sampled`."""
        return self._of(body, piece, self._spread(body, intervals, keys), higher)

    def at(self, body: str, piece: int, places: NDArray, *, higher: bool = True) -> Samples:
        """Samples at those of some places (n, 3) [m] that lie in half a pitch, in axes x, r, t."""
        mesh, local = self.displacements[0].space.mesh, self._local(places, piece)
        points, _ = located(mesh, self._mesh_name(body), local * MILLIMETRES, self.moved)
        samples = self._of(body, piece, points, higher)
        axes = cylinder_axes(*self._local(samples.place, piece)[:, 1:].T)
        axes[:, 2] *= -1 if piece % 2 else 1  # the mirrored half counts azimuths the other way round
        return in_axes(samples, axes)

    def _of(self, body: str, piece: int, points: Spread, higher: bool) -> Samples:
        displacement, values = self.displacements[higher], self.halves[higher][piece]
        displacement.vec.FV().NumPy()[:] = values
        place = ngs.CF((ngs.x, ngs.y, ngs.z))(points.mapped) / MILLIMETRES
        # With fillets the mesh has one body.
        points, place = points.where(within := self._within(body, place[:, 0])), place[within]
        gradient, moved = ngs.Grad(displacement)(points.mapped), displacement(points.mapped)
        stress = hooke(strain_of(gradient), self.cage.materials[body])
        return Samples(points.key, points.even, self._placed(place, piece), moved, stress)

    def _within(self, body: str, x: NDArray) -> NDArray:
        """Whether places at x (n,) [m] belong to a body."""
        within = np.full(x.shape, body == "ring")
        for end in self.cage.ends:
            start = self.cage.end_distance(end)
            stop = start + self.cage.bar_length
            low, high = {"ring": (-inf, start), "bars": (start, stop), "flange": (stop, inf)}[body]
            there = (end * x > low - NEAR) & (end * x < high + NEAR)
            within = within & there if body == "ring" else within | there
        return within

    def _spread(self, body: str, intervals: int, keys: NDArray | None) -> Spread:
        """Points in half a pitch; those in all elements are the same in every piece, and kept."""
        if keys is not None:
            return self._spread_anew(body, intervals, keys)
        if (body, intervals) not in self._kept:
            self._kept[body, intervals] = self._spread_anew(body, intervals, None)
        return self._kept[body, intervals]

    def _spread_anew(self, body: str, intervals: int, keys: NDArray | None) -> Spread:
        mesh = self.displacements[0].space.mesh
        return spread(mesh, self._mesh_name(body), intervals, keys, self._beside_notches(body, intervals))

    def _mesh_name(self, body: str) -> str:
        """Of the elements that hold a body, and with fillets others."""
        return body if self.cage.fillet == 0 else ".*"

    def _beside_notches(self, body: str, intervals: int) -> NDArray:
        """Places (n, 3) of half a pitch where the reach of its sharp edges ends [mm]."""
        x, r = notches(self.cage).around(intervals).T[:, :, None] * MILLIMETRES
        steps = np.linspace(NEAR, 1 - NEAR, intervals + 1)
        if body == "bars":
            t = steps * self.cage.bar_width / 2 * MILLIMETRES
            return np.stack(np.broadcast_arrays(x, t, np.sqrt(r**2 - t**2)), axis=-1).reshape(-1, 3)
        azimuth = steps * pi / self.cage.bars
        return np.stack(np.broadcast_arrays(x, r * np.sin(azimuth), r * np.cos(azimuth)), axis=-1).reshape(
            -1, 3
        )

    def _local(self, place: NDArray, piece: int) -> NDArray:
        """The reverse of `_placed`."""
        bar, mirrored = divmod(piece, 2)
        x, y, z = place.T
        s, c = np.sin(2 * pi * bar / self.cage.bars), np.cos(2 * pi * bar / self.cage.bars)
        t, n = y * c - z * s, y * s + z * c
        return np.stack([x, -t if mirrored else t, n], axis=1)

    def _placed(self, place: NDArray, piece: int) -> NDArray:
        """Places (n, 3) of the half pitch at azimuth 0 in that of a piece."""
        bar, mirrored = divmod(piece, 2)
        x, t, n = place.T
        t = -t if mirrored else t
        s, c = np.sin(2 * pi * bar / self.cage.bars), np.cos(2 * pi * bar / self.cage.bars)
        return np.stack([x, n * s + t * c, n * c - t * s], axis=1)


def feet_size(cage: SquirrelCage) -> float:
    """Largest element edge at the feet of the bars [m]: a part of their thickness, or of their fillets."""
    return IN_FILLET * cage.fillet if cage.fillet > 0 else FEET * cage.bar_thickness


def loaded_cage(
    cage: SquirrelCage,
    patches: Patches,
    forces: NDArray,
    mesh_size: MeshSize,
    feet: float | None = None,
    nodes_of: Shape | None = None,
) -> LoadedCage:
    """Solve a squirrel cage under roller forces, by two orders of displacements.

    Forces (Z, M) are the generalised ones of `fem.assembly.roller_loads` [N], positive outward. `mesh_size`
    has the higher order, 2 or more; `feet` is the largest element edge at the feet of the bars [m], by
    default that of `feet_size`; with `nodes_of` the mesh of another cage and band is taken, its nodes moved
    to these.
    Raises `ImpossiblePart` if the band is longer than the track, or elements are inside out or far too many;
    `NotSolved` if half a pitch cannot be solved, or the mesh is too coarse for the patches.

    Valid
    -----
    Small displacement, perfect bonds, rigid clamps; no load outside the band.
    """
    with threads(1):  # half a pitch is small: a second thread would only wait
        feet = min(feet or feet_size(cage), mesh_size.size)
        mesh = half_pitch(cage, patches.length, mesh_size, feet, graded_clamp=True, nodes_of=nodes_of)
        solved = [
            _solved(cage, patches, forces, mesh, order) for order in (mesh_size.order - 1, mesh_size.order)
        ]
    (lower, of_lower, radius), (higher, of_higher, _) = solved
    moved = None
    if nodes_of is not None:
        moved = cage_faces(nodes_of.part, nodes_of.length), cage_faces(cage, patches.length)
    return LoadedCage(
        cage=cage, radius=radius, displacements=(lower, higher), halves=(of_lower, of_higher), moved=moved
    )


def _solved(
    cage: SquirrelCage, patches: Patches, forces: NDArray, mesh: ngs.Mesh, order: int
) -> tuple[ngs.GridFunction, NDArray, float]:
    """A field on half a pitch, its values (2 bars, unknowns) on every half, and the radius of the raceway."""
    half = assembled_half_pitch(cage, mesh, order)
    band = roller_loads.band(half.space, "raceway", roller_loads.HIGHEST_ORDER)
    even, odd = _load_vectors(band, patches, forces, cage.bars)
    phases = np.arange(cage.bars // 2 + 1)
    turn = np.exp(-2j * pi * np.outer(np.arange(cage.bars), phases) / cage.bars) / cage.bars
    even, odd = _parts(even @ turn), _parts(-1j * odd @ turn)
    share = np.eye(2 * phases.size)
    halves = reduced_under(half, even, share, True), reduced_under(half, odd, share, False)
    a, b = (in_whole(half, u) for u in _fields(half, halves, cage.bars))
    # The field is that of phase 0, with those of bars/2, and twice the real part of those between.
    weight = np.where((phases == 0) | (2 * phases == cage.bars), 1.0, 2.0)
    back = weight * np.exp(2j * pi * np.outer(np.arange(cage.bars), phases) / cage.bars)
    mirrored = np.real(back @ _complex(a).T)
    negative = np.real(back @ (1j * _complex(b)).T)
    values = np.stack([mirrored + negative, mirrored - negative], axis=1).reshape(2 * cage.bars, -1)
    return ngs.GridFunction(half.space), values, band.radius


def _parts(columns: NDArray) -> NDArray:
    """Complex columns as real ones, real part and imaginary part one after the other."""
    return np.stack([np.real(columns), np.imag(columns)], axis=2).reshape(len(columns), -1)


def _complex(columns: NDArray) -> NDArray:
    """The reverse of `_parts`."""
    return columns[:, ::2] + 1j * columns[:, 1::2]


def _load_vectors(
    band: roller_loads.Band, patches: Patches, forces: NDArray, bars: int
) -> tuple[NDArray, NDArray]:
    """Load vectors (unknowns, bars) of every pitch: its part that is its own mirror image, and the rest."""
    bar = 2 * pi * np.arange(bars) / bars
    around = np.stack([bar[:, None] + band.azimuth, bar[:, None] - band.azimuth], axis=1)  # (bars, 2, points)
    repeats = 2 * bars
    whole = replace(
        band, x=np.tile(band.x, repeats), azimuth=around.ravel(), area=np.tile(band.area, repeats),
        radii=np.tile(band.radii, repeats),
        along_x=csr_array((0, 0)), along_y=csr_array((0, 0)), along_z=csr_array((0, 0)),
    )  # fmt: skip
    y, z = (
        (traction @ forces.ravel()).reshape(around.shape)
        for traction in roller_loads.tractions(whole, patches)
    )
    s, c = np.sin(bar)[:, None, None], np.cos(bar)[:, None, None]
    outward, sideways = y * s + z * c, (y * c - z * s) * np.array([1.0, -1.0])[:, None]
    even, odd = (
        band.forces(*((field[:, 0] + sign * field[:, 1]).T / 2 for field in (sideways, outward)))
        for sign in (1, -1)
    )
    return even, odd


def _fields(half: HalfPitch, halves: tuple[ReducedHalfPitch, ReducedHalfPitch], bars: int) -> list[NDArray]:
    """Displacements (unknowns, 2 phases) of the symmetric part and of the other, as from `interior`."""
    faces: list[list[NDArray]] = [[], []]
    cuts = [each.cut for each in halves]
    for phase in range(bars // 2 + 1):
        columns, theta = slice(2 * phase, 2 * phase + 2), 2 * pi * phase / bars
        c, s = np.cos(theta / 2), np.sin(theta / 2)
        ties = np.repeat([[c, c, -s], [s, s, c]], half.cut.shape[1], axis=1)
        stiffness = sum(t[:, None] * f.stiffness * t for f, t in zip(cuts, ties, strict=True))
        pull = sum(t[:, None] * f.coupling[:, columns] for f, t in zip(cuts, ties, strict=True))
        try:
            z = cho_solve(cho_factor(stiffness), pull)
        except LinAlgError as refusal:
            raise NotSolved(f"phase {theta:.3g} rad could not be solved: {refusal}") from refusal
        for face, tie in zip(faces, ties, strict=True):
            face.append(tie[:, None] * z)
    return [
        interior(half, each, np.hstack(face), each.cut.share)
        for each, face in zip(halves, faces, strict=True)
    ]
