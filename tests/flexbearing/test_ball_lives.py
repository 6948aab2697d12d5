"""Rating lives of ball bearings: what a run stores, what modifies them, what they need."""

import numpy as np
import pytest
from pytest import approx

from flexbearing import run
from flexbearing.api import check, read_case
from flexbearing.case import BadCase
from flexbearing.life import ball_lives
from flexbearing.report.output import text
from flexbearing.runs.ball import angular_answers
from quasidynamic.outcome.ball_capacity import ball_dynamic_rating, ball_fatigue_load_limit
from quasidynamic.outcome.ball_life import ball_reference_life
from quasidynamic.outcome.life_factors import BALLS, CLEANLINESS, contamination_factor, modification_factor
from tests.flexbearing.noted import texts
from tests.places import CONFIGS

STEEP, DEEP = CONFIGS / "harris218.toml", CONFIGS / "6209.toml"
CLEAN = "oil, in-line filter, -/15/12"
ISO = {"life.lubrication": "a_ISO", "life.cleanliness": CLEAN, "lubricant.inlet_temperature": "70 degC"}
VG_32 = ISO | {"lubricant.oil": "ISO VG 32"}
SHEET = ISO | {"lubricant.data_sheet": {
    "name": "oil 32", "cold_temperature": "40 degC", "cold_viscosity": "32 mm^2/s",
    "hot_temperature": "100 degC", "hot_viscosity": "5.4 mm^2/s"}}  # fmt: skip


@pytest.fixture(scope="module")
def steep():
    return run(STEEP)


def test_life_is_the_reference_life_of_the_loads(steep):
    row = ball_lives.row(read_case(STEEP))
    expected = ball_reference_life(steep.rigid["contact_load"], row, (1.0, 0.0), ball_dynamic_rating(row))
    assert float(steep["life_L10"].to("Mrev")) == approx(expected, rel=1e-9)
    both = steep.rigid["raceway_life"] / 1e6
    assert (both ** (-10 / 9)).sum() ** -0.9 == approx(expected, rel=1e-9)
    assert steep.attributes["life"] == {}
    assert "reference life L10r, ISO/TS 16281 " in text(steep)


def test_inner_ring_that_stands_meets_its_loads_with_one_place():
    """A ring at rest takes the mean of power 10/3; under unequal loads the life changes, and a little."""
    inner, outer = (
        float(run(DEEP, {f"operation.{ring}_speed": "1800 rpm", f"operation.{other}_speed": "0 rpm"})[
            "life_L10"].to("Mrev"))
        for ring, other in (("inner", "outer"), ("outer", "inner"))
    )  # fmt: skip
    assert 0.6 < outer / inner < 0.98


def test_given_rating_takes_the_place_of_the_formula(steep):
    doubled = run(
        STEEP, {"life.dynamic_rating": f"{2 * ball_dynamic_rating(ball_lives.row(read_case(STEEP)))} N"}
    )
    assert float(doubled["life_L10"].to("Mrev")) == approx(8 * float(steep["life_L10"].to("Mrev")), rel=1e-9)


def test_modified_life_by_hand():
    result = run(DEEP, VG_32 | {"life.reliability": 0.95, "life.static_rating": "20 kN"})
    case = read_case(DEEP, VG_32)
    viscosity = 11.19e-6  # [m2/s] of ISO VG 32 at 70 degC, between 32 at 40 and 5.4 at 100
    kappa = viscosity * 1e6 / (4500 * (1800 * 65.0) ** -0.5)
    assert ball_lives.rated(case).kappa == approx(kappa, rel=0.01)
    basic = float(result["life_L10"].to("Mrev"))
    load = ball_lives.rated(case).dynamic / basic ** (1 / 3)
    pitch = case.bearing.pitch_diameter
    share = contamination_factor(ball_lives.rated(case).kappa, pitch, CLEANLINESS[CLEAN]) * 20e3 / 22 / load
    a_iso = modification_factor(ball_lives.rated(case).kappa, share, BALLS).value
    (first, second), record = (
        result.attributes["life"]["rigid"]["factors"],
        result.attributes["life"]["rigid"],
    )
    assert (first["name"], second["name"]) == ("a_ISO", "a_1")
    assert first["value"] == approx(a_iso, rel=1e-9)
    assert record["modified_Mrev"] == approx(basic * a_iso * second["value"], rel=1e-9)
    assert float(result["modified_life"].to("Mrev")) == approx(record["modified_Mrev"], rel=1e-12)
    assert "\n a_ISO " in text(result)


