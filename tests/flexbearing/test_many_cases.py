"""Outputs of many cases at once are those of single runs, and a row says the dangers of its run."""

from types import SimpleNamespace

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import read_case
from flexbearing.families import FAMILIES
from flexbearing.outputs import outputs
from flexbearing.quantities.roller import LAYOUT
from flexbearing.runs.answer import Answer
from flexbearing.runs.rows import answers
from flexbearing.runs.run_case import answered
from flexbearing.runs.side_by_side import _shapes
from quasidynamic.outcome.ring_stiffness import Tangent
from tests.cold_oil import PAPER, RIGID, cold_case, settings
from tests.places import CONFIGS

EVERY = [output.name for output in outputs(LAYOUT)]
FLANGE = {
    "bearing.flange.ring": "outer", "bearing.flange.clearance": "30 um", "bearing.flange.height": "2 mm",
    "bearing.flange.roller_chamfer": "0.4 mm", "bearing.flange.stiffness": "100 N/um",
    "bearing.flange.friction": 0.05, "operation.misalignment": "0.2 mrad",
}  # fmt: skip
ROUGH = {
    "bearing.roughness.roller": "0.1 um", "bearing.roughness.inner_raceway": "0.2 um",
    "bearing.roughness.outer_raceway": "0.2 um", "life.lubrication": "film",
}  # fmt: skip
KINDS = {
    "as it is": {},
    "flanges": FLANGE,
    "rough surfaces": ROUGH,
    "edge stress": {"life.edge_stress": True, "accuracy.slices": 30, "operation.misalignment": "3 arcmin"},
    "free tilt, known pockets": {
        "operation.tilt": "free", "operation.moment": "20 N m", "bearing.cage.pocket_clearance": "0.1 mm",
    },
}  # fmt: skip


def variants(path, changes, loads=(9000, 12000, 15000)):
    return [
        read_case(
            path, changes | {"operation.radial_load": f"{load} N", "operation.inner_speed": f"{speed} rpm"}
        )
        for load, speed in zip(loads, (1500, 3000, 2000), strict=False)
    ]


def single(case, texts, others="searched"):
    """The answer of a run."""
    result = flexbearing.api.compute(case, others=others)
    return answered(result, texts, FAMILIES[case.kind])


def refused(place):
    raise AssertionError(f"case {place} needed a run of its own")


def column(found, text):
    return np.array([answer.numbers.get(text, np.nan) for answer in found])


def assert_equal(found, cases, texts, others="searched"):
    expected = [single(case, texts, others) for case in cases]
    assert [answer.status for answer in found] == [answer.status for answer in expected]
    assert [answer.why for answer in found] == [answer.why for answer in expected]
    for text in texts:
        of_each = np.array([answer.numbers[text] for answer in expected])
        least = 1e-12
        if text == "power_loss.transport":  # what a sum leaves open: as exact as the sum
            least = 1e-9 * np.nanmin(column(found, "driving_power"))
        assert column(found, text) == approx(of_each, rel=1e-9, abs=least, nan_ok=True), text


@pytest.mark.sampled(2)
@pytest.mark.parametrize("changes", KINDS.values(), ids=KINDS)
def test_every_output_of_many_rigid_cases_is_that_of_single_runs(changes):
    cases, texts = variants(CONFIGS / "nu209.toml", changes, (9000, 15000)), [*EVERY, "rigid.life_L10 [h]"]
    found = answers(cases, texts, refused)
    assert_equal(found, cases, texts)
    assert sum(not np.isnan(column(found, text)).any() for text in texts) > 30


@pytest.mark.slow
def test_rollers_on_half_spaces_are_solved_beside_each_other_and_beside_slices():
    """Every output; their most loaded rollers are solved one by one, from states that are not."""
    life = {
        "life.capacity": "iso281",
        "life.lubrication": "a_ISO",
        "life.cleanliness": "grease, normal cleanliness",
    }
    both = [
        case
        for contact in ("half_space", "slices")
        for case in variants(
            CONFIGS / "nu209.toml",
            {"bearing.contact": contact, "operation.misalignment": "2 arcmin"} | life,
            (4000, 9000),
        )
    ]
    assert_equal(answers(both, EVERY, refused), both, EVERY)


@pytest.mark.slow
def test_cases_of_other_kinds_keep_their_places():
    """One of each kind, then another one of each."""
    each = [variants(CONFIGS / "nu209.toml", changes, (9000, 15000)) for changes in KINDS.values()]
    cases = [case for kinds in zip(*each, strict=True) for case in kinds]
    texts = ["max_roller_load", "rigid.skew.max_skew", "modified_life", "minimum_lambda.outer"]
    assert_equal(answers(cases, texts, refused), cases, texts)


def test_a_row_says_the_dangers_of_its_run():
    cases = variants(CONFIGS / "nu209.toml", {}, (9000, 2e5, 9e4))
    found = answers(cases, ["max_roller_load"], refused)
    assert [answer.why.count("danger: ") for answer in found] == [0, 3, 2]
    assert "life after all factors" in found[1].why
    assert "contact pressure" in found[2].why
    assert_equal(found[:1] + found[2:], cases[:1] + cases[2:], ["max_roller_load"])


@pytest.mark.slow
def test_a_row_tells_other_equilibria_as_its_run_does(tmp_path):
    case = read_case(cold_case(tmp_path), [*RIGID, *settings(13)])
    found = answers([case], ["life_L10"], refused, search=True)
    assert "several equilibria between rigid raceways" in found[0].why
    assert_equal(found, [case], ["life_L10"])


