"""The section [life]: which factors it asks for, and what becomes of the basic life."""

from math import prod

import numpy as np
import pytest
from pytest import approx

from flexbearing import run
from flexbearing.api import check, read_case
from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.coupling import LinearPair
from flexbearing.derivatives.rollers import sensitivities
from flexbearing.life import roller_lives
from flexbearing.report.output import text
from flexbearing.runs.rows import answers
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic.outcome.capacity import (
    dynamic_rating,
    raceway_capacity,
    reference_raceway_capacity,
    roller_capacity,
)
from quasidynamic.outcome.life import (
    RollerBody,
    edge_stress_factor,
    reference_life,
    reference_load,
    slice_life,
)
from quasidynamic.outcome.life_factors import (
    film_factor,
    material_factor,
    modification_factor,
    modification_slope,
    reliability_factor,
)
from quasidynamic.outcome.rating_life import ROLLER_EXPONENT
from tests.places import CONFIGS
from tests.reference.modified_slices import modification

PLAIN = CONFIGS / "nu209.toml"
ROUGH = {
    "bearing.roughness.roller": "0.05 um",
    "bearing.roughness.inner_raceway": "0.1 um",
    "bearing.roughness.outer_raceway": "0.2 um",
}
SMALL = {"bearing.roller.diameter": "0.5 mm", "bearing.cage.thickness": "0.2 mm"}
CLEAN = {"life.lubrication": "a_ISO", "life.cleanliness": "oil, in-line filter, -/17/14"}
ONCE = CLEAN | {"life.modification": "bearing"}

THIN = CLEAN | {"lubricant.viscosity": "0.8 mPa s"}


@pytest.fixture(scope="module")
def state():
    return roller_bearing.bearing(read_case(PLAIN, ["accuracy.slices=30"])).solve()


def lived(state, settings):
    case = read_case(PLAIN, {"accuracy.slices": 30, **settings})
    rated = SolvedRows.of(case, roller_bearing.bearing(case), state, LinearPair(None, None)).life[0]
    return None if rated is None else rated.record()


def only(found):
    (factor,) = found["factors"]
    assert found["modified_Mrev"] == approx(found["basic_Mrev"] * factor["value"], rel=1e-12)
    return factor


def loads(state):
    return state.slice_loads * state.balance.roller.raceways.slices.width


def test_nothing_modifies_a_life_unless_it_is_asked_for(state):
    assert lived(state, {}) is None


def test_edge_stress_is_that_of_the_slices(state):
    bearing = state.balance.roller.bearing
    factor = only(lived(state, {"life.edge_stress": True}))
    edge = edge_stress_factor(30)
    expected = slice_life(*(edge * np.array(loads(state))), raceway_capacity(bearing), (True, False))
    assert factor["name"] == "edge stress"
    assert factor["value"] == approx(expected / state.life, rel=1e-12)


def test_rollers_fail_as_well(state):
    bearing = state.balance.roller.bearing
    factor = only(lived(state, {"life.roller_body": True}))
    ratio = bearing.diameter_ratio
    body = RollerBody(capacity=roller_capacity(bearing), speed_ratio=(1 - ratio**2) / (2 * ratio))
    expected = slice_life(*loads(state), raceway_capacity(bearing), (True, False), rollers=body)
    assert factor["name"] == "roller body"
    assert factor["value"] == approx(expected / state.life, rel=1e-12)


def test_steel_with_its_melting(state):
    factor = only(lived(state, {"life.steel": "M50", "life.melting": "VIM-VAR"}))
    assert factor["value"] == approx(material_factor("M50", "VIM-VAR").value, rel=1e-12)
    assert "VIM-VAR 6" in factor["note"]


def test_reliability(state):
    factor = only(lived(state, {"life.reliability": 0.95}))
    assert factor["value"] == approx(reliability_factor(0.95).value, rel=1e-12)
    assert "0.95" in factor["note"]


def test_film_factor_is_that_of_the_thinnest_film_over_its_own_roughness(state):
    factor = only(lived(state, {**ROUGH, "life.lubrication": "film"}))
    films = np.where(state.loads > 1.0, state.film, np.inf)
    ratio = min(films[0].min() / np.hypot(0.05e-6, 0.1e-6), films[1].min() / np.hypot(0.05e-6, 0.2e-6))
    assert factor["value"] == approx(film_factor(ratio).value, rel=1e-12)
    assert f"smallest film ratio {ratio:.3g}" in factor["note"]


