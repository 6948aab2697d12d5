"""Balls between races that end on shoulders."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import NotSolved, RingOperation
from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.balance.balls.angular_contact import race_contacts
from quasidynamic.balance.balls.elastic_grooves import ElasticGrooves, shape_of
from quasidynamic.balance.balls.ending_races import EndingRaces
from quasidynamic.contact.ellipse.truncated import ERROR
from quasidynamic.solve.balls.elastic_load_distribution import elastic_ball_loads
from quasidynamic.solve.balls.load_distribution import ball_loads
from quasidynamic.solve.step_length import SolverOutcome
from tests.quasidynamic.test_angular_balance import BEARING, balance, place
from tests.quasidynamic.test_elastic_grooves import random_groove
from tests.quasidynamic.test_four_point import LOOSE, TIGHT
from tests.quasidynamic.test_four_point_elastic import soft
from tests.quasidynamic.test_truncated_contact import by_half_spaces

THRUST = RingOperation(load=(20e3, 0.0, 0.0, 0.0, 0.0))
MANY = replace(BEARING, balls=16)


def ending(bearing, inner, outer):
    """The bearing with grooves that end at angles [deg], towards the shoulder and on the other side."""
    ends = {
        name: replace(getattr(bearing, name), ends=tuple(np.radians(angles)))
        for name, angles in (("inner", inner), ("outer", outer))
    }
    return replace(bearing, **ends)


def solved(ends, operation=THRUST, **model):
    return AngularContactBallBearing(bearing=ending(MANY, *ends), **model).solve(operation)


PLACES = {  # contact angles [rad] and approaches [m], and the least share of a load that is left
    "cut on the inner race": ((0.6, 0.5, 2e-5, 2e-5), (0.8, 0.9)),
    "cut beyond the middle": ((0.72, 0.83, 2e-5, 2e-5), (0.5, 0.7)),
    "cut on the other side": ((-0.25, -0.3, 2e-5, 3e-5), (0.5, 0.7)),
    "whole": ((0.1, 0.05, 1e-5, 1e-5), (1.0, 1.0)),
}


@pytest.mark.parametrize("control", ["outer", "inner", "equal"])
@pytest.mark.parametrize("name", PLACES)
def test_derivatives_of_cut_contacts_are_their_differences(name, control):
    at, (least, most) = PLACES[name]
    bearing = ending(BEARING, (39.0, 11.0), (45.0, 17.0))
    races = EndingRaces.of(bearing, race_contacts(bearing))
    own = replace(balance(control, 1500.0), bearing=bearing, races=races)
    groove, centre = place(*at)
    found, step = own.balls(groove, centre), 1e-9
    assert least <= (found.cut.loads / found.cut.whole).min() <= most
    for direction, move in enumerate((step, 1j * step)):
        by_groove = own.balls(groove + move, centre).forces - own.balls(groove - move, centre).forces
        by_ball = own.balls(groove, centre + move).forces - own.balls(groove, centre - move).forces
        scale = np.abs(found.by_ball).max()
        assert np.abs(by_groove / (2 * step) - found.by_groove[direction]).max() < 1e-8 * scale
        assert np.abs(by_ball / (2 * step) - found.by_ball[direction]).max() < 1e-8 * scale


def test_forces_of_a_contact_are_those_of_half_spaces():
    """The pressure pushes along its normals, which meet in the ball centre: S is its moment over D/2.

    But for the approach, by which centres are farther apart than at first touch.
    """
    bearing, approach = ending(BEARING, (90.0, 90.0), (43.0, 90.0)), 2e-5
    outer = race_contacts(bearing)[1]
    races = EndingRaces.of(bearing, race_contacts(bearing))
    places = place(0.6, 0.72, 2e-5, approach)
    found = replace(balance("outer", 0.0), bearing=bearing, races=races).balls(*places).cut
    load, aside, whole = (values[1, 0, 0] for values in (found.loads, found.aside, found.whole))
    across, curvature = outer.semi_axes(whole)[0], 2 / 20e-3 - 1 / (0.53 * 20e-3)
    cut = 0.53 * 20e-3 * (np.radians(43.0) - 0.72) / across
    share, _, slope = by_half_spaces(float(cut), float(outer.across / outer.along))
    assert load == approx(share * whole, abs=ERROR * whole)
    moment = slope * 0.4 * whole * approach / (curvature * across)
    reach = BEARING.outer_reach
    assert aside == approx(-moment / 10e-3 * reach / (reach + approach), rel=0.01)


def test_shoulders_that_cut_nothing_off_change_nothing():
    far, without = solved(((70.0, 70.0), (70.0, 70.0))), AngularContactBallBearing(bearing=MANY).solve(THRUST)
    for name in ("ring_displacement", "loads", "contact_angles", "stiffness", "ring_load"):
        assert np.array_equal(getattr(far, name), getattr(without, name))
    assert far.whole_loads is None
    assert far.evaluations == without.evaluations


@pytest.mark.parametrize("model", [{}, {"control": "coulomb", "friction": 0.06}])
@pytest.mark.parametrize("speed", [0.0, 800.0])
def test_cut_contacts_give_way_more_and_carry_the_load(model, speed):
    operation = replace(THRUST, inner_speed=speed, load=(20e3, 0.0, 3e3, 0.0, 0.0))
    cut, whole = (
        solved(((44.0, 44.0), (42.0, 42.0)), operation, **model),
        solved(((90.0,) * 2,) * 2, operation, **model),
    )
    assert cut.carried_shares.min() < 0.8
    assert cut.ring_displacement[0] > 1.02 * whole.ring_displacement[0]
    assert cut.whole_displacement == approx(whole.ring_displacement, abs=0)
    axial = cut.loads * np.sin(cut.contact_angles) + cut.section_forces * np.cos(cut.contact_angles)
    assert axial.sum(1) == approx([20e3, 20e3], rel=1e-8)


def test_elastic_grooves_are_displaced_by_all_that_cut_contacts_push():
    """Loads, and forces along the sections; the ring is displaced further than with whole contacts."""
    grooves = [random_groove(seed, MANY.balls, 1e-3 * MANY.outer_reach / THRUST.load[0]) for seed in (1, 2)]
    bearing = ending(MANY, (44.0, 44.0), (42.0, 42.0))
    state = AngularContactBallBearing(bearing=bearing).solve(THRUST, ElasticGrooves(*grooves))
    assert state.carried_shares.min() < 0.8
    normals = np.exp(-1j * state.contact_angles)
    force = (1j * state.loads + state.section_forces) * normals
    for race, sign in enumerate((-1, 1)):
        moved = shape_of(grooves[race], state.contact_angles[race], sign * force[race]).moved
        assert state.groove_displacement[race] == approx(moved, abs=1e-6 * np.abs(moved).max())
    assert force.real.sum(1) == approx([20e3, 20e3], rel=1e-8)
    assert state.ring_displacement[0] > state.whole_displacement[0] + 1e-6


def test_stiffness_is_the_derivative_of_the_load():
    load = np.array(THRUST.load)
    ends, step = ((44.0, 44.0), (42.0, 42.0)), 1.0
    more, less = (solved(ends, RingOperation(load=(load[0] + move, 0, 0, 0, 0))) for move in (step, -step))
    slope = 2 * step / (more.ring_displacement[0] - less.ring_displacement[0])
    own = solved(ends).stiffness
    assert slope == approx(1 / np.linalg.inv(own)[0, 0], rel=1e-6)
    assert own == approx(own.T, rel=1e-6, abs=1e-6 * np.abs(own).max())  # forces of an energy


def test_reversed_thrust_rides_on_the_edge_of_open_shoulders():
    back = solved(((60.0, 20.0), (60.0, 10.0)), RingOperation(load=(-20e3, 0.0, 0.0, 0.0, 0.0)))
    assert np.degrees(back.contact_angles).max() < -40.0  # beyond the ends
    assert back.carried_shares.max() < 0.1
    assert back.ring_load[0] == approx(-20e3)
    assert back.peak_pressures.max() > 4.2e9


def test_balls_that_climb_over_an_open_shoulder_end_with_the_part_of_the_load_that_is_borne():
    tilting = RingOperation(load=(-1500.0, 0.0, 30.0, 100.0, 0.0))
    with pytest.raises(
        NotSolved, match=r"climb over the shoulders.* they bear 0% to 3% of this load"
    ) as ended:
        solved(((27.0, 12.0), (46.0, 17.0)), tilting)
    assert ended.value.outcome is SolverOutcome.OVER_SHOULDER


# -- four-point balls ----------------------------------------------------------------------------------

SLOW_LOAD = np.array([20e3, 50e3, 0.0, 2e3, 0.0])


def test_four_point_balls_on_shoulders_beyond_their_contacts_are_as_without():
    far, without = (ball_loads(bearing, SLOW_LOAD) for bearing in (slow(60.0), TIGHT.bearing))
    assert np.array_equal(far.loads, without.loads)
    assert np.array_equal(far.displacement, without.displacement)
    assert far.iterations == without.iterations


def test_four_point_balls_on_shoulders_carry_the_load_and_give_way_more():
    cut, whole = ball_loads(slow(47.0), SLOW_LOAD), ball_loads(TIGHT.bearing, SLOW_LOAD)
    assert (cut.loads < 0.6 * cut.whole).any()
    assert (np.abs(cut.displacement) > 1.05 * np.abs(whole.displacement)).all()
    assert cut.stiffness == approx(cut.stiffness.T, rel=1e-6, abs=1e-6 * np.abs(cut.stiffness).max())
    step = 1.0 * np.eye(5)[0]
    more, less = (ball_loads(slow(47.0), SLOW_LOAD + sign * step).displacement for sign in (1, -1))
    assert cut.stiffness @ (more - less) / 2 == approx(step, abs=1e-5)


def test_four_point_balls_between_nearly_rigid_rings_are_cut_as_between_rigid_ones():
    rigid = ball_loads(slow(47.0), SLOW_LOAD)
    elastic = elastic_ball_loads(slow(47.0), SLOW_LOAD, soft(24, 1e-16))
    assert elastic.loads == approx(rigid.loads, abs=1e-4 * rigid.loads.max())
    softer = elastic_ball_loads(slow(47.0), SLOW_LOAD, soft(24, 1e-13))
    assert softer.imbalance < 1e-9
    assert np.abs(softer.displacement[0]) > np.abs(rigid.displacement[0])


def slow(end):
    """The bearing with arches that end at an angle [deg] on both rings."""
    return replace(TIGHT.bearing, groove_ends=(np.radians(end),) * 2)


def test_four_point_balls_that_climb_over_shoulders_end_so():
    """Contacts of 45 deg, shoulders at 29 and 30 deg."""
    bearing = replace(LOOSE.bearing, groove_ends=(0.512, 0.5306))
    with pytest.raises(NotSolved, match="climb over the shoulders") as ended:
        ball_loads(bearing, np.array([-426.3, -110.1, 79.5, 26.6, 10.6]))
    assert ended.value.outcome is SolverOutcome.OVER_SHOULDER
