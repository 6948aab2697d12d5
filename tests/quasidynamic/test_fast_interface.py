"""An interface between fast balls and their races that shears."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.errors import ImpossiblePart
from tests.quasidynamic.test_fast_rolling_balls import BEARING, FAST, LOAD, UPRIGHT, RingOperation

OPERATION = RingOperation(load=LOAD, displacement=UPRIGHT, inner_speed=FAST)


@pytest.mark.parametrize("model", ["fastsim", "kalker"])
def test_an_interface_takes_from_the_torque_and_makes_stick(model):
    def rolled(compliance):
        bearing = AngularContactBallBearing(bearing=BEARING, friction=0.1, interface_compliance=compliance)
        return bearing.roll(bearing.solve(OPERATION), model, (16, 32))

    none, stiff, soft, softer = map(rolled, (0.0, 1e-12, 1e-6, 1e-3))
    assert stiff.friction_torque == approx(none.friction_torque, rel=1e-4)
    assert softer.friction_torque < 0.2 * soft.friction_torque < 0.2 * none.friction_torque
    assert np.all(soft.stick_share > none.stick_share)


def test_an_interface_that_cannot_be_is_refused():
    with pytest.raises(ImpossiblePart, match="interface_compliance"):
        AngularContactBallBearing(bearing=BEARING, interface_compliance=-1e-6)
