"""Life from the rating C_r: of ISO 281, or of a catalogue."""

from pathlib import Path

import pytest
from pytest import approx

from flexbearing import api, check
from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.coupling import LinearPair
from flexbearing.runs import life
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic.outcome.capacity import dynamic_rating, raceway_capacity, reference_raceway_capacity
from quasidynamic.outcome.life import reference_life

PLAIN = Path(__file__).parents[2] / "configs" / "nu209.toml"
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
    with pytest.raises(BadCase, match="ISO 281, table 7"):
        check(PLAIN, ISO | slim)
    check(PLAIN, ISO | slim | {"life.dynamic_rating": "20 kN"})


def test_ratings_are_those_of_the_drawing_at_any_temperature():
    parts = ("inner_ring", "outer_ring", "roller", "shaft")
    temperatures = {f"operation.temperatures.{part}": "120 degC" for part in parts}
    temperatures |= {"operation.temperatures.reference": "20 degC"}
    cold, hot = (read_case(PLAIN, settings) for settings in ({}, temperatures))
    at_rest, warm = (roller_bearing.parts(case) for case in (cold, hot))
    assert warm.roller.diameter > at_rest.roller.diameter
    for rating in (life.dynamic, life.static, life.fatigue_limit):
        assert rating(hot, warm) == rating(cold, at_rest)
    assert warm.roller.mass == approx(at_rest.roller.mass, rel=1e-14)


@pytest.mark.parametrize(
    ("rollers", "diameter", "pitch"), [(60, "11 mm", "2 m"), (8, "30 mm", "120 mm")], ids=["small", "large"]
)
def test_rollers_that_iso_281_does_not_rate_have_every_other_answer(rollers, diameter, pitch):
    """The limits of light and heavy loads follow from C_r: without it both are not judged."""
    size = {"rollers": rollers, "roller.diameter": diameter, "outer_raceway_diameter": pitch}
    result = api.run(PLAIN, {f"bearing.{name}": value for name, value in size.items()})
    assert result.attributes["status"] == "converged"
    judged = {found["quantity"] for found in result.attributes["findings"] if found["limit"] is not None}
    assert "contact_pressure" in judged
    assert "load" not in judged
