"""Ratings of spherical roller bearings: factors e, Y, and the dynamic rating of SKF's series 222 and 223.

Ratings and factors are those of the maker's catalogue, cited from memory; it has no rollers: those are taken
that have the static rating, 0.55 of (D - d)/2 thick.
"""

from math import atan, degrees
from pathlib import Path
from typing import Any

import pytest
from pytest import approx

from flexbearing.case import understood
from flexbearing.catalogue.new import case_text
from flexbearing.families import FAMILIES
from flexbearing.life import tapered_lives
from quasidynamic.outcome.tapered_life import (
    InclinedRow,
    SphericalRow,
    load_limit,
    tapered_dynamic_load,
    tapered_static_load,
)
from quasidynamic.parts.roller_bearing import Roller
from tests.random_tapered import STEEL

TABLE = {  # d, D, B [mm], C, C_0 [kN], e, Y_1, Y_2, Y_0
    "22210": (50, 90, 23, 104.0, 108.0, 0.24, 2.8, 4.2, 2.8),
    "22308": (40, 90, 33, 150.0, 140.0, 0.37, 1.8, 2.7, 1.8),
    "22220": (100, 180, 46, 425.0, 490.0, 0.24, 2.8, 4.2, 2.8),
}


@pytest.mark.parametrize("name", TABLE)
def test_factors_follow_from_the_contact_angle(name):
    *_, limit, first, second, static = TABLE[name]
    angle = atan(limit / 1.5)
    assert load_limit(angle) == approx(limit, rel=1e-12)
    below, above = (tapered_dynamic_load(1.0, axial, angle, opposed=True) for axial in (0.0, 1.0))
    assert (below.axial_factor, above.axial_factor) == approx((first, second), abs=0.05)
    assert tapered_static_load(1.0, 1.0, angle, opposed=True).axial_factor == approx(static, abs=0.06)


@pytest.mark.parametrize("name", TABLE)
def test_dynamic_rating_from_the_static_one(name):
    """Makers rate above the standard, by 9 to 13 % with these rollers."""
    bore, outside, width, dynamic, static, limit, *_ = TABLE[name]
    page = {
        "bore": f"{bore} mm", "outside": f"{outside} mm", "width": f"{width} mm", "load": "3 kN",
        "static_rating": f"{static} kN", "speed": "1000 rpm",
        "angle": f"{degrees(atan(limit / 1.5)):.6g} deg",
    }  # fmt: skip
    file = Path(f"{name}.toml")
    text, _ = case_text("spherical_roller", page, file)
    case: Any = understood(text, file, {}, FAMILIES)
    own = tapered_lives.rated(case)
    assert own.static == approx(1e3 * static, rel=1e-3)
    assert 0.86 < own.dynamic / (1e3 * dynamic) < 0.92


def test_barrels_are_rated_above_cones():
    row = 18, Roller(diameter=11e-3, length=7e-3, material=STEEL), 70e-3, 0.16, 2
    assert SphericalRow(*row).dynamic_rating / InclinedRow(*row).dynamic_rating == approx(
        1.15 / 1.1, rel=1e-12
    )
    assert SphericalRow(*row).static_rating == approx(InclinedRow(*row).static_rating, rel=1e-12)
