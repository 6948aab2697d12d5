"""Mott, Machine elements in mechanical design, chapter 14 for the shaft of P12-40, in a public solution."""

import pytest

from tests.literature.selected import Choice

CHOICES = (
    Choice("P12-40, left", "10000 h", "6212", bore=60, required=(41.941, 1e-4),
           options={"load": "6351 N", "speed": "480 rpm"}),
    Choice("P12-40, right", "10000 h", "6212", bore=60, required=(33.825, 1e-4),
           options={"load": "5122 N", "speed": "480 rpm"}),
)  # fmt: skip


@pytest.mark.parametrize("choice", CHOICES, ids=lambda choice: choice.name)
def test_choice(choice, tmp_path):
    choice.check(tmp_path)
