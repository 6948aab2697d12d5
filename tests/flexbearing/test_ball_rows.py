"""Rows of ball bearings are those of their runs; those of the same parts are balanced side by side."""

import pytest
from pytest import approx

import flexbearing
from flexbearing.api import read_case
from flexbearing.families import FAMILIES
from flexbearing.life import ball_lives
from flexbearing.outputs import outputs, requested
from quasidynamic import AngularContactBallBearing, ImpossiblePart, OutOfRange
from tests.places import CONFIGS

SPEEDS = [{"operation.inner_speed": f"{speed} rpm"} for speed in (3000, 6000, 9000)]
HEAVY = {"operation.load.axial": "500 kN"}  # with dangers
TABLES = {
    "fast": ("harris218", [*SPEEDS, HEAVY]),
    "fast, stick and slip": ("catalogue/6208", [{"operation.load.axial": "1 kN"}, {}]),
    "slow": ("joshi2015_qj309", [{"friction.coefficient": 0.05}, HEAVY]),
}


def rows_of(cases, texts):
    return FAMILIES[cases[0].kind].rows()(cases, texts, lambda place: pytest.fail("a run of its own"))


@pytest.mark.parametrize(("name", "changes"), TABLES.values(), ids=TABLES)
def test_every_output_of_a_row_is_that_of_its_run(name, changes):
    cases = [read_case(CONFIGS / f"{name}.toml", each) for each in changes]
    layout = FAMILIES[cases[0].kind].layout()
    texts = [output.name for output in outputs(layout)]
    for case, row in zip(cases, rows_of(cases, texts), strict=True):
        run = flexbearing.api.compute(case)
        assert row.status == run.attributes["status"]
        assert bool(run.dangers) == (case.operation.load.axial == 5e5)
        assert row.why == "; ".join(f"danger: {note['text']}" for note in run.dangers)
        expected = [requested(layout, text).number({"rigid": run.rigid}) for text in texts]
        found = [row.numbers[text] for text in texts]
        assert found == approx(expected, rel=1e-9, abs=1e-6, nan_ok=True)


def test_cases_of_the_same_bearing_are_balanced_side_by_side(monkeypatch):
    solve, counts = AngularContactBallBearing.solve_many, []

    def counted(self, at, grooves=None):
        counts.append(len(at))
        return solve(self, at, grooves)

    monkeypatch.setattr(AngularContactBallBearing, "solve_many", counted)
    other = {"bearing.pitch_diameter": "125.5 mm"}
    cases = [read_case(CONFIGS / "harris218.toml", each) for each in (*SPEEDS, other)]
    assert len({row.numbers["life_L10"] for row in rows_of(cases, ["life_L10"])}) == 4
    assert counts == [3, 1]


def test_beside_a_case_beyond_a_law_each_is_solved_for_itself(monkeypatch):
    cases = [read_case(CONFIGS / "harris218.toml", each) for each in SPEEDS[:2]]
    expected = [row.numbers["life_L10"] for row in rows_of(cases, ["life_L10"])]
    solve = AngularContactBallBearing.solve_many

    def alone(self, at, grooves=None):
        if len(at) > 1:
            raise OutOfRange("one of them is beyond a law")
        return solve(self, at, grooves)

    monkeypatch.setattr(AngularContactBallBearing, "solve_many", alone)
    assert [row.numbers["life_L10"] for row in rows_of(cases, ["life_L10"])] == approx(expected, rel=1e-9)


@pytest.mark.parametrize("status", ["not solved", "bad input"])
def test_a_row_without_a_solution_says_why_and_the_others_have_theirs(status, monkeypatch):
    changes = (SPEEDS[0], {"operation.load.axial": "0 N"} if status == "not solved" else {}, SPEEDS[1])
    cases, lives = [read_case(CONFIGS / "harris218.toml", each) for each in changes], ball_lives.lives

    def no_factor(case, state):
        if case is cases[1]:
            raise ImpossiblePart("such a part cannot be")
        return lives(case, state)

    monkeypatch.setattr(ball_lives, "lives", no_factor)
    first, failed, last = rows_of(cases, ["life_L10"])
    assert (failed.status, failed.numbers) == (status, {})
    assert ("nothing holds the inner ring" if status == "not solved" else "cannot be") in failed.message
    assert first.status == last.status == "converged"
