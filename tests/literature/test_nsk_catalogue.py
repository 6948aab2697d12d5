"""Worked examples of NSK's catalogue Rolling Bearings, section 5.7, deep groove ball bearing 6208.

The same lives, rounded down to two digits, are required of series 62, which must give the 6208 back. Example
2, recalled: bore 50 mm, 3000 N, 1900 1/min, at least 10 000 h.
"""

import pytest

from quasidynamic.outcome.ball_equivalent_load import ball_dynamic_load
from quasidynamic.outcome.rating_life import BALL_EXPONENT, rating_life
from tests.literature.selected import SERIES_62, Choice
from tests.literature.worked_example import WorkedExample, hours

RATING, STATIC, F_0 = 29100.0, 17900.0, 14.0  # [N], [N], [-]
SPEED = 900.0  # [1/min]
RELATIVE = F_0 * 1000.0 / STATIC


def turned(load):
    return hours(rating_life(RATING, load, BALL_EXPONENT), SPEED)


def both():
    return ball_dynamic_load(2500.0, 1000.0, 0.0, RELATIVE)


EXAMPLES = (
    WorkedExample("example 1, 2500 N: f_h", 3.88, lambda: (turned(2500.0) / 500) ** (1 / 3), 5e-3),
    WorkedExample("example 1: life, two digits", 29000, lambda: turned(2500.0), 0.01, "h"),
    WorkedExample("example 3, 1000 N along the axis: f_0 F_a/C_0", 0.782, lambda: RELATIVE, 6.4e-4),
    WorkedExample("example 3: e", 0.26, lambda: both().limit, 0.023),
    WorkedExample("example 3: X", 0.56, lambda: both().radial_factor, 5e-3),
    WorkedExample("example 3: Y", 1.67, lambda: both().axial_factor, 3e-3),
    WorkedExample("example 3: P", 3070.0, lambda: both().value, 2e-3, "N"),
    WorkedExample("example 3: C_r/P", 9.48, lambda: RATING / both().value, 2e-3),
    WorkedExample("example 3: life", 15800, lambda: turned(both().value), 5e-3, "h"),
)


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.name)
def test_worked_example(example):
    example.check()


CHOICES = (
    Choice("example 1", "29000 h", "6208", options={"load": "2500 N", "speed": "900 rpm"}),
    Choice("example 2", "10000 h", "6210", bore=50, options={"load": "3000 N", "speed": "1900 rpm"},
           bearings={**SERIES_62, "6010": (50, 80, 16)}),
    Choice("example 3", "15000 h", "6208", options={"load": "2500 N", "axial": "1 kN", "speed": "900 rpm"}),
)  # fmt: skip


@pytest.mark.parametrize("choice", CHOICES, ids=lambda choice: choice.name)
def test_choice(choice, tmp_path):
    choice.check(tmp_path)
