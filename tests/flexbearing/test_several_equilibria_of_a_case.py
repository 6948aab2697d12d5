"""Several equilibria by cold oil, from the case file to the file, the note and the page."""

import json

import pytest
from pytest import approx

import flexbearing
from flexbearing import __main__ as program
from flexbearing.runs.several import SeveralEquilibria
from tests.bearings import paper_bearing
from tests.cold_oil import PAPER, RIGID, cold_case, settings

THICK_RING = ("inner.kind=rigid", "outer.kind=ring", "outer.thickness=15 mm", "accuracy.structure=beam")


@pytest.fixture(scope="module", params=[13.0, pytest.param(13.5, marks=pytest.mark.slow)])
def cold(request, tmp_path_factory):
    """Runs that ended half a degree apart in different states: 533 N and 2534 Mrev, 552 N and 2208 Mrev."""
    folder = tmp_path_factory.mktemp("cold")
    return flexbearing.run(cold_case(folder), [*RIGID, *settings(request.param)], output=folder / "r.h5")


def note_on_several(result):
    (note,) = [note for note in result.attributes["notes"] if note["code"] == "several-equilibria"]
    return note


@pytest.mark.slow
def test_two_answers_half_a_degree_apart_are_both_told_as_one_of_several(cold):
    assert note_on_several(cold)["grade"] == "danger"
    found = cold.attributes["equilibria"]["rigid"]
    computed = found["computed"]
    assert computed["largest_inner_load_N"] == approx(cold.rigid["inner_load"].max(), rel=1e-9)
    assert 1e6 * computed["life_L10_Mrev"] == approx(float(cold.rigid["life_L10"]), rel=1e-9)
    assert computed["power_loss_W"] == approx(float(cold.rigid["driving_power"]), rel=1e-6)
    known = [computed, *found["others"]]
    loads = [state["largest_inner_load_N"] for state in known]
    assert (min(loads), max(loads)) == (approx(533, abs=3), approx(552, abs=3))
    assert len({state["loaded_rollers"] for state in known}) > 1
    lives = [state["life_L10_Mrev"] for state in known]
    assert (min(lives), max(lives)) == (approx(2208, rel=0.02), approx(2530, rel=0.02))


@pytest.mark.slow
def test_rollers_that_pass_a_pitch_reach_one_state_from_either_answer(cold):
    """547.6 N and 2249 Mrev at 13 degC in the time domain, see tests/reference/test_moving_rollers.py."""
    passing = cold.attributes["equilibria"]["rigid"]["after_passing_pitches"]
    assert passing["settled"]
    assert passing["largest_inner_load_N"] == approx(547.6, rel=5e-3)
    assert passing["life_L10_Mrev"] == approx(2249, rel=1e-2)


def test_spread_and_passing_state_stand_in_note_page_and_json(cold, capsys):
    text = note_on_several(cold)["text"]
    passing = cold.attributes["equilibria"]["rigid"]["after_passing_pitches"]
    for word in (
        "rigid raceways",
        "Mrev",
        "N m",
        f"{passing['largest_inner_load_N']:.1f} N",
    ):
        assert word in text
    assert cold.summary()["equilibria"] == cold.attributes["equilibria"]
    assert program.command(["summary", str(cold.path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["equilibria"]["rigid"]["others"]
    assert program.command(["summary", str(cold.path)]) == 0
    page = capsys.readouterr().out
    assert "\nusable     No" in page
    assert "\ndanger     several equilibria between rigid raceways" in page
    assert program.command(["summary", str(cold.path), "--all"]) == 0
    page = capsys.readouterr().out
    assert page.startswith("DANGER: several equilibria between rigid raceways")
    assert "several equilibria\n" in page
    assert f"{passing['largest_inner_load_N']:,.0f}" in page


def test_a_bearing_with_thin_films_is_told_nothing():
    result = flexbearing.run(PAPER, RIGID)
    assert "equilibria" not in result.attributes
    assert "several equilibria" not in " ".join(note["text"] for note in result.attributes["notes"])


def test_what_leads_back_to_the_end_state_is_an_information_without_numbers():
    led_back = SeveralEquilibria("flexible raceways", paper_bearing().solve(), True, (), led_back=2).note()
    assert led_back.grade == "information"
    assert "no other equilibrium was found: 2 that exist" in led_back.text


def test_a_danger_is_a_spread_of_the_answer_itself_that_misleads():
    """Not of states on the way to it or that hardly differ; an answer that is not stable always is one."""
    state = paper_bearing().solve()
    alike, heavier = state, paper_bearing(load=22000.0).solve()
    grades = {
        "another life": SeveralEquilibria("rigid raceways", state, True, (heavier,)).note().grade,
        "on the way": SeveralEquilibria("rigid raceways", state, True, (heavier,)).note(answer=False).grade,
        "alike": SeveralEquilibria("rigid raceways", state, True, (alike,)).note().grade,
        "not stable": SeveralEquilibria("rigid raceways", state, False, (alike,)).note().grade,
    }
    assert grades == {
        "another life": "danger", "on the way": "information", "alike": "information", "not stable": "danger",
    }  # fmt: skip
    assert "not stable" in SeveralEquilibria("rigid raceways", state, False, (alike,)).note().text


@pytest.mark.slow
def test_end_state_between_flexible_raceways_is_examined_for_itself(tmp_path):
    """A thick ring keeps several; those between rigid raceways, on the way to it, are no danger then."""
    result = flexbearing.run(cold_case(tmp_path), [*THICK_RING, *settings(13.0)], output=tmp_path / "r.h5")
    notes = [note for note in result.attributes["notes"] if note["code"] == "several-equilibria"]
    assert len(notes) == 2
    dangers = [note["text"] for note in notes if note["grade"] == "danger"]
    assert len(dangers) == 1
    assert "between flexible raceways" in dangers[0]
    found = result.attributes["equilibria"]["flexible"]
    assert found["raceways"] == "flexible raceways"
    largest = result.flexible["inner_load"].max()
    assert found["computed"]["largest_inner_load_N"] == approx(largest, rel=1e-9)
    assert all(abs(other["largest_inner_load_N"] / largest - 1) > 1e-3 for other in found["others"])