def test_without_a_search_a_row_says_that_other_equilibria_are_likely(tmp_path):
    case = read_case(cold_case(tmp_path), [*RIGID, *settings(13)])
    found = answers([case], ["life_L10"], refused)
    assert "several equilibria are likely" in found[0].why
    assert_equal(found, [case], ["life_L10"], others="reported")


BEAM = {
    "accuracy.structure": "beam", "inner.kind": "rigid", "materials.outer_ring.yield_stress": "20 MPa",
    "coupling.tolerance": 1e-13,  # or single runs end before rounding does
}  # fmt: skip
EVERY_BLOCK = [f"{block}.{name}" for block in ("rigid", "flexible") for name in EVERY]


def test_every_output_of_cases_between_the_same_elastic_rings_is_that_of_single_runs():
    first = variants(PAPER, BEAM | {"materials.outer_ring.yield_stress": ""}, (9000,))
    cases = first + variants(PAPER, BEAM, (9000, 12000, 19000))[1:]
    found = answers(cases, EVERY_BLOCK, refused)
    assert_equal(found, cases, EVERY_BLOCK)
    assert ["squirrel-cage bars (nominal): " in answer.why for answer in found] == [False, True, True]
    assert (column(found, "flexible.max_roller_load") < column(found, "rigid.max_roller_load")).all()


@pytest.mark.slow
def test_rings_that_grow_with_the_speed_are_those_of_single_runs():
    """The paper's inner ring on its shaft; loads and speeds around those of the paper."""
    cases = [
        read_case(
            PAPER,
            {
                "operation.radial_load": f"{load} kN",
                "operation.inner_speed": f"{speed} rpm",
                "coupling.tolerance": 1e-13,
            },
        )
        for load in (16, 22)
        for speed in (20000, 38000)
    ]
    texts = [*EVERY, "rigid.max_roller_load"]
    assert_equal(answers(cases, texts, refused, search=True), cases, texts)


def test_cases_between_other_rings_are_not_mixed():
    changes = [BEAM, BEAM | {"outer.thickness": "4 mm"}, {"inner.kind": "rigid", "outer.kind": "rigid"}]
    cases = [
        case
        for each in zip(*(variants(PAPER, change, (9000, 19000)) for change in changes), strict=True)
        for case in each
    ]
    texts = ["max_roller_load", "rigid.max_roller_load", "stiffness"]
    assert_equal(answers(cases, texts, refused), cases, texts)


OWN_RUN = {
    "nothing holds the ring": ({"operation.radial_load": "0 N"}, "undetermined"),
    "a target": ({"accuracy.target": "5 %"}, "accuracy.target"),
    "roller positions": ({"operation.roller_positions": 4}, "operation.roller_positions"),
    "an elastic ring of its own": (
        {"outer.kind": "ring", "outer.thickness": "4 mm", "outer.width": "10 mm"}, ""
    ),
}  # fmt: skip


@pytest.mark.parametrize(("changes", "reason"), OWN_RUN.values(), ids=OWN_RUN)
def test_what_needs_a_run_of_its_own_has_one_and_says_why(changes, reason):
    path, told = CONFIGS / "nu209.toml", Answer("told alone", "why", {"life_L10": 7.0})
    cases = [read_case(path), read_case(path, changes), read_case(path)]
    found = answers(cases, ["life_L10", "cage_slip"], lambda place: told)
    assert [answer.status for answer in found] == ["converged", "told alone", "converged"]
    assert (found[1].message, found[1].numbers) == ("why", {"life_L10": 7.0})
    assert reason in found[1].own_run
    assert found[0].own_run == found[2].own_run == ""
    assert found[0].numbers["life_L10"] == found[2].numbers["life_L10"] != 7.0


def test_nothing_is_computed_but_what_is_wanted(monkeypatch):
    def never(*given):
        raise AssertionError("not asked for")

    monkeypatch.setattr(Tangent, "of", never)
    monkeypatch.setattr("flexbearing.runs.solved_rows.estimated", never)
    monkeypatch.setattr("flexbearing.runs.solved_rows.skew.at", never)
    cases = variants(CONFIGS / "nu209.toml", FLANGE)
    found = answers(cases, ["max_roller_load", "cage_slip", "life_L10 [h]", "driving_torque"], refused)
    assert np.isfinite([list(answer.numbers.values()) for answer in found]).all()


def test_no_cases_have_no_answers():
    assert answers([], ["life_L10"], refused) == []


def test_rollers_of_another_length_have_rings_of_their_own():
    """The parts are the same, the loaded band is not."""
    cases = [
        case
        for length in ("5 mm", "4.5 mm")
        for case in variants(
            CONFIGS / "mao2016.toml",
            {"bearing.roller.length": length, "accuracy.structure": "beam"},
            (4000, 8000),
        )
    ]
    assert_equal(answers(cases, ["max_roller_load"], refused), cases, ["max_roller_load"])


def test_a_pair_of_raceways_without_a_shape_is_round_beside_one_with_a_shape():
    shape = np.ones((2, 3, 2))
    pairs = [SimpleNamespace(initial_deviation=each) for each in (None, shape)]
    assert _shapes(pairs) == approx(np.stack([0 * shape, shape]))
    assert _shapes(pairs[:1]) is None
