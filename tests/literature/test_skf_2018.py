"""Worked examples of SKF's catalogue Rolling bearings (2018), chapter C: a rope sheave, a centrifugal pump.

Their reference viscosities are read from a diagram of SKF, and a_SKF is SKF's own: both are not compared.
"""

import pytest
from pytest import approx

from quasidynamic import oil_at
from quasidynamic.outcome.rating_life import BALL_EXPONENT, rating_life


def hours(life, speed):
    """Of a life [10^6 revolutions] at a speed [1/min]."""
    return life * 1e6 / 60 / speed


def test_deep_groove_bearing_of_a_rope_sheave():
    """6207, C 27 kN (C/P 49), P 0.55 kN, 2450 r/min: 804 800 h."""
    life = rating_life(27.0, 0.55, BALL_EXPONENT)
    assert 27.0 / 0.55 == approx(49, rel=5e-3)
    assert hours(life, 2450) == approx(804800, rel=1e-4)


def test_angular_contact_pair_of_a_pump():
    """7312 BE back to back: 1.62 C, P = 0.57 F_r + 0.93 F_a = 11.52 kN, 3000 r/min: 17 400 h."""
    load = 0.57 * 1.45 + 0.93 * 11.5
    assert load == approx(11.52, abs=5e-3)
    assert hours(rating_life(1.62 * 104, load, BALL_EXPONENT), 3000) == approx(17400, rel=5e-3)


def test_roller_bearing_of_a_pump():
    """NU 311: C 156 kN, P 3.29 kN (C/P 47), 3000 r/min: more than a million hours."""
    assert 156 / 3.29 == approx(47, abs=0.5)
    assert hours(rating_life(156, 3.29), 3000) > 1e6


@pytest.mark.parametrize(("celsius", "viscosity"), [(70, 20), (85, 13)])
def test_viscosity_of_the_oil(celsius, viscosity):
    """ISO VG 68, read from a diagram to two digits."""
    oil = oil_at("ISO VG 68", celsius + 273.15)
    assert 1e6 * oil.viscosity / oil.density == approx(viscosity, rel=0.08)
