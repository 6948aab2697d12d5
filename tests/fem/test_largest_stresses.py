"""Largest stresses of bodies of revolution against closed forms, whole solids and finer meshes."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from pytest import approx

from fem import ClampedFace, Elastic, MeshSize, OuterRing, Patches, RingOnShaft
from fem.parts.surroundings import Surroundings
from fem.section.loaded_section import loaded_section
from fem.solid.clearing import clearing
from fem.solid.extremes import LEAST, Largest, Samples, extremes, principal, von_mises
from fem.solid.factored_solid import factored

STEEL = Elastic(youngs_modulus=203e9, poisson_ratio=0.28)
RING = OuterRing(raceway_diameter=75e-3, thickness=3.6e-3, width=10e-3, elastic=STEEL, support=ClampedFace())
SHAFT = RingOnShaft(
    raceway_diameter=65e-3, track_width=19e-3, rib_diameter=66.5e-3, bore=59.6e-3, width=21e-3,
    shaft_bore=51.6e-3, shaft_length=22e-3, ring=STEEL, shaft=STEEL,
)  # fmt: skip
ROLLERS = 2 * pi * np.arange(12) / 12
PATCHES = Patches(azimuths=tuple(ROLLERS), length=5e-3, axial_modes=2, width=1e-3)
FORCES = np.clip(np.cos(ROLLERS - 0.1), 0, None)[:, None] * [1000.0, 50.0]
SIZE = MeshSize(order=4, size=4e-3, raceway_size=2e-3)


@pytest.fixture(scope="module")
def loaded():
    return loaded_section(RING, PATCHES, FORCES, SIZE)


@pytest.mark.slow
def test_section_moves_and_is_stressed_as_the_whole_solid(loaded):
    """Fourier series on the axial section against tetrahedra, away from patches and clamp."""
    solid = factored(RING, PATCHES, MeshSize(order=3, size=4e-3, raceway_size=3e-3), 1).under(FORCES)
    found = loaded.samples("ring", 0, 4)
    x, y, z = found.place.T
    inside = np.hypot(y, z) - 37.5e-3
    far = (x < 0) & (inside > 0.5e-3) & (inside < 3.2e-3)
    far &= clearing(RING, PATCHES, FORCES, 37.5e-3)(found.place)
    some = np.flatnonzero(far)[:: max(1, far.sum() // 200)]
    points = solid.mesh(*(1e3 * found.place[some]).T)
    shift = np.linalg.norm(solid.displacement(points), axis=1)
    assert np.linalg.norm(found.displacement[some], axis=1) == approx(shift, rel=0, abs=0.02 * shift.max())
    stress = von_mises(solid.stress(points)[:, [0, 4, 8, 1, 5, 2]])
    assert np.median(np.abs(von_mises(found.stress[some]) / stress - 1)) < 0.03


@pytest.mark.long
def test_printed_error_holds_on_a_finer_mesh():
    """Two orders more on elements of half the size: within the error, below 5 %, at the same place."""
    clear = clearing(RING, PATCHES, FORCES, 37.5e-3)
    sizes = (MeshSize(order=k + 6, size=3e-3 / (k or 1), raceway_size=1e-3 / (k or 1)) for k in (0, 2))
    both = [extremes(loaded_section(RING, PATCHES, FORCES, size), "ring", clear) for size in sizes]
    for measure in ("von_mises", "tension", "compression"):
        usual, reference = (getattr(one, measure) for one in both)
        assert abs(usual.value - reference.value) <= usual.error <= 0.05 * abs(usual.value), measure
        assert np.degrees(abs(usual.azimuth - reference.azimuth)) < 3, measure


def compound_tubes(radii, mismatch, speed):
    """Constants (C, D) of u = C r + D/r - K r^3 of the inner and the outer tube, and the axial strain.

    Long bonded tubes of one material with free ends, the inner one larger by a strain: generalised plane
    strain. Timoshenko and Goodier, Theory of Elasticity, art. 32 and 151.
    """
    a, b, c = radii
    e, nu, rho = STEEL.youngs_modulus, STEEL.poisson_ratio, 7850.0
    cube = (1 + nu) * (1 - 2 * nu) / (8 * e * (1 - nu)) * rho * speed**2
    stiff = e / ((1 + nu) * (1 - 2 * nu))

    def radial(r):
        """Of C, D, axial strain, free strain and r^3."""
        return stiff * np.array([1, -(1 - 2 * nu) / r**2, nu, -(1 + nu), -(3 - 2 * nu) * cube * r**2])

    def axial_force(r, s):
        """The same, of the axial stress over the section between two radii."""
        area, fourth = (s**2 - r**2) / 2, (s**4 - r**4) / 4
        return stiff * np.array(
            [2 * nu * area, 0, (1 - nu) * area, -(1 + nu) * area, -4 * nu * cube * fourth]
        )

    rows, right = np.zeros((5, 5)), np.zeros(5)
    for row, value, tube, sign in (
        (0, radial(a), 0, 1), (1, radial(c), 1, 1), (2, radial(b), 0, 1), (2, radial(b), 1, -1),
        (3, np.array([b, 1 / b, 0, 0, 0]), 0, 1), (3, np.array([b, 1 / b, 0, 0, 0]), 1, -1),
        (4, axial_force(a, b), 0, 1), (4, axial_force(b, c), 1, 1),
    ):  # fmt: skip
        rows[row, 2 * tube : 2 * tube + 2] += sign * value[:2]
        rows[row, 4] += sign * value[2]
        right[row] -= sign * (value[3] * (mismatch if tube == 0 else 0.0) + value[4])
    return np.linalg.solve(rows, right), stiff, cube


@pytest.mark.slow
def test_heat_and_rotation_press_the_ring_as_closed_forms_do():
    """Far from the ends of a ring as long as its shaft, which is 2e-4 larger, both turning fast."""
    speed, strain, nu = 3000.0, 2e-4, STEEL.poisson_ratio
    long = replace(SHAFT, track_width=0.16, rib_diameter=None, width=0.16, shaft_length=0.161)
    around = Surroundings(
        thermal_strains={"ring": 0.0, "shaft": strain}, densities={"ring": 7850.0, "shaft": 7850.0},
        speed=speed,
    )  # fmt: skip
    still = replace(PATCHES, azimuths=(0.0,))
    state = loaded_section(long, still, np.zeros((1, 2)), SIZE, around)
    constants, stiff, cube = compound_tubes((25.8e-3, 29.8e-3, 32.5e-3), strain, speed)
    for tube, body in enumerate(("shaft", "ring")):
        found = state.samples(body, 0, 1)
        middle = np.abs(found.place[:, 0]) < 4e-3
        r = np.hypot(found.place[middle, 1], found.place[middle, 2])
        c, d, free = *constants[2 * tube : 2 * tube + 2], (0.0 if tube else strain)
        hoop = stiff * (
            c + (1 - 2 * nu) * d / r**2 + nu * constants[4] - (1 + nu) * free - (1 + 2 * nu) * cube * r**2
        )
        assert np.abs(hoop).max() > 40e6
        assert found.stress[middle, 2] == approx(hoop, rel=0, abs=2e-3 * np.abs(hoop).max())


def test_invariants_are_those_of_the_tensor():
    draw = np.random.default_rng(3).standard_normal((50, 6))
    tensor = draw[:, [[0, 3, 5], [3, 1, 4], [5, 4, 2]]]
    first, second, third = principal(draw).T
    assert np.all(first >= second)
    assert np.all(second >= third)
    assert first + second + third == approx(np.trace(tensor, axis1=1, axis2=2), abs=1e-12)
    from_principal = np.sqrt(((first - second) ** 2 + (second - third) ** 2 + (third - first) ** 2) / 2)
    assert von_mises(draw) == approx(from_principal, rel=1e-12)


@pytest.mark.slow
def test_largest_values_have_signs_and_errors(loaded):
    most = extremes(loaded, "ring", clearing(RING, PATCHES, FORCES, 37.5e-3))
    assert isinstance(most.von_mises, Largest)
    assert most.tension.value > 0 > most.compression.value
    for largest in (most.von_mises, most.tension, most.compression):
        assert LEAST * abs(largest.value) <= largest.error < 0.1 * abs(largest.value)


def test_places_within_reach_of_a_roller_are_moved_to_where_it_ends():
    """Around the axis at their own radius and place along it, and straight away from the roller's line."""
    clear = clearing(RING, PATCHES, FORCES, 37.5e-3)
    phi, r, x = np.array([0.01, -0.02, 0.03]), np.array([37.5e-3, 38e-3, 39e-3]), np.array([0.0, 1e-3, -3e-3])
    inside = np.stack([x, r * np.sin(phi), r * np.cos(phi)], axis=1)
    assert not clear(inside).any()
    rim = clear.rim(inside)
    assert len(rim) == 6
    assert clear(rim).all()
    beyond = np.maximum(np.abs(rim[:, 0]) - PATCHES.length / 2, 0)
    distance = np.hypot(beyond, np.hypot(rim[:, 1], rim[:, 2] - 37.5e-3))
    assert distance == approx(np.full(6, 4 * PATCHES.width), rel=1e-5)
    turned = rim[:3]
    assert turned[:, 0] == approx(x, abs=1e-12)
    assert np.hypot(turned[:, 1], turned[:, 2]) == approx(r, rel=1e-9)
    assert np.sign(turned[:, 1]) == approx(np.sign(phi))


