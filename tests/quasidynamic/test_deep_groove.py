"""Deep groove ball bearings: clearance, free contact angle, loads, closed forms, limits."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from pytest import approx
from scipy.optimize import brentq

from quasidynamic.balance.balls.angular_contact import race_contacts
from quasidynamic.contact.ellipse.point_contact import in_series
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.solve.balls.preloaded_place import preloaded_place
from quasidynamic.solve.step_length import SolverOutcome
from tests.deep_groove import LEVEL, deep_groove, solved
from tests.random_balls import drawn_deep_groove, unbalanced

CONTROLS = pytest.mark.parametrize("control", ["outer", "inner", "equal"])
COMBINED = (2000.0, 1000.0, 5000.0, 20.0, -10.0)


# -- geometry -------------------------------------------------------------------------------------


@pytest.mark.parametrize("clearance", [0.0, 5e-6, 15e-6, 60e-6])
def test_free_contact_angle_follows_from_the_clearance(clearance):
    """cos(alpha_0) = 1 - P_d/(2 A), at the end of the end play 2 A sin(alpha_0)."""
    bearing = deep_groove(clearance)
    distance = 2 * 6.6e-3 - 12.7e-3
    assert np.cos(bearing.free_contact_angle) == approx(1 - clearance / (2 * distance), rel=1e-13)
    touching = distance * np.sin(bearing.free_contact_angle)
    assert bearing.touching_place == approx(touching, rel=1e-12, abs=1e-18)
    if clearance:
        light = solved(bearing, (1e-6, 0.0, 0.0, 0.0, 0.0))
        assert light.ring_displacement[0] == approx(touching, rel=1e-3)
        other = solved(bearing, (-1e-6, 0.0, 0.0, 0.0, 0.0))
        both = light.ring_displacement[0] - other.ring_displacement[0]
        assert bearing.end_play == approx(both, rel=1e-3)
    assert deep_groove(-clearance).end_play == 0.0


def test_clearance_of_an_angular_contact_bearing_changes_its_angle():
    bearing = replace(deep_groove(0.0), contact_angle=np.radians(25.0))
    assert bearing.free_contact_angle == approx(np.radians(25.0), rel=1e-14)
    assert bearing.touching_place == approx(0.0, abs=1e-18)
    tighter = replace(bearing, clearance=-20e-6)
    change = np.cos(tighter.free_contact_angle) - np.cos(np.radians(25.0))
    assert change == approx(20e-6 / (2 * bearing.centre_distance), rel=1e-12)
    assert tighter.touching_place < 0.0
    assert tighter.end_play is None


@pytest.mark.parametrize("clearance", [1.1e-3, -1.1e-3, np.nan])
def test_clearance_beyond_the_grooves_is_refused(clearance):
    with pytest.raises(ImpossiblePart, match=r"bearing\.clearance"):
        deep_groove(clearance)


# -- closed forms ---------------------------------------------------------------------------------


@pytest.mark.parametrize("clearance", [0.0, 15e-6, 40e-6])
@pytest.mark.parametrize("thrust", [100.0, 3000.0, -17800.0])
def test_contact_angle_under_thrust_in_closed_form(clearance, thrust):
    """Z K A^1.5 sin(alpha) (cos(alpha_0)/cos(alpha) - 1)^1.5 = F_a, at the angle alpha of all balls."""
    bearing = deep_groove(clearance)
    distance, stiffness = bearing.centre_distance, in_series(*race_contacts(bearing))
    free = np.arccos(1 - clearance / 2 / distance)

    def off(angle):
        stretch = distance * (np.cos(free) / np.cos(angle) - 1)
        return 9 * stiffness * max(stretch, 0.0) ** 1.5 * np.sin(angle) - abs(thrust)

    angle = np.sign(thrust) * brentq(off, free, 1.3, xtol=1e-15)
    state = solved(bearing, (thrust, 0.0, 0.0, 0.0, 0.0))
    assert state.contact_angles == approx(np.full((2, 9), angle), rel=1e-9)
    assert state.loads == approx(np.full((2, 9), thrust / 9 / np.sin(angle)), rel=1e-9)


@pytest.mark.parametrize("clearance", [15e-6, 0.0, -15e-6])
def test_radial_load_is_shared_by_the_approaches(clearance):
    """Q_j = K (delta cos(psi_j) - P_d/2)^1.5 at a displacement delta, ball by ball."""
    bearing = deep_groove(clearance)
    state = solved(bearing, (0.0, 0.0, 8900.0, 0.0, 0.0))
    approach = state.ring_displacement[2] * np.cos(bearing.azimuths) - clearance / 2
    expected = in_series(*race_contacts(bearing)) * np.maximum(approach, 0.0) ** 1.5
    assert state.loads == approx(np.stack([expected] * 2), rel=1e-9, abs=1e-6)
    assert (expected * np.cos(bearing.azimuths)).sum() == approx(8900.0, rel=1e-9)
    assert np.abs(state.contact_angles[:, expected > 0]).max() < 1e-9
    assert np.abs(state.ring_displacement[[0, 1, 3, 4]]).max() < 1e-12


# -- balance and symmetry -------------------------------------------------------------------------


@CONTROLS
@pytest.mark.parametrize("speed", [0.0, 1000.0, -1500.0])
@pytest.mark.parametrize("clearance", [15e-6, -10e-6])
def test_combined_load_is_in_balance(control, speed, clearance):
    state = solved(deep_groove(clearance), COMBINED, speed=speed, control=control)
    assert unbalanced(state) < 1e-10


@CONTROLS
def test_thrust_the_other_way_is_the_mirror_image(control):
    load = np.array(COMBINED)
    state = solved(load=load, speed=1000.0, control=control)
    mirrored = solved(load=load * [-1, 1, 1, -1, -1], speed=1000.0, control=control)
    assert mirrored.loads == approx(state.loads, rel=1e-8, abs=1e-6)
    assert mirrored.contact_angles == approx(-state.contact_angles, rel=1e-7, abs=1e-9)
    assert mirrored.ring_displacement == approx(
        state.ring_displacement * [-1, 1, 1, -1, -1], rel=1e-7, abs=1e-13
    )


def test_balls_stand_symmetric_about_the_load_line():
    for azimuth in (0.0, np.pi / 9):
        state = solved(deep_groove(azimuth=azimuth), (0.0, 0.0, 8900.0, 0.0, 0.0), speed=1000.0)
        loads = dict(zip(np.round(np.cos(state.bearing.azimuths), 9), state.loads.T, strict=True))
        for place, pair in zip(np.cos(state.bearing.azimuths), state.loads.T, strict=True):
            assert pair == approx(loads[np.round(place, 9)], rel=1e-9, abs=1e-9)


def test_balls_out_of_the_load_zone_rest_on_the_outer_race_at_speed():
    state = solved(load=(0.0, 0.0, 3000.0, 0.0, 0.0), speed=1500.0)
    loose = ~state.on_inner
    assert 4 <= loose.sum() <= 6
    assert state.loads[1, loose] == approx(state.centrifugal_force[loose], rel=1e-9)
    assert state.contact_angles[:, loose][1] == approx(np.zeros(loose.sum()), abs=1e-12)


@CONTROLS
def test_stiffness_is_the_derivative_of_the_load(control):
    bearing = deep_groove()
    state = solved(bearing, COMBINED, speed=800.0, control=control)
    units, columns = np.array([1.0, 1.0, 1.0, 30.0, 30.0]), []
    for direction in range(5):
        step = 1e-8 * units * np.eye(5)[direction]
        ends = [
            solved(bearing, held=tuple(state.ring_displacement + side * step), speed=800.0, control=control)
            for side in (1, -1)
        ]
        columns.append((ends[0].ring_load - ends[1].ring_load) / (2 * step[direction]))
    difference = (np.array(columns).T - state.stiffness) * np.outer(units, units)
    assert np.abs(difference).max() < 1e-6 * np.abs(state.stiffness * np.outer(units, units)).max()


# -- limits ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("load", [(0.0, 0.0, 8900.0, 0.0, 0.0), COMBINED], ids=["radial", "combined"])
@pytest.mark.parametrize("side", [1, -1])
def test_clearance_that_vanishes_leaves_the_bearing_without(load, side):
    none = solved(deep_groove(0.0), load)
    near = [solved(deep_groove(side * size), load).ring_displacement[2] for size in (2e-9, 1e-9)]
    changes = np.array(near) - none.ring_displacement[2]
    assert changes[0] / changes[1] == approx(2.0, rel=1e-2)
    assert np.abs(changes).max() < 4e-9


def test_slow_bearing_tends_to_the_static_one():
    rest = solved(load=COMBINED)
    gaps = [
        np.abs(solved(load=COMBINED, speed=speed).ring_displacement - rest.ring_displacement).max()
        for speed in (80.0, 40.0)
    ]
    assert gaps[0] / gaps[1] == approx(4.0, rel=0.02)  # inertia grows as the square of speed


def test_contact_angle_zero_is_the_limit_of_small_ones():
    deep, load = deep_groove(0.0), (2000.0, 0.0, 4000.0, 0.0, 0.0)
    slanted = replace(deep, contact_angle=np.radians(0.01))
    one, other = solved(deep, load, LEVEL, 500.0), solved(slanted, load, LEVEL, 500.0)
    assert other.loads == approx(one.loads, rel=1e-4)


# -- preload --------------------------------------------------------------------------------------


@pytest.mark.sampled(2)
@pytest.mark.parametrize("clearance", [15e-6, 0.0, -15e-6])
@pytest.mark.parametrize("angle", [0.0, 25.0])
def test_preload_holds_the_ring_where_its_force_does_at_rest(angle, clearance):
    bearing = replace(deep_groove(clearance), contact_angle=np.radians(angle))
    place = preloaded_place(bearing, 400.0)
    assert solved(bearing, (400.0, 0.0, 0.0, 0.0, 0.0)).ring_displacement[0] == approx(place, rel=1e-8)
    held = solved(bearing, held=(place, None, None, 0.0, 0.0))
    assert held.ring_load[0] == approx(400.0, rel=1e-8)


@pytest.mark.parametrize("force", [0.0, -1.0, np.nan, np.inf])
def test_preload_is_a_positive_force(force):
    with pytest.raises(ImpossiblePart, match=r"preload\.force"):
        preloaded_place(deep_groove(), force)


# -- robustness -----------------------------------------------------------------------------------


def test_free_ring_on_two_balls_is_refused_by_name():
    """Two balls hold no tilt; the message says in which directions, and a level ring is solved."""
    bearing, load = deep_groove(60e-6, azimuth=np.pi / 9), (0.0, 0.0, 5.0, 0.0, 0.0)
    with pytest.raises(NotSolved, match="nothing holds the inner ring along x, about y, its place") as caught:
        solved(bearing, load)
    assert caught.value.outcome is SolverOutcome.UNDETERMINED
    assert unbalanced(solved(bearing, load, LEVEL)) < 1e-10


@pytest.mark.parametrize("friction", [0.05])
def test_coulomb_friction_moves_balls_nearly_as_race_control(friction):
    free = solved(load=COMBINED, speed=1000.0, control="coulomb", friction=friction)
    ruled = solved(load=COMBINED, speed=1000.0, friction=friction)
    assert unbalanced(free) < 1e-8
    assert free.loads == approx(ruled.loads, rel=0.05, abs=5.0)
    assert 0.5 < free.friction_torque / ruled.friction_torque <= 1.0 + 1e-6


@settings(max_examples=40, deadline=None, derandomize=True)
@given(seed=st.integers(0, 10**6))
def test_any_deep_groove_bearing_is_solved_or_refused_by_name(seed):
    model, operation = drawn_deep_groove(seed)
    try:
        state = model.solve(operation)
    except NotSolved as refused:
        assert refused.outcome is SolverOutcome.UNDETERMINED  # noqa: PT017
        return
    assert unbalanced(state) < 1e-8


@pytest.mark.slow
def test_a_thousand_random_bearings_are_solved():
    outcomes = {}
    for seed in range(1000):
        model, operation = drawn_deep_groove(seed)
        try:
            outcome = "solved" if unbalanced(model.solve(operation)) < 1e-8 else "not in balance"
        except NotSolved as refused:
            outcome = str(refused.outcome)
        outcomes[outcome] = outcomes.get(outcome, 0) + 1
    assert outcomes == {"solved": 1000}
