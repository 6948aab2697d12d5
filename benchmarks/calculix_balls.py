r"""A deep groove bearing in a soft housing, monolithic in CalculiX: `python -m benchmarks.calculix_balls`.

The 6209 of `configs/6209.toml` between a rigid inner ring and an elastic outer one, real groove and shoulders
of its section, bonded in a rubber-like layer whose outside is clamped; at rest, under a radial load on a ring
that does not tilt, and under a combined one on a ring that does. Both programs start from the same case.

CalculiX takes the whole at once: half of ring and layer of quadratic hexahedra (C3D20), large displacements
(under the radial load, where no contact turns, small ones, too, in the way of `benchmarks.calculix_springs`),
every ball a nonlinear spring (SPRINGA) between the groove centres, which carries only where it is pulled:

.. math:: L - A = (Q / K)^{2/3} - h Q

with K of both contacts in series and h Q the indentation of a half-space by the patch, which the ring yields
once more. The centre of the outer groove follows the race (*EQUATION): along the contact normal n the mean of
the normal displacements over a Gaussian patch around the contact, across it what this mean changes with the
contact angle,

.. math:: w = \langle u_n \rangle_\alpha\, n + \frac{d \langle u_n \rangle_\alpha}{d\alpha}\, t

so that the spring presses by normal tractions and a turn of the section about the groove centre moves
nothing. Patches are placed at the contact angles of the run before, until these settle. flexbearing has
instead stations at fixed angles with interpolation between them, harmonics around the axis, and linear
elasticity.

The inner ring is moved to a given place, as load control finds no solution through the clearance; flexbearing
gets the load that this takes. Needs the program `ccx`, on Debian in the package `calculix-ccx`.
"""

import argparse
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

import fem
import quasidynamic as qd
from benchmarks.calculix import NODES, halved, printed, rows
from benchmarks.calculix_springs import gauss, plastic_cube, serendipity
from benchmarks.machine import describe
from fem.half_space.gaussian_patch import patch_answers
from flexbearing import run
from flexbearing.api import read_case
from flexbearing.build.groove_parts import groove_part
from flexbearing.case.balls.deep_groove import DeepGrooveCase
from flexbearing.runs.angular_contact import bearing
from quasidynamic.balance.balls.angular_contact import race_contacts

CASE = "configs/6209.toml"
PATCH = 1.0  # [mm] standard deviation
RING = [
    "outer.kind=ring", "outer.thickness=3.65 mm", "outer.width=19 mm", "bearing.outer.shoulder=2.184 mm",
    "outer.support=housing", "outer.housing_thickness=4 mm", "outer.housing_width=19 mm",
    "outer.housing_support=seat", "materials.housing.youngs_modulus=0.2 GPa",
    "materials.housing.poisson_ratio=0.3", "materials.housing.density=1000 kg/m^3",
    f"accuracy.patch_width={PATCH} mm", "operation.inner_speed=0 rpm",
]  # fmt: skip
LOADS = ("axial", "radial_y", "radial_z", "moment_y", "moment_z")
UNITS = ("N", "N", "N", "N m", "N m")
HELD = ["operation.displacement.tilt_y=0 deg", "operation.displacement.tilt_z=0 deg"]
RADIAL = ["operation.load.radial_z=8 kN", *HELD]
LOAD_CASES = {
    "radial": (RADIAL, (2,), True),
    "radial, small displacements": (RADIAL, (2,), False),
    "combined": (["operation.load.radial_z=5 kN", "operation.load.axial=3 kN"], (0, 2, 3), True),
}  # for the place of the ring; directions in which it is free; whether displacements may be large
# elements on each shoulder, on the groove, along the radius of the ring and of the layer, on each side of a
# ball around the axis, between two balls
MESHES = ((1, 6, 2, 1, 2, 2), (2, 8, 2, 2, 3, 2), (2, 10, 3, 2, 4, 2))
NEAR = 0.12  # [rad] fine elements on each side of a ball
REACH = 4.0  # standard deviations of a patch
STEP = 1e-3  # [rad] of the change of a patch with the contact angle
MOST, POINTS = 8000.0, 150  # [N] end of the table of a spring; CalculiX 2.20 goes wrong above 200 points
RUNS, TURNED = 6, 3e-4  # of CalculiX at most, and change of the contact angles [rad] that ends them
LAWFUL = 1e-3  # of the largest load
MM = 1e3


