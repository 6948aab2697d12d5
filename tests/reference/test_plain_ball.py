"""Production and the one-page model are the same ball."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.solve.balls.sliding_motion import guided_motion
from tests.ball_bearings import one_ball, slow_bearing
from tests.reference.plain_ball import contacts, guided, heat, joshi, solve

CASES = {
    "two contacts": {"angle": [45.0], "load": [1000.0]},
    "spinning": {"angle": [45.0, 45.0], "load": [1000.0, 1000.0]},
    "between": {"angle": [40.0, 50.0], "load": [3000.0, 800.0]},
    "local spin": {"angle": [45.0], "load": [1000.0], "spin": "local"},
    "local spin between": {"angle": [40.0, 50.0], "load": [3000.0, 800.0], "spin": "local"},
}


def both(name):
    case = {"spin": "centre"} | CASES[name]
    bearing = slow_bearing(20e-3, 0.2, 20, conformity=0.54, friction=0.1, modulus=207e9, spin=case["spin"])
    plain = {"D": 20e-3, "dm": 0.2, "r": 10.8e-3, "E": 207e9, "friction": 0.1}
    return one_ball(bearing, case["angle"], case["load"]), plain | case | {"angle": np.radians(case["angle"])}


@pytest.mark.parametrize("name", CASES)
def test_motion_of_production_balances_the_plain_model(name):
    balls, case = both(name)
    mesh, motion = contacts(case), balls.sliding.motion[0]
    assert heat(case, mesh, motion) == approx(balls.torque, rel=5e-4)
    force, axial, radial = joshi(case, mesh, motion)
    friction, arm = 0.1 * sum(case["load"]), 2 * 1e-3
    assert force == approx(0.0, abs=1e-4 * friction)
    assert (axial, radial) == approx((0.0, 0.0), abs=5e-4 * friction * arm)


def test_plain_model_sees_a_motion_that_is_not_in_balance():
    """A thousandth more ball speed unbalances the moments far more than the check above allows."""
    balls, case = both("two contacts")
    mesh, motion = contacts(case), balls.sliding.motion[0] * [1, 1.001, 1.001]
    assert heat(case, mesh, motion) > 1.01 * balls.torque
    assert abs(joshi(case, mesh, motion)[1]) > 5e-2 * 0.1 * sum(case["load"]) * 2e-3


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("name", "attitude"), [("two contacts", 0.6), ("local spin", 0.85)])
def test_least_heat_about_a_given_axis_is_that_of_the_plain_model(name, attitude):
    balls, case = both(name)
    found = guided_motion(balls.contacts, balls.ellipse, np.array([attitude])).power
    assert found == approx(guided(case, attitude), rel=2e-3)
    assert found[0] > 1.01 * balls.torque


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_plain_search_finds_the_same_motion(name):
    balls, case = both(name)
    motion, torque = solve(case)
    assert torque == approx(balls.torque, rel=1e-3)
    assert motion == approx(balls.sliding.motion[0], rel=5e-3, abs=5e-3)
