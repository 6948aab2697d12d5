"""Worked examples of SKF's catalogue Rolling bearings (2018), chapter C: a rope sheave, a centrifugal pump.

Their reference viscosities are read from a diagram of SKF, and a_SKF is SKF's own: both are not compared.
Viscosities of the oil are read from a diagram to two digits.
"""

import pytest

from quasidynamic import oil_at
from quasidynamic.outcome.rating_life import BALL_EXPONENT, rating_life
from tests.literature.worked_example import WorkedExample, hours

PUMP = 0.57 * 1.45 + 0.93 * 11.5  # [kN] P = 0.57 F_r + 0.93 F_a


def viscosity(celsius):
    """Kinematic [mm2/s]."""
    oil = oil_at("ISO VG 68", celsius + 273.15)
    return 1e6 * oil.viscosity / oil.density


def sheave():
    return hours(rating_life(27.0, 0.55, BALL_EXPONENT), 2450)


def pair():
    return hours(rating_life(1.62 * 104, PUMP, BALL_EXPONENT), 3000)


EXAMPLES = (
    WorkedExample("rope sheave, 6207, 0.55 kN: C/P", 49, lambda: 27.0 / 0.55, 5e-3),
    WorkedExample("rope sheave: life", 804800, sheave, 1e-4, "h"),
    WorkedExample("pump, 7312 BE back to back: P", 11.52, lambda: PUMP, 5e-4, "kN"),
    WorkedExample("pump, 7312 BE back to back: life", 17400, pair, 5e-3, "h"),
    WorkedExample("pump, NU 311, 3.29 kN: C/P", 47, lambda: 156 / 3.29, 0.011),
    WorkedExample("ISO VG 68 at 70 °C, diagram", 20, lambda: viscosity(70), 0.08, "mm²/s"),
    WorkedExample("ISO VG 68 at 85 °C, diagram", 13, lambda: viscosity(85), 0.08, "mm²/s"),
)


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.name)
def test_worked_example(example):
    example.check()


def test_roller_bearing_of_a_pump_lives_more_than_a_million_hours():
    """NU 311: C 156 kN, P 3.29 kN, 3000 r/min."""
    assert hours(rating_life(156, 3.29), 3000) > 1e6
