"""Life from the rating C_r: of ISO 281, or of a catalogue."""

import re
from pathlib import Path

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing import api
from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.case import BadCase, understood
from flexbearing.coupling import LinearPair
from flexbearing.families import FAMILIES
from flexbearing.life import roller_lives
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic.outcome.capacity import dynamic_rating, raceway_capacity, reference_raceway_capacity
from quasidynamic.outcome.life import reference_life
from tests.places import CONFIGS

PLAIN = CONFIGS / "nu209.toml"
CATALOGUE = PLAIN.parent / "catalogue"
NJ2210, NEAR = CATALOGUE / "nj2210.toml", ("13 mm", "11 mm")
ISO = {"life.capacity": "iso281"}
CLEAN = {"life.lubrication": "a_ISO", "life.cleanliness": "oil, in-line filter, -/17/14"}


@pytest.fixture(scope="module")
def state():
    return roller_bearing.bearing(read_case(PLAIN)).solve()


def lived(state, settings):
    case = read_case(PLAIN, settings)
    rated = SolvedRows.of(case, roller_bearing.bearing(case), state, LinearPair(None, None)).life[0]
    return None if rated is None else rated.record()


def test_rating_of_iso_281_gives_the_reference_life(state):
    found, bearing = lived(state, ISO), state.balance.roller.bearing
    loads = state.slice_loads * state.balance.roller.raceways.slices.width
    expected = reference_life(*loads, bearing, (True, False))
    assert found["modified_Mrev"] == approx(expected, rel=1e-12)
    (factor,) = found["factors"]
    assert factor["name"] == "capacity"
    assert f"{dynamic_rating(bearing):.5g} N, formula of ISO 281" in factor["note"]
    # both are printed forms of one theory
    ratios = [
        new / old
        for new, old in zip(reference_raceway_capacity(bearing), raceway_capacity(bearing), strict=True)
    ]
    assert all(0.9 < ratio < 1.1 for ratio in ratios)


def test_rating_of_iso_281_by_hand():
    # C_r = b_m f_c (i l cos a)^(7/9) Z^(3/4) D^(29/27); ISO 281, table 7, prints
    # f_c = 88.5 at gamma = 0.16
    bearing = roller_bearing.bearing(read_case(PLAIN, {"bearing.outer_raceway_diameter": "72.5 mm"})).bearing
    by_hand = 1.1 * 88.5 * 9.601 ** (7 / 9) * 14**0.75 * 10 ** (29 / 27)
    assert dynamic_rating(bearing) == approx(by_hand, rel=1e-3)


def test_life_goes_with_the_fourth_power_of_the_given_rating(state):
    one, two = (lived(state, ISO | {"life.dynamic_rating": f"{c} kN"}) for c in (40, 80))
    assert two["modified_Mrev"] == approx(2**4 * one["modified_Mrev"], rel=1e-12)
    assert "40000 N, given" in one["factors"][0]["note"]


def test_given_rating_reaches_a_iso(state):
    notes = []
    for rating in ("30 kN", "60 kN"):
        found = lived(state, CLEAN | {"life.dynamic_rating": rating})
        notes.append(found["factors"][0]["note"])
    assert notes[0] != notes[1]  # P_ref = C_r / L^(3/10) with L ~ C_r^4


def test_ratings_of_a_catalogue_modify_no_life():
    """They are compared with the formulas by `flexbearing life`."""
    given = {"life.dynamic_rating": "40 kN", "life.static_rating": "45 kN", "life.fatigue_limit_load": "5 kN"}
    assert read_case(PLAIN, given).life.is_basic
    assert not read_case(PLAIN, {**given, "life.capacity": "iso281"}).life.is_basic


def test_life_by_rating_needs_a_radial_load():
    with pytest.raises(BadCase, match=r'radial_load = "0 N" cannot be; it must be above 0 N for life.loads'):
        read_case(PLAIN, {"life.loads": "rating", "operation.radial_load": "0 N"})