def test_samples_where_the_reach_ends_are_those_of_the_field(loaded):
    """Places one by one against the lattice in the same sector."""
    lattice = loaded.samples("ring", 0, 4)
    some = slice(None, None, 997)
    found = loaded.at("ring", 0, lattice.place[some])
    assert len(found.place) == len(lattice.place[some])
    assert found.place == approx(lattice.place[some], abs=1e-9)
    size = np.abs(lattice.stress).max()
    # elements next to each other differ a little where they meet
    assert np.median(np.abs(found.stress - lattice.stress[some]).max(axis=1)) < 1e-6 * size
    shift = lattice.displacement[some]
    assert found.displacement == approx(shift, rel=0, abs=1e-6 * np.abs(lattice.displacement).max())


class Peaks:
    """A field with a broad peak over many elements, and a sharp one that coarse samples miss."""

    def __init__(self):
        self.place = np.array([[0.0, 1e-5 * k, 39e-3] for k in range(40)] + [[0.0, 0.0, -39e-3]])
        self.coarse = np.append(np.full(40, 100e6), 90e6)
        self.fine = np.append(np.full(40, 101e6), 150e6)

    def pieces(self, body):
        return (0,)

    def samples(self, body, piece, intervals, keys=None, *, higher=True):
        chosen = np.arange(41) if keys is None else keys
        stress = np.zeros((chosen.size, 6))
        stress[:, 0] = (self.coarse if keys is None else self.fine)[chosen]
        return Samples(
            chosen, np.ones(chosen.size, dtype=bool), self.place[chosen], np.zeros((len(stress), 3)), stress
        )

    def at(self, body, piece, places, *, higher=True):
        return self.samples(body, piece, 4, np.zeros(0, dtype=int))


