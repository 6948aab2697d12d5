"""The 218 angular-contact bearing of Harris, Rolling Bearing Analysis, under thrust at high speed.

Inputs as in the textbook: raceways 102.79 and 147.73 mm, 16 balls of 22.23 mm, groove radii 11.63 mm, 40
degrees without load, outer-race control. Not printed: E 206 GPa, nu 0.3, 7800 kg/m3 assumed.
Source of the outputs: an independent solution of the same equations with the signs of a positive ball speed.
"""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.parts.angular_contact_bearing import RingOperation
from tests.ball_bearings import fast_bearing

RPM = np.pi / 30
HARRIS = fast_bearing(22.23e-3, (102.79e-3 + 147.73e-3) / 2, 16, np.radians(40.0), 11.63 / 22.23)
# thrust [N], speed [rpm], contact angles [deg]
ROWS = [
    (17800.0, 0.0, 41.50, 41.50),
    (17800.0, 6000.0, 44.72, 38.04),
    (17800.0, 10000.0, 49.95, 31.33),
    (17800.0, 15000.0, 56.78, 19.23),
    (22250.0, 10000.0, 48.70, 33.61),
]


DEFLECTION = 36.0  # [um] under 17 800 N at rest


def turning(thrust, speed):
    operation = RingOperation(load=(thrust, 0.0, 0.0, 0.0, 0.0), inner_speed=speed * RPM)
    return AngularContactBallBearing(bearing=HARRIS, control="outer").solve(operation)


@pytest.mark.parametrize(("thrust", "speed", "inner", "outer"), ROWS)
def test_contact_angles(thrust, speed, inner, outer):
    state = turning(thrust, speed)
    assert np.degrees(state.contact_angles[0]) == approx(np.full(16, inner), abs=0.05)
    assert np.degrees(state.contact_angles[1]) == approx(np.full(16, outer), abs=0.05)


def test_static_deflection():
    assert 1e6 * turning(17800.0, 0.0).ring_displacement[0] == approx(DEFLECTION, abs=0.1)