def test_oil_by_name_by_its_sheet_and_by_its_data_has_one_viscosity_ratio():
    by_data = ISO | {"lubricant.viscosity": "10 mPa s", "lubricant.density": "893.7 kg/m^3"}
    ratios = [ball_lives.rated(read_case(DEEP, settings)).kappa for settings in (VG_32, SHEET, by_data)]
    assert ratios == approx([ratios[0]] * 3, rel=5e-3)


def test_oil_beyond_its_data_is_told():
    result = run(DEEP, SHEET | {"lubricant.inlet_temperature": "120 degC"})
    assert any("oil 32 at 120 degC is extrapolated" in words for words in texts(result))


@pytest.mark.parametrize(
    ("settings", "why"),
    [
        ({"life.lubrication": "a_ISO", "life.cleanliness": CLEAN}, r"lubricant is missing.*a_ISO"),
        ({"life.lubrication": "a_ISO"}, r"\[life\] cleanliness is missing"),
        ({"life.cleanliness": CLEAN}, "left out without"),
        ({"life.reliability": 0.95, "operation.inner_speed": "0 rpm"}, "another one than operation.outer"),
        ({"life.loads": "rating", "operation.preload.displacement": "5 um"}, "give a force"),
        ({"life.loads": "rating", "operation.load.radial_z": "0 N"}, "some force"),
        ({"lubricant.oil": "ISO VG 32", "lubricant.density": "860 kg/m^3",
          "lubricant.inlet_temperature": "60 degC"}, "or its data, not both"),
        (ISO | {"lubricant.viscosity": "10 mPa s"}, "density is missing"),
    ],
    ids=str,
)  # fmt: skip
def test_what_a_life_lacks_is_told(settings, why):
    with pytest.raises(BadCase, match=why):
        check(DEEP, settings)


def test_bearing_at_rest_has_no_life():
    at_rest = run(DEEP, {"operation.inner_speed": "0 rpm"})
    assert "life_L10" not in at_rest.rigid
    assert not any("life" in words for words in texts(at_rest))


@pytest.mark.parametrize(
    ("settings", "why"),
    [
        ({"bearing.contact_angle": "50 deg"}, "thrust"),
        ({"bearing.contact_angle": "50 deg", "life.dynamic_rating": "100 kN"}, "thrust"),
        ({"materials.ball": "Si3N4", "materials.inner_ring": "Si3N4"}, "balls of steel"),
    ],
    ids=["thrust", "thrust, of a maker", "ceramic"],
)
def test_bearing_without_a_rating_says_why(settings, why):
    result = run(STEEP, settings)
    assert "life_L10" not in result.rigid
    (note,) = [each for each in result.attributes["notes"] if each["code"] == "no-life"]
    assert why in note["text"]


def test_a_given_rating_lives_beyond_the_static_one():
    """D cos(alpha)/d_m of 0.46 is beyond ISO 76: no s_0, which takes neither loads nor lives."""
    result = run(DEEP, {
        "bearing.balls": 5, "bearing.ball.diameter": "31 mm", "life.dynamic_rating": "30 kN",
        "bearing.pitch_diameter": "68 mm", "bearing.inner.radius": "16 mm", "bearing.outer.radius": "16 mm"
    })  # fmt: skip
    assert ("life_L10" in result.rigid, "static_safety" in result.rigid) == (True, False)


@pytest.mark.parametrize(
    ("settings", "reason", "rated"),
    [
        (VG_32 | {"operation.inner_speed": "1 rpm"}, "at least 0.1", True),
        (SHEET | {"lubricant.inlet_temperature": "250 degC"}, "usable range", True),
        ({"materials.ball": "Si3N4", "materials.inner_ring": "Si3N4", "life.reliability": 0.95},
         "balls of steel", False),
    ],
    ids=["thin oil", "no viscosity", "no rating"],
)  # fmt: skip
def test_a_law_that_does_not_hold_takes_the_modified_life_alone(settings, reason, rated):
    result = run(DEEP, settings)
    assert ("life_L10" in result.rigid, "modified_life" in result.rigid) == (rated, False)
    (note,) = [each for each in result.attributes["notes"] if each["code"] == "no-modified-life"]
    assert reason in note["text"]
    (row,) = angular_answers([read_case(DEEP, settings)], ["peak_pressure.inner", "modified_life"])
    assert row.why == f"outside validity: {note['text']}"
    assert row.numbers["peak_pressure.inner"] > 0


