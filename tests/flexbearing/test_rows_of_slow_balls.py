"""Rows of slow ball bearings: they compute what their outputs need, with the numbers of single runs."""

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import read_case
from flexbearing.findings.neglected import MUCH_NEGLECTED
from flexbearing.outputs import requested
from flexbearing.progress import Logged
from flexbearing.quantities.four_point import LAYOUT
from flexbearing.runs import four_point, neglect
from flexbearing.runs.ball import four_point_answers
from quasidynamic.outcome import slow_balls
from tests.places import CONFIGS

JOSHI = CONFIGS / "joshi2015_fourpoint.toml"
LIFE, TORQUE, LOAD = "life_L10 [Mrev]", "torque.inner [N m]", "max_contact_load [N]"
THRUSTS = ("0 N", "300 kN", "-200 kN")
FEW = "bearing.balls=40"


def cases(*settings):
    return [read_case(JOSHI, [f"operation.load.axial={load}", FEW, *settings]) for load in THRUSTS]


def test_rows_have_the_numbers_of_runs_wherever_their_search_begins():
    texts = (LIFE, LOAD, TORQUE)
    for case, answer in zip(cases(), four_point_answers(cases(), texts), strict=True):
        run = flexbearing.run(JOSHI, [f"operation.load.axial={case.operation.load.axial!r} N", FEW])
        blocks = {"rigid": four_point.block(four_point.solved(case))}
        for text in texts:
            alone = requested(LAYOUT, text).number(blocks)
            assert answer.numbers[text] == approx(alone, rel=1e-7)
        assert run.summary()["rigid"]["life_L10_Mrev"] == approx(answer.numbers[LIFE], rel=1e-7)


def test_a_row_of_lives_does_not_move_the_balls(monkeypatch):
    def never(*_):
        raise AssertionError("no torque is asked for")

    monkeypatch.setattr(slow_balls, "sliding_motion", never)
    answers = four_point_answers(cases(), (LIFE, LOAD))
    assert all(answer.status == "converged" for answer in answers)
    with pytest.raises(AssertionError, match="no torque"):
        four_point_answers(cases()[:1], (TORQUE,))


@pytest.mark.parametrize("coefficient", [0.12, 0.4])
def test_rolling_balls_have_more_heat_than_those_that_move_freely(coefficient):
    for case in cases(f"friction.coefficient={coefficient}"):
        solution = four_point.solved(case)
        exact, bounds = (
            of(solution)["neglected"] for of in (neglect.of_slow_balls, neglect.danger_of_slow_balls)
        )
        assert solution.balls.rolling_torque >= solution.balls.torque
        assert all(bounds[name] >= exact[name] * (1 - 1e-12) for name in exact)


@pytest.mark.parametrize(("thrust", "danger"), [("50 N", True), ("200 N", False)])
def test_a_danger_is_reported_by_rows_as_by_runs(thrust, danger):
    """Fast balls under a light thrust: friction sets another orbit than the one that was assumed."""
    settings = ["operation.speed=10000 rpm", f"operation.load.axial={thrust}"]
    case = read_case(JOSHI.with_name("joshi2015_qj309.toml"), settings)
    solution = four_point.solved(case)
    exact = neglect.of_slow_balls(solution)["neglected"]
    assert neglect.danger_of_slow_balls(solution)["neglected"] == exact  # the bounds are too near to it
    assert (max(exact.values()) > MUCH_NEGLECTED.limit) == danger
    (answer,) = four_point_answers([case], (LIFE,))
    assert (MUCH_NEGLECTED.code in {each.code for each in answer.findings}) == danger


def test_rigid_rings_beside_elastic_ones_are_solved_where_a_row_has_them(monkeypatch):
    """Elastic rings are found once for all rows."""
    names, found = [], []
    monkeypatch.setattr(
        four_point, "solved", lambda case, rings=None, *_, **__: names.append(rings) or _Solved()
    )
    monkeypatch.setattr(four_point, "elastic_rings", lambda *_: found.append(1) or "rings")
    case = read_case(JOSHI.with_name("slewing_bolted.toml"))
    known = four_point.Known()
    assert [name for name, _ in four_point.blocks(case, Logged(), rigid=False, known=known)] == ["flexible"]
    assert [name for name, _ in four_point.blocks(case, Logged(), known=known)] == ["rigid", "flexible"]
    assert names == ["rings", None, "rings"]
    assert len(found) == 1


class _Solved:
    distribution = None


def test_quantities_by_name_are_those_of_the_whole_block():
    solution = four_point.solved(cases()[0])
    whole, few = four_point.block(solution), four_point.block(solution, {"life_L10", "contact_load"})
    assert few.keys() == {"life_L10", "contact_load"} & whole.keys()
    assert all(np.array_equal(few[name], whole[name]) for name in few)
