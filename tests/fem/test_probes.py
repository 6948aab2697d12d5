"""Readings of probes against closed forms, the fields that they are read of, and each other."""

from dataclasses import replace
from math import cos, pi, radians, sin
from types import SimpleNamespace

import numpy as np
import pytest
from pytest import approx

from fem import (
    ClampedFace,
    Elastic,
    Foundation,
    Housing,
    ImpossiblePart,
    MeshSize,
    OuterRing,
    Patches,
    RingOnShaft,
    SquirrelCage,
    Stations,
)
from fem.mesh.notches import Notches
from fem.parts.bar_section import bar_section
from fem.parts.bolted_ring import BoltedRing
from fem.parts.groove import BallPatches, Groove
from fem.parts.probe import Probe, radius, walls
from fem.parts.surroundings import Surroundings
from fem.section.loaded_section import loaded_section
from fem.solid.clearing import Clearing, GrooveArc, clearing
from fem.solid.extremes import extremes, von_mises
from fem.solid.lattice import hooke, hooke_reversed
from fem.solid.probes import readings
from fem.squirrel_cage.loaded_cage import loaded_cage

STEEL = Elastic(youngs_modulus=203e9, poisson_ratio=0.28)
POINT = Probe(azimuth=0.0, x=0.0, outside=True, depth=0.0, angle=0.0, length=0.0)
# A square bar bent to a circle, on springs that are soft beside it: under balanced loads a free ring.
SOFT = Foundation(axial=2e4, radial=2e4, tangential=2e4)
BAR = OuterRing(raceway_diameter=75e-3, thickness=1.2e-3, width=1.2e-3, elastic=STEEL, support=SOFT)
PULL = 10.0  # [N] outward at both ends of a diameter


def patches(part, azimuths, width):
    return Patches(azimuths=azimuths, length=part.width, axial_modes=2, width=width)


def pulled(turned=0.0):
    loads = patches(BAR, (turned, turned + pi), 0.8e-3)
    size = MeshSize(order=4, size=0.6e-3, raceway_size=0.6e-3)
    return loaded_section(BAR, loads, np.array([[PULL, 0.0]] * 2), size)


def read(sampled, part, *probes, width=1e-3):
    """Readings by name, the probes first."""
    found = readings(sampled, part, probes, width)
    largest, smallest = found.principal_strains
    return SimpleNamespace(
        displacement=found.displacement.T, strain=found.strain.T, axial_strain=found.strain[0],
        hoop_strain=found.strain[2], radial_displacement=found.displacement[1],
        gauge_strain=found.gauge_strain, strain_error=found.strain_error, largest_strain=largest,
        smallest_strain=smallest,
    )  # fmt: skip


@pytest.fixture(scope="module")
def pulled_ring():
    return pulled()


def test_hoop_strain_of_a_ring_pulled_at_a_diameter_is_that_of_a_curved_bar(pulled_ring):
    r"""M = P R (|sin|/2 - 1/pi), N = P |sin|/2 on the middle line, stress by Winkler, Timoshenko part II."""
    t = BAR.thickness
    middle, area = BAR.raceway_diameter / 2 + t / 2, t * BAR.width
    for degrees in (15.0, 60.0, 90.0, 155.0, 300.0):
        s = abs(sin(radians(degrees)))
        neutral = t / np.log((middle + t / 2) / (middle - t / 2))
        force, moment = PULL * s / 2, -PULL * middle * (s / 2 - 1 / pi)
        both = read(
            pulled_ring,
            BAR,
            *(replace(POINT, azimuth=radians(degrees), outside=side) for side in (True, False)),
        )
        for place, r in enumerate((middle + t / 2, middle - t / 2)):
            bending = moment * (r - neutral) / (area * (middle - neutral) * r)
            expected = (force / area + bending) / STEEL.youngs_modulus
            assert both.hoop_strain[place] == approx(expected, rel=0.01), (degrees, place)


