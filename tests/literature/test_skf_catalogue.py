"""Worked examples of SKF's General Catalogue 6000, Selection of bearing size: ball bearing 6309.

Its viscosity ratio (8.15 mm2/s read from a diagram of SKF, where ISO 281 has 9.65) and a_SKF are SKF's own
and are not compared.
"""

import pytest

from quasidynamic.outcome.rating_life import BALL_EXPONENT, rating_life, static_safety
from tests.literature.worked_example import WorkedExample, hours


def turns():
    return rating_life(55.3, 10.0, BALL_EXPONENT)


EXAMPLES = (
    WorkedExample("example 1 a, 6309, 10 kN: L_10", 169, turns, 5e-3, "10^6"),
    WorkedExample("example 1 a, 3000 r/min: L_10h", 940, lambda: hours(turns(), 3000), 5e-3, "h"),
    WorkedExample("example 5, 24026, 500 kN: s_0", 1.63, lambda: static_safety(815.0, 500.0), 5e-3),
)


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.name)
def test_worked_example(example):
    example.check()