@dataclass(frozen=True)
class Grid:
    """Half a ring and its layer: nodes on a grid twice as fine as the elements, 0 where there is none."""

    number: NDArray  # (2 axial + 1, 2 radial + 1, 2 around + 1)
    elements: NDArray  # (axial, radial, around, 20)
    place: NDArray  # (nodes, 3) x, r cos phi, r sin phi [mm]
    angles: NDArray  # [rad] contact angles of the nodes on the groove
    first: int  # of these along the axis
    radial: int  # elements of the ring along the radius
    azimuths: NDArray  # [rad]

    @cached_property
    def surface(self) -> tuple[NDArray, NDArray, NDArray, sparse.csr_array]:
        """Angles, azimuths and weights (points) on the groove, and shape functions there (points, nodes)."""
        (alpha, by_alpha), (phi, by_phi) = gauss(self.angles[::2], 4), gauss(self.azimuths[::2], 4)
        i, k = (
            np.searchsorted(ends[::2], at) - 1 for ends, at in ((self.angles, alpha), (self.azimuths, phi))
        )
        xi = (2 * (alpha - self.angles[2 * i]) / np.diff(self.angles[::2])[i] - 1)[:, None]
        eta = (2 * (phi - self.azimuths[2 * k]) / np.diff(self.azimuths[::2])[k] - 1)[None, :]
        point = np.arange(alpha.size * phi.size).reshape(alpha.size, phi.size)
        shapes = sparse.csr_array((point.size, len(self.place) + 1))
        for a, b in product((-1, 0, 1), repeat=2):
            if (a, b) == (0, 0):
                continue
            node = self.number[(self.first + 2 * i + 1 + a)[:, None], 0, (2 * k + 1 + b)[None, :]]
            value = np.broadcast_to(serendipity(xi, eta, a, b), point.shape)
            shapes += sparse.csr_array((value.ravel(), (point.ravel(), node.ravel())), shape=shapes.shape)
        grids = np.meshgrid(alpha, phi, indexing="ij"), np.outer(by_alpha, by_phi)
        return grids[0][0].ravel(), grids[0][1].ravel(), grids[1].ravel(), shapes


