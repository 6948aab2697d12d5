"""The way from the life of a catalogue to that of a case."""

import json
import subprocess
import sys
from itertools import pairwise
from math import prod

import numpy as np
import pytest
from pytest import approx

from flexbearing import read, run
from flexbearing.api import against_catalogue, read_case
from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.quantities.life_records import Ratings
from flexbearing.report.catalogue_life import scaled
from flexbearing.report.output import text
from quasidynamic.outcome.capacity import STRESS_REDUCTION, dynamic_rating
from tests.places import CONFIGS

PLAIN, FITS, CAGE = (CONFIGS / f"{name}.toml" for name in ("nu209", "nu209_fits", "mao2016"))
OIL = "oil, in-line filter, -/15/12"
CLEAN = {"life.lubrication": "a_ISO", "life.cleanliness": OIL, "life.capacity": "iso281"}
EDGE = {"life.edge_stress": True}
CROWNED = {
    "bearing.roller.profile": "crowned", "bearing.roller.straight_length": "6 mm",
    "bearing.roller.crown_radius": "1 m",
}  # fmt: skip
TEN = {
    "plain": (PLAIN, {}),
    "light": (PLAIN, {"operation.radial_load": "500 N"}),
    "heavy": (PLAIN, {"operation.radial_load": "20 kN", "life.capacity": "iso281"}),
    "tilted": (PLAIN, {"operation.misalignment": "2 arcmin", "accuracy.slices": 30} | EDGE),
    "preloaded": (PLAIN, {"bearing.clearance": "-5 um", **CLEAN}),
    "crowned": (PLAIN, CROWNED),
    "of a maker": (PLAIN, {"life.dynamic_rating": "44 kN", "life.capacity": "iso281"}),
    "with fits": (FITS, {}),
    "steel": (FITS, {"life.steel": "M50", "life.reliability": 0.95, "operation.radial_load": "9 kN"}),
    "between rigid rings": (CAGE, {"outer.kind": "rigid", "inner.kind": "rigid", "bearing.roughness": {
        "roller": "0.05 um", "inner_raceway": "0.1 um", "outer_raceway": "0.1 um"},
        "life.lubrication": "film"}),
}  # fmt: skip


def life(case, settings):
    """Of a run [10^6 revolutions]."""
    result = run(case, settings)
    modified = result.attributes["life"].get("flexible")
    return modified["modified_Mrev"] if modified else float(result["flexible.life_L10"].to("Mrev"))


QUICK = ("preloaded",)


@pytest.fixture(
    scope="module",
    params=[pytest.param(name, marks=[] if name in QUICK else pytest.mark.slow) for name in TEN],
)
def compared(request):
    case, settings = TEN[request.param]
    return case, settings, against_catalogue(case, settings)


def require_last(found, life):
    """The last stage is the case with its life, to which all factors lead."""
    first, *others = found["stages"]
    assert first["factor"] is None
    assert others[-1]["settings"] == []
    assert others[-1]["life_Mrev"] == approx(life, rel=1e-12)
    product = first["life_Mrev"] * prod(stage["factor"] for stage in others)
    assert product == approx(others[-1]["life_Mrev"], rel=1e-12)


def require_names(stages):
    """Each stage leaves out what the next one is named after."""
    for before, after in pairwise(stages):
        assert list(before["settings"]) == [*after["left_out_by"], *after["settings"]]
        assert after["left_out_by"]


@pytest.mark.slow
def test_first_life_is_that_of_the_catalogue(compared):
    case, settings, found = compared
    wanted = read_case(case, settings)
    drawn = roller_bearing.nominal(wanted, roller_bearing.parts(wanted))
    rating = wanted.life.dynamic_rating or dynamic_rating(drawn)
    ratio = rating / wanted.operation.radial_load
    lives = [stage["life_Mrev"] for stage in found["stages"]]
    by_hand = [ratio ** (10 / 3), ratio**4, (ratio / STRESS_REDUCTION) ** 4]
    assert lives[:3] == approx(by_hand, rel=1e-12)
    assert found["ratings"]["life_Mrev"] == approx(by_hand[0], rel=1e-12)


