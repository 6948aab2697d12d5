"""Worked examples of NSK's catalogue Rolling Bearings, section 5.7, deep groove ball bearing 6208."""

from pytest import approx

from quasidynamic.outcome.ball_equivalent_load import ball_dynamic_load
from quasidynamic.outcome.rating_life import BALL_EXPONENT, rating_life

RATING, STATIC, F_0 = 29100.0, 17900.0, 14.0  # [N], [N], [-]
SPEED = 900.0  # [1/min]


def hours(load):
    return rating_life(RATING, load, BALL_EXPONENT) * 1e6 / 60 / SPEED


def test_radial_load():
    """Example 1: 2500 N; f_h = 3.88, printed as 29 000 h."""
    assert (hours(2500.0) / 500) ** (1 / 3) == approx(3.88, rel=5e-3)
    assert hours(2500.0) == approx(29000, rel=0.01)  # two digits are printed


def test_radial_and_axial_load():
    """Example 3: 1000 N more along the axis; X 0.56, Y 1.67, P = 3070 N, C_r/P 9.48, 15 800 h."""
    relative = F_0 * 1000.0 / STATIC
    assert relative == approx(0.782, abs=5e-4)
    load = ball_dynamic_load(2500.0, 1000.0, 0.0, relative)
    assert load.limit == approx(0.26, abs=6e-3)
    assert (load.radial_factor, load.axial_factor) == approx((0.56, 1.67), abs=5e-3)
    assert load.value == approx(3070.0, rel=2e-3)
    assert RATING / load.value == approx(9.48, rel=2e-3)
    assert hours(load.value) == approx(15800, rel=5e-3)