@dataclass(frozen=True)
class Model:
    """A bearing and its outer ring; balls of one half, the first under the load."""

    bearing: qd.AngularContactBearing
    ring: fem.OuterRing
    housing: fem.Housing

    @classmethod
    def of(cls, settings: list[str]) -> "Model":
        """Build from the case file."""
        case = read_case(CASE, settings)
        assert isinstance(case, DeepGrooveCase)
        ring = groove_part(case, "outer")
        assert isinstance(ring, fem.OuterRing)
        assert isinstance(ring.support, fem.Housing)
        return cls(bearing(case).bearing, ring, ring.support)

    @property
    def azimuths(self) -> NDArray:
        """Of the balls of one half [rad]."""
        return self.bearing.azimuths[: self.bearing.balls // 2 + 1]

    @property
    def counts(self) -> NDArray:
        """How often each of them is on the whole ring."""
        return np.where(self.azimuths == 0, 1, 2)

    @cached_property
    def groove(self) -> tuple[float, float]:
        """Radius of the groove, and of its centre from the axis [mm]."""
        assert self.ring.groove
        return MM * self.ring.groove.radius, MM * self.ring.groove.centre_radius

    @property
    def moves(self) -> NDArray:
        """Axial and radial move of the inner groove centre (balls, 2, 5) by the place of the ring."""
        sine, cosine, none = np.sin(self.azimuths), np.cos(self.azimuths), 0 * self.azimuths
        axial = np.stack([none + 1, none, none, cosine, -sine], axis=-1)
        return np.stack([axial, np.stack([none, sine, cosine, none, none], axis=-1)], axis=1)

    @cached_property
    def table(self) -> tuple[NDArray, NDArray]:
        """Loads [N] of a ball, and distances [mm] of the groove centres beyond that without load."""
        load = MOST * np.linspace(0.0, 1.0, POINTS) ** 3
        series = sum(each.coefficient ** (-2 / 3) for each in race_contacts(self.bearing))
        half_space = patch_answers(np.zeros(1), PATCH / MM, self.ring.materials["ring"])[0]
        approach = MM * (load ** (2 / 3) * series - half_space * load)
        if not (np.diff(approach) > 0).all():
            raise RuntimeError("the half-space yields more than the contact: the patches are too narrow")
        return load, approach + MM * (self.bearing.centre_distance - self.bearing.groove_offset[1])

    def meshed(self, shoulder: int, groove: int, radial: int, layer: int, near: int, between: int) -> Grid:
        """Half of ring and layer."""
        (radius, centre), ring = self.groove, self.ring
        land, half, outside = (
            MM * ring.raceway_diameter / 2,
            MM * ring.width / 2,
            MM * (ring.raceway_diameter / 2 + ring.thickness),
        )
        end = np.arccos((land - centre) / radius)
        alpha = halved(np.linspace(-end, end, groove + 1))
        away = halved(np.linspace(radius * np.sin(end), half, shoulder + 1))[1:]
        x = np.concatenate([-away[::-1], radius * np.sin(alpha), away])
        inside = np.concatenate([land + 0 * away, centre + radius * np.cos(alpha), land + 0 * away])
        deep = halved(np.linspace(0, 1, radial + 1) ** 1.4)
        r = inside[:, None] + deep * (outside - inside[:, None])
        further = outside + MM * self.housing.thickness * halved(np.linspace(0, 1, layer + 1))[1:]
        r = np.concatenate([r, np.broadcast_to(further, (len(x), len(further)))], axis=1)
        phi = halved(np.unique(np.round(list(self._ends(near, between)), 12)))
        shape = len(x), r.shape[1], len(phi)
        number, odd = np.zeros(shape, dtype=int), sum(np.indices(shape) % 2)
        number[odd <= 1] = np.arange(1, np.count_nonzero(odd <= 1) + 1)
        i, j, k = np.nonzero(number)
        place = np.stack([x[i], r[i, j] * np.cos(phi[k]), r[i, j] * np.sin(phi[k])], axis=1)
        first = 2 * np.stack(np.meshgrid(*(np.arange(n // 2) for n in shape), indexing="ij"), axis=-1)
        i, j, k = np.moveaxis(first[..., None, :] + NODES, -1, 0)
        return Grid(number, number[i, j, k], place, alpha, len(away), radial, phi)

    def _ends(self, near: int, between: int) -> Iterator[float]:
        """Azimuths where elements end."""
        pitch = 2 * np.pi / self.bearing.balls
        around = np.concatenate(
            [np.linspace(-NEAR, NEAR, 2 * near + 1), np.linspace(NEAR, pitch - NEAR, between + 1)]
        )
        for azimuth in self.azimuths:
            yield from (at for at in azimuth + around if -1e-9 < at < np.pi - NEAR / 4)
        yield np.pi

    def patch(self, grid: Grid, azimuth: float, angle: float) -> NDArray:
        """Shares (nodes + 1, 3) of the nodes in the mean normal displacement of a contact."""
        radius, centre = self.groove
        alpha, phi, weight, shapes = grid.surface
        arcs = radius * (alpha - angle), (centre + radius * np.cos(angle)) * (phi - azimuth)
        apart = np.hypot(*arcs) / PATCH
        share = np.where(apart < REACH, weight * np.exp(-(apart**2) / 2), 0.0)
        normal = directions(alpha, phi)
        found = shapes.T @ (share[:, None] * normal)
        if azimuth == 0.0:
            found[:, 2] = 0.0
        return found / (share @ (normal @ directions(angle, azimuth)))

    def centre(self, grid: Grid, azimuth: float, angle: float) -> NDArray:
        """Shares (2, nodes + 1, 3) of the nodes in the axial and radial move of the groove centre."""
        behind, normal, ahead = (self.patch(grid, azimuth, angle + part * STEP) for part in (-1, 0, 1))
        across, (sine, cosine) = (ahead - behind) / (2 * STEP), (np.sin(angle), np.cos(angle))
        return np.stack([sine * normal + cosine * across, cosine * normal - sine * across])


class Found(NamedTuple):
    """What a program finds; balls of one half."""

    loads: NDArray  # [N]
    angles: NDArray  # [rad]
    moved: NDArray  # (balls, 2) [mm] axial and radial displacement of the outer groove centres
    carried: NDArray  # (5) load of the whole ring [N, N m]


def directions(angle: NDArray | float, azimuth: NDArray | float) -> NDArray:
    """Outward normals of the groove (..., 3)."""
    parts = np.sin(angle), np.cos(angle) * np.cos(azimuth), np.cos(angle) * np.sin(azimuth)
    return np.stack(np.broadcast_arrays(*parts), axis=-1)


def deck(model: Model, grid: Grid, angles: NDArray, place: NDArray, large: bool) -> str:
    """Input of CalculiX with patches at contact angles and the inner ring at a place (5) [m, R_i rad]."""
    count, last, total = len(model.azimuths), len(grid.place), grid.elements[..., 0].size
    outer, inner = last + 1 + np.arange(count), last + 1 + count + np.arange(count)
    across, start = directions(0.0, model.azimuths), model.table[1][0]
    length = MM * model.bearing.groove_offset[1]
    numbers, steel = np.arange(1, total + 1).reshape(grid.elements.shape[:3]), model.ring.materials["ring"]
    lines = [
        "*NODE, NSET=ALL", *rows(np.arange(1, last + 1), grid.place),
        "*NODE, NSET=OUTER", *rows(outer, model.groove[1] * across),
        "*NODE, NSET=INNER", *rows(inner, (model.groove[1] + length) * across),
        *solid("RING", numbers[:, : grid.radial], grid.elements[:, : grid.radial], steel),
        *solid("LAYER", numbers[:, grid.radial :], grid.elements[:, grid.radial :], model.housing.elastic),
        "*NSET, NSET=SEAT", *(f"{n}," for n in grid.number[:, -1].ravel() if n),
        "*NSET, NSET=MIDDLE", *(f"{n}," for n in grid.number[:, :-1, [0, -1]].ravel() if n),
        "*BOUNDARY", "SEAT, 1, 3", "MIDDLE, 3, 3",
    ]  # fmt: skip
    for node, azimuth, angle in zip(outer.tolist(), model.azimuths, angles, strict=True):
        axial, radial = model.centre(grid, azimuth, angle)
        lines += follows(node, 1, axial)
        lines += follows(node, 2, np.cos(azimuth) * radial)
        lines += follows(node, 3, np.sin(azimuth) * radial) if azimuth else ["*BOUNDARY", f"{node}, 3, 3"]
    force, distance = model.table
    for ball, part in enumerate(model.counts / 2):
        lines += [
            f"*ELEMENT, TYPE=SPRINGA, ELSET=BALL{ball}",
            f"{total + 1 + ball}, {outer[ball]}, {inner[ball]}",
        ]
        lines += [f"*SPRING, ELSET=BALL{ball}, NONLINEAR", f"0., {start - 10.0:.11f}"]
        lines += [f"{part * f:.11f}, {a:.11f}" for f, a in zip(force, distance, strict=True)]
    if not large:
        lines += plastic_cube(int(inner[-1]) + 1, total + count + 1)
    lines += [
        f"*STEP, INC=200{', NLGEOM' if large else ''}", "*STATIC", "0.5, 1.",
        "*CONTROLS, PARAMETERS=FIELD", "1e-6, 1e-4", "*BOUNDARY",
    ]  # fmt: skip
    for node, azimuth, (axial, radial) in zip(inner, model.azimuths, MM * (model.moves @ place), strict=True):
        moved = axial, radial * np.cos(azimuth), radial * np.sin(azimuth)
        lines += [f"{node}, {way}, {way}, {to:.11f}" for way, to in enumerate(moved, 1)]
    lines += ["*NODE PRINT, NSET=INNER", "RF", "*NODE PRINT, NSET=OUTER", "U", "*END STEP"]
    return "\n".join(lines) + "\n"


def solid(name: str, numbers: NDArray, elements: NDArray, elastic: fem.Elastic) -> Iterator[str]:
    """Elements of one material."""
    yield f"*ELEMENT, TYPE=C3D20, ELSET={name}"
    for number, nodes in zip(numbers.ravel(), elements.reshape(-1, 20), strict=True):
        yield f"{number}, " + ", ".join(map(str, nodes[:10])) + ","
        yield ", ".join(map(str, nodes[10:]))
    yield from (f"*MATERIAL, NAME={name}", "*ELASTIC")
    yield f"{elastic.youngs_modulus / MM**2}, {elastic.poisson_ratio}"
    yield f"*SOLID SECTION, ELSET={name}, MATERIAL={name}"


def follows(node: int, direction: int, shares: NDArray) -> Iterator[str]:
    """Equation that moves a node by shares (nodes + 1, 3) of others."""
    others, ways = np.nonzero(np.abs(shares) > 1e-12)
    terms = [f"{node}, {direction}, -1."]
    terms += [f"{n}, {way + 1}, {shares[n, way]:.12f}" for n, way in zip(others, ways, strict=True)]
    yield from ("*EQUATION", str(len(terms)))
    yield from (", ".join(terms[first : first + 4]) for first in range(0, len(terms), 4))


def calculix(
    program: str, model: Model, grid: Grid, place: NDArray, near: Found, large: bool
) -> tuple[Found, float]:
    """What CalculiX finds at a place of the inner ring, patches at first as `near`, and its seconds."""
    angles, seconds = near.angles, 0.0
    for _ in range(RUNS):
        text, more = printed(program, deck(model, grid, angles, place, large))
        found, seconds = read(model, text, place), seconds + more
        turned, angles = np.abs(found.angles - angles).max(), found.angles
        print(f"    contact angles turned by {np.degrees(turned):.4f} deg, {more:.0f} s", flush=True)
        if turned < TURNED:
            return found, seconds
    raise RuntimeError("contact angles of CalculiX do not settle")


def read(model: Model, text: str, place: NDArray) -> Found:
    """Loads, angles and displacements from what CalculiX printed at last, where springs obey their law."""
    if "time  0.1000000E+01" not in text:
        raise RuntimeError("CalculiX did not move the inner ring all the way")
    words = [line.split() for line in text.splitlines()]
    numbers = [word[1:] for word in words if len(word) == 4 and word[0].isdigit()]
    count, across = len(model.azimuths), directions(0.0, model.azimuths)
    forces, moved = np.array(numbers[-2 * count :], dtype=float).reshape(2, count, 3)
    pairs = [np.stack([each[:, 0], (each * across).sum(axis=1)], axis=1) for each in (forces, moved)]
    force, centre = pairs[0] * (2 / model.counts)[:, None], pairs[1]
    start = np.array([0.0, MM * model.bearing.groove_offset[1]])
    apart = start + MM * (model.moves @ place) - centre
    loads, (known, distance) = np.hypot(*force.T), model.table
    lawful = np.interp(np.hypot(*apart.T) - start[1], distance, known)
    error = np.abs(loads - lawful).max() / loads.max()
    if not error < LAWFUL or loads.max() > MOST:
        raise RuntimeError(f"the springs of CalculiX are {error:.1e} of the largest load off their law")
    carried = np.einsum("jap,ja,j->p", model.moves, force, model.counts)
    carried[3:] *= model.bearing.inner_groove_radius
    carried[[1, 4]] = 0.0  # the other half
    return Found(loads, np.where(loads > 0, np.arctan2(*force.T), 0.0), centre, carried)


def ours(settings: list[str]) -> tuple[Found, NDArray]:
    """What flexbearing finds, and the place of its ring (5) [m, R_i rad]."""
    with tempfile.TemporaryDirectory() as folder:
        result = run(CASE, [*RING, *settings], output=f"{folder}/out.h5")
    if result.attributes["status"] != "converged":
        raise RuntimeError(f"flexbearing: {result.attributes['message']}")
    block, model = result.flexible, Model.of([*RING, *settings])
    half = slice(len(model.azimuths))
    place = block["ring_displacement"] * np.array([1, 1, 1, *[model.bearing.inner_groove_radius] * 2])
    loads = block["contact_load"][1, half]
    angles = np.where(loads > 0, block["contact_angle"][1, half], 0.0)
    return Found(loads, angles, np.empty(0), block["ring_load"]), place


def under(name: str, carried: Sequence[float] | NDArray) -> tuple[Found, NDArray]:
    """The same under a load (5) that CalculiX finds in one of its cases."""
    settings, free, _ = LOAD_CASES[name]
    held = [each for each in settings if each in HELD]
    return ours([*held, *(f"operation.load.{LOADS[way]}={carried[way]:.4f} {UNITS[way]}" for way in free)])


def compared(program: str, name: str, meshes: int) -> None:
    """Print both programs side by side for each mesh."""
    settings, _, large = LOAD_CASES[name]
    (near, place), model = ours(settings), Model.of([*RING, *settings])
    print(f"{name}: inner ring moved by {listed(MM * place, '.6f')} mm, tilts times R_i")
    for counts in MESHES[:meshes]:
        grid = model.meshed(*counts)
        print(f"  {grid.elements[..., 0].size} elements, {len(grid.place)} nodes")
        found, seconds = calculix(program, model, grid, place, near, large)
        own, moved = under(name, found.carried)
        print(f"    load {listed(found.carried, '.3f')} N, N m; {seconds:.0f} s of the processor")
        for text, each in (("ccx ", found), ("ours", own)):
            print(f"    {text} {listed(each.loads, '.1f')} N; {listed(np.degrees(each.angles), '.3f')} deg")
        off = 100 * np.abs(own.loads - found.loads).max() / found.loads.max()
        turned = np.degrees(np.abs(own.angles - found.angles)[found.loads > 0].max())
        print(f"    loads within {off:.3f} % of the largest, angles {turned:.3f} deg")
        print(f"    inner ring of flexbearing {listed(1e6 * (moved - place), '+.2f')} um further", flush=True)


def listed(values: NDArray, shown: str) -> str:
    """Numbers in a row."""
    return ", ".join(format(value, shown) for value in values)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--meshes", type=int, default=len(MESHES), help="the coarsest of them")
    parser.add_argument("--only", choices=LOAD_CASES)
    options = parser.parse_args()
    program = shutil.which("ccx")
    if program is None:
        print("CalculiX is not installed: there is no program `ccx`. On Debian: apt install calculix-ccx")
        return
    print(describe())
    for name in [options.only] if options.only else LOAD_CASES:
        compared(program, name, options.meshes)


if __name__ == "__main__":
    main()
