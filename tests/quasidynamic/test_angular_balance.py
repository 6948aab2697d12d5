"""Forces on balls between two grooves, wherever they are."""

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx

from quasidynamic.balance.balls.angular_contact import AngularBalance, race_contacts
from quasidynamic.balance.balls.ball_position import groove_arm
from quasidynamic.balance.balls.light_ball import (
    FULL_ANGLE,
    FULL_CAGED,
    FULL_GRIP,
    FULL_TRACTION,
    LARGEST_ANGLE,
    LARGEST_TRACTION,
    grip,
    held_traction,
    limited_angle,
)
from quasidynamic.balance.balls.race_control import PrescribedControl
from tests.ball_bearings import fast_bearing

BEARING = fast_bearing(20e-3, 120e-3, 4, np.radians(40.0), 0.52, 0.53)
CONTROLS = pytest.mark.parametrize("control", ["outer", "inner", "equal"])


def balance(control, speed=1000.0):
    return AngularBalance(
        bearing=BEARING,
        contacts=race_contacts(BEARING),
        control=PrescribedControl(BEARING, control),
        load=np.zeros((1, 5)),
        held=np.zeros((1, 5), bool),
        place=np.zeros((1, 5)),
        speeds=np.array([speed, 0.0]).reshape(2, 1, 1),
    )


def place(inner_angle, outer_angle, inner_approach, outer_approach):
    """Groove and ball centres (1, 4) of balls all alike."""
    centre = (BEARING.outer_reach + outer_approach) * 1j * np.exp(-1j * outer_angle)
    groove = centre + (BEARING.inner_reach + inner_approach) * 1j * np.exp(-1j * inner_angle)
    return np.full((1, 4), groove), np.full((1, 4), centre)


PLACES = {  # contact angles [rad], approaches [m]
    "pressed": (0.6, 0.5, 2e-5, 2e-5),
    "barely touching": (0.7, 0.3, 1.5e-6, 8e-6),
    "contacts far apart": (1.35, 0.2, 5e-6, 1e-5),
    "on the wall of the inner groove": (1.75, 0.2, 8e-6, 1e-5),
    "traction at its bound": (0.9, 0.6, 1e-6, 2e-6),
    "off the inner race": (0.4, 0.1, -1e-5, 1e-5),
}


@CONTROLS
@pytest.mark.parametrize("where", PLACES.values(), ids=PLACES.keys())
def test_derivatives_by_the_places_of_ball_and_groove(control, where):
    require_slopes(balance(control), *place(*where))


def require_slopes(own, groove, centre):
    """Derivatives by the places of ball and groove are the differences of the forces."""
    here, step = own.balls(groove, centre), 1e-10
    for k, way in enumerate((step, 1j * step)):
        for by, ahead, behind in (
            (here.by_ball, own.balls(groove, centre + way), own.balls(groove, centre - way)),
            (here.by_groove, own.balls(groove + way, centre), own.balls(groove - way, centre)),
        ):
            slope = (ahead.forces - behind.forces) / (2 * step)
            assert np.abs(by[k] - slope).max() <= 2e-5 * np.abs(here.by_ball).max()


def test_a_ball_beyond_the_half_circle_is_pushed_along_the_shaft():
    groove, centre = place(2.0, 0.1, 0.0, 1e-5)
    centre = centre + (BEARING.inner_reach * (np.sin(2.0) - 1) - 1e-5)  # onto the wall
    found = balance("outer").balls(groove, centre)
    assert found.contacts.angles[0] == approx(np.full((1, 4), np.pi / 2), abs=1e-12)
    assert (found.loads[0] > 0).all()


@given(st.complex_numbers(max_magnitude=1.0), st.complex_numbers(max_magnitude=1.0), st.floats(0.0, 1.0))
def test_distance_from_a_groove_is_convex(one, other, part):
    def distance(arm):
        return abs(groove_arm(np.array(arm)))

    between = distance(part * one + (1 - part) * other)
    assert between <= part * distance(one) + (1 - part) * distance(other) + 1e-12


@given(st.floats(-3.1, 3.1))
def test_angle_of_the_kinematics_is_exact_then_bounded(apart):
    (seen, slope), step = limited_angle(np.array([apart])), 1e-6
    assert abs(seen[0]) <= min(abs(apart), LARGEST_ANGLE)
    if abs(apart) <= FULL_ANGLE:
        assert seen[0] == apart
    ahead, behind = (limited_angle(np.array([apart + s]))[0] for s in (step, -step))
    assert slope == approx((ahead - behind) / (2 * step), abs=1e-5)


@given(st.floats(-5.0, 5.0), st.floats(0.1, 3.0))
def test_traction_is_all_that_is_wanted_then_bounded(wanted, load):
    def traction(wanted, load):
        return held_traction(np.array([wanted]), np.array([load]))

    (held, by_wanted, by_load), step = traction(wanted, load), 1e-6
    assert abs(held[0]) <= LARGEST_TRACTION * load * (1 + 1e-12)
    if abs(wanted) <= FULL_TRACTION * load:
        assert held[0] == wanted
    slope = (traction(wanted + step, load)[0] - traction(wanted - step, load)[0]) / (2 * step)
    assert by_wanted == approx(slope, abs=1e-4)
    slope = (traction(wanted, load + step)[0] - traction(wanted, load - step)[0]) / (2 * step)
    assert by_load == approx(slope, abs=1e-4)


def test_no_traction_without_a_load():
    held, _, _ = held_traction(np.array([3.0, -3.0]), np.zeros(2))
    assert held == approx(np.zeros(2), abs=1e-300)


def test_inner_race_lets_go_of_an_unloaded_ball():
    loads = np.array([0.0, 0.5, 100.0])
    hold, slope = grip(loads, np.ones(3), np.ones(3))
    assert (FULL_GRIP, FULL_CAGED) == approx((0.5, 5e-3))
    assert hold[0] == 0.0
    assert hold[1] == approx(np.tanh(2.5), rel=1e-12)
    assert hold[2] == 1.0
    assert slope[0] == approx(5.0, rel=1e-12)
    assert slope[2] == 0.0