def test_last_life_is_that_of_the_case_and_nothing_is_left_over(compared):
    case, settings, found = compared
    require_last(found, life(case, settings))


def test_neighbours_differ_in_what_the_second_is_named_after(compared):
    _, _, found = compared
    require_names(found["stages"][3:])  # those before are the three of the rating


def test_loads_of_the_rollers_are_nearly_those_of_the_standard(compared):
    """Straight rollers without clearance between rigid rings: assumed of C_r."""
    _, settings, found = compared
    loads = found["stages"][3]
    assert loads["name"].startswith("loads of all rollers")
    low = 0.3 if settings.get("operation.radial_load") == "500 N" else 0.88  # 500 N: they press on at speed
    assert low < loads["factor"] < 1.12


@pytest.mark.slow
def test_every_life_can_be_had_with_its_settings():
    found = against_catalogue(FITS)
    for stage in found["stages"]:
        assert life(FITS, stage["settings"]) == approx(stage["life_Mrev"], rel=1e-12)
    hours = {stage["life_h"] / stage["life_Mrev"] for stage in found["stages"]}
    assert list(hours) == approx([1e6 / 3000 / 60] * len(hours), rel=1e-12)


@pytest.mark.slow
def test_profiles_of_rollers_and_of_raceways_are_factors_of_their_own():
    profiled = {
        "bearing.roller.profile": "johns_gohar", "bearing.roller.design_load": "4 kN",
        "bearing.outer_raceway.profile": "iso16281",
    }  # fmt: skip
    stages = against_catalogue(PLAIN, profiled)["stages"]
    places = {stage["name"]: place for place, stage in enumerate(stages)}
    assert places["profile of the raceways"] == places["profile of the rollers"] + 1
    for name in ("profile of the rollers", "profile of the raceways"):
        before, stage = stages[places[name] - 1], stages[places[name]]
        assert stage["factor"] == approx(stage["life_Mrev"] / before["life_Mrev"], rel=1e-12)
        assert abs(stage["factor"] - 1) > 0.01
    assert stages[-1]["life_Mrev"] == approx(life(PLAIN, profiled), rel=1e-12)


@pytest.mark.slow
def test_rings_that_settings_changed_are_left_out_as_well():
    found = against_catalogue(CAGE, ["outer.thickness=4 mm", "bearing.roller.drop=2 um"])
    names = [stage["name"] for stage in found["stages"]]
    assert {"flexible rings", "profile of the rollers"} <= set(names)


@pytest.mark.slow
def test_flexible_rings_are_a_factor_of_their_own():
    found = against_catalogue(CAGE)
    rings = next(stage for stage in found["stages"] if stage["name"] == "flexible rings")
    assert rings["left_out_by"] == ["outer=", "outer.kind=rigid", "inner=", "inner.kind=rigid"]
    held = ["life.capacity=iso281", "operation.tilt=fixed"]
    rigid, elastic = (life(CAGE, [*held, *further]) for further in (rings["left_out_by"], []))
    assert rings["factor"] == approx(elastic / rigid, rel=1e-9)


@pytest.mark.slow
def test_a_ring_that_tilts_with_flexible_rings_does_so_after_them():
    """Between rigid rings it would not tilt, and its factor would be 1."""
    stages = against_catalogue(CAGE)["stages"]
    names = [stage["name"] for stage in stages]
    place = names.index("inner ring free to tilt between the flexible rings")
    assert names[place - 1] == "flexible rings"
    assert "tilt of the inner ring between rigid rings" not in names
    assert stages[place]["left_out_by"] == ["operation.tilt=fixed"]
    held, free = (
        life(CAGE, ["life.capacity=iso281", f"operation.tilt={tilt}"]) for tilt in ("fixed", "free")
    )
    assert stages[place]["factor"] == approx(free / held, rel=1e-9)
    assert stages[place]["factor"] > 2


