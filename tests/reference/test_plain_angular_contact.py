"""Production and the one-page model are the same angular-contact bearing."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.parts.angular_contact_bearing import RingOperation
from quasidynamic.parts.material import Material
from tests.ball_bearings import fast_bearing
from tests.reference import plain_angular_contact as plain
from tests.reference.plain_coulomb_ball import semi_axes

STEEL = Material(youngs_modulus=plain.E, poisson_ratio=plain.NU, density=plain.DENSITY)
PLAIN = {"D": 7.938e-3, "dm": 54e-3, "fi": 0.515, "fo": 0.525, "alpha": 0.35, "Z": 18, "omega": 1000.0}


def production(thrust, radial, speed, control):
    bearing = fast_bearing(*(PLAIN[name] for name in ("D", "dm", "Z", "alpha", "fi", "fo")), STEEL)
    operation = RingOperation(
        load=(thrust, 0.0, radial, 0.0, 0.0), displacement=(None, None, None, 0.0, 0.0), inner_speed=speed
    )
    return AngularContactBallBearing(bearing=bearing, control=control).solve(operation)


@pytest.mark.parametrize("control", ["equal", "outer"])
def test_equilibrium_of_production_is_that_of_the_plain_model(control):
    state = production(1500.0, 300.0, PLAIN["omega"], control)
    place, balls = plain.bearing(PLAIN | {"control": control}, 1500.0, 300.0)
    assert state.ring_displacement[[0, 2]] == approx(place, rel=1e-7)
    assert state.loads[0] == approx([ball["Qi"] for ball in balls], rel=1e-7)
    assert state.loads[1] == approx([ball["Qo"] for ball in balls], rel=1e-7)
    assert state.contact_angles[0] == approx([ball["inner"] for ball in balls], rel=1e-7)
    assert state.contact_angles[1] == approx([ball["outer"] for ball in balls], rel=1e-7)


@pytest.mark.parametrize("speed", [0.0, 2000.0])
def test_semi_axes_are_those_at_the_loaded_contact_angle(speed):
    """At the angle without load, 20.05 degrees, they would be 0.1 to 0.6 % off."""
    state, ball = production(1500.0, 300.0, speed, "outer"), PLAIN["D"]
    for race, (side, conformity) in enumerate(((-1, PLAIN["fi"]), (1, PLAIN["fo"]))):
        for number in (0, 9):
            gamma = ball / PLAIN["dm"] * np.cos(state.contact_angles[race, number])
            across, along = 2 / ball - 1 / (conformity * ball), 2 / ball / (1 + side * gamma)
            known = np.array(semi_axes(across, along)) * np.cbrt(state.loads[race, number])
            assert [axis[race, number] for axis in state.semi_axes] == approx(known, rel=1e-9)
            assert state.peak_pressures[race, number] == approx(
                1.5 * state.loads[race, number] / np.pi / known.prod(), rel=1e-9
            )


def test_static_thrust():
    state = production(1500.0, 0.0, 0.0, "outer")
    assert state.contact_angles == approx(np.full((2, 18), plain.thrust_angle(PLAIN, 1500.0)), rel=1e-10)


def test_plain_model_sees_a_state_that_is_not_in_equilibrium():
    """The check above can fail: ten micrometres off, the thrust is another one."""
    place, balls = plain.bearing(PLAIN | {"control": "equal"}, 1500.0, 300.0)
    there, _ = plain.ball(PLAIN | {"control": "equal"}, place[0] + 1e-5, place[1], (0.5, 1.0))
    assert there["Qi"] > 1.3 * balls[0]["Qi"]
