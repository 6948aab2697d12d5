"""Koyo, Ball and roller bearings, section 5.6, examples 1 and 2, read on hchbearing.com.

That prints them without the speed: 1600 and 1000 1/min follow from their C_r of 19 730 and 51 280 N.
"""

import pytest

from tests.literature.selected import OF_SIZES, SERIES_62, Choice

CHOICES = (
    Choice("example 1, series 62", "10000 h", "6206", required=(19.73, 5e-4),
           options={"load": "2000 N", "axial": "300 N", "speed": "1600 rpm"},
           bearings={**SERIES_62, "6206": (30, 62, 16, 0, 12.8)}),
    Choice("example 2, series 63", "10000 h", "6310",
           options={"load": "4000 N", "axial": "2400 N", "speed": "1000 rpm"}, bearings=OF_SIZES),
)  # fmt: skip


@pytest.mark.parametrize("choice", CHOICES, ids=lambda choice: choice.name)
def test_choice(choice, tmp_path):
    choice.check(tmp_path)
