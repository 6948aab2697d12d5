"""Orbit, spin and attitude of balls."""

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx

from quasidynamic.motion.ball_speeds import (
    ball_attitude,
    ball_motion,
    centrifugal_force,
    gyroscopic_moment,
    spin_to_roll,
)
from quasidynamic.motion.roller_speeds import rolling_cage_speed, rolling_roller_speed

ANGLES = st.floats(-0.8, 0.8)
CONTROLS = pytest.mark.parametrize("control", ["outer", "inner", "equal"])


def contact_velocity(angle, ratio, motion, ring, side):
    """Ball minus race at the centre of a contact, from vectors, for a pitch diameter of one."""
    normal = side * np.array([np.sin(angle), np.cos(angle)])  # axial, radial
    beta = motion.attitude.value
    spin = motion.spin.value * np.array([-np.cos(beta), np.sin(beta)])
    arm = ratio / 2 * normal
    ball = spin[0] * arm[1] - spin[1] * arm[0]
    race = (ring - motion.orbit.value) * (0.5 + arm[1])
    relative = spin - np.array([ring - motion.orbit.value, 0.0])
    return ball - race, relative @ normal


@CONTROLS
@given(ANGLES, ANGLES, st.floats(0.02, 0.35), st.floats(-1e3, 1e3), st.floats(-1e3, 1e3))
def test_ball_does_not_slip_at_the_centres_of_its_contacts(
    control, inner, outer, ratio, inner_speed, outer_speed
):
    motion = ball_motion(np.array([inner, outer]), ratio, (inner_speed, outer_speed), control)
    for angle, ring, side in ((inner, inner_speed, -1), (outer, outer_speed, 1)):
        slip, spin = contact_velocity(angle, ratio, motion, ring, side)
        assert slip == approx(0.0, abs=1e-10)
        rolling = (ring - motion.orbit.value) / ratio
        ratios = spin_to_roll(angle, motion.attitude.value, ratio, side)
        assert spin == approx(-side * rolling * ratios, abs=1e-8)


@given(ANGLES, ANGLES, st.floats(0.02, 0.35))
def test_ball_does_not_spin_on_the_controlling_race(inner, outer, ratio):
    for control, angle, side in (("outer", outer, 1), ("inner", inner, -1)):
        attitude = ball_attitude(np.array([inner, outer]), ratio, control).value
        assert spin_to_roll(angle, attitude, ratio, side) == approx(0.0, abs=1e-12)


@CONTROLS
def test_radial_bearing_is_a_roller_bearing(control):
    motion = ball_motion(np.zeros(2), 0.2, (100.0, -30.0), control)
    assert motion.orbit.value == approx(rolling_cage_speed(100.0, -30.0, 0.2), rel=1e-13)
    assert motion.spin.value == approx(rolling_roller_speed(100.0, -30.0, 0.2), rel=1e-13)
    assert gyroscopic_moment(motion, 1.0).value == 0.0


@CONTROLS
@given(ANGLES, ANGLES)
def test_derivatives_by_the_contact_angles(control, inner, outer):
    angles, step = np.array([inner, outer]), 1e-6

    def quantities(at):
        motion = ball_motion(at, 0.15, (500.0, -200.0), control)
        force = centrifugal_force(motion.orbit, 0.01, 0.1)
        return [*motion, force, gyroscopic_moment(motion, 1e-6)]

    here = quantities(angles)
    for k in range(2):
        shift = step * np.eye(2)[k]
        for at, ahead, behind in zip(
            here, quantities(angles + shift), quantities(angles - shift), strict=True
        ):
            slope = (ahead.value - behind.value) / (2 * step)
            assert at.slopes[k] == approx(slope, rel=1e-6, abs=1e-7 * max(1.0, abs(at.value)))
