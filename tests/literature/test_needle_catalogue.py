"""Ratings of needle roller bearings with machined rings, series NA 49 of SKF as a public list has them.

The list has no needles: those are taken that have the static rating. Raceways F of ISO 1206 are from memory.
"""

import pytest
from pytest import approx

from flexbearing.catalogue.page import read
from flexbearing.catalogue.roller_set import roller_set

TABLE = {  # d, D, B, F [mm], C, C_0 [kN]
    "NA 4905": (25, 42, 17, 30, 24.2, 34.5),
    "NA 4906": (30, 47, 17, 35, 25.5, 39.0),
    "NA 4907": (35, 55, 20, 42, 31.9, 54.0),
    "NA 4908": (40, 62, 22, 48, 42.9, 71.0),
    "NA 4909": (45, 68, 22, 52, 45.7, 78.0),
    "NA 4910": (50, 72, 22, 58, 47.3, 85.0),
    "NA 4912": (60, 85, 25, 68, 60.5, 114.0),
    "NA 4913": (65, 90, 25, 72, 61.6, 120.0),
    "NA 4914": (70, 100, 30, 80, 84.2, 163.0),
    "NA 4916": (80, 110, 30, 90, 88.0, 183.0),
}


@pytest.mark.parametrize("name", TABLE)
def test_dynamic_rating_from_the_static_one(name):
    bore, outside, width, inner, dynamic, static = TABLE[name]
    page = {
        "bore": f"{bore} mm", "outside": f"{outside} mm", "width": f"{width} mm",
        "inner_raceway": f"{inner} mm", "static_rating": f"{static} kN", "load": "3 kN", "speed": "1000 rpm",
    }  # fmt: skip
    needles = roller_set(read("needle_roller", page))
    own = needles.rated(*needles.chosen)
    assert own.static == approx(1e3 * static, rel=1e-3)
    assert own.dynamic == approx(1e3 * dynamic, rel=0.06)