def test_factor_of_iso_281_by_hand(state):
    """d_m = 65 mm, 3000 rpm: nu_1 = 4500 / sqrt(3000 65) mm2/s; C_u/P and e_C as printed in the standard."""
    pitch = 65.032
    factor = only(lived(state, ONCE))
    kappa = 18e-3 / 850 * 1e6 / (4500 / np.sqrt(3000 * pitch))
    left = min(0.0288 * kappa**0.68 * pitch**0.55, 1.0) * (1 - 1.6329 / pitch ** (1 / 3))
    limit = 44 * (1 - 10 / pitch) * 14 * 9.601 * 10 / 8.2
    assert f"kappa {kappa:.3g}" in factor["note"]
    words = dict(part.rsplit(" ", 1) for part in factor["note"].removesuffix(" N").split(", "))
    load = float(words["equivalent load"])
    assert load == approx(4450, rel=0.2)  # clearance spreads the load worse than the standard's bearing
    assert float(words["e_C C_u/P"]) == approx(left * limit / load, rel=2e-3)
    value = 0.1 * (1 - (1.5859 - 1.2348 / kappa**0.071739) * (left * limit / load) ** 0.4) ** -9.185
    assert factor["value"] == approx(value, rel=5e-3)
    grown = modification_slope(kappa, left * limit / load) / ROLLER_EXPONENT
    assert factor["life_exponent"] == approx(grown, rel=5e-3)


def test_viscosity_ratio_is_that_of_the_speed_of_one_ring_past_the_other():
    speeds = {"operation.inner_speed": "3000 rpm", "operation.outer_speed": "-1000 rpm"}
    kappa = []
    for settings in (speeds, {"operation.inner_speed": "4000 rpm"}):
        case = read_case(PLAIN, {**settings, **CLEAN})
        kappa.append(roller_lives.rated(case, roller_bearing.bearing(case).bearing).kappa)
    assert kappa[0] == approx(kappa[1], rel=1e-12)


def test_equivalent_load_counts_each_race_with_its_own_capacity():
    """Fast rollers load the outer race more, by their inertia."""
    case = read_case(PLAIN, {"operation.inner_speed": "15000 rpm", **ONCE})
    state = roller_bearing.bearing(case).solve()
    bearing, (inner, outer) = state.balance.roller.bearing, loads(state)
    rating = dynamic_rating(bearing)
    load, swapped = (
        f"equivalent load {reference_load(reference_life(*pair, bearing, (True, False)), rating):.4g} N"
        for pair in ((inner, outer), (outer, inner))
    )
    assert load != swapped
    (factor,) = lived(state, {"operation.inner_speed": "15000 rpm", **ONCE})["factors"]
    assert load in factor["note"]


def test_all_factors_together_make_the_modified_life(state):
    settings = {
        "life.edge_stress": True,
        "life.roller_body": True,
        "life.steel": "52100",
        "life.melting": "VAR",
        "life.reliability": 0.99,
        **CLEAN,
    }
    found = lived(state, settings)
    names = [factor["name"] for factor in found["factors"]]
    assert names == ["edge stress", "roller body", "a_ISO", "material", "a_1"]
    together = prod(factor["value"] for factor in found["factors"])
    assert found["basic_Mrev"] == state.life
    assert found["modified_Mrev"] == approx(state.life * together, rel=1e-12)
    assert "ISO 281 has no such factor beside a_ISO" in found["factors"][3]["note"]


# -- refusals --------------------------------------------------------------------------------------


