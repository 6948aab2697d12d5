"""Choices of public lectures and problems.

- "Antifriction bearings 2", example 2: 53.98 kN with a_1 = 0.6 at 95 %, where ISO 281 has 0.64. It takes an
  NU2210 of 58.5 kN; a lighter NU210 of today has more.
- A problem: 3 kN 10 %, 2 kN 20 %, 1 kN 30 % of the time, idling for the rest, 37.0 Mrev with 5.54 kN.
"""

import pytest
from pytest import approx

from tests.literature.selected import ROLLERS, SERIES_62, Choice

OF_50_MM = {"NU1010": (50, 80, 16), "NU210": (50, 90, 20, 73.5, 69.5), "NU2210": (50, 90, 23)}
ROWS = "time [%],operation.load.radial_z [kN]\n10,3\n20,2\n30,1\n40,0\n"
HOURS = 36.96e6 / 1000 / 60  # 37.0 Mrev, to four digits, at 1000 1/min


CHOICES = (
    Choice("shaft of 50 mm", "8000 h", "NU210", "NU2210", factor=1.3, reliability=0.95,
           options={"load": "5 kN", "speed": "1450 rpm"}, bearings=OF_50_MM, like=ROLLERS,
           required=(53.98 * (0.6 / 0.64) ** 0.3, 2e-3)),
)  # fmt: skip


@pytest.mark.parametrize("choice", CHOICES, ids=lambda choice: choice.name)
def test_choice(choice, tmp_path):
    choice.check(tmp_path)


def test_idling(tmp_path):
    """The rating for 37.0 Mrev is the printed one; such a bearing is too small for the largest load."""
    sizes = {**SERIES_62, "of 5.54 kN": (10, 30, 9, 5.54, 2.39)}
    choice = Choice("", f"{HOURS} h", "6201", options={"speed": "1000 rpm"}, bearings=sizes, spectrum=ROWS)
    found = choice.selection(tmp_path)
    (printed,) = (card for card in found.cards if card.candidate.designation == "of 5.54 kN")
    assert printed.rated.required_rating == approx(5540, rel=5e-4)
    assert printed.rated.life == approx(3600 * HOURS, rel=2e-3)
    assert "heavy-load" in printed.verdict
    assert found.chosen.candidate.designation == "6201"
