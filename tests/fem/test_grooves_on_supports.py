"""Rings with grooves on every support that rings of rollers have: lines, teeth, springs, matrices."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from fem import (
    Foundation,
    Groove,
    LineForce,
    LineSupports,
    MeshSize,
    OuterRing,
    PlanetGear,
    ReducedBody,
    Resolution,
    Stations,
)
from fem.condense import HARMONICS, condense_in_process
from fem.section.planet_rim import PlanetRim
from fem.section.ring_on_lines import RingOnLines
from tests.fem import test_ring_on_matrix as matrices
from tests.fem.test_parts import STEEL

GROOVE = Groove(radius=6.6e-3, centre_radius=32.25e-3)
SHOULDER, OUTSIDE, WIDTH, PATCH = 2.2e-3, 42.5e-3, 19e-3, 1.2e-3
LAND = GROOVE.bottom(1) - SHOULDER
ANGLES = np.radians([-25.0, 0.0, 25.0])
BALLS = 0.1 + 2 * np.pi * np.arange(9) / 9
THREE = LineSupports(azimuths=tuple(np.radians([-40.0, 40.0, 180.0])))
TEETH = PlanetGear(
    forces=(
        LineForce(azimuth=np.pi / 2, radial=-200.0, tangential=-500.0),
        LineForce(azimuth=-np.pi / 2, radial=-200.0, tangential=500.0),
    ),
    radius=48e-3,
)


def ring(support, groove=GROOVE):
    inside = GROOVE.bottom(1) - (SHOULDER if groove else 0.0)
    return OuterRing(
        raceway_diameter=2 * inside, thickness=OUTSIDE - inside, width=WIDTH, elastic=STEEL, support=support,
        groove=groove,
    )  # fmt: skip


def resolved(groove=GROOVE):
    mesh = MeshSize(order=4, size=3e-3, raceway_size=4 * PATCH / 6)
    stations = Stations(angles=ANGLES, width=PATCH) if groove else None
    return Resolution(length=GROOVE.width(LAND, 1), axial_modes=2, mesh_size=mesh, stations=stations)


def condensed(support, groove=GROOVE):
    return condense_in_process(ring(support, groove), HARMONICS, resolved(groove))


@pytest.fixture(scope="module")
def free():
    return condensed(PlanetGear(forces=())).ring


@pytest.fixture(scope="module")
def on_springs():
    return condensed(Foundation(axial=0.0, radial=1e9, tangential=0.0))


def test_lines_balance_the_balls(free):
    """Force along y and z, and moment about the middle of the groove, of any forces on its stations."""
    forces = np.random.default_rng(1).normal(size=(9, 3))
    azimuths = (0.3, 1.5, 3.0, 4.4)
    pushes = RingOnLines(free, LineSupports(azimuths=azimuths)).line_forces(BALLS, forces)
    reading = free.reading[:3]
    expected = np.array([np.cos(ANGLES), -np.sin(ANGLES) * GROOVE.centre_radius])
    # shoulders cut the outer patches: 1.3 % of their moment
    assert reading.T == approx(expected, rel=1.5e-2, abs=1e-9)
    radial, moments = (forces @ reading).T
    for wave in (np.sin, np.cos):
        psi, phi = wave(np.array(azimuths)), wave(BALLS)
        assert pushes.sum(axis=1) @ psi == approx(radial @ phi, rel=0, abs=1e-9)
        lever = WIDTH / 6 * (pushes[:, 1] - pushes[:, 0]) @ psi
        assert lever == approx(moments @ phi, rel=0, abs=1e-9)


def test_lines_turned_with_the_balls_give_the_same(free):
    turned = replace(THREE, azimuths=tuple(np.array(THREE.azimuths) + 0.7))
    here, there = RingOnLines(free, THREE).at(BALLS), RingOnLines(free, turned).at(BALLS + 0.7)
    assert there.absolute == approx(here.absolute, rel=0, abs=1e-9 * np.abs(here.absolute).max())


def test_mirrored_lines_and_forces_give_mirrored_displacements(free):
    phi = BALLS - 0.1
    mirrored = -np.arange(9) % 9
    C = RingOnLines(free, THREE).at(phi).absolute
    assert C[mirrored][:, :, mirrored] == approx(C, rel=0, abs=1e-9 * np.abs(C).max())


def test_many_soft_lines_all_round_are_a_foundation(free, on_springs):
    """Radial springs per area hold neither the ring along its axis nor its groove, nor do lines."""
    count = 60
    stiffness = 1e9 * 2 * np.pi * OUTSIDE * WIDTH / count
    lines = LineSupports(azimuths=tuple(2 * np.pi * np.arange(count) / count), stiffness=stiffness)
    found = RingOnLines(free, lines).at(BALLS).absolute
    known = on_springs.at(BALLS).absolute
    assert found == approx(known, rel=0, abs=1e-3 * np.abs(known).max())


def test_a_ring_that_nothing_holds_along_its_axis_stays_in_the_mean(free, on_springs):
    """An even axial force moves nothing, and its groove is not moved along by any other even force."""
    for raceway in (on_springs, free.raceway):
        assert np.abs(raceway.response[0] @ np.sin(ANGLES)).max() < 1e-2 * np.abs(raceway.response[0]).max()


def test_lines_that_only_push_let_the_ring_lift_off(free):
    forces = np.zeros((9, 3))
    forces[0] = 100.0
    lines = LineSupports(azimuths=tuple(2 * np.pi * np.arange(7) / 7))
    pulling, pushing = (
        RingOnLines(free, replace(lines, pushing=each)).line_forces(BALLS, forces).sum(axis=1)
        for each in (False, True)
    )
    assert pulling.min() < -1.0
    assert pushing.min() > -1e-6


def test_rim_of_a_planet_gear_bends_as_that_of_rollers(free):
    """The rim of rollers ends at the bottom of the groove; shoulders stiffen that of balls."""
    phi = 2 * np.pi * np.arange(360) / 360
    of_balls = PlanetRim(free, TEETH).at(phi)
    of_rollers = condensed(TEETH, groove=None).at(phi)
    middle, cylinder = of_balls.initial_deviation[:, 1], of_rollers.initial_deviation[:, 0]
    assert np.corrcoef(middle, cylinder)[0, 1] > 0.99
    x = np.linspace(-WIDTH / 2, WIDTH / 2, 1001)
    arc = GROOVE.centre_radius + np.sqrt(np.maximum(GROOVE.radius**2 - x**2, 0.0))
    thickness = OUTSIDE - np.where(np.abs(x) < GROOVE.width(LAND, 1) / 2, arc, LAND)
    stiffer = np.mean(thickness**3) / (OUTSIDE - GROOVE.bottom(1)) ** 3
    assert np.ptp(cylinder) / np.ptp(middle) == approx(stiffer, rel=0.2)
    assert not of_balls.translation.any()
    read = of_balls.initial_deviation @ free.reading[:3]
    for wave in (np.sin, np.cos):
        assert wave(phi) @ read == approx(np.zeros(2), abs=1e-9 * np.abs(read).sum())


@pytest.mark.slow
def test_springs_as_a_matrix_are_a_foundation(monkeypatch):
    axial, radial, tangential = 2e12, 5e12, 1e12
    monkeypatch.setattr("fem.section.ring_on_matrix.SHARE", 1.0)  # shorter waves keep these springs
    monkeypatch.setattr(matrices, "RADIUS", OUTSIDE)
    monkeypatch.setattr(matrices, "WIDTH", WIDTH)
    monkeypatch.setattr(matrices, "OFFSET", 0.0)
    body: ReducedBody = matrices.springs((axial, radial, tangential), azimuths=17)
    known = condensed(Foundation(axial=axial, radial=radial, tangential=tangential)).at(BALLS).absolute
    found = condensed(body).at(BALLS).absolute
    assert found == approx(known, rel=0, abs=1e-8 * np.abs(known).max())
