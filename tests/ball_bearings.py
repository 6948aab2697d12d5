"""Ball bearings that several tests use."""

import numpy as np

from quasidynamic.contact.ellipse.rigid_slip import Spin
from quasidynamic.four_point import FourPointBallBearing
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing
from quasidynamic.parts.ball import Ball, FourPointBearing, FrictionCurve, Groove, constant_friction
from quasidynamic.parts.material import Material

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7800)


def fast_bearing(ball, pitch, balls, angle, conformity, outer_conformity=None, material=STEEL, **more):
    """One groove in each ring; angle in radians, conformity r/D."""
    return AngularContactBearing(
        ball=Ball(diameter=ball, material=material),
        inner=Groove(conformity=conformity, material=material),
        outer=Groove(conformity=outer_conformity or conformity, material=material),
        balls=balls,
        pitch_diameter=pitch,
        contact_angle=angle,
        **more,
    )


def slow_bearing(
    ball=30e-3,
    pitch=1.0,
    balls=60,
    angle=45.0,
    conformity=0.525,
    outer_conformity=None,
    clearance=0.0,
    friction: float | FrictionCurve = 0.1,
    modulus=210e9,
    loss=0.0,
    spin: Spin = "centre",
):
    """Four-point bearing; angle in degrees, conformity r/D."""
    steel = Material(youngs_modulus=modulus, poisson_ratio=0.3, density=7850)
    return FourPointBallBearing(
        bearing=FourPointBearing(
            ball=Ball(diameter=ball, material=steel),
            inner=Groove(conformity=conformity, material=steel),
            outer=Groove(conformity=outer_conformity or conformity, material=steel),
            balls=balls,
            pitch_diameter=pitch,
            contact_angle=np.radians(angle),
            clearance=clearance,
        ),
        friction=friction if isinstance(friction, FrictionCurve) else constant_friction(friction),
        hysteresis_loss=loss,
        spin=spin,
    )


def one_ball(bearing, angles, loads):
    """Sliding of one ball: contact angles [deg] and loads [N] of its diagonals, the same on both races."""
    shape = (1, len(loads), 2)
    angle, load = (np.broadcast_to(np.array(value, float)[None, :, None], shape) for value in (angles, loads))
    return bearing.slide(np.radians(angle), load)