def test_diameters_of_the_pulled_ring_change_as_those_of_a_thin_one(pulled_ring):
    t = BAR.thickness
    middle, stiffness = (BAR.raceway_diameter + t) / 2, STEEL.youngs_modulus * BAR.width * t**3 / 12
    found = read(pulled_ring, BAR, *(replace(POINT, azimuth=a) for a in (0.0, pi / 2, pi, -pi / 2)))
    along, across = found.radial_displacement.reshape(2, 2).sum(axis=0)
    assert along == approx(PULL * middle**3 / stiffness * (pi / 4 - 2 / pi), rel=0.01)
    assert across == approx(-PULL * middle**3 / stiffness * (2 / pi - 1 / 2), rel=0.01)


LAND, GROOVE = 37.5e-3, Groove(radius=0.6e-3, centre_radius=37.1e-3)
GROOVED = OuterRing(
    raceway_diameter=2 * LAND, thickness=2e-3, width=2e-3, elastic=STEEL, support=SOFT, groove=GROOVE
)  # fmt: skip


def bolted(race):
    """A ring of the same section with two arcs, on a bolted face that is hardly held."""
    outward = {"outer": 1, "inner": -1}[race]
    return BoltedRing(
        race=race, groove=Groove(radius=0.6e-3, centre_radius=LAND - 0.4e-3 * outward, aside=0.05e-3),
        raceway_diameter=2 * LAND, far_diameter=2 * LAND + 4e-3 * outward, width=2e-3, face_distance=1e-3,
        face_side=1, elastic=STEEL, normal_stiffness=1e5, shear_stiffness=1e5,
    )  # fmt: skip


FOUR_POINT, FOUR_POINT_INNER = bolted("outer"), bolted("inner")
ON_ARCS = (0.35, 0.46, 0.57)  # [rad] stations of each arc


def pinched(ring=GROOVED, turned=0.0, finer=1, forces=None, width=0.15e-3):
    """A ring that two balls press apart, at stations of its groove; on elements so much smaller.

    On two arcs they press the middle of both, with the same force outward.
    """
    middle = PULL * np.array([0.0, 1.0, 0.0])
    if two := len(ring.groove.sides) > 1:
        middle = np.tile(middle, 2) / (2 * cos(ON_ARCS[1]))
    stations = Stations(angles=ON_ARCS if two else (-0.5, 0.0, 0.5), width=width)
    across = ring.groove.width(LAND, ring.outward)
    loads = BallPatches(azimuths=(turned, turned + pi), length=across, stations=stations)
    size = MeshSize(order=3 + finer, size=1e-3 / finer, raceway_size=0.4e-3 / finer)
    return loaded_section(ring, loads, np.array([middle] * 2) if forces is None else forces, size)


@pytest.fixture(scope="module")
def pinched_ring():
    return pinched()


def grooved_strain(degrees, r, ring=GROOVED):
    """Of the section with its groove, as above: its area, middle and neutral line by sums over its height."""
    (wall,), groove = walls(ring), ring.groove
    height = np.linspace(*wall[2:], 20001)
    below = np.maximum(groove.radius**2 - (height - groove.centre_radius) ** 2, 0.0)
    wide = ring.width - 2 * np.maximum(np.sqrt(below) - groove.aside, 0.0)
    area, moment, curved = (np.trapezoid(wide * f, height) for f in (1.0, height, 1 / height))
    middle, neutral = moment / area, area / curved
    s = abs(sin(radians(degrees)))
    bending = -PULL * middle * (s / 2 - 1 / pi) * (r - neutral) / (area * (middle - neutral) * r)
    return (PULL * s / 2 / area + bending) / STEEL.youngs_modulus


@pytest.mark.parametrize(
    "ring", [GROOVED, FOUR_POINT, FOUR_POINT_INNER], ids=["one arc", "two arcs", "two arcs, inner"]
)
def test_hoop_strain_of_a_grooved_ring_between_two_balls_is_that_of_a_curved_bar(ring, pinched_ring):
    """Opposite the groove, at its bottom, on a shoulder: the surface follows the groove."""
    loaded = pinched_ring if ring is GROOVED else pinched(ring)
    (wall,), outer = walls(ring), ring.outward > 0
    faces = [
        (replace(POINT, outside=outer), wall[3 if outer else 2]),
        (replace(POINT, outside=not outer), ring.groove.bottom(ring.outward)),
        (replace(POINT, outside=not outer, x=0.7e-3), LAND),
    ]
    for degrees in (20.0, 90.0, 155.0, 300.0):
        found = read(loaded, ring, *(replace(p, azimuth=radians(degrees)) for p, _ in faces))
        expected = [grooved_strain(degrees, r, ring) for _, r in faces]
        assert found.hoop_strain == approx(expected, rel=0.01), degrees


