"""Tables of tapered roller bearings in SKF's General Catalogue 6000 (2003), cited from memory.

The catalogue does not print rollers: those are taken that give its static rating and fill the pitch circle.
"""

from math import atan, degrees
from pathlib import Path

import pytest
from pytest import approx

from flexbearing.case import understood
from flexbearing.catalogue.new import case_text
from flexbearing.families import FAMILIES
from flexbearing.life import tapered_lives
from quasidynamic.outcome.tapered_life import axial_factor, load_limit

TABLE = {  # d, D, width of the cone [mm], C, C_0 [kN], e, Y
    "30205": (25, 52, 15, 30.8, 33.5, 0.37, 1.6),
    "30206": (30, 62, 16, 40.2, 44.0, 0.37, 1.6),
    "30210": (50, 90, 20, 76.5, 91.5, 0.43, 1.4),
    "30309": (45, 100, 25, 108.0, 120.0, 0.35, 1.7),
    "32207": (35, 72, 23, 66.0, 78.0, 0.37, 1.6),
    "32210": (50, 90, 23, 82.5, 100.0, 0.43, 1.4),
    "32308": (40, 90, 33, 117.0, 140.0, 0.35, 1.7),
}


@pytest.mark.parametrize("name", TABLE)
def test_dynamic_rating_and_factors_of_the_table(name):
    bore, outside, width, dynamic, static, limit, factor = TABLE[name]
    angle = atan(limit / 1.5)
    page = {
        "bore": f"{bore} mm", "outside": f"{outside} mm", "width": f"{width} mm",
        "angle": f"{degrees(angle)} deg",
        "static_rating": f"{static} kN", "load": "5 kN", "axial": "3 kN", "speed": "1000 rpm",
    }  # fmt: skip
    file = Path(f"{name}.toml")
    text, *_ = case_text("tapered_roller", page, file)
    own = tapered_lives.rated(understood(text, file, {}, FAMILIES))
    assert own.static == approx(1e3 * static, rel=1e-3)
    assert own.dynamic == approx(1e3 * dynamic, rel=0.05)
    assert load_limit(angle) == approx(limit, rel=1e-12)
    assert round(axial_factor(angle), 1) == factor