def test_ceramic_balls_live_by_a_given_rating():
    result = run(STEEP, {"materials.ball": "Si3N4", "life.dynamic_rating": "100 kN"})
    assert np.isfinite(result.rigid["life_L10"])


def test_contact_angle_of_a_deep_groove_rating_is_zero_whatever_the_clearance():
    rows = [ball_lives.row(read_case(DEEP, {"bearing.clearance": c})) for c in ("-5 um", "40 um")]
    assert rows[0] == rows[1]
    assert rows[0].contact_angle == 0.0
    assert ball_fatigue_load_limit(rows[0]) == approx(928, rel=1e-2)


def test_short_life_is_a_danger():
    result = run(DEEP, {"operation.load.radial_z": "40 kN", "operation.inner_speed": "12000 rpm"})
    assert "short-life" in {note["code"] for note in result.dangers}


def test_static_rating_of_hybrids_is_that_of_their_stiffer_contacts():
    """The load at a pressure goes with E*^-2; ISO 20056-2 allows hybrids a little more than 4200 MPa."""
    hybrid = {"materials.ball": "Si3N4", "materials.inner_ring": "100Cr6", "materials.outer_ring": "100Cr6"}
    steel, ceramic = (read_case(DEEP, settings) for settings in ({}, hybrid))
    soft, stiff = (1 - 0.3**2) / 207e9, (1 - 0.26**2) / 315e9
    assert ball_lives.rated(ceramic).static / ball_lives.rated(steel).static == approx(
        ((soft + stiff) / (2 * soft)) ** 2
    )
    assert ball_lives.rated(ceramic).dynamic == ball_lives.rated(steel).dynamic
    result = run(DEEP, hybrid)
    assert result.rigid["static_safety"] > 0
    assert "assumed" in next(each["text"] for each in result.attributes["notes"] if each["code"] == "hybrid")


def test_a_modified_life_of_hybrids_is_marked():
    """ISO 16281 (2025), scope: "The calculation of the modified reference rating life is not applicable"."""
    codes = [
        {note.code for note in ball_lives.notes(read_case(DEEP, settings))}
        for settings in (VG_32, {"materials.ball": "Si3N4"}, VG_32 | {"materials.ball": "Si3N4"})
    ]
    assert ["hybrid-modified-life" in each for each in codes] == [False, False, True]


def test_given_static_rating_follows_the_material_of_the_balls():
    place = DEEP.parent / "catalogue" / "6208.toml"
    assert ball_lives.rated(read_case(place, {"materials.ball": "Si3N4"})).static == approx(
        0.7 * 19e3, rel=0.01
    )


@pytest.mark.parametrize("limit", ["0.8 kN", None])
def test_a_rating_that_the_balls_change_is_noted_with_its_factor(limit, tmp_path):
    place = tmp_path / "6208.toml"
    lines = (DEEP.parent / "catalogue" / "6208.toml").read_text().splitlines()
    place.write_text("\n".join(line for line in lines if limit or not line.startswith("fatigue_limit_load")))
    case = read_case(place, {"materials.ball": "Si3N4"})
    (note,) = [each for each in ball_lives.notes(case) if each.code == "rating-of-other-balls"]
    assert ("C_0r times 0.70, C_u times 0.70" if limit else "C_0r times 0.70, and C_u with C_0r") in note.text
    assert "C_r as given" in note.text
    unchanged = read_case(place, {})
    assert "rating-of-other-balls" not in {each.code for each in ball_lives.notes(unchanged)}


def test_a_rating_of_a_hybrid_is_noted_where_its_balls_become_steel(tmp_path):
    place = tmp_path / "hybrid.toml"
    text = (DEEP.parent / "catalogue" / "6208.toml").read_text()
    place.write_text(text.replace('ball = "100Cr6"', 'ball = "Si3N4"'))
    codes = [{each.code for each in ball_lives.notes(read_case(place, settings))}
             for settings in ({}, {"materials.ball": "100Cr6"})]  # fmt: skip
    assert ["rating-of-other-balls" in each for each in codes] == [False, True]


def test_rings_as_balls_of_no_bearing_steel_are_noted():
    """A ring whose material is not given takes that of the balls."""
    settings = {"materials.ball.youngs_modulus": "110 GPa", "life.dynamic_rating": "10 kN"}
    codes = [{note["code"] for note in run(DEEP, each).attributes["notes"]} for each in ({}, settings)]
    assert ["rings-as-balls" in each for each in codes] == [False, True]