def test_places_count_beyond_the_reach_of_the_arc_that_a_ball_presses(pinched_ring):
    clear = clearing(GROOVED, pinched_ring.patches, pinched_ring.forces, pinched_ring.radius)
    bottom = GROOVE.bottom(1)
    places = np.array([[0.0, 0.0, bottom + 0.59e-3], [0.0, 0.0, bottom + 0.61e-3], [0.0, bottom, 0.0]])
    assert clear(places).tolist() == [False, True, True]
    for outward in (1, -1):
        arc = GrooveArc(GROOVE, outward, (-0.3, 0.6))
        towards = outward * np.array([[sin(a), 0.0, cos(a)] for a in (0.2, 1.0)])
        centre = np.array([0.0, 0.0, GROOVE.centre_radius])
        on_arc = centre + outward * GROOVE.radius * np.array([[sin(a), 0.0, cos(a)] for a in (0.2, 0.6)])
        assert arc.nearest(centre + 2 * GROOVE.radius * towards, 0.0) == approx(on_arc, rel=1e-12)


def test_contacts_that_no_place_is_near_to_are_left_out_rightly():
    """Places of a sector, also across +-180 degrees and all around, against the distance from every arc."""
    random = np.random.default_rng(1)
    loaded = [(GrooveArc(GROOVE, 1, (-0.3, 0.6)), phi) for phi in random.uniform(-7.0, 7.0, 12)]
    for begin, sector, reach in ((3.0, 0.4, 2e-3), (-1.0, 6.3, 2e-3), (0.0, 0.4, 50e-3)):
        clear = Clearing(
            part=GROOVED, sharp=Notches(np.zeros((0, 2, 2)), 0.0), loaded=loaded, reach=reach, tips=None
        )
        azimuth, radius = begin + random.uniform(0.0, sector, 400), random.uniform(36e-3, 40e-3, 400)
        places = np.stack([0 * radius, radius * np.sin(azimuth), radius * np.cos(azimuth)], axis=1)
        far = [np.linalg.norm(places - arc.nearest(places, phi), axis=1) > reach for arc, phi in loaded]
        assert (clear(places) == np.all(far, axis=0)).all()


ON_SHAFT = RingOnShaft(
    raceway_diameter=2 * LAND, track_width=2e-3, rib_diameter=None, bore=2 * LAND - 4e-3, width=2e-3,
    shaft_bore=2 * LAND - 8e-3, shaft_length=4e-3, ring=STEEL, shaft=STEEL,
    groove=Groove(radius=0.6e-3, centre_radius=LAND + 0.4e-3),
)  # fmt: skip


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("ring", [ON_SHAFT, FOUR_POINT, FOUR_POINT_INNER], ids=["on shaft", "outer", "inner"])
def test_arc_that_a_ball_presses_is_where_it_is_stressed(ring, side):
    """Its mirror image counts: of an inner race the arc towards +x is pressed to -x."""
    if two := len(ring.groove.sides) > 1:
        ring = replace(ring, normal_stiffness=1e15, shear_stiffness=1e15)
    forces = np.zeros((2, 6 if two else 3))
    forces[:, (1 if side > 0 else 4) if two else 1 + side] = PULL * ring.outward
    loaded = pinched(ring, forces=forces, width=0.1e-3)
    samples = loaded.samples("ring", 0, 4)
    place = samples.place[von_mises(samples.stress).argmax()]
    clear = clearing(ring, loaded.patches, loaded.forces, loaded.radius)
    assert np.sign(place[0]) == side * ring.outward
    assert clear(np.stack([place, place * [-1, 1, 1]])).tolist() == [False, True]


