"""Shigley, Mechanical engineering design: the ball bearing of 7900 and 4450 lbf, problem 11-1, both recalled.

Its Weibull curve at 99 % requires 29.8 kN, a_1 of ISO 281 28.5 kN.
"""

import pytest

from tests.literature.selected import Choice

LBF = 4.4482216152605
# Table 11-2, series 02 [kN], recalled
SERIES_02 = {
    "02-30": (30, 62, 16, 19.5, 10.0), "02-35": (35, 72, 17, 25.5, 13.7), "02-40": (40, 80, 18, 30.7, 16.6),
    "02-45": (45, 85, 19, 33.2, 18.6), "02-50": (50, 90, 20, 35.1, 19.6), "02-55": (55, 100, 21, 43.6, 25.0),
}  # fmt: skip
CHOICES = (
    Choice("7900 lbf", "16150 h", "02-50", bearings=SERIES_02,
           options={"load": f"{500 * LBF} N", "axial": f"{400 * LBF} N", "speed": "720 rpm"}),
    Choice("11-1", "30000 h", "02-40", factor=1.2, reliability=0.99, bearings=SERIES_02,
           options={"load": f"{413 * LBF} N", "speed": "300 rpm"}),
)  # fmt: skip


@pytest.mark.parametrize("choice", CHOICES, ids=lambda choice: choice.name)
def test_choice(choice, tmp_path):
    choice.check(tmp_path)
