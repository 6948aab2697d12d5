"""One convention of axes: x axial, z along the load, azimuth from z to y, moments by the right hand."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.four_point import RingLoad
from quasidynamic.parts.angular_contact_bearing import RingOperation
from tests.ball_bearings import fast_bearing, slow_bearing
from tests.bearings import paper_bearing

FAST = fast_bearing(22.23e-3, 125.26e-3, 16, np.radians(40.0), 0.5232, 0.5265)
SLOW = slow_bearing(clearance=10e-6, balls=24, ball=30e-3, pitch=0.5)
MIRROR = np.array([1, -1, 1, 1, -1])  # y -> -y of forces along x, y, z and of moments about y, z


def fast(load, speed=1000.0):
    return AngularContactBallBearing(bearing=FAST).solve(RingOperation(load=tuple(load), inner_speed=speed))


def slow(load):
    x, y, z, about_y, about_z = load
    ring = RingLoad(axial=x, radial_y=y, radial_z=z, moment_y=about_y, moment_z=about_z)
    return SLOW.solve(ring).distribution


def unit_vectors(azimuth):
    """Axial, radial, and towards growing azimuth (3, Z)."""
    zero = 0 * azimuth
    radial = np.array([zero, np.sin(azimuth), np.cos(azimuth)])
    return np.array([1 + zero, zero, zero]), radial, np.array([zero, np.cos(azimuth), -np.sin(azimuth)])


def test_what_turns_towards_growing_azimuth_turns_about_minus_x():
    axial, radial, along = unit_vectors(np.linspace(0.0, 6.0, 7))
    assert np.cross(-axial, radial, axis=0) == approx(along, abs=1e-15)
    assert np.cross(radial, axial, axis=0) == approx(along, abs=1e-15)  # skew: +x end leads, about +e_r
    assert np.cross(-along, axial, axis=0) == approx(
        radial, abs=1e-15
    )  # tilt: +x end further out, about -e_phi


@pytest.mark.parametrize(
    "load", [(2e4, 0.0, 8e3, 400.0, 0.0), (2e4, 0.0, 8e3, -400.0, 0.0)], ids=["moment", "opposite moment"]
)
def test_load_along_z_and_moment_about_y_are_symmetric_to_the_plane_of_the_load(load):
    """Balls at azimuths phi and -phi carry the same, nothing moves along y or turns about z."""
    state, opposite = fast(load), (-np.arange(16)) % 16
    assert state.loads == approx(state.loads[:, opposite], rel=1e-8)
    assert state.ring_displacement[[1, 4]] == approx(0.0, abs=1e-9 * np.abs(state.ring_displacement).max())
    assert state.loads[0].argmax() == 0
    found, opposite = slow(load), (-np.arange(24)) % 24
    assert found.loads == approx(found.loads[opposite], abs=1e-8 * found.loads.max())


def test_mirrored_load_gives_mirrored_balls():
    load = np.array([9e3, 1e3, 3e3, 100.0, -50.0])
    state, mirrored, order = fast(load), fast(load * MIRROR), (-np.arange(16)) % 16
    assert mirrored.loads == approx(state.loads[:, order], rel=1e-8)
    assert mirrored.ring_displacement == approx(state.ring_displacement * MIRROR, rel=1e-6, abs=1e-14)
    first, second, order = slow(load), slow(load * MIRROR), (-np.arange(24)) % 24
    assert second.loads == approx(first.loads[order], abs=1e-8 * first.loads.max())
    assert second.displacement == approx(first.displacement * MIRROR, rel=1e-6, abs=1e-13)


def test_moments_are_those_of_the_forces_on_their_levers():
    """r x F of the forces of the balls on the ring, by vectors in space."""
    load = np.array([9e3, 1e3, 3e3, 100.0, -50.0])
    found, pitch = slow(load), SLOW.bearing.pitch_diameter
    axial, radial, _ = unit_vectors(SLOW.bearing.azimuths)
    loads, angles = found.loads[..., 0], found.angles[..., 0]  # of the inner ring
    along = loads * np.sin(angles) @ np.array([1.0, -1.0])
    outward = (loads * np.cos(angles)).sum(1)
    force = along * axial + outward * radial  # the load on the ring goes into the balls
    moment = np.cross(pitch / 2 * radial, along * axial, axis=0)
    carried = np.concatenate([force.sum(1), moment.sum(1)[1:]])
    assert carried / [1, 1, 1, pitch, pitch] == approx(load / [1, 1, 1, pitch, pitch], abs=1e-9 * 9e3)


@pytest.mark.parametrize("place", [3, 4], ids=["about y", "about z"])
def test_positive_moment_presses_the_balls_that_it_pushes_along_x(place):
    """About y the ring at +z moves along x, about z the ring at -y: theta x r."""
    load, azimuth = np.array([2e4, 0.0, 0.0, 0.0, 0.0]), FAST.azimuths
    load[place] = 50.0
    turn = np.eye(3)[place - 2]
    pushed = np.cross(turn[:, None], unit_vectors(azimuth)[1], axis=0)[0]
    straight = RingOperation(load=tuple(load), displacement=(None, 0.0, 0.0, None, None))
    state = AngularContactBallBearing(bearing=FAST).solve(straight)
    assert state.ring_displacement[place] > 0
    assert np.corrcoef(state.loads[0], pushed)[0, 1] > 0.99


def test_rollers_and_balls_name_tilts_alike():
    """Tilts in the matrix of a roller bearing are right-handed, those of `ring_tilt` slopes dz/dx, dy/dx."""
    bearing = paper_bearing(moment=20.0)
    state = bearing.solve()
    assert state.ring_tilt[0] > 0
    load = np.array([-20.0, 0.0])  # a moment that raises dz/dx turns about -y
    tilt = state.tangent.compliance[3:, 3:] @ load
    assert tilt[0] < 0
    along, across = state.tangent.compliance[2, 3], state.tangent.compliance[3, 2]
    assert along == approx(
        across, rel=0.05, abs=1e-3 * np.sqrt(state.tangent.compliance[2, 2] * state.tangent.compliance[3, 3])
    )