@pytest.mark.slow
def test_largest_stress_of_a_grooved_ring_is_above_a_ball_on_its_outside(pinched_ring):
    """Beyond the reach of the patches: the groove, where the shoulder is pressed more, does not count."""
    clear = clearing(GROOVED, pinched_ring.patches, pinched_ring.forces, pinched_ring.radius)
    tension = extremes(pinched_ring, "ring", clear).tension
    assert sin(tension.azimuth) == approx(0.0, abs=0.05)
    assert tension.radius == approx(LAND + GROOVED.thickness, rel=1e-6)
    there = replace(POINT, azimuth=tension.azimuth, x=tension.x)
    strain = read(pinched_ring, GROOVED, there).strain
    assert tension.value == approx(hooke(strain, STEEL)[0, 2], abs=tension.error)
    bent = STEEL.youngs_modulus * grooved_strain(0.0, tension.radius)
    assert tension.value == approx(bent, rel=0.03)


@pytest.mark.slow
def test_error_of_the_largest_stress_of_a_grooved_ring_holds_on_a_finer_mesh(pinched_ring):
    clear = clearing(GROOVED, pinched_ring.patches, pinched_ring.forces, pinched_ring.radius)
    tension, reference = (extremes(each, "ring", clear).tension for each in (pinched_ring, pinched(finer=2)))
    assert tension.value == approx(reference.value, abs=tension.error)
    assert tension.error < 0.03 * tension.value


def test_a_grooved_ring_turned_with_its_balls_reads_the_same_and_less_the_stiffer_it_is(pinched_ring):
    at = replace(POINT, azimuth=0.8)
    expected = read(pinched_ring, GROOVED, at).strain[0]
    turned = read(pinched(turned=0.3), GROOVED, replace(at, azimuth=1.1)).strain[0]
    assert turned == approx(expected, rel=0, abs=1e-9 * np.abs(expected).max())
    steel, springs = replace(STEEL, youngs_modulus=2**20 * STEEL.youngs_modulus), 2**20 * SOFT.radial
    held = Foundation(axial=springs, radial=springs, tangential=springs)
    stiff = replace(GROOVED, elastic=steel, support=held)
    rigid = read(pinched(stiff), stiff, at).strain[0]
    assert 2**20 * rigid == approx(expected, rel=0, abs=1e-6 * np.abs(expected).max())


def lame(outside, pressure):
    """Hoop strain of a ring under inner pressure at one of its surfaces, plane stress, Timoshenko part II."""
    a, b = THICK.raceway_diameter / 2, THICK.raceway_diameter / 2 + THICK.thickness
    sum_of_stresses = 2 * pressure * a**2 / (b**2 - a**2)
    radial = 0.0 if outside else -pressure
    return (sum_of_stresses - radial * (1 + STEEL.poisson_ratio)) / STEEL.youngs_modulus


THICK = OuterRing(raceway_diameter=40e-3, thickness=10e-3, width=5e-3, elastic=STEEL, support=SOFT)
SIZE = MeshSize(order=4, size=4e-3, raceway_size=2e-3)
AROUND = tuple(2 * pi * np.arange(20) / 20)
EVEN = np.cos(np.array(AROUND) - 0.1) ** 2  # in balance without the springs


@pytest.mark.parametrize("outside", [True, False])
def test_hoop_strain_under_inner_pressure_is_that_of_lame(outside):
    evenly = loaded_section(THICK, patches(THICK, AROUND, 10e-3), np.tile([1e3, 0.0], (20, 1)), SIZE)
    found = read(evenly, THICK, *(replace(POINT, azimuth=a, outside=outside) for a in (0.2, 1.7)))
    pressure = 20e3 / (pi * THICK.raceway_diameter * THICK.width)
    assert found.hoop_strain == approx(lame(outside, pressure), rel=2e-3)
    assert found.largest_strain == approx(found.hoop_strain, rel=1e-6)
    assert found.strain_error == approx(0, abs=1e-2 * lame(outside, pressure))


