"""Production and the one-page model are the same bearing where friction decides what balls do."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.parts.angular_contact_bearing import RingOperation
from quasidynamic.parts.material import Material
from tests.ball_bearings import fast_bearing
from tests.reference import plain_coulomb_ball as plain

STEEL = Material(youngs_modulus=plain.E, poisson_ratio=plain.NU, density=plain.DENSITY)
PLAIN = {"D": 7.938e-3, "dm": 54e-3, "fi": 0.52, "fo": 0.525, "alpha": 0.44, "Z": 18, "omega": 1500.0}


def production(friction, thrust):
    bearing = fast_bearing(*(PLAIN[name] for name in ("D", "dm", "Z", "alpha", "fi", "fo")), STEEL)
    operation = RingOperation(
        load=(thrust, 0.0, 0.0, 0.0, 0.0),
        displacement=(None, None, None, 0.0, 0.0),
        inner_speed=PLAIN["omega"],
    )
    return AngularContactBallBearing(bearing=bearing, control="coulomb", friction=friction).solve(operation)


@pytest.mark.slow
@pytest.mark.parametrize("friction", [0.05, 0.1])
def test_balls_of_production_are_those_of_the_plain_model(friction):
    state, known = production(friction, 1500.0), plain.thrust_bearing(PLAIN | {"mu": friction}, 1500.0)
    assert state.contact_angles[:, 0] == approx(known["angles"], rel=1e-5)
    assert state.loads[:, 0] == approx(known["loads"], rel=1e-5)
    assert np.abs(state.tractions[:, 0]) == approx(known["tractions"], rel=1e-3)
    assert state.orbital_speed[0] == approx(known["orbit"], rel=1e-6)
    axial, radial, turn = known["spin"]
    assert state.attitude[0] == approx(np.arctan2(radial, -axial), rel=1e-4)
    assert state.yaw[0] == approx(np.arcsin(turn / state.ball_speed[0]), rel=1e-3)
    assert state.friction_torque == approx(known["torque"], rel=1e-4)
