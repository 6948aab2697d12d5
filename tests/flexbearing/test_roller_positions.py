"""Rollers that pass a pitch: the numbers of every position, and what the summary says of them."""

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from pytest import approx
from scipy.optimize import brentq

import flexbearing
from flexbearing.api import read_case
from flexbearing.case import BadCase
from flexbearing.report.output import text
from flexbearing.runs import passage
from flexbearing.runs.passage import load_half_a_pitch_further
from tests.flexbearing.noted import codes
from tests.places import CONFIGS

CASE = CONFIGS / "nu209.toml"
QUICK = ["accuracy.slices=8", "accuracy.axial_shapes=2"]
RIGID = ["inner.kind=rigid", "outer.kind=rigid"]
RING = [
    "inner.kind=rigid", "outer.kind=ring", "outer.thickness=3 mm", "outer.width=19 mm",
    "accuracy.structure=beam", "outer.support=foundation", "outer.foundation_radial=30 N/mm^3",
]  # fmt: skip
LINES = [
    "inner.kind=rigid", "outer.kind=ring", "outer.thickness=5 mm", "outer.width=19 mm",
    "accuracy.element_order=3", "outer.support=lines", 'outer.line_azimuths=["0 deg", "120 deg", "240 deg"]',
]  # fmt: skip
STRUCTURES = {
    "rigid": RIGID,
    "ring that only pushes": RING,
    "ring that pulls": [*RING, "outer.bilateral=true"],
    "ring on lines": pytest.param(LINES, marks=pytest.mark.slow),
    "clamped ring": [*RING[:5], "outer.support=side"],
    "ring with waves": [
        *RING[:5],
        "outer.support=side",
        "bearing.form_error.outer.waves=3",
        "bearing.form_error.outer.amplitude=8 um",
    ],
}


PAPER = CASE.with_name("mao2016.toml")
POSITIONS = {  # file and settings
    "rigid rings": (CASE, RIGID),
    "rigid rings, heavily loaded": (CASE, [*RIGID, "operation.radial_load=20 kN"]),
    "ring on lines": (CASE, LINES),
    "many rollers": (PAPER, [*RIGID, "operation.tilt=fixed"]),
}


def run(folder, *settings):
    return flexbearing.run(CASE, [*QUICK, *settings], output=folder / "r.h5")


@pytest.mark.slow
@pytest.mark.parametrize("structure", STRUCTURES.values(), ids=STRUCTURES.keys())
def test_every_position_is_a_run_with_its_first_roller_there(structure, tmp_path):
    passed = run(tmp_path, *structure, "operation.roller_positions=2").attributes["passage"]
    assert passed["azimuth_deg"] == approx([0, 180 / 14], rel=1e-12)
    assert passed["status"] == ["converged"] * 2
    for place, azimuth in enumerate(passed["azimuth_deg"]):
        alone = run(tmp_path, *structure, f"bearing.first_roller_azimuth={azimuth!r} deg")
        numbers = alone.summary()["flexible"]
        for name in ("max_roller_load_N", "life_L10_Mrev", "driving_torque_Nm", "total_stiffness_N_per_m"):
            assert passed["values"][name][place] == approx(numbers[name], rel=1e-5)
        inner, outer = (passed["values"][f"peak_pressure_MPa.{race}"][place] for race in ("inner", "outer"))
        assert (inner, outer) == approx(
            (numbers["peak_pressure_MPa"]["inner"], numbers["peak_pressure_MPa"]["outer"]), rel=1e-5
        )


def test_range_over_a_pitch_is_in_the_summary_and_noted(tmp_path):
    result = run(tmp_path, *LINES, "operation.roller_positions=4")
    passed = result.attributes["passage"]
    loads = np.array(passed["values"]["max_roller_load_N"])
    assert loads.max() > 1.3 * loads.min()  # a roller over the line or two beside it
    damage = np.mean(1 / np.array(passed["values"]["life_L10_Mrev"]))
    assert passed["mean_life_Mrev"] == approx(1 / damage, rel=1e-12)
    printed = text(result)
    assert "rollers passing a pitch" in printed
    assert f"{loads.min():,.0f}" in printed
    assert f"{loads.max():,.0f}" in printed
    assert "life L10 by equal damage" in printed
    assert "roller-position" in codes(result)
    assert result.summary()["passage"]["status"] == ["converged"] * 4