@pytest.mark.parametrize("race", ["outer", "inner"])
def test_mean_hoop_strain_of_a_bolted_ring_under_balls_is_that_of_lame(race):
    """Of a ring without its shallow groove under pressure there, at the surface opposite."""
    ring = bolted(race)
    wall = LAND, LAND + 10e-3 * ring.outward
    ring = replace(ring, far_diameter=2 * wall[1], width=4e-3, face_distance=2e-3)
    loaded = pinched(ring)
    at = replace(POINT, outside=ring.outward > 0, length=2 * pi * wall[1])
    a, b = wall
    expected = 2 * (2 * PULL / (2 * pi * 4e-3)) * a / abs(b**2 - a**2) / STEEL.youngs_modulus
    assert read(loaded, ring, at).hoop_strain == approx(expected, rel=0.01)


@pytest.fixture(scope="module")
def uneven():
    forces = EVEN[:, None] * [1000.0, 50.0]
    return loaded_section(THICK, patches(THICK, AROUND, 2e-3), forces, SIZE)


def test_mean_around_the_ring_is_that_of_the_mean_pressure(uneven):
    """Every harmonic but the one without waves has no mean, however the load is spread."""
    radius = THICK.raceway_diameter / 2 + THICK.thickness
    found = read(uneven, THICK, replace(POINT, length=2 * pi * radius))
    pressure = 1e3 * EVEN.sum() / (pi * THICK.raceway_diameter * THICK.width)
    assert found.hoop_strain == approx(lame(True, pressure), rel=2e-3)


def test_mean_along_a_gauge_tends_to_the_point_with_the_square_of_its_length(uneven):
    for angle in (0.0, 0.6, pi / 2):
        lengths = (0.0, 0.5e-3, 1e-3, 2e-3)
        found = read(uneven, THICK, *(replace(POINT, azimuth=0.5, angle=angle, length=s) for s in lengths))
        off = np.abs(found.gauge_strain[1:] - found.gauge_strain[0])
        assert off[1:] / off[:-1] == approx(4, rel=0.15)


def test_strains_are_slopes_of_the_displacements(uneven):
    """Hoop, axial and shear strain of a cylinder from displacements of neighbouring probes."""
    step, r, x = 1e-5, 30e-3, 0.7e-3
    at = replace(POINT, azimuth=0.35, x=x)
    turned = (replace(at, azimuth=at.azimuth + side * step / r) for side in (-1, 1))
    shifted = (replace(at, x=x + side * step) for side in (-1, 1))
    found = read(uneven, THICK, at, *turned, *shifted)
    moved = found.displacement
    by_arc, by_x = (moved[2] - moved[1]) / (2 * step), (moved[4] - moved[3]) / (2 * step)
    size = np.abs(found.strain[0]).max()
    assert found.hoop_strain[0] == approx(by_arc[2] + moved[0, 1] / r, rel=0, abs=1e-4 * size)
    assert found.axial_strain[0] == approx(by_x[0], rel=0, abs=1e-4 * size)
    assert found.strain[0, 5] == approx(by_arc[0] + by_x[2], rel=0, abs=1e-4 * size)


def test_stress_of_a_probe_is_the_largest_that_the_fields_have(pulled_ring):
    """At the place of the largest von Mises stress, by Hooke's law."""
    clear = clearing(BAR, pulled_ring.patches, pulled_ring.forces, pulled_ring.radius)
    largest = extremes(pulled_ring, "ring", clear).von_mises
    depth = BAR.raceway_diameter / 2 + BAR.thickness - largest.radius
    found = read(
        pulled_ring, BAR, replace(POINT, azimuth=largest.azimuth, x=largest.x, depth=max(depth, 0.0))
    )
    stress = hooke(found.strain, STEEL)
    assert von_mises(stress) == approx(largest.value, rel=1e-4)
    assert hooke_reversed(stress, STEEL) == approx(found.strain, rel=1e-9, abs=1e-15)


def test_a_turned_load_is_read_alike_at_a_turned_probe(pulled_ring):
    turn = 5.9
    turned = read(pulled(turn), BAR, replace(POINT, azimuth=1.1 + turn, angle=0.4, length=1e-3))
    found = read(pulled_ring, BAR, replace(POINT, azimuth=1.1, angle=0.4, length=1e-3))
    assert turned.strain == approx(found.strain, rel=1e-9, abs=1e-12)
    assert turned.displacement == approx(found.displacement, rel=1e-9, abs=1e-15)


