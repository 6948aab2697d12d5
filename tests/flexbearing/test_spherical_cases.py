"""Spherical roller bearings as cases: what a run and a report of them have."""

from pathlib import Path

import numpy as np
import pytest
from pytest import approx

from flexbearing import BadCase, api
from flexbearing.families import FAMILIES
from flexbearing.life import tapered_lives
from flexbearing.report.html import html, of_result
from tests.sound_results import in_sphere

CASE = Path(__file__).parents[2] / "configs" / "22210.toml"


@pytest.fixture(scope="module")
def result():
    return api.run(CASE)


@pytest.mark.parametrize("settings", [(), ("operation.inner_speed=6000 rpm", "operation.load.axial=-3 kN")])
def test_balances_hold_for_the_stored_loads(settings):
    result = api.run(CASE, settings)
    assert [*in_sphere(result, result.rigid, 1e-9)] == []
    assert result.rigid["ring_load"][3:] == approx(0.0, abs=1e-9 * 10e3 * 70e-3)  # about the centre


def test_rating_life_is_that_of_the_catalogue_with_two_rows():
    values = api.run(CASE).rigid
    tangent = np.tan(np.radians(9.09))
    load = 10e3 + 0.45 / tangent * 1.5e3
    assert values["equivalent_load"] == approx(load, rel=1e-9)
    case = api.read_case(CASE, ["life.loads=rating"])
    assert tapered_lives.rated(case).lived == approx(1e6 * (104e3 / load) ** (10 / 3), rel=1e-9)
    heavy = api.run(CASE, ["operation.load.axial=6 kN"]).rigid
    assert heavy["equivalent_load"] == approx(0.67 * 10e3 + 0.67 / tangent * 6e3, rel=1e-9)
    assert heavy["static_safety"] == approx(108e3 / (10e3 + 0.44 / tangent * 6e3), rel=1e-9)


def test_report_has_rows_and_no_rib(result):
    page = html(of_result(result))
    assert "axial force, row 2" in page
    assert "barrel" in page.lower()
    assert not [name for name in result.rigid if "rib" in name]


def test_rows_are_those_of_a_run(result):
    rows = FAMILIES["spherical_roller"].rows
    assert rows
    (answer,) = rows()([api.read_case(CASE)], ["max_roller_load", "life_L10"])
    assert answer.numbers["max_roller_load"] == approx(result.rigid["inner_load"].max(), rel=1e-9)
    assert answer.numbers["life_L10"] == approx(result.rigid["life_L10"] / 1e6, rel=1e-9)


def test_contact_that_ends_beyond_the_roller_is_a_finding(result):
    def codes(found):
        return {each["code"] for each in found.attributes["findings"] if each["verdict"] == "not met"}

    name = "contact-at-roller-end"
    assert name not in codes(result)
    assert name in codes(api.run(CASE, ["operation.load.radial_z=40 kN"]))


def test_a_given_rating_follows_the_contact_angle():
    ratings = [
        api.run(CASE, [f"bearing.contact_angle={angle} deg"]).rigid["dynamic_rating"] for angle in (9.09, 12)
    ]
    cosines = np.cos(np.radians([9.09, 12]))
    assert ratings[0] == 104e3
    assert ratings[1] / ratings[0] == approx((cosines[1] / cosines[0]) ** (7 / 9 + 2 / 9), rel=2e-2)
    assert ratings[1] < ratings[0]


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        (["operation.load.moment_y=3 N m"], "moment_y is not a key of this case"),
        (["operation.tilt=free"], "tilt is not a key of this case"),
        (["outputs.friction=true"], "friction is not a key of this case"),
        (["outer.kind=ring"], "outer"),
        (["bearing.roller.length=10 mm"], "rollers of both rows meet"),
        (["bearing.outer_osculation=1"], "below 1"),
        (["bearing.rollers=20"], "at most 19, or they touch"),
    ],
)
def test_what_cannot_be_is_refused(settings, words):
    with pytest.raises(BadCase, match=words):
        api.check(CASE, settings)