REFUSED = {
    "edge stress of a straight roller": (
        {"life.edge_stress": True, "bearing.roller.profile": "straight", "accuracy.slices": 30},
        ['[bearing.roller] profile = "straight" cannot be', "life.edge_stress"],
    ),
    "edge stress of few slices": (
        {"life.edge_stress": True}, ["[accuracy] slices", "at least 30 for life.edge_stress"],
    ),
    "steel without melting": ({"life.steel": "M50"}, ["[life] melting is missing: life.steel needs it"]),
    "melting without steel": ({"life.melting": "VAR"}, ["[life] steel is missing: life.melting needs it"]),
    "a_ISO without cleanliness": (
        {"life.lubrication": "a_ISO"}, ['[life] cleanliness is missing: lubrication = "a_ISO" needs it'],
    ),
    "cleanliness without a_ISO": (
        {"life.cleanliness": "grease, normal cleanliness"},
        ["[life] cleanliness", 'left out without life.lubrication = "a_ISO"'],
    ),
    "film without roughness": (
        {"life.lubrication": "film"},
        ['[bearing] roughness is missing: life.lubrication = "film" needs it; it is a table'],
    ),
    "reliability of a dream": ({"life.reliability": 0.99999}, ["[life] reliability", "at most 0.9995"]),
    "steel without a factor": ({"life.steel": "M51"}, ['[life] steel = "M51"', '"M50"']),
}  # fmt: skip


OUTSIDE = {  # a law, and what the case keeps
    "oil too thin": (THIN, "", {"life_L10"}),
    "oil too thin, C_r of ISO 281": (THIN | {"life.capacity": "iso281"}, "", {"life_L10", "reference_life"}),
    "oil too thin, C_r/P": (THIN | {"life.loads": "rating"}, "", {"life_L10"}),
    "rollers too small": (CLEAN | SMALL, "outside 0.01 to 0.3 of ISO 281", {"life_L10"}),
    "rollers too small, C_r of ISO 281": (
        {"life.capacity": "iso281"} | SMALL, "outside 0.01 to 0.3 of ISO 281", {"life_L10"}
    ),
}  # fmt: skip


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("settings", "reason", "lives"), OUTSIDE.values(), ids=OUTSIDE)
def test_a_law_that_does_not_hold_takes_the_modified_life_alone(settings, reason, lives):
    result = run(PLAIN, settings)
    assert result.attributes["status"] == "converged"
    assert lives == {"life_L10", "reference_life", "modified_life"} & set(result.flexible)
    (note,) = [each for each in result.attributes["notes"] if each["code"] == "no-modified-life"]
    assert reason in note["text"]
    broken = [each for each in result.attributes["findings"] if each["code"] == "no-modified-life"]
    assert ("not met" in {each["verdict"] for each in broken}) == (not reason)
    assert "\nmodified life, " not in text(result)


def test_single_runs_rows_and_derivatives_agree_that_there_is_no_modified_life():
    texts = ["modified_life", "life_L10"]
    alone = run(PLAIN, THIN)
    (row, other) = answers([read_case(PLAIN, THIN), read_case(PLAIN, CLEAN)], texts, lambda place: None)
    assert np.isnan(row.numbers["modified_life"])
    assert row.numbers["life_L10"] == approx(float(alone["life_L10"].number), rel=1e-9)
    assert row.why == "outside validity: " + next(
        each["text"] for each in alone.attributes["notes"] if each["code"] == "no-modified-life"
    )
    assert (other.why, other.numbers["modified_life"] > 0) == ("", True)
    with pytest.raises(BadCase, match="no such output"):
        sensitivities(read_case(PLAIN, THIN), ["modified_life"], ["bearing.roller.length"])


@pytest.mark.parametrize(("settings", "expected"), REFUSED.values(), ids=REFUSED.keys())
def test_factor_that_cannot_be_is_refused_before_anything_is_solved(settings, expected):
    with pytest.raises(BadCase) as problem:
        check(PLAIN, settings)
    for part in expected:
        assert part in str(problem.value)


def test_a_iso_of_slices(state):
    settings, (inner, outer) = CLEAN, loads(state)
    rated = roller_lives.rated(read_case(PLAIN, settings), state.balance.roller.bearing)
    capacity = reference_raceway_capacity(state.balance.roller.bearing, rated.dynamic)

    def a_iso(load):
        return modification_factor(rated.kappa, rated.fatigue_share / load).value

    factor = only(lived(state, settings))
    assert factor["value"] == approx(modification(inner, outer, capacity, a_iso), rel=1e-9)
    assert f"{only(lived(state, ONCE))['value']:.4g} once for the bearing" in factor["note"]
    more = [(1 + 1e-6) * each for each in loads(state)]
    grown = only(lived(state, settings))["life_exponent"]
    step = np.log(modification(*more, capacity, a_iso) / factor["value"]) / (-4 * np.log(1 + 1e-6))
    assert grown == approx(step, rel=1e-4)
