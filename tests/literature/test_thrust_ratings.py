"""Ratings of thrust ball bearings: ISO 281 as printed in Machinery's Handbook, 31st ed., table 29."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import OutOfRange
from quasidynamic.outcome.ball_capacity import ball_dynamic_rating
from quasidynamic.outcome.four_point_life import RatedArcs, four_point_life
from quasidynamic.outcome.thrust_ball_capacity import (
    is_thrust,
    thrust_ball_dynamic_rating,
    thrust_ball_geometry_factor,
    thrust_ball_raceway_capacity,
)
from quasidynamic.parts.ball import BallRow

GAMMAS = (0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.09, 0.10, 0.12, 0.14, 0.16, 0.18, 0.20, 0.22,
          0.24, 0.26, 0.28, 0.30)  # fmt: skip
PRINTED = {  # f_c by contact angle [deg]
    45: (42.1, 51.7, 58.2, 63.3, 67.3, 70.7, 73.5, 75.9, 78.0, 79.7, 82.3, 84.1, 85.1, 85.5, 85.4, 84.9,
         84.0, 82.8, 81.3, 79.6),
    60: (39.2, 48.1, 54.2, 58.9, 62.6, 65.8, 68.4, 70.7, 72.6, 74.2, 76.6, 78.3, 79.2, 79.6, 79.5),
    75: (37.3, 45.9, 51.7, 56.1, 59.7, 62.7, 65.2, 67.3, 69.2, 70.7),
}  # fmt: skip


def row(gamma=0.05, angle=45.0, conformity=0.54, ball=20e-3, balls=40):
    """Balls at a gamma = D cos(alpha)/D_pw."""
    return BallRow(
        balls=balls, ball_diameter=ball, contact_angle=np.radians(angle),
        pitch_diameter=ball * np.cos(np.radians(angle)) / gamma, inner_conformity=conformity,
        outer_conformity=conformity,
    )  # fmt: skip


@pytest.mark.parametrize("angle", PRINTED)
def test_geometry_factor_is_the_printed_table(angle):
    printed = PRINTED[angle]
    found = [thrust_ball_geometry_factor(row(gamma, angle)) for gamma in GAMMAS[: len(printed)]]
    assert found == approx(printed, abs=0.06)


@pytest.mark.parametrize(
    "changed", [{"angle": 44.9}, {"gamma": 0.0099}, {"gamma": 0.301}, {"gamma": 0.16, "angle": 67.5}], ids=str
)
def test_beyond_the_table_there_is_no_factor(changed):
    with pytest.raises(OutOfRange):
        thrust_ball_geometry_factor(row(**changed))


def test_wider_grooves_are_rated_lower_and_closer_ones_as_the_table():
    factors = [thrust_ball_geometry_factor(row(conformity=f)) for f in (0.52, 0.53, 0.54, 0.55, 0.57)]
    assert factors[:3] == approx([factors[0]] * 3, rel=1e-12)
    assert np.all(np.diff(factors[2:]) < 0)


def test_axial_rating_by_hand():
    """f_c 67.3 at gamma 0.05: 1.3 x 67.3 cos^0.7 tan Z^(2/3) D^1.8 = 176.1 kN; from 25.4 mm on by D^1.4."""
    by_hand = 1.3 * 67.3 * np.cos(np.pi / 4) ** 0.7 * 40 ** (2 / 3) * 20**1.8
    assert thrust_ball_dynamic_rating(row()) == approx(by_hand, rel=1e-3)
    small, large = (thrust_ball_dynamic_rating(row(ball=d * 1e-3)) for d in (25.4, 50.8))
    assert large == approx(2**1.4 * small, rel=1e-4)


def test_axial_rating_follows_from_the_radial_one_as_in_annex_c():
    """C_a is 1.91 tan(alpha) (1 - sin(alpha)/3) C_r by ISO 281, annex C.4, rounded for all sizes."""
    closest = replace(row(), inner_conformity=0.52, outer_conformity=0.52)
    ratio = thrust_ball_dynamic_rating(row()) / ball_dynamic_rating(closest)
    assert ratio == approx(1.91 * (1 - np.sin(np.pi / 4) / 3), rel=0.025)


@pytest.mark.parametrize("angle", [45.0, 60.0])
def test_a_central_thrust_gives_the_rating_life(angle):
    """All balls carry F/(Z sin(alpha)): L = (C_a/F)^3; a radial bearing has no such identity."""
    balls, thrust = row(angle=angle), 30e3
    arcs, each = RatedArcs.of(balls), thrust / (balls.balls * np.sin(balls.contact_angle))
    loads = np.zeros((2, 2, balls.balls))
    loads[:, 0] = each
    assert arcs.thrust
    assert four_point_life(loads, arcs) == approx((arcs.rating / thrust) ** 3, rel=1e-12)
    assert thrust_ball_raceway_capacity(balls) == arcs.capacities


def test_the_contact_angle_decides_between_radial_and_axial_ratings():
    assert [is_thrust(row(angle=angle)) for angle in (40.0, 45.0, 50.0)] == [False, True, True]
    assert RatedArcs.of(row(), thrust=False).rating == ball_dynamic_rating(row())