def test_static_rating_of_a_catalogue_gives_its_fatigue_limit(state):
    notes = []
    for further in ({}, {"life.static_rating": "25 kN"}, {"life.fatigue_limit_load": "1 kN"}):
        notes.append(lived(state, CLEAN | further)["factors"][0])
    assert len({note["value"] for note in notes}) == 3


def test_formula_of_iso_281_stops_where_its_table_ends():
    slim = {"bearing.outer_raceway_diameter": "31 mm", "bearing.rollers": 5, "bearing.cage.thickness": "2 mm"}
    case, rated = (read_case(PLAIN, ISO | slim | more) for more in ({}, {"life.dynamic_rating": "20 kN"}))
    assert "ISO 281, table 7" in roller_lives.rated(case, roller_bearing.parts(case)).unmodified
    assert roller_lives.rated(rated, roller_bearing.parts(rated)).unmodified == ""


def test_ratings_are_those_of_the_drawing_at_any_temperature():
    parts = ("inner_ring", "outer_ring", "roller", "shaft")
    temperatures = {f"operation.temperatures.{part}": "120 degC" for part in parts}
    temperatures |= {"operation.temperatures.reference": "20 degC"}
    cold, hot = (read_case(PLAIN, settings) for settings in ({}, temperatures))
    at_rest, warm = (roller_bearing.parts(case) for case in (cold, hot))
    assert warm.roller.diameter > at_rest.roller.diameter
    after, before = roller_lives.rated(hot, warm), roller_lives.rated(cold, at_rest)
    for name in ("dynamic", "static", "fatigue_limit"):
        assert getattr(after, name) == getattr(before, name)
    assert warm.roller.mass == approx(at_rest.roller.mass, rel=1e-14)


@pytest.mark.parametrize(
    ("rollers", "diameter", "pitch"), [(60, "11 mm", "2 m"), (8, "30 mm", "120 mm")], ids=["small", "large"]
)
def test_rollers_that_iso_281_does_not_rate_have_every_other_answer(rollers, diameter, pitch):
    """The limits of light and heavy loads follow from C_r: without it both are not judged."""
    size = {"rollers": rollers, "roller.diameter": diameter, "outer_raceway_diameter": pitch}
    few = {"accuracy.slices": 5}
    result = api.run(PLAIN, few | {f"bearing.{name}": value for name, value in size.items()})
    assert result.attributes["status"] == "converged"
    judged = {found["quantity"] for found in result.attributes["findings"] if found["limit"] is not None}
    assert "contact_pressure" in judged
    assert "load" not in judged


# each size with another value of a bearing of a catalogue
SIZES = {
    "nj2210": {
        "bearing.roller.length": "8 mm", "bearing.roller.diameter": "10.5 mm", "bearing.rollers": 14,
        "bearing.outer_raceway_diameter": "83 mm",
    },
    "6208": {
        "bearing.ball.diameter": "11 mm", "bearing.balls": 8, "bearing.pitch_diameter": "61 mm",
        "bearing.inner.conformity": 0.53, "bearing.outer.conformity": 0.54,
    },
    "7208": {"bearing.contact_angle": "30 deg"},
}  # fmt: skip
EACH = [(file, key, value) for file, sizes in SIZES.items() for key, value in sizes.items()]
GIVEN = {"dynamic_rating": "C_r", "static_rating": "C_0r", "fatigue_limit_load": "C_u"}


def rated(case):
    """Ratings that are used over those of the formulas."""
    found = FAMILIES[case.kind].catalogue().rated(case).page(1.0)
    return {name: found.ratings_N[name] / found.formulas_N[name] for name in GIVEN.values()}


@pytest.mark.parametrize(("file", "key", "value"), EACH, ids=[f"{file}-{key}" for file, key, _ in EACH])
def test_given_ratings_keep_their_factor_on_the_formula_where_a_size_changes(file, key, value):
    plain, changed = (read_case(CATALOGUE / f"{file}.toml", each) for each in ({}, {key: value}))
    assert rated(changed) == approx(rated(plain), rel=1e-9)
    again = read_case(CATALOGUE / f"{file}.toml", {key: value, "life.dynamic_rating": "50 kN"})
    found = FAMILIES[again.kind].catalogue().rated(again).page(1.0).ratings_N
    assert found["C_r"] == 50e3  # a rating of a setting is that of the bearing that results
    assert rated(again)["C_0r"] == approx(rated(plain)["C_0r"], rel=1e-9)