def test_a_rosette_of_three_probes_gives_the_principal_strains(uneven):
    """Readings at 0, 45 and 90 degrees, by the formula of rosettes."""
    at = replace(POINT, azimuth=0.9, x=1e-3)
    found = read(uneven, THICK, *(replace(at, angle=radians(angle)) for angle in (0, 45, 90)))
    a, b, c = found.gauge_strain
    spread = np.hypot(a - b, b - c) / 2**0.5
    assert found.largest_strain[0] == approx((a + c) / 2 + spread, rel=1e-9)
    assert found.smallest_strain[0] == approx((a + c) / 2 - spread, rel=1e-9)


# -- squirrel cages --------------------------------------------------------------------------

CAGE = SquirrelCage(
    raceway_diameter=75e-3, thickness=5e-3, width=8e-3, bars=8, bar_width=6e-3, bar_thickness=2e-3,
    bar_length=14e-3, flange_length=4e-3, elastic=STEEL,
)  # fmt: skip
FORCE = 900.0
ON_CAGE = MeshSize(order=3, size=8e-3, raceway_size=4e-3)


def loaded_at(azimuth):
    loads = Patches(azimuths=(azimuth,), length=5e-3, axial_modes=2, width=1.5e-3)
    return loaded_cage(CAGE, loads, np.array([[FORCE, 0.0]]), ON_CAGE, feet=4e-3)


@pytest.fixture(scope="module")
def loaded():
    return loaded_at(0.25)


def test_bending_of_the_bars_balances_the_load(loaded):
    """Moments of each bar at two sections from strains at four corners; their slopes are forces."""
    section, start = bar_section(CAGE), CAGE.width / 2
    sections = (start + 5e-3, start + 9e-3)
    off = 0.06
    corners = [(r, side * off) for r in CAGE.bar_radii for side in (-1, 1)]
    bars = 2 * pi * np.arange(CAGE.bars) / CAGE.bars
    probes = [
        replace(POINT, azimuth=bar + at, x=x, outside=r == CAGE.bar_radii[1])
        for bar in bars for x in sections for r, at in corners
    ]  # fmt: skip
    stress = STEEL.youngs_modulus * read(loaded, CAGE, *probes).axial_strain.reshape(-1, 2, 4)
    inertia = np.asarray(section.inertia)
    beam = np.array([
        [1 / section.area, (r * cos(at) - section.centre) / inertia[0], r * sin(at) / inertia[1]]
        for r, at in corners
    ])  # fmt: skip
    forces = np.linalg.lstsq(beam, stress.reshape(-1, 4).T, rcond=None)[0].T.reshape(-1, 2, 3)
    outward, around = -(np.diff(forces[..., 1:], axis=1)[:, 0] / (sections[1] - sections[0])).T
    along_z, along_y = (
        (outward * np.cos(bars) - around * np.sin(bars)).sum(),
        (outward * np.sin(bars) + around * np.cos(bars)).sum(),
    )
    assert along_z == approx(FORCE * cos(0.25), rel=0.01)
    assert along_y == approx(FORCE * sin(0.25), rel=0.01)
    assert forces[..., 0].sum(axis=0) == approx(0, abs=0.01 * FORCE)  # no axial load


def test_readings_of_a_cage_are_mirrored_with_its_load(loaded):
    """Across the middle of a bar, where one half pitch ends, too."""
    places = (0.3, 0.05, -0.4)
    found = read(loaded, CAGE, *(replace(POINT, azimuth=a, x=1e-3) for a in places))
    other = read(loaded_at(-0.25), CAGE, *(replace(POINT, azimuth=-a, x=1e-3) for a in places))
    assert other.displacement == approx(found.displacement * [1, 1, -1], rel=1e-7, abs=1e-12)
    assert other.strain == approx(found.strain * [1, 1, 1, 1, -1, -1], rel=1e-6, abs=1e-10)
    middle = read(loaded, CAGE, *(replace(POINT, azimuth=a, x=1e-3) for a in (-1e-7, 1e-7)))
    assert middle.displacement[0] == approx(middle.displacement[1], rel=1e-5, abs=1e-12)