def test_a_given_rating_that_is_scaled_says_so():
    maker = PLAIN.parent / "catalogue" / "nu210.toml"
    found = against_catalogue(maker, {"bearing.roller.length": "8 mm"})["ratings"]
    assert found["ratings_N"]["C_r"] == approx(73.5e3 * found["scales"]["C_r"], rel=1e-12)
    assert scaled(Ratings(**found), "C_r") == f", times {found['scales']['C_r']:.4g} by the formula"


@pytest.mark.slow
def test_static_safety_and_modified_rating_life():
    found = against_catalogue(PLAIN, CLEAN | {"life.static_rating": "44.5 kN"})["ratings"]
    assert found["static_safety"] == approx(10.0, rel=1e-12)
    assert found["given"] == ["C_0r"]
    assert found["modified_Mrev"] == approx(found["a_ISO"] * found["life_Mrev"], rel=1e-12)
    modified = run(PLAIN, CLEAN | {"life.static_rating": "44.5 kN", "life.loads": "rating"})
    assert modified.attributes["life"]["flexible"]["modified_Mrev"] == approx(
        found["modified_Mrev"], rel=1e-12
    )


@pytest.mark.parametrize(
    ("case", "settings", "why"),
    [
        (PLAIN, {"operation.radial_load": "0 N"}, "without a radial load"),
        (PLAIN, {"life.loads": "rating"}, "already"),
        (
            CONFIGS / "joshi2015_fourpoint.toml",
            {},
            'kind = "four_point_ball" has no radial ratings in ISO 281',
        ),
    ],
    ids=["no load", "already by rating", "four-point"],
)
def test_what_has_no_catalogue_life_is_refused(case, settings, why):
    with pytest.raises(BadCase, match=why):
        against_catalogue(case, settings)


@pytest.mark.slow
def test_the_command_prints_every_factor_and_the_same_as_json():
    words = [sys.executable, "-m", "flexbearing", "life", str(PLAIN)]
    page, data = (
        subprocess.run([*words, *more], check=True, capture_output=True, text=True).stdout
        for more in ((), ("--json",))
    )
    found = json.loads(data)
    for stage in found["stages"]:
        assert stage["name"].split()[0] in page
        assert (stage["factor"] or 1) == approx(1, abs=0.01) or stage["meaning"][:20] in page
        assert f"{stage['life_Mrev']:,.4g}" in page
    assert '--set "bearing.clearance=0 um"' in page
    assert np.isfinite([stage["life_h"] for stage in found["stages"]]).all()


@pytest.mark.slow
def test_comparison_is_stored_where_it_is_wanted(tmp_path):
    result = run(PLAIN, {"outputs.catalogue_life": True}, output=tmp_path / "plain.h5")
    stored = read(tmp_path / "plain.h5").attributes["catalogue_life"]
    assert stored == result.attributes["catalogue_life"] == against_catalogue(PLAIN)
    assert "from the life of the catalogue to that of the case" in text(result)


def test_an_empty_setting_takes_a_key_out():
    assert read_case(PLAIN, ["lubricant.traction=", "lubricant.limiting_ratio="]).lubricant.traction == "4109"
    without = read_case(FITS, ["bearing.fits.cold_clearance=", "bearing.clearance=20 um"])
    assert without.bearing.clearance == approx(20e-6)
    assert without.bearing.mounting is None
    assert read_case(PLAIN, ["bearing.roughness="]).bearing.roughness is None  # it is not there
    with pytest.raises(BadCase, match="clearance is missing"):
        read_case(PLAIN, ["bearing.clearance="])


@pytest.mark.parametrize(
    "name",
    ["6208", *(pytest.param(name, marks=pytest.mark.slow) for name in ("7208", "nu210", "nu1012", "nj2210"))],
)
def test_shipped_catalogue_cases_are_compared(name):
    """Their materials stand as names, of which a setting changes one number."""
    case = CONFIGS / "catalogue" / f"{name}.toml"
    *_, last = against_catalogue(case)["stages"]
    *_, modified = run(case).attributes["life"].values()
    assert last["life_Mrev"] == approx(modified["modified_Mrev"], rel=1e-9)
