"""Worked examples of SKF's General Catalogue 6000, Selection of bearing size: ball bearing 6309.

Its viscosity ratio (8.15 mm2/s read from a diagram of SKF, where ISO 281 has 9.65) and a_SKF are SKF's own
and are not compared.
"""

from pytest import approx

from quasidynamic.outcome.rating_life import BALL_EXPONENT, rating_life, static_safety


def test_basic_life_of_6309():
    """Example 1 a: C 55.3 kN, 10 kN at 3000 r/min: 169 million revolutions, 940 h."""
    life = rating_life(55.3, 10.0, BALL_EXPONENT)
    assert life == approx(169, rel=5e-3)
    assert life * 1e6 / 60 / 3000 == approx(940, rel=5e-3)


def test_static_safety_of_24026():
    """Example 5: C_0 815 kN, P_0 500 kN: s_0 = 1.63."""
    assert static_safety(815.0, 500.0) == approx(1.63, rel=5e-3)