def test_a_second_peak_is_looked_into_however_broad_the_first_is():
    still = clearing(RING, replace(PATCHES, azimuths=(1.5,), width=1e-6), np.ones((1, 2)), 37.5e-3)
    most = extremes(Peaks(), "ring", replace(still, reach=1e-3))
    assert most.von_mises.value == approx(150e6)
    assert most.tension.azimuth == approx(pi)
    # nothing changes from order to order: the least error is that of the largest stress, of small ones, too
    assert most.compression.error == approx(LEAST * 150e6)


class BelowALine:
    """Pressure that falls with the inverse of the distance from the line of a roller at z = 37.5 mm."""

    def pieces(self, body):
        return (0,)

    def samples(self, body, piece, intervals, keys=None, *, higher=True):
        across, depth = np.meshgrid(np.linspace(-4e-3, 4e-3, 24), np.linspace(1e-4, 3.5e-3, 11))
        return self.at(body, piece, np.stack([0 * depth, across, 37.5e-3 + depth], axis=-1).reshape(-1, 3))

    def at(self, body, piece, places, *, higher=True):
        stress, number = np.zeros((len(places), 6)), np.arange(len(places))
        stress[:, 2] = -1e5 / np.hypot(places[:, 1], places[:, 2] - 37.5e-3)
        return Samples(number * 0, number % 2 == 0, places, np.zeros((len(stress), 3)), stress)


def test_largest_pressure_below_a_roller_is_that_where_its_reach_ends():
    """Samples are 0.3 mm from each other, the reach is 2 mm: the nearest alone would miss percents."""
    line = clearing(RING, replace(PATCHES, azimuths=(0.0,), width=0.5e-3), np.ones((1, 2)), 37.5e-3)
    most = extremes(BelowALine(), "ring", line)
    assert most.compression.value == approx(-1e5 / 2e-3, rel=1e-4)
