"""Deep groove ball bearings that several tests use."""

import numpy as np

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.outcome.angular_contact_state import AngularContactState
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing, RingOperation
from quasidynamic.parts.ball import Ball, Groove
from quasidynamic.parts.material import Material

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7800.0)
RPM = np.pi / 30
LEVEL = (None, None, None, 0.0, 0.0)  # the ring does not tilt


def deep_groove(
    clearance=15e-6, balls=9, ball=12.7e-3, pitch=65e-3, groove=6.6e-3, outer_groove=None, azimuth=0.0
) -> AngularContactBearing:
    """The 209 bearing, changed; lengths in metres."""
    return AngularContactBearing(
        ball=Ball(diameter=ball, material=STEEL),
        inner=Groove(conformity=groove / ball, material=STEEL),
        outer=Groove(conformity=(outer_groove or groove) / ball, material=STEEL),
        balls=balls,
        pitch_diameter=pitch,
        contact_angle=0.0,
        clearance=clearance,
        first_ball_azimuth=azimuth,
    )


def solved(
    bearing=None, load=(0.0,) * 5, held=(None,) * 5, speed=0.0, control="outer", friction=None
) -> AngularContactState:
    """Its balance."""
    model = AngularContactBallBearing(bearing=bearing or deep_groove(), control=control, friction=friction)
    return model.solve(RingOperation(load=tuple(load), displacement=held, inner_speed=speed))
