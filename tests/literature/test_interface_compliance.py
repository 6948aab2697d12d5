"""An interface between ball and race that shears: the penalty of finite elements, after Heras et al. (2017).

Torques come from an independent solution of the same equations, with the pressure of the true profiles
instead of Hertz's, for the loads that meet the printed torques of full sliding; 4 um meet the 1.7 N m that
the paper's finite elements have for B1, and spoil its nominal case.
"""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from pytest import approx

from quasidynamic.errors import ImpossiblePart
from tests.ball_bearings import one_ball, slow_bearing
from tests.literature.test_heras2017 import CASES, FITTED

TORQUES = {  # [N m] by elastic slip [um] at the limit of friction
    "b1": {1: 2.46, 2: 2.20, 3: 1.98, 4: 1.77, 5: 1.59, 8: 1.15},
    "nominal": {1: 17.0, 2: 16.5, 3: 16.1, 4: 15.6, 5: 15.1, 8: 13.7},
}
EACH = [(name, slip) for name, torques in TORQUES.items() for slip in torques]


def rolled(name, compliance, model: Any = "kalker"):
    osculation, friction, *_ = CASES[name]
    bearing = slow_bearing(
        30e-3, 1.0, 60, 45.0, 0.5 / osculation, friction=friction, modulus=200e9, spin="local"
    )
    bearing = replace(bearing, interface_compliance=compliance)
    balls = bearing.roll(one_ball(bearing, [45.0], [1e3 * FITTED[name][0][0]]), model, (20, 40))
    (ball,) = filter(None, balls.rolled)
    return ball


@pytest.mark.slow
@pytest.mark.parametrize(("name", "slip"), EACH)
def test_torque_with_an_interface_is_that_of_an_independent_program(name, slip):
    ball = rolled(name, 1e-6 * slip)
    assert ball.extrapolated_torque == approx(TORQUES[name][slip], rel=0.02)
    assert rolled(name, 1e-6 * slip, "fastsim").torque == approx(ball.torque, rel=0.03)


@pytest.mark.parametrize("model", ["kalker", "fastsim"])
def test_a_stiff_interface_is_none_and_a_soft_one_carries_no_friction(model):
    """The torque falls in proportion to a small compliance, and as the inverse of a large one."""
    none, small, twice, large, huge = (
        rolled("b1", compliance, model).torque for compliance in (0.0, 1e-9, 2e-9, 1e-2, 1.0)
    )
    assert 0.0 < none - small < 1e-3 * none
    assert (none - twice) / (none - small) == approx(2.0, rel=0.05)
    assert large / huge == approx(100.0, rel=0.01)
    assert huge < 1e-4 * none


def test_an_interface_makes_contacts_stick():
    none, soft = (rolled("b1", compliance).fine.rolled.stick_share for compliance in (0.0, 4e-6))
    assert np.all(none < 0.3)
    assert soft == approx(0.85, abs=0.05)  # of the same independent solution


@pytest.mark.parametrize("compliance", [-1e-6, np.nan, np.inf])
def test_an_interface_that_cannot_be_is_refused(compliance):
    with pytest.raises(ImpossiblePart, match="interface_compliance"):
        replace(slow_bearing(), interface_compliance=compliance)
