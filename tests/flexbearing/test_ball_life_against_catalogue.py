"""The way from the life of a catalogue to that of a ball bearing."""

import pytest
from pytest import approx

from flexbearing import read, run
from flexbearing.api import against_catalogue, read_case
from flexbearing.case import BadCase
from flexbearing.case.read import written
from flexbearing.life import ball_lives
from flexbearing.report.catalogue_life import sections
from flexbearing.report.output import laid_out, text
from tests.flexbearing.noted import texts
from tests.flexbearing.test_life_against_catalogue import require_last, require_names
from tests.places import CONFIGS

ANGULAR, STEEP, DEEP = (CONFIGS / f"{name}.toml" for name in ("rivera2021_7008", "harris218", "6209"))
OIL = {
    "lubricant.oil": "ISO VG 68", "lubricant.inlet_temperature": "70 degC", "life.lubrication": "a_ISO",
    "life.cleanliness": "oil, in-line filter, -/17/14",
}  # fmt: skip
STEEL = {
    "youngs_modulus": "206 GPa",
    "poisson_ratio": 0.3,
    "density": "7800 kg/m^3",
    "expansion": "12e-6 1/K",
}
WARM = {
    "bearing.fits": {"bore": "90 mm", "outer_diameter": "160 mm", "shaft": "k5"},
    **{f"materials.{part}": STEEL for part in ("shaft", "inner_ring", "outer_ring")},
    "materials.ball.expansion": "12e-6 1/K",
    "operation.temperatures": {
        "shaft": "70 degC", "inner_ring": "65 degC", "ball": "60 degC", "outer_ring": "50 degC",
        "reference": "20 degC",
    },
}  # fmt: skip
SIX = {
    "thrust": (STEEP, {}),
    "both loads, free to tilt, reliable": (ANGULAR, {
        "operation.load.radial_z": "300 N", "operation.displacement": {}, "life.reliability": 0.95}),
    "ruled by friction": (STEEP, {
        "operation.control": "coulomb", "friction.coefficient": 0.08, "operation.load.radial_z": "6 kN"}),
    "deep groove, tilted, oil, of a maker": (DEEP, OIL | {
        "operation.load.axial": "2 kN", "operation.load.moment_y": "5 N m", "life.dynamic_rating": "35.1 kN",
        "life.static_rating": "21.6 kN", "life.fatigue_limit_load": "0.915 kN"}),
    "warm, fitted, preloaded": (STEEP, WARM | {
        "operation.load.axial": "0 N", "operation.preload.force": "4 kN", "operation.load.radial_z": "3 kN"}),
    "deep groove, preloaded": (DEEP, {"operation.preload.force": "500 N", "operation.load.radial_z": "4 kN"}),
}  # fmt: skip


def life(case, settings):
    """Of a run [10^6 revolutions]."""
    result = run(case, settings)
    modified = result.attributes["life"].get("rigid")
    return modified["modified_Mrev"] if modified else float(result["life_L10"].to("Mrev"))


@pytest.fixture(scope="module", params=SIX)
def compared(request):
    case, settings = SIX[request.param]
    return case, settings, against_catalogue(case, settings)


@pytest.mark.sampled(2)
def test_first_life_is_that_of_the_catalogue(compared):
    case, settings, found = compared
    wanted = read_case(case, settings)
    rating = wanted.life.dynamic_rating or found["ratings"]["formulas_N"]["C_r"]
    by_hand = (rating / found["ratings"]["load_N"]) ** 3
    assert found["stages"][0]["life_Mrev"] == approx(by_hand, rel=1e-12)
    assert found["ratings"]["life_Mrev"] == approx(by_hand, rel=1e-12)
    parts = found["ratings"]["equivalent_load"]
    assert parts["X"] * parts["F_r_N"] + parts["Y"] * parts["F_a_N"] == approx(
        found["ratings"]["load_N"], rel=1e-12
    )


@pytest.mark.sampled(2)
def test_last_life_is_that_of_the_case_and_nothing_is_left_over(compared):
    case, settings, found = compared
    require_last(found, life(case, settings))


def test_neighbours_differ_in_what_the_second_is_named_after(compared):
    _, _, found = compared
    require_names(found["stages"][1:])  # the one before is that of the rating


@pytest.mark.sampled(2)
def test_every_life_can_be_had_with_its_settings(compared):
    case, settings, found = compared
    given = written(settings)
    for stage in found["stages"]:
        assert life(case, [*given, *stage["settings"]]) == approx(stage["life_Mrev"], rel=1e-9)


