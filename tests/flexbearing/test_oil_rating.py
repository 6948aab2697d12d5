"""Viscosity ratio and largest a_ISO of an oil, as a report has them beside any life."""

import numpy as np
import pytest
from pytest import approx

from flexbearing import api
from flexbearing.families import FAMILIES
from flexbearing.runs.life_of_state import of_oil
from quasidynamic.outcome.life_factors import CLEANLINESS, ROLLERS
from tests.flexbearing.hostile_cases import CONFIGS

RPM = np.pi / 30


def test_viscosities_are_those_of_iso_281():
    found = of_oil(20e-6, 3000 * RPM, 70.5e-3, 0.1, ROLLERS)
    needed = 4500 / np.sqrt(3000 * 70.5)  # [mm2/s]
    assert found["reference_viscosity"] == approx(1e-6 * needed, rel=1e-12)
    assert found["viscosity_ratio"] == approx(20 / needed, rel=1e-12)
    kappa = found["viscosity_ratio"]
    bracket = 1 - (1.5859 - 1.2348 / kappa**0.071739) * 0.1**0.4
    assert found["largest_a_ISO"] == approx(0.1 * bracket**-9.185, rel=1e-12)


def test_below_a_ratio_of_a_tenth_iso_281_has_no_factor():
    found = of_oil(0.5e-6, 3000 * RPM, 70.5e-3, 0.1, ROLLERS)
    assert found["viscosity_ratio"] < 0.1
    assert "largest_a_ISO" not in found


OIL = ("lubricant.oil=ISO VG 68", "lubricant.inlet_temperature=70 degC")


@pytest.mark.parametrize(
    ("kind", "file", "oil"),
    [("cylindrical_roller", "nu209.toml", ()), ("deep_groove_ball", "6209.toml", OIL),
     ("cylindrical_roller", "mao2016.toml", ())],
)  # fmt: skip
def test_no_cleanliness_has_a_larger_factor(kind, file, oil):
    catalogue = FAMILIES[kind].catalogue()
    cleanliness = [each for each in CLEANLINESS if each.startswith("oil, in-line")]
    cases = [
        api.read_case(CONFIGS / file, [*oil, "life.lubrication=a_ISO", f"life.cleanliness={each}"])
        for each in cleanliness
    ]
    rated = [catalogue.ratings(case, 1.0) for case in cases]
    found = catalogue.oil(cases[0], rated[0].life_Mrev)
    assert max(each.a_ISO for each in rated) <= found["largest_a_ISO"]
    assert rated[0].viscosity_ratio == approx(found["viscosity_ratio"], rel=1e-12)


def test_a_ball_bearing_without_an_oil_has_nothing_of_it():
    assert FAMILIES["deep_groove_ball"].catalogue().oil(api.read_case(CONFIGS / "6209.toml"), 1.0) == {}