def test_a_shorter_roller_has_a_shorter_life():
    long, short = (
        api.run(NJ2210, {"bearing.roller.length": length}).rigid["modified_life"] for length in NEAR
    )
    assert short < 0.8 * long


@pytest.mark.parametrize(
    ("file", "key"),
    [("nj2210", "bearing.roller.length"), ("nj2210", "bearing.roller.diameter"),
     ("6208", "bearing.ball.diameter"), ("7208", "bearing.pitch_diameter")],
)  # fmt: skip
def test_derivative_of_the_life_is_that_of_a_rating_by_the_formula(file, key):
    """Other sizes with ratings of settings, which are those of the formula times the maker's factor."""
    place = CATALOGUE / f"{file}.toml"
    case = read_case(place)
    found = api.sensitivities(case, of=["modified_life"], by=[key])["modified_life", key]
    factors, lives, step = rated(case), [], 1e-4
    for side in (-1, 1):
        size = {key: f"{found.key.value * (1 + side * step)!r} m"}
        of = FAMILIES[case.kind].catalogue().rated(read_case(place, size)).page(1.0).formulas_N
        given = {f"life.{name}": f"{factors[to] * of[to]!r} N" for name, to in GIVEN.items()}
        lives.append(float(api.run(place, size | given).rigid["modified_life"]))
    expected = np.log(lives[1] / lives[0]) / np.log((1 + step) / (1 - step))
    assert found.elasticity == approx(expected, rel=1e-3)
    assert found.elasticity > 1


def test_a_given_rating_is_that_of_the_file_after_the_result_is_read_again():
    settings = {"bearing.roller.length": "8 mm"}
    about = api.run(NJ2210, settings).attributes
    again = understood(about["case_text"], Path("elsewhere.toml"), about["case_overrides"], FAMILIES)
    assert rated(again) == rated(read_case(NJ2210, settings))


FAR = {
    "as the maker's": ({}, "rating-above-formula", "C_r"),
    "of two rows": ({"life.dynamic_rating": "148 kN"}, "rating-above-formula", "C_r"),
    "of a smaller bearing": ({"life.static_rating": "60 kN"}, "rating-below-formula", "C_0r"),
    "far from its bearing": ({"bearing.roller.length": "5 mm"}, "changed-rating", "C_0r"),
}


@pytest.mark.parametrize(("settings", "code", "place"), FAR.values(), ids=FAR)
def test_ratings_far_from_the_formula_are_a_finding(settings, code, place):
    found = api.run(NJ2210, settings).attributes
    broken = {(each["code"], each["place"]) for each in found["findings"] if each["verdict"] == "not met"}
    assert (code, place) in broken
    assert code in {note["code"] for note in found["notes"]}


@pytest.mark.parametrize(
    ("file", "key", "values"),
    [
        ("nj2210", "bearing.roller.length", ["13 mm", "5 mm"]),
        ("6208", "bearing.ball.diameter", ["12 mm", "7 mm"]),
    ],
)
def test_rows_far_from_the_bearing_of_the_maker_say_so(file, key, values, tmp_path):
    over = {
        "case": str(CATALOGUE / f"{file}.toml"),
        "over": {key: values},
        "collect": {"life": "life_L10 [h]"},
    }
    near, far = flexbearing.study(over, tmp_path, jobs=1)["message"].values
    assert "a given rating became" not in near
    assert "a given rating became" in far


def test_a_setting_that_hides_what_is_wrong_in_the_file_says_so(tmp_path):
    place = tmp_path / "wrong.toml"
    place.write_text(re.sub(r'length = "[^"]*"', 'length = "long"', NJ2210.read_text()))
    with pytest.raises(BadCase, match=r"belongs to its bearing\.roller\.length"):
        api.check(place, {"bearing.roller.length": "12 mm"})