def test_displacements_of_a_cage_have_the_slopes_of_its_strains(loaded):
    step, r = 1e-5, CAGE.raceway_diameter / 2 + CAGE.thickness
    for azimuth in (0.35, -0.2):
        at = replace(POINT, azimuth=azimuth, x=0.5e-3)
        found = read(loaded, CAGE, at, *(replace(at, azimuth=azimuth + s * step / r) for s in (-1, 1)))
        moved = found.displacement
        slope = (moved[2] - moved[1])[2] / (2 * step)
        assert found.hoop_strain[0] == approx(slope + moved[0, 1] / r, rel=1e-3)


# -- places ----------------------------------------------------------------------------------

HOUSED = replace(
    THICK, support=Housing(thickness=3e-3, width=4e-3, elastic=STEEL, support=ClampedFace()), offset=0.5e-3
)
SHAFT = RingOnShaft(
    raceway_diameter=65e-3, track_width=19e-3, rib_diameter=66.5e-3, bore=59.6e-3, width=21e-3,
    shaft_bore=51.6e-3, shaft_length=40e-3, ring=STEEL, shaft=STEEL,
)  # fmt: skip


@pytest.mark.parametrize(
    ("part", "x", "outside", "expected"),
    [
        (HOUSED, 0.0, True, 33e-3),
        (HOUSED, 1.8e-3, True, 30e-3),
        (HOUSED, -2.4e-3, True, 33e-3),
        (SHAFT, 0.0, False, 25.8e-3),
        (SHAFT, 10e-3, True, 33.25e-3),
        (SHAFT, -15e-3, True, 29.8e-3),
        (CAGE, 10e-3, True, 41e-3),
        (CAGE, 20e-3, False, 37.5e-3),
        (replace(CAGE, collar_length=2e-3, collar_thickness=7e-3), 3e-3, True, 44.5e-3),
    ],
)
def test_a_probe_lies_on_the_surface_at_its_place(part, x, outside, expected):
    assert radius(part, replace(POINT, x=x, outside=outside)) == approx(expected, rel=1e-5)
    deeper = radius(part, replace(POINT, x=x, outside=outside, depth=1e-3))
    assert deeper == approx(expected - (1e-3 if outside else -1e-3), rel=1e-9)


@pytest.mark.parametrize(
    ("part", "probe", "words"),
    [
        (CAGE, {"x": -5e-3}, "x = -5 mm is beside the part"),
        (CAGE, {"x": 10e-3, "azimuth": 0.3}, "x = 10 mm at 17.19 deg is in a slot between bars"),
        (THICK, {"depth": 11e-3}, "depth = 11 mm; allowed is up to the wall, 10 mm"),
        (replace(SHAFT, shaft_bore=0.0), {"outside": False}, "a solid shaft has no inner surface"),
    ],
)
def test_a_place_without_material_is_refused(part, probe, words):
    with pytest.raises(ImpossiblePart, match=words):
        radius(part, replace(POINT, **probe))


def test_a_gauge_that_reaches_beyond_the_material_is_refused(uneven):
    with pytest.raises(ImpossiblePart, match="a probe at x = 0 mm, 90 deg reaches beyond the material"):
        read(uneven, THICK, POINT, replace(POINT, azimuth=pi / 2, angle=pi / 2, length=6e-3))


def test_heat_alone_strains_nothing_that_may_expand():
    """A gauge that is compensated for its body reads what stress makes."""
    turning = Surroundings(thermal_strains={"ring": 1e-3}, densities={"ring": 7800.0}, speed=0.0)
    free = loaded_section(THICK, patches(THICK, (0.0,), 1e-3), np.zeros((1, 2)), SIZE, turning)
    found = read(free, THICK, POINT)
    assert found.strain == approx(0, abs=1e-7)
    assert found.radial_displacement == approx(30e-6, rel=1e-3)