def test_names_tell_what_acts():
    names = {
        key: [stage["name"] for stage in against_catalogue(*SIX[key])["stages"][2:]]
        for key in ("thrust", "deep groove, tilted, oil, of a maker", "deep groove, preloaded")
    }
    speed = "inertia of the balls at speed"
    assert names["thrust"] == [speed]
    assert names["deep groove, tilted, oil, of a maker"] == [
        "operating clearance", "tilt of the inner ring", speed, "lubrication"
    ]  # fmt: skip
    assert names["deep groove, preloaded"] == [
        "operating clearance", "tilt of the inner ring", "rigid preload instead of that of a spring", speed
    ]  # fmt: skip


def test_radial_load_on_a_deep_groove_bearing_without_clearance_is_what_its_rating_assumes():
    """C_r stands for half the balls loaded between aligned rings: 1.2 % are left."""
    found = against_catalogue(DEEP)
    assert found["stages"][1]["factor"] == approx(0.988, abs=2e-3)


def test_ratings_of_a_maker_are_shown_beside_the_formulas():
    ratings = against_catalogue(*SIX["deep groove, tilted, oil, of a maker"])["ratings"]
    assert ratings["given"] == ["C_r", "C_0r", "C_u"]
    assert ratings["ratings_N"] == approx({"C_r": 35.1e3, "C_0r": 21.6e3, "C_u": 915.0}, rel=1e-12)
    assert ratings["formulas_N"]["C_r"] == approx(32.72e3, rel=1e-3)
    assert ratings["static_safety"] == approx(21.6e3 / 8.9e3, rel=1e-12)  # 0.6 F_r + 0.5 F_a is less than F_r
    assert ratings["scales"] == dict.fromkeys(ratings["given"], 1.0)
    assert ratings["modified_Mrev"] == approx(ratings["a_ISO"] * ratings["life_Mrev"], rel=1e-12)


@pytest.mark.parametrize(
    ("case", "settings", "why"),
    [
        (DEEP, {"operation.load.radial_z": "0 N"}, "without a force"),
        (DEEP, {"operation.inner_speed": "0 rpm"}, "no ring turns"),
        (DEEP, {"life.loads": "rating"}, "already"),
        (DEEP, {"operation.preload.displacement": "5 um"}, "preload.displacement: a catalogue knows lives"),
        (
            STEEP,
            {"operation.load.axial": "0 N", "operation.displacement.axial": "20 um"},
            "under given forces",
        ),
        (STEEP, {"bearing.contact_angle": "50 deg"}, "above 45 deg"),
    ],
    ids=["no load", "at rest", "already by rating", "offset", "held", "thrust bearing"],
)
def test_what_has_no_catalogue_life_is_refused(case, settings, why):
    with pytest.raises(BadCase, match=why):
        against_catalogue(case, settings)


def test_comparison_is_stored_and_printed_where_it_is_wanted(tmp_path):
    settings = {"operation.load.axial": "2 kN", "outputs.catalogue_life": True}
    result = run(DEEP, settings, output=tmp_path / "deep.h5")
    stored = read(tmp_path / "deep.h5").summary()["catalogue_life"]
    assert stored == result.attributes["catalogue_life"]
    again = against_catalogue(DEEP, settings)
    assert [stage["name"] for stage in stored["stages"]] == [stage["name"] for stage in again["stages"]]
    assert [stage["life_Mrev"] for stage in stored["stages"]] == approx(
        [stage["life_Mrev"] for stage in again["stages"]], rel=1e-12
    )
    assert "from the life of the catalogue to that of the case" in text(result)
    plain = run(DEEP, {"operation.load.axial": "2 kN"})
    assert plain.summary()["catalogue_life"] is None
    assert "catalogue" not in text(plain)


def test_comparison_that_cannot_be_is_a_note():
    result = run(DEEP, {"operation.inner_speed": "0 rpm", "outputs.catalogue_life": True})
    assert result.attributes["status"] == "converged"
    (why,) = [words for words in texts(result) if "catalogue" in words]
    assert "no ring turns" in why


def test_load_beyond_the_formula_is_told():
    def page(load):
        return laid_out(sections(against_catalogue(DEEP, {"operation.load.radial_z": load})), None)

    assert "leaves it to the maker" not in page("10 kN")
    assert "P is above C_r/2: ISO 281 leaves it to the maker" in page("17 kN")
    assert "P is above C_r/2 and C_0r" in page("25 kN")


def test_equivalent_load_of_a_preload_is_its_force():
    case = read_case(*SIX["deep groove, preloaded"])
    assert case.operation.forces == approx((4000.0, 500.0), rel=1e-12)
    assert ball_lives.rated(case).load().value == 4000.0
