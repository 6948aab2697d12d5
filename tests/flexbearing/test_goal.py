"""Changes that reach a life."""

import json

import numpy as np
import pytest
from pytest import approx

import flexbearing as fb
from flexbearing import __main__ as program
from flexbearing.goal import search
from flexbearing.goal.approach import Track, reach
from flexbearing.goal.target import target
from tests.places import CONFIGS

TEXTBOOK = CONFIGS / "nu209.toml"


@pytest.fixture(scope="module")
def goal():
    return fb.Case(TEXTBOOK).goal("x2")


def test_every_change_that_reaches_it_does_so_in_a_run_of_its_own(goal):
    before = fb.run(TEXTBOOK)["life_L10 [h]"].number
    reaching = [each for each in goal.changes if each.reaches]
    assert len(reaching) >= 5
    for change in reaching:
        life = fb.run(TEXTBOOK, change.settings)["life_L10 [h]"].number
        assert life == approx(change.life, rel=1e-6)
        assert life >= 2 * before * (1 - 1e-3)
    assert [each.steps for each in reaching] == sorted(each.steps for each in reaching)


def test_load_that_doubles_the_life_is_bracketed_by_runs(goal):
    load = float(goal["operation.radial_load"].keys[0].after.split()[0])
    lives = [fb.run(TEXTBOOK, {"operation.radial_load": f"{factor * load} N"})["life_L10"].number
             for factor in (0.995, 1.0, 1.005)]  # fmt: skip
    assert lives[0] > 2 * fb.run(TEXTBOOK)["life_L10"].number > lives[2]


def test_a_lever_that_cannot_says_how_far_it_comes(goal):
    """The raceway diameter has a best value in between; no other one nearby gives a longer life."""
    change = goal["bearing.outer_raceway_diameter"]
    assert not change.reaches
    assert "falls" in change.limit
    best = float(change.keys[0].after.split()[0])
    for factor in (0.98, 1.02):
        other = {"bearing.outer_raceway_diameter": f"{factor * best} mm"}
        assert fb.run(TEXTBOOK, other)["life_L10 [h]"].number < change.life


def test_a_pair_needs_fewer_steps_than_either_alone(goal):
    assert goal.pair is not None
    assert goal.pair.steps < min(each.steps for each in goal.changes if each.reaches)
    life = fb.run(TEXTBOOK, goal.pair.settings)["life_L10 [h]"].number
    assert life == approx(goal.target.wanted, rel=1e-3)


def test_a_shorter_life_and_a_life_in_hours_are_goals_too(monkeypatch):
    """By the load alone."""
    of_case = search.levers
    monkeypatch.setattr(search, "levers", lambda case: [
        lever for lever in of_case(case) if lever.key.path == "operation.radial_load"])  # fmt: skip
    monkeypatch.setattr(search, "choices", lambda case: [])
    before = fb.run(TEXTBOOK)
    hours = 0.5 * before["life_L10 [h]"].number
    found = fb.Case(TEXTBOOK).goal("x0.5")
    assert found["operation.radial_load"].life == approx(hours, rel=1e-3)
    for wanted in (found.target, target(before, f"{hours!r} h"), target(before, f"{60 * hours!r} min")):
        assert wanted.wanted == approx(hours)


@pytest.mark.parametrize("life", ["2", "x", "x-1", "20000", "20000 mm", "x2 h", "long"])
def test_a_text_that_is_no_life_is_refused(life, capsys):
    assert program.command(["goal", str(TEXTBOOK), "--life", life]) == 2
    assert len(capsys.readouterr().err.strip().splitlines()) == 1


def test_the_command_prints_changes_or_json(goal, capsys, monkeypatch):
    lives = []
    monkeypatch.setattr("flexbearing.goal.search.goal", lambda *given: lives.append(given[2]) or goal)
    assert program.command(["goal", str(TEXTBOOK), "--life", "x2", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert lives == ["x2"]
    assert found["wanted"] == approx(2 * found["before"])
    assert any(each["reaches"] for each in found["changes"])


FUNCTIONS = {  # negative at zero; where the root is, or the largest value
    "linear": (lambda x: x - 3.0, 3.0, True),
    "late": (lambda x: x - 9.9, 9.9, True),
    "falls again": (lambda x: 1.0 - (x - 4.0) ** 2, 3.0, True),
    "an early rise": (lambda x: -1.0 - (x - 0.05) ** 2, 0.05, False),
    "falls before the end": (lambda x: -1.0 - (x - 8.0) ** 2, 8.0, False),
    "too low": (lambda x: -1.0 - (x - 6.0) ** 2, 6.0, False),
    "too short": (lambda x: 0.01 * x - 1.0, 10.0, False),
    "ends": (lambda x: x - 8.0 if x < 5.0 else np.nan, 4.9, False),
}


def test_functions_are_followed_side_by_side_to_their_roots_or_largest_values():
    functions = [each[0] for each in FUNCTIONS.values()]
    tracks = [Track({0.0: function(0.0)}, 10.0) for function in functions]
    batches = []

    def batch(numbers, places):
        batches.append(len(numbers))
        return [functions[number](place) for number, place in zip(numbers, places, strict=True)]

    reach(tracks, [2.0] * len(tracks), batch)
    for track, (_, place, reaches) in zip(tracks, FUNCTIONS.values(), strict=True):
        assert (track.root is not None) == reaches
        assert (track.best if track.root is None else track.root) == approx(
            place, abs=0.12 if not reaches else 1e-3
        )
    assert max(batches) == len(functions)
