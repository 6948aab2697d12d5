"""Reference lives of a deep groove ball bearing by ISO/TS 16281, as another program prints them.

A public program, minzhun/ISO16281 on GitHub (Test_BallBearing.py), compares itself with these numbers, which
by the names of its variables are those of MASTA. Seven balls of 11.5 mm on 43.5 mm, grooves of 0.52 and 0.53,
E 210 GPa, nu 0.3, C_r 23.4 kN; a ball on the load line; the inner ring turns.
"""

import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.outcome.ball_life import ball_reference_life
from quasidynamic.outcome.life import reference_load
from quasidynamic.outcome.rating_life import BALL_EXPONENT
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing, RingOperation
from quasidynamic.parts.ball import Ball, Groove
from quasidynamic.parts.ball_row import BallRow
from quasidynamic.parts.material import Material

STEEL = Material(youngs_modulus=210e9, poisson_ratio=0.3, density=7850.0)
DIAMETER, PITCH, RATING = 11.5e-3, 43.5e-3, 23.4e3
ROW = BallRow(
    balls=7, ball_diameter=DIAMETER, pitch_diameter=PITCH, contact_angle=0.0, inner_conformity=0.52,
    outer_conformity=0.53,
)  # fmt: skip


def solved(clearance=0.0, axial=0.0, radial=0.0, moment=0.0):
    """At rest with a diametral clearance [m]."""
    bearing = AngularContactBearing(
        ball=Ball(diameter=DIAMETER, material=STEEL),
        inner=Groove(conformity=0.52, material=STEEL),
        outer=Groove(conformity=0.53, material=STEEL),
        balls=7, pitch_diameter=PITCH, contact_angle=0.0, clearance=clearance,
    )  # fmt: skip
    load = (axial, 0.0, radial, moment, 0.0)
    return AngularContactBallBearing(bearing=bearing).solve(RingOperation(load=load))


@pytest.mark.parametrize(
    ("loads", "life"),
    [
        ({"radial": 1e3}, 13163.019),
        ({"axial": 1e3}, 2222.7318),
        ({"radial": 1e3, "clearance": 10e-6}, 10795.7948),
        ({"axial": 1e3, "clearance": 10e-6}, 3115.8781),
        ({"radial": 1e3, "axial": 1e3, "clearance": 10e-6}, 1630.5367),
    ],
    ids=["radial", "axial", "radial, clearance", "axial, clearance", "both, clearance"],
)
def test_reference_life(loads, life):
    """Within 1e-4 of five printed lives [10^6 revolutions]."""
    found = ball_reference_life(solved(**loads).loads, ROW, (1.0, 0.0), RATING)
    assert found == approx(life, rel=1e-4)
    assert reference_load(found, RATING, BALL_EXPONENT) == approx(RATING * life ** (-1 / 3), rel=1e-4)


def test_displacements():
    """Printed in um."""
    assert 1e6 * solved(radial=1e3).ring_displacement[2] == approx(15.1101, rel=1e-4)
    assert 1e6 * solved(axial=1e3).ring_displacement[0] == approx(133.5381, rel=1e-4)
    assert 1e6 * solved(radial=1e3, clearance=10e-6).ring_displacement[2] == approx(21.223, rel=1e-4)
    both = solved(radial=1e3, axial=1e3, clearance=10e-6)
    assert 1e6 * both.ring_displacement[0] == approx(146.4603, rel=1e-4)
    assert 1e6 * both.ring_displacement[2] == approx(19.5923, rel=1e-4)


def test_life_under_a_moment():
    """1 N m: 785 145. ISO/TS 16281 gives the ball loads half the pitch diameter as lever.

    Here it is the radius of the inner groove centres, 1.06 % more, so the moment is as much larger; 0.6 % is
    left.
    """
    wider = (PITCH / 2 + 0.02 * DIAMETER) / (PITCH / 2)
    found = ball_reference_life(solved(moment=wider * 1.0).loads, ROW, (1.0, 0.0), RATING)
    assert found == approx(785144.7521, rel=7e-3)