@pytest.mark.slow
def test_positions_are_solved_in_fewer_steps_than_a_cold_start(tmp_path, monkeypatch):
    """Each begins at the one before."""
    from flexbearing.coupled.attempts import CoupledBearing
    from flexbearing.runs import passage

    begun = []
    attempts = CoupledBearing.attempts

    def watched(self, *heard):
        begun.append(self.initial is not None)
        return attempts(self, *heard)

    monkeypatch.setattr(passage.CoupledBearing, "attempts", watched)
    run(tmp_path, *RING, "operation.roller_positions=4")
    assert begun == [False, True, True, True]


def test_position_that_is_not_solved_is_a_danger_and_the_rest_is_reported(tmp_path, monkeypatch):
    from flexbearing.coupling import PartnerFailed
    from flexbearing.runs import passage

    solved, calls = passage.solved, []

    def second_fails(*given):
        calls.append(given)
        if len(calls) == 2:
            raise PartnerFailed("no luck", "iteration limit")
        return solved(*given)

    monkeypatch.setattr(passage, "solved", second_fails)
    result = run(tmp_path, *RIGID, "operation.roller_positions=4")
    passed = result.attributes["passage"]
    assert passed["status"] == ["converged", "converged", "iteration limit", "converged"]
    assert passed["values"]["max_roller_load_N"][2] is None
    assert "unsolved-position" in codes(result, "danger")
    assert text(result).startswith("DANGER: roller positions: 1 of 4 were not solved")


def test_one_position_alone_has_no_passage(tmp_path):
    result = run(tmp_path, *RIGID)
    assert "passage" not in result.attributes
    assert "rollers passing" not in text(result)


@pytest.mark.parametrize(("file", "settings"), POSITIONS.values(), ids=POSITIONS.keys())
def test_half_a_pitch_is_foreseen_from_the_loads_of_one_position(file, settings):
    case = [*QUICK, *settings, "operation.roller_positions=2"]
    result = flexbearing.run(file, case)
    loads, azimuths = result.flexible["inner_load"], result.flexible["roller_azimuth"]
    foreseen = load_half_a_pitch_further(azimuths, loads, 0.0)
    _, moved = result.attributes["passage"]["values"]["max_roller_load_N"]
    assert foreseen == approx(moved, rel=0, abs=0.03 * loads.max())


@pytest.mark.parametrize(("rollers", "gap"), [(12, 0.0), (14, 0.0), (14, 0.5), (14, -0.5), (30, 0.2)])
def test_half_a_pitch_between_rigid_rings_is_foreseen_from_the_loads(rollers, gap):
    """Approaches a cos(phi) - gap and loads that carry 1 N; a roller at the load or two beside it."""

    def largest(first):
        azimuths = 2 * np.pi * (np.arange(rollers) + first) / rollers
        loads = lambda a: np.maximum(a * np.cos(azimuths) - gap, 0) ** (10 / 9)  # noqa: E731
        a = brentq(lambda a: loads(a) @ np.cos(azimuths) - 1, 0, 100)
        return azimuths, loads(a)

    azimuths, loads = largest(0.0)
    _, beside = largest(0.5)
    turned = azimuths + 0.7  # with the load
    for at, direction in ((azimuths, 0.0), (turned, 0.7)):
        foreseen = load_half_a_pitch_further(at, loads, direction)
        assert foreseen == approx(beside.max(), rel=0, abs=0.02 * loads.max())


