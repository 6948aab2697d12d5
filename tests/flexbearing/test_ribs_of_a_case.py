"""An axial load of a roller case: from [bearing.ribs] to summary, findings and refusals."""

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import read_case
from flexbearing.case import BadCase
from flexbearing.report.output import text
from quasidynamic.outcome.axial_capacity import rib_strength, warm_rib_load
from tests.places import CONFIGS

NU209 = CONFIGS / "nu209.toml"
RIBS = {
    "bearing.ribs.inner_height": "1.5 mm",
    "bearing.ribs.outer_height": "1.2 mm",
    "bearing.ribs.end_radius": "500 mm",
    "bearing.ribs.friction": 0.05,
}
SIZES = {"bearing.ribs.outside_diameter": "85 mm", "bearing.ribs.bore": "45 mm"}
THRUST = {**RIBS, "operation.axial_load": "500 N"}


@pytest.fixture(scope="module")
def result():
    return flexbearing.run(NU209, {**THRUST, **SIZES, "life.static_rating": "50 kN"})


def test_summary_and_losses(result):
    summary, block = result.summary()["rigid"], result.rigid
    assert summary["ribs"]["max_rib_load_N"] == approx(block["rib_thrust"].max())
    assert sum(summary["ribs"]["rib_thrusts_N"]) == approx(500.0)
    heat = block["rib_friction"] * block["rib_sliding"]
    assert summary["power_loss_W"]["ribs"] == approx(heat.sum())
    assert "axial load 500 N" in str(result)
    assert "thrust on the ribs" in text(result)


def test_limits_are_those_of_the_maker(result):
    found = {(each["code"], each["grade"]): each for each in result.attributes["findings"]}
    case = result.attributes["case_si"]
    assert found["axial-load", "danger"]["limit"] == approx(case["operation"]["radial_load"] / 2)
    assert found["rib-strength", "danger"]["limit"] == approx(rib_strength(0.085))
    speed, length = case["operation"]["inner_speed"], case["bearing"]["roller"]["length"]
    permitted = warm_rib_load(50e3, speed, 0.045, 0.085, length, case["operation"]["radial_load"])
    assert found["rib-heat", "usual"]["limit"] == approx(float(permitted))


def test_limits_without_sizes_are_not_checked():
    result = flexbearing.run(NU209, THRUST)
    verdicts = {each["code"]: each["verdict"] for each in result.attributes["findings"]}
    assert verdicts["axial-load"] == "met"
    assert verdicts["rib-heat"] == verdicts["rib-strength"] == "not checked"


def test_without_thrust_ribs_change_nothing():
    with_ribs, without = (flexbearing.run(NU209, each).rigid for each in (RIBS, {}))
    assert with_ribs.keys() == without.keys()
    assert np.array_equal(with_ribs["unknowns"], without["unknowns"])


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"operation.axial_load": "1 N"}, "ribs"),
        ({**THRUST, "operation.radial_load": "0 N"}, "radial_load"),
        ({**THRUST, "bearing.contact": "half_space"}, "contact"),
        ({**THRUST, "bearing.second_row.distance": "25 mm"}, "second_row"),
        ({**THRUST, "bearing.ribs.outer_height": "9 mm"}, "outer_height"),
        ({**THRUST, "bearing.ribs.bore": "60 mm"}, "bore"),
        ({**THRUST, "bearing.ribs.outside_diameter": "70 mm"}, "outside_diameter"),
    ],
)
def test_refused(settings, message):
    with pytest.raises(BadCase, match=message):
        read_case(NU209, settings)


def test_sizes_are_given_once():
    with pytest.raises(BadCase, match=r"rings or \[bearing.fits\] give it"):
        read_case(NU209.with_name("nu209_fits.toml"), {**RIBS, **SIZES})
