"""Ratings of cylindrical roller thrust bearings: the table of ISO 281, and SKF's series 811.

The factors are cited from memory. Ratings of the series are those of a public list (SKF 811.. TN), which has
no rollers: those are taken that have the static rating, 0.43 of the height thick.
"""

from math import pi
from pathlib import Path

import pytest
from pytest import approx

from flexbearing.case import understood
from flexbearing.catalogue.new import case_text
from flexbearing.families import FAMILIES
from flexbearing.life import tapered_lives
from quasidynamic import OutOfRange
from quasidynamic.outcome.thrust_roller_capacity import ThrustRow
from quasidynamic.parts.roller_bearing import Roller
from tests.random_tapered import STEEL

FACTORS = {0.01: 105.4, 0.02: 122.9, 0.03: 134.5, 0.04: 143.4, 0.05: 150.7}  # of 90 degrees
TABLE = {  # d, D, H [mm], C, C_0 [kN]
    "81106": (30, 47, 11, 27.0, 78.0),
    "81108": (40, 60, 13, 43.0, 137.0),
    "81110": (50, 70, 14, 47.5, 166.0),
    "81113": (65, 90, 18, 83.0, 320.0),
    "81115": (75, 100, 19, 83.0, 335.0),
    "81116": (80, 105, 19, 81.5, 335.0),
}


def thrust_geometry_factor(ratio):
    """Rating of one roller with 1 mm of diameter and length."""
    roller = Roller(diameter=1e-3, length=1e-3, material=STEEL)
    return ThrustRow(1, roller, 1e-3 / ratio, pi / 2).dynamic_rating


@pytest.mark.parametrize("ratio", FACTORS)
def test_factors_of_the_table(ratio):
    assert thrust_geometry_factor(ratio) == approx(FACTORS[ratio], abs=0.06)


@pytest.mark.parametrize("ratio", [0.009, 0.31])
def test_no_factor_beyond_the_table(ratio):
    with pytest.raises(OutOfRange):
        thrust_geometry_factor(ratio)


@pytest.mark.parametrize("name", TABLE)
def test_dynamic_rating_from_the_static_one(name):
    bore, outside, height, dynamic, static = TABLE[name]
    page = {
        "bore": f"{bore} mm", "outside": f"{outside} mm", "width": f"{height} mm",
        "static_rating": f"{static} kN", "axial": "3 kN", "speed": "1000 rpm",
    }  # fmt: skip
    file = Path(f"{name}.toml")
    text, _ = case_text("thrust_roller", page, file)
    own = tapered_lives.rated(understood(text, file, {}, FAMILIES))
    assert own.static == approx(1e3 * static, rel=1e-3)
    assert own.dynamic == approx(1e3 * dynamic, rel=0.07)


def test_the_shipped_bearing_has_both_ratings_of_its_catalogue():
    file = Path(__file__).parents[2] / "configs" / "81110.toml"
    own = tapered_lives.rated(understood(file.read_text(), file, {}, FAMILIES))
    assert (own.dynamic, own.static) == approx((47.5e3, 166e3), rel=3e-3)
