r"""Displacement and stress of a body of revolution under its rollers or balls, in harmonics on its section.

.. math:: F_{nm}(\varphi) = \frac{2 - \delta_{n0}}{2\pi} e^{-(n s/R)^2/2}
          \sum_j F_{jm} e^{in(\varphi - \varphi_j)}, \quad
          \varepsilon(\varphi) = \sum_{nm} \varepsilon_{nm} \{\mathrm{Re}, \mathrm{Im}\} F_{nm}(\varphi)

with the real part for what is its own mirror image in the plane of a roller, the imaginary part for the rest,
and s the width of a roller's patch; those of balls fade as in `fem.raceway.stations`. Heat and rotation come
on top, in harmonic 0.

Source
------
Fourier series of Gaussian patches on a body of revolution; derived here.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import lru_cache
from math import ceil, pi
from typing import Any

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly.factorisation import threads
from fem.assembly.harmonic_stiffness import HarmonicAnswers, answers
from fem.mesh.axial_section import sections
from fem.mesh.moved_nodes import Faces
from fem.mesh.notches import notches
from fem.mesh.section_mesh import faces_of
from fem.mesh.solid import MILLIMETRES
from fem.parts.boundary_conditions import FreeMotions
from fem.parts.groove import BallPatches
from fem.parts.part import Part
from fem.parts.resolution import Resolution, Shape
from fem.parts.rings import MeshSize, Patches
from fem.parts.surroundings import Surroundings
from fem.raceway.stations import fade
from fem.section.expansion import heating, rotation
from fem.section.raceway_shapes import body_of_revolution, raceway_modes
from fem.section.revolved_body import Body
from fem.section.rigid_body_modes import held_on_points
from fem.solid.extremes import NOWHERE, Samples
from fem.solid.lattice import Spread, hooke, located, spread

SMOOTH = 4.3  # standard deviations of a Gaussian's spectrum, beyond which 1e-4 of it is left
STEPS = 3.0  # azimuths over the width of a patch
BETWEEN = 9  # azimuths of fine samples, from half way before a coarse one to half way after it
CHUNK = 64  # azimuths of a piece
AXES = [0, 1, 2, 3, 5, 4]  # xx, rr, tt, xr, rt, xt of what the forms give as xx, rr, tt, xr, xt, rt
EVEN = [0, 1, 2, 3]  # of them, which go with the cosine


@dataclass(frozen=True)
class Field:
    """What one order of displacements answers."""

    body: Body
    elements: HarmonicAnswers  # to the shapes of the raceway, a unit of force per radian each
    steady: NDArray  # (unknowns,) of heat and rotation [m]


@dataclass(frozen=True, kw_only=True)
class LoadedSection:
    """A body of revolution under rollers or balls; see `fem.solid.extremes.Sampled`."""

    part: Part  # a cage with its bars spread evenly
    patches: Patches | BallPatches
    forces: NDArray  # (Z, M) [N] positive outward; of a groove on all stations of one arc, then of the other
    surroundings: Surroundings
    fields: tuple[Field, Field]  # of the lower and the higher order
    moved: tuple[Faces, Faces] | None = None  # with which nodes of another mesh were moved, before and after

    @property
    def radius(self) -> float:
        """Of the raceway [m]."""
        return self.part.raceway_diameter / 2

    @property
    def azimuths(self) -> NDArray:
        """Of coarse samples [rad]."""
        count = ceil(2 * pi * STEPS * self.radius / self.patches.width)
        return 2 * pi * np.arange(count) / count

    def pieces(self, body: str) -> Iterable[int]:
        """Sectors of some azimuths."""
        return range(ceil(self.azimuths.size / CHUNK))

    def samples(
        self, body: str, piece: int, intervals: int, keys: NDArray | None = None, *, higher: bool = True
    ) -> Samples:
        """Samples of a sector; the key of an element holds its azimuth, too."""
        of_order, elements = self.fields[higher], self.fields[higher].body.space.mesh.ne
        if keys is None:
            number = np.arange(piece * CHUNK, min((piece + 1) * CHUNK, self.azimuths.size))
            return self._at(of_order, body, intervals, None, self.azimuths[number], number * elements)
        parts = []
        for number in np.unique(keys // elements):
            step = self.azimuths[1] / 2 * np.linspace(-1, 1, BETWEEN)
            wanted = keys[keys // elements == number] % elements
            azimuth = self.azimuths[number] + step
            parts.append(
                self._at(of_order, body, intervals, wanted, azimuth, np.full(BETWEEN, number * elements))
            )
        return Samples(*(np.concatenate(column) for column in zip(*parts, strict=True)))

    def at(self, body: str, piece: int, places: NDArray, *, higher: bool = True) -> Samples:
        """Samples at those of some places (n, 3) [m] that lie in a sector, in axes x, r, t."""
        x, y, z = places.T
        step = self.azimuths[1]
        azimuth = (np.arctan2(y, z) + step / 2) % (2 * pi) - step / 2
        low, high = ((piece + k) * CHUNK - 0.5 for k in (0, 1))
        kept = (azimuth >= low * step) & (azimuth < high * step)
        if not kept.any():
            return NOWHERE
        flat = np.stack([x, np.hypot(y, z)], axis=1)[kept] * MILLIMETRES
        of_order = self.fields[higher]
        points, which = located(of_order.body.space.mesh, body, flat, self.moved)
        return self._of(of_order, body, points, azimuth[kept][which])

    def _at(
        self,
        of_order: Field,
        body: str,
        intervals: int,
        elements: NDArray | None,
        azimuth: NDArray,
        key: NDArray,
    ) -> Samples:
        """Samples (points times azimuths) in some elements of the section, None: in all of the body."""
        rims = notches(self.part).around(intervals) * MILLIMETRES
        points = spread(of_order.body.space.mesh, body, intervals, elements, rims)
        samples = self._of(of_order, body, points, azimuth, everywhere=True)
        middle = np.abs(np.arange(azimuth.size) - azimuth.size // 2) % 2 == 0
        even = points.even[:, None] & (middle if elements is not None else True)
        even = np.broadcast_to(even, (points.key.size, azimuth.size))
        return samples._replace(key=(points.key[:, None] + key).ravel(), even=even.ravel())

    def _of(
        self, of_order: Field, body: str, points: Spread, azimuth: NDArray, *, everywhere: bool = False
    ) -> Samples:
        """Samples of points, each at its azimuth, or everywhere at all of some azimuths."""
        x, r = ngs.CF((ngs.x, ngs.y))(points.mapped).T / MILLIMETRES
        moved, plain, turned = _strains(of_order, points.mapped, r)
        cosine, sine = self._waves(of_order.elements, azimuth)
        of = np.matmul if everywhere else _each
        strain = np.stack([
            of(plain[:, c], wave[0]) + of(turned[:, c], wave[1])
            for c, wave in enumerate(cosine if c in EVEN else sine for c in range(6))
        ], axis=-1)  # fmt: skip
        shift = np.stack([of(moved[:, c], wave[0]) for c, wave in enumerate((cosine, cosine, sine))], axis=-1)
        strain[..., :3] -= self.surroundings.thermal_strains.get(body, 0.0)
        stress = hooke(strain[..., AXES], self.part.materials[body])
        s, c = np.sin(azimuth), np.cos(azimuth)
        x, r = (x[:, None], r[:, None]) if everywhere else (x, r)
        place = np.stack(np.broadcast_arrays(x, r * s, r * c), axis=-1)
        return Samples(
            points.key, points.even, place.reshape(-1, 3), shift.reshape(-1, 3), stress.reshape(-1, 6)
        )  # fmt: skip

    def _waves(self, elements: HarmonicAnswers, azimuth: NDArray) -> tuple[NDArray, NDArray]:
        """Factors of the basis and the steady field (2, B + 1, azimuths), with the cosine and the sine.

        The first are for strains without the harmonic n, the second for those with it.
        """
        n = np.arange(len(elements.factors))
        weight = self._spectrum(n) / pi
        weight[0] /= 2
        own = np.exp(-1j * np.outer(n, self.patches.azimuths)) @ self.forces * weight
        load = np.einsum("nbm,nm->bn", elements.factors, own)
        turn = np.exp(1j * np.outer(n, azimuth))
        waves = np.stack([load @ turn, (load * n) @ turn])
        steady = np.zeros((2, 1, azimuth.size))
        steady[0] = 1.0
        return np.hstack([np.real(waves), steady]), np.hstack([np.imag(waves), 0 * steady])

    def _spectrum(self, n: NDArray) -> NDArray:
        """Share of a line that patches carry in harmonics (N + 1, M), or (N + 1, 1) of rollers [-]."""
        groove, patches = self.part.groove, self.patches
        if groove is not None and isinstance(patches, BallPatches):
            angles = np.tile(patches.stations.angles, len(groove.sides))
            return fade(groove, self.part.outward, angles, patches.width, int(n[-1]))
        return np.exp(-((n[:, None] * patches.width / self.radius) ** 2) / 2)


def _each(fields: NDArray, waves: NDArray) -> NDArray:
    """Every point (n, B) by its own wave (B, n)."""
    return np.einsum("nb,bn->n", fields, waves)


def _strains(of_order: Field, mapped: Any, radius: NDArray) -> tuple[NDArray, NDArray, NDArray]:
    """Displacement (n, 3, B + 1), strain without the harmonic and that with it (n, 6, B + 1) of the basis."""
    fields = np.column_stack([of_order.elements.basis, of_order.steady])
    values = ngs.GridFunction(of_order.body.space)
    gradient = ngs.CF(tuple(ngs.Grad(component) for component in values.components))
    moved, plain, turned = (np.zeros((radius.size, k, fields.shape[1])) for k in (3, 6, 6))
    for k, column in enumerate(fields.T):
        values.vec.FV().NumPy()[:] = column
        u = ngs.CF(tuple(values.components))(mapped)
        d = MILLIMETRES * gradient(mapped)
        hoop, twist = u[:, 1] / radius, u[:, 2] / radius
        moved[:, :, k] = u
        plain[:, :, k] = np.stack(
            [d[:, 0], d[:, 3], hoop, d[:, 2] + d[:, 1], d[:, 4], d[:, 5] - twist], axis=1
        )
        turned[:, 2, k], turned[:, 4, k], turned[:, 5, k] = twist, -u[:, 0] / radius, -hoop
    return moved, plain, turned


@threads(1)  # sections are small: a second thread would only wait
def loaded_section(
    part: Part,
    patches: Patches | BallPatches,
    forces: NDArray,
    mesh_size: MeshSize,
    surroundings: Surroundings | None = None,
    nodes_of: Shape | None = None,
) -> LoadedSection:
    """Solve a body of revolution under rollers or balls, by two orders of displacements.

    Forces (Z, M) [N] are those of `fem.assembly.roller_loads`, or on stations of a groove, arc by arc,
    positive outward; the part is held in every direction, a cage may have a groove. `mesh_size` has the
    higher order, 2 or more; surroundings are heat and rotation; with `nodes_of` the mesh of another part and
    band is taken, its nodes moved to these.
    Raises `ImpossiblePart` if the part is not known as a body of revolution, `NotSolved` if a solve fails.

    Valid
    -----
    Small displacement, perfect bonds, clamps that are rigid to rollers but follow heat and rotation; no load
    outside the band.
    """
    around = surroundings or Surroundings()
    last = ceil(SMOOTH * part.raceway_diameter / 2 / patches.width)
    fields = []
    for order in (mesh_size.order - 1, mesh_size.order):
        mesh = replace(mesh_size, order=order)
        body, elements = _answered(part, _resolution(patches, mesh, nodes_of), last)
        fields.append(Field(body, elements, _steady(body, around)))
    lower, higher = fields
    moved = None
    if nodes_of is not None:
        before, after = sections(nodes_of.part, nodes_of.length), sections(part, patches.length)
        moved = faces_of(before), faces_of(after)
    return LoadedSection(
        part=part,
        patches=patches,
        forces=forces,
        surroundings=around,
        fields=(lower, higher),
        moved=moved,
    )


def _resolution(patches: Patches | BallPatches, mesh: MeshSize, nodes_of: Shape | None) -> Resolution:
    plain = {"length": patches.length, "mesh_size": mesh, "nodes_of": nodes_of}
    if isinstance(patches, BallPatches):
        return Resolution(**plain, stations=patches.stations)
    return Resolution(**plain, axial_modes=patches.axial_modes)


@lru_cache(maxsize=4)  # both orders of both rings: only the forces differ from row to row of a study
def _answered(part: Part, resolution: Resolution, last: int) -> tuple[Body, HarmonicAnswers]:
    body = body_of_revolution(part, resolution)
    return body, answers(body.stiffness, raceway_modes(body, part, resolution), last)


def _steady(body: Body, around: Surroundings) -> NDArray:
    """Displacement (unknowns,) by heat and rotation [m]."""
    load = np.zeros(body.stiffness.unknowns)
    if any(around.thermal_strains.values()):
        load += heating(body, around.thermal_strains)
    if around.speed:
        load += rotation(body, around.densities, around.speed)
    if not load.any():
        return np.zeros_like(load)
    free = replace(body, stiffness=replace(body.stiffness, clamped=np.zeros_like(body.stiffness.clamped)))
    held = held_on_points(free, FreeMotions(axial=True, turning=True, across=True), 0)
    return held.solve(0, load[:, None])[:, 0]
