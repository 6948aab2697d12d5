"""Load distribution and torque of four-point contact ball bearings."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from pytest import approx

from quasidynamic.balance.balls.four_contacts import FourContacts
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.four_point import RingLoad
from quasidynamic.parts.ball import Groove
from quasidynamic.solve.balls.load_distribution import ball_loads
from tests.ball_bearings import slow_bearing

TIGHT = slow_bearing(clearance=-10e-6, balls=24, ball=30e-3, pitch=0.5)
LOOSE = slow_bearing(clearance=10e-6, balls=24, ball=30e-3, pitch=0.5)
part = st.floats(-1.0, 1.0)
cases = st.tuples(part, part, part, part, part, st.floats(2.0, 5.5)).map(
    lambda c: np.array([*c[:3], 0.25 * c[3], 0.25 * c[4]]) * 10 ** c[5]
).filter(lambda load: np.abs(load).max() > 1.0)  # fmt: skip
bearings = st.sampled_from([TIGHT.bearing, LOOSE.bearing])


def carried(bearing, found):
    """Sum of the ball forces, written out ball by ball."""
    total = np.zeros(5)
    for azimuth, loads, angles in zip(
        bearing.azimuths, found.loads[..., 0], found.angles[..., 0], strict=True
    ):
        radial = (loads * np.cos(angles)).sum()
        axial = (loads * np.sin(angles)) @ [1, -1]
        pitch = bearing.pitch_diameter / 2
        total += [
            axial,
            radial * np.sin(azimuth),
            radial * np.cos(azimuth),
            axial * pitch * np.cos(azimuth),
            -axial * pitch * np.sin(azimuth),
        ]
    return total


@settings(max_examples=25)
@given(bearings, cases)
def test_balls_carry_the_load(bearing, load):
    found = ball_loads(bearing, load)
    largest = max(np.abs(load).max(), found.loads.max())
    assert carried(bearing, found) == approx(load, abs=1e-10 * largest)


@pytest.mark.parametrize("clearance", [10e-6, 200e-6])
@pytest.mark.parametrize("angle", [20.0, 45.0])
def test_end_play_is_the_way_between_light_thrusts(clearance, angle):
    bearing = slow_bearing(clearance=clearance, angle=angle, balls=24, ball=30e-3, pitch=0.5).bearing
    up, down = (ball_loads(bearing, np.array([sign * 1e-3, 0, 0, 0, 0])) for sign in (1, -1))
    assert up.displacement[0] - down.displacement[0] == approx(bearing.end_play, rel=2e-3)
    assert TIGHT.bearing.end_play == approx(0.0, abs=1e-15)
    with pytest.raises(ImpossiblePart, match="below the distance of the groove centres"):
        replace(TIGHT.bearing, clearance=1.01 * TIGHT.bearing.centre_distance)


@settings(max_examples=15)
@given(cases)
def test_stiffness_is_that_of_small_further_loads(load):
    bearing = TIGHT.bearing
    found = ball_loads(bearing, load)
    lever = np.array([1, 1, 1, 0.25, 0.25])
    further = 1e-4 * max(np.abs(load).max(), found.loads.max()) * lever
    for direction in np.diag(further):
        up, down = (ball_loads(bearing, load + sign * direction) for sign in (1, -1))
        change = (up.displacement - down.displacement) / 2
        assert found.stiffness @ change / further == approx(direction / further, abs=1e-4)
    scaled = found.stiffness / np.outer(lever, lever)
    assert scaled == approx(scaled.T, abs=1e-12 * np.abs(scaled).max())


@settings(max_examples=10)
@given(bearings, cases, st.integers(1, 23))
def test_load_turned_by_some_balls_turns_the_distribution(bearing, load, steps):
    angle = 2 * np.pi * steps / bearing.balls
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    turned = load.copy()
    turned[[2, 1]], turned[[4, 3]] = turn @ load[[2, 1]], turn @ load[[4, 3]]  # azimuths grow from z to y
    before, after = ball_loads(bearing, load), ball_loads(bearing, turned)
    assert after.loads == approx(np.roll(before.loads, steps, axis=0), abs=1e-7 * before.loads.max())


@settings(max_examples=10)
@given(bearings, cases)
def test_bearing_seen_in_a_mirror_swaps_its_diagonals(bearing, load):
    seen = load * [-1, 1, 1, -1, -1]
    before, after = ball_loads(bearing, load), ball_loads(bearing, seen)
    assert after.loads == approx(before.loads[:, ::-1], abs=1e-7 * before.loads.max())


def test_axial_load_goes_over_one_diagonal_of_a_loose_bearing():
    """Q = F/(Z sin a), and the contact angle follows from the stretched distance of the groove centres."""
    bearing = LOOSE.bearing
    found = ball_loads(bearing, np.array([5e4, 0, 0, 0, 0]))
    load, angle = found.loads[0, 0, 0], found.angles[0, 0, 0]
    assert found.loads == approx(np.tile([[load, load], [0.0, 0.0]], (24, 1, 1)), rel=1e-9)
    assert load == approx(5e4 / 24 / np.sin(angle), rel=1e-10)
    length = bearing.centre_distance + (load / FourContacts.of(bearing).in_series) ** (2 / 3)
    assert length * np.cos(angle) == approx(
        (bearing.centre_distance - 10e-6) * np.cos(np.radians(45)), rel=1e-10
    )


def test_interference_loads_both_diagonals_of_every_ball():
    """Opposite contacts carry a little less and more: contacts of one ball, whose angles are not the same."""
    found = ball_loads(TIGHT.bearing, np.zeros(5))
    assert found.loads == approx(FourContacts.of(TIGHT.bearing).in_series * 10e-6**1.5, rel=1e-4)
    assert (found.loads * np.cos(found.angles)) @ [1, -1] == approx(np.zeros((24, 2)), abs=1e-9)
    assert found.displacement == approx(np.zeros(5), abs=1e-15)


def test_torque_grows_with_every_ball_that_is_added():
    torques = [
        slow_bearing(clearance=-10e-6, balls=balls, pitch=0.5).solve(RingLoad()).torque for balls in (10, 20)
    ]
    assert torques[1] == approx(2 * torques[0], rel=1e-9)


def test_both_rings_feel_the_torque_of_the_bearing():
    state = TIGHT.solve(RingLoad(radial_z=2e4, axial=1e4, moment_y=-3e3))
    inner, outer = state.balls.torques.total.sum(axis=0)
    assert inner == approx(state.torque, rel=1e-8)
    assert outer == approx(-state.torque, rel=1e-8)
    assert state.distribution.loads == approx(state.balls.load, rel=1e-12)


def test_loose_bearing_leaves_balls_idle():
    state = LOOSE.solve(RingLoad(radial_z=2e3))
    assert 0 < state.balls.sliding.driven.sum() < 24
    assert (state.balls.ball_torques > 0).sum() == state.balls.sliding.driven.sum()


def test_nothing_holds_an_unloaded_loose_ring():
    with pytest.raises(NotSolved, match="nothing holds the ring") as refused:
        ball_loads(LOOSE.bearing, np.zeros(5))
    assert refused.value.outcome == "undetermined"


def test_what_cannot_be_is_refused():
    with pytest.raises(ImpossiblePart, match="five finite numbers"):
        ball_loads(TIGHT.bearing, np.array([1.0, np.nan, 0, 0, 0]))
    with pytest.raises(ImpossiblePart, match="do not fit"):
        slow_bearing(balls=200)
    with pytest.raises(ImpossiblePart, match="halve it"):
        Groove(conformity=0.5, material=TIGHT.bearing.ball.material)
    with pytest.raises(ImpossiblePart, match="interference must be below"):
        slow_bearing(clearance=-2e-3)
    with pytest.raises(ImpossiblePart, match="at least 3"):
        slow_bearing(balls=2)
    with pytest.raises(ImpossiblePart, match="contact_angle"):
        slow_bearing(angle=95.0)


@pytest.mark.parametrize("number", [100, pytest.param(1000, marks=pytest.mark.slow)])
def test_random_bearings_find_their_balance(number):
    """Three balls to a full ring, clearance to interference, loads over five decades."""
    rng = np.random.default_rng(number)
    for _ in range(number):
        ball = 10 ** rng.uniform(-3, -1)
        pitch = ball * 10 ** rng.uniform(0.6, 1.9)
        bearing = slow_bearing(
            ball,
            pitch,
            balls=int(rng.integers(3, int(0.95 * np.pi * pitch / ball))),
            angle=rng.uniform(5, 75),
            conformity=rng.uniform(0.505, 0.6),
            outer_conformity=rng.uniform(0.505, 0.6),
            clearance=ball * rng.uniform(-1, 1) * 10 ** rng.uniform(-5, -2.5),
        ).bearing
        load = rng.normal(size=5) * (rng.random(5) < 0.7) + 1e-3
        load *= 8e6 * ball**2 * bearing.balls * 10 ** rng.uniform(-5, 0)
        load[3:] *= pitch / 2
        found = ball_loads(bearing, load)
        assert found.imbalance < 1e-9
        assert carried(bearing, found) == approx(load, abs=1e-8 * max(np.abs(load).max(), found.loads.max()))
