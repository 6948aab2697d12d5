"""Rollers between washers: even shares, loads off the axis, inertia, sliding, and random bearings."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic import ImpossiblePart, Lubrication, NotSolved, RingOperation, oil_at, tapered_loads
from quasidynamic.contact.line.load_law import raceway_coefficients
from quasidynamic.parts.material import Material
from quasidynamic.parts.profile import STRAIGHT, Logarithmic, Profile
from quasidynamic.parts.roller_bearing import Roller
from quasidynamic.parts.tapered_bearing import TaperedRollerBearing, without_rib
from quasidynamic.tapered_friction import TaperedFriction
from tests.bearings import TRACTION
from tests.reference import plain_thrust_rollers as plain

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7850)
RIGHT = np.pi / 2


def washers(rollers=21, pitch=60e-3, diameter=6e-3, length=6e-3, profile: Profile = STRAIGHT, angle=RIGHT):
    return TaperedRollerBearing(
        rollers=rollers,
        pitch_diameter=pitch,
        cup_angle=angle,
        cone_angle=angle,
        roller=Roller(diameter=diameter, length=length, material=STEEL, profile=profile),
        rib=without_rib(angle),
        inner_ring=STEEL,
        outer_ring=STEEL,
    )


def loaded(bearing, thrust, about_y=0.0, about_z=0.0, speed=0.0, slices=40):
    operation = RingOperation(
        load=(thrust, 0, 0, about_y, about_z), displacement=(None, 0, 0, None, None), inner_speed=speed
    )
    return tapered_loads(bearing, operation, slices)


@pytest.mark.parametrize("speed", [0.0, 400.0])
def test_thrust_is_shared_evenly(speed):
    found = loaded(washers(), 10e3, speed=speed)
    assert found.loads == approx(10e3 / 21, rel=1e-9)
    assert found.displacement[3:] == approx(0.0, abs=1e-12)


@pytest.mark.parametrize("lever", [0.1, 0.5, 0.9])  # over the pitch radius
def test_eccentric_loads_are_those_of_the_page_of_springs(lever):
    moment, bearing = lever * 0.03 * 10e3, washers()
    found = loaded(bearing, 10e3, moment, slices=20)
    coefficient = float(np.ravel(raceway_coefficients(bearing))[0])
    expected = plain.loads(21, 60e-3, 6e-3, coefficient, 20, 10e3, moment)
    assert found.loads == approx(
        np.array([expected, expected]), abs=1e-6 * expected.max()
    )  # contacts are rounded


@pytest.mark.parametrize("lever", [0.2, 0.6, 0.8])
def test_many_short_rollers_have_the_load_of_the_integrals(lever):
    bearing = washers(rollers=120, pitch=1.0, diameter=6e-3, length=6e-3)
    found = loaded(bearing, 100e3, lever * 0.5 * 100e3)
    assert 100e3 / (120 * found.loads.max()) == approx(plain.sjovall(lever), rel=1e-3)


def test_a_ring_whose_load_is_beyond_the_rollers_tips():
    assert loaded(washers(), 10e3, 0.0, 320.0).loads.min() < 1e-3
    with pytest.raises(NotSolved, match="tips the ring over the outer ends"):
        loaded(washers(), 10e3, 0.0, 331.0)


def test_gyroscopic_moments_tilt_rollers_and_press_their_outer_ends_on_one_washer():
    found = loaded(washers(), 10e3, speed=1000.0)
    moments = found.slice_loads * found.slices.widths @ found.slices.centres
    assert moments[1] - moments[0] == approx(found.speeds.gyroscopic_moment, rel=1e-9)
    roller = washers().roller
    assert found.speeds.gyroscopic_moment == approx(roller.inertia * found.speeds.orbit * found.speeds.spin)
    assert found.speeds.spin == approx(1000.0 * 30 / 6, rel=1e-12)
    assert found.speeds.orbit == approx(500.0, rel=1e-12)


def test_without_a_rib_rollers_carry_centrifugal_forces_along_their_normals_alone():
    angle = np.pi / 4
    operation = RingOperation(load=(1e3, 0, 0, 0, 0), displacement=(None, 0, 0, 0, 0), inner_speed=1000.0)
    found = tapered_loads(washers(angle=angle), operation)
    force = found.speeds.centrifugal_force
    assert found.loads[0] == approx(1e3 / 21 / np.sin(angle), rel=1e-9)
    assert found.loads[1] - found.loads[0] == approx(force * np.cos(angle), rel=1e-7)


def test_heat_of_sliding_grows_with_the_length_of_rollers_and_vanishes_with_them():
    """Geometric sliding is the place along the roller times the speed of a washer against the cage."""
    oil = oil_at("ISO VG 100", 333.0)
    laws = Lubrication(oil=oil, oil_fraction=0.0, churning_gap=None, traction=TRACTION["eyring"](oil))
    heat = []
    for length in (3e-3, 6e-3):
        found = loaded(washers(length=length), 40e3 * length / 6e-3, speed=100.0)
        friction = TaperedFriction(found, laws, 0.0)
        sliding = friction.state.sliding
        assert sliding[0] - sliding[0].mean(-1, keepdims=True) == approx(
            np.broadcast_to(50.0 * found.slices.centres, sliding[0].shape), abs=1e-6
        )
        assert friction.power == approx(
            sum(getattr(friction, f"{name}_heat").sum() for name in ("sliding", "rolling", "churning"))
            + friction.drag_heat.sum() + friction.pocket_heat.sum() + friction.transport.sum(), rel=1e-9,
        )  # fmt: skip
        heat.append(friction.sliding_heat.sum())
    assert 2.0 < heat[1] / heat[0] < 4.5  # twice the load on twice the lever: 4 with constant friction


def test_angles_beyond_a_right_one_are_refused():
    with pytest.raises(ImpossiblePart, match="90 deg"):
        washers(angle=1.6)


@pytest.mark.parametrize("seed", range(100))
def test_random_bearings_are_in_balance(seed):
    random = np.random.default_rng(seed)
    rollers, pitch = int(random.integers(6, 60)), 10 ** random.uniform(-1.7, 0.3)
    diameter = random.uniform(0.4, 0.85) * np.pi * pitch / rollers / 1.3
    length = min(diameter * random.uniform(0.8, 3.0), 0.25 * pitch)
    profile = (
        Logarithmic(amplitude=random.uniform(1e-4, 6e-4) * diameter) if random.random() < 0.7 else STRAIGHT
    )
    bearing = washers(rollers, pitch, diameter, length, profile)
    thrust = 60e6 * rollers * diameter * length * 10 ** random.uniform(-3, 0.5)
    lever = random.uniform(0, 0.97) * pitch / 2 * np.cos(np.pi / rollers)
    turn, speed = (
        random.uniform(0, 2 * np.pi),
        random.choice([0.0, 1.0]) * 10 ** random.uniform(-1, 1) / pitch,
    )
    found = loaded(bearing, thrust, thrust * lever * np.cos(turn), thrust * lever * np.sin(turn), speed)
    moments = found.slice_loads * found.slices.widths @ found.slices.centres
    largest, arms = found.loads.max(), found.loads[0] * pitch / 2 + moments[0]
    azimuths = bearing.azimuths
    left = [
        *(found.loads[0] - found.loads[1]),
        *((moments[1] - moments[0] - found.speeds.gyroscopic_moment) / (length / 2)),
        found.loads[0].sum() - thrust,
        (arms @ np.cos(azimuths) - thrust * lever * np.cos(turn)) / pitch,
        (-arms @ np.sin(azimuths) - thrust * lever * np.sin(turn)) / pitch,
    ]
    assert np.abs(left).max() < 1e-9 * max(largest, thrust)