@pytest.mark.slow
def test_roller_under_a_bar_or_between_two_is_told():
    """Seven bars: 3054 N under a bar, 2795 N with the rollers half a pitch further."""
    bars = [*QUICK, "outer.bars=7"]
    alone = flexbearing.run(PAPER, bars)
    (note,) = [note["text"] for note in alone.attributes["notes"] if note["code"] == "roller-position"]
    assert "half a pitch further the largest roller load is" in note
    assert f"{note} (operation.roller_positions=8)" in text(alone).replace("\n  ", " ")
    passed = flexbearing.run(PAPER, [*bars, "operation.roller_positions=2"])
    under, between = passed.attributes["passage"]["values"]["max_roller_load_N"]
    assert under > 1.07 * between
    assert f"{between:,.4g} N instead of {under:,.4g} N" in note
    assert "roller-position" not in codes(flexbearing.run(PAPER, QUICK))


def test_rigid_rings_of_few_rollers_are_told_too(tmp_path):
    """The load of the note is that of a run there."""
    (note,) = [
        note for note in run(tmp_path, *RIGID).attributes["notes"] if note["code"] == "roller-position"
    ]
    moved = run(tmp_path, *RIGID, f"bearing.first_roller_azimuth={180 / 14!r} deg").summary()["flexible"]
    assert f"load is {moved['max_roller_load_N']:,.4g} N instead of" in note["text"]
    assert f"the basic life L10 {moved['life_L10_Mrev']:,.4g} Mrev instead of" in note["text"]
    many = flexbearing.run(PAPER, [*QUICK, *RIGID, "operation.tilt=fixed"], output=tmp_path / "m.h5")
    assert "roller-position" not in codes(many)


def test_cage_with_a_bar_at_every_roller_is_solved_half_a_pitch_further(monkeypatch):
    """Half a pitch leads every roller from a bar to the middle of a bay, and no load shows it."""
    state: Any = SimpleNamespace(loads=np.ones((2, 30)), life=1.0)
    there: Any = SimpleNamespace(loads=1.1 * np.ones((2, 30)), life=0.7)
    monkeypatch.setattr(passage, "_half_a_pitch_further", lambda *_: there)
    monkeypatch.setattr(passage, "_stiffnesses", lambda each, _: f"{each.life:g} and 2")
    rings: Any = SimpleNamespace(solved_in_full=False)
    (note,) = passage.notes(read_case(PAPER, ["outer.bars=30"]), None, rings, state)  # pyright: ignore
    assert "1.1 N instead of 1 N (+10.0%), the basic life L10 0.7 Mrev instead of 1 Mrev" in note.text
    assert "the radial stiffness along y and z 0.7 and 2 instead of 1 and 2 kN/mm" in note.text


@pytest.mark.parametrize(
    "settings", [["outer.kind=rigid"], ["accuracy.structure=solid"]], ids=["none", "solid"]
)
def test_position_that_cannot_be_solved_is_told_without_a_number(settings, monkeypatch):
    """None from the solver, or a solid that would have to be condensed anew."""
    loads = np.array([[0, 1.0, 2, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]] * 2)
    bearing = SimpleNamespace(azimuths=2 * np.pi * (np.arange(14) - 2) / 14)
    balance = SimpleNamespace(roller=SimpleNamespace(bearing=bearing))
    state: Any = SimpleNamespace(loads=loads, life=1.0, balance=balance)
    rings: Any = SimpleNamespace(solved_in_full=False)
    monkeypatch.setattr(passage, "_half_a_pitch_further", lambda *_: None)
    (note,) = passage.notes(read_case(CASE, settings), None, rings, state)  # pyright: ignore
    assert "is not solved here" in note.text


@pytest.mark.parametrize("count", ["0", "1", "1001"])
def test_positions_are_two_or_more(count):
    with pytest.raises(BadCase, match="roller_positions"):
        read_case(CASE, [f"operation.roller_positions={count}"])


def test_the_stiffness_that_is_told_half_a_pitch_further_is_that_of_a_run_there():
    case = Path(PAPER).parent / "catalogue" / "nu210.toml"
    (note,) = [
        each["text"] for each in flexbearing.run(case).attributes["notes"] if "half a pitch" in each["text"]
    ]
    there = flexbearing.run(case, ["bearing.first_roller_azimuth=11.25 deg"])
    across, along = (float(there[f"total_stiffness_{axis} [kN/mm]"].number) for axis in ("yy", "zz"))
    assert f"the radial stiffness along y and z {across:,.4g} and {along:,.4g} instead of" in note
