"""What runs say of the peak pressure of slices: where it is that of the contact, and where not."""

import pytest
from pytest import approx

import flexbearing
from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.coupling import LinearPair
from flexbearing.findings.row import of_records
from flexbearing.runs import notes, roller_findings
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic.errors import NotSolved
from quasidynamic.outcome import sliced_peak as check
from quasidynamic.outcome.sliced_peak import corner_rise
from tests.flexbearing.noted import keys
from tests.places import CONFIGS

PLAIN = CONFIGS / "nu209.toml"
HEAVY = ["operation.radial_load=25 kN", "operation.misalignment=8 arcmin"]
TILTED = ["operation.radial_load=4 kN", "operation.misalignment=12 arcmin"]
STRAIGHT = ["bearing.roller.profile=straight"]
CORNER = ["bearing.roller.profile=crowned", "bearing.roller.straight_length=5 mm",
          "bearing.roller.crown_radius=0.5 m"]  # fmt: skip
TANGENT = ["bearing.roller.profile=tangent_crowned", *CORNER[1:]]
SHALLOW = ["bearing.roller.profile=crowned", "bearing.roller.straight_length=0 mm",
           "bearing.roller.crown_radius=1.2 m", "operation.radial_load=12 kN"]  # fmt: skip
SHORT_DROP = ["operation.radial_load=9 kN", "operation.misalignment=3 arcmin", "bearing.roller.drop=0.5 um"]
WHOLE = ['bearing.contact="half_space"']


def solved(settings):
    case = read_case(PLAIN, settings)
    model = roller_bearing.bearing(case)
    rows = SolvedRows.of(case, model, model.solve(), LinearPair(None, None))
    return rows, notes.of_sliced_peak(rows)


def told(settings):
    rows, notes = solved(settings)
    return rows.each[0], notes


def test_logarithmic_rollers_under_usual_loads_need_no_word():
    assert told([])[1] == ()
    assert told(["operation.misalignment=4 arcmin"])[1] == ()


def test_peak_that_slices_miss_is_told_with_that_of_the_contact():
    state, (note,) = told(TILTED)
    assert (note.grade, note.code) == ("outside validity", "sliced-peak")
    peak = check.sliced_peak(state)
    assert not peak.at_end
    assert peak.error < -0.05
    assert peak.pressure == approx(state.peak_pressure.max(), rel=1e-12)
    for words in (f"{peak.pressure / 1e9:.3g} GPa", f"{peak.whole.peak_pressure / 1e9:.3g} GPa", "below"):
        assert words in note.text
    assert ("bearing.contact", "half_space") in note.keys


def test_peak_with_the_edge_stress_of_the_standard_is_judged_as_it_is_told():
    """Its factor is made for the life: heavy aligned rollers seem to be pressed at their ends."""
    edge = ["life.edge_stress=true", "accuracy.slices=30", "operation.radial_load=25 kN"]
    result = flexbearing.run(PLAIN, edge)
    assert keys(result, "pressed-end") == {"bearing.contact": "half_space"}


@pytest.mark.parametrize("settings", [STRAIGHT, HEAVY, SHORT_DROP], ids=["straight", "heavy", "short drop"])
def test_pressed_end_is_a_finding_without_a_whole_contact(settings, monkeypatch):
    monkeypatch.setattr(check, "whole_contact", None)  # would raise
    rows, notes = solved(settings)
    assert rows.sliced_peak_error[0] > 0.09
    assert notes == ()
    (found,) = roller_findings.of_rows(rows)
    assert [(each.grade, each.code) for each in of_records(found)] == [("outside validity", "pressed-end")]


@pytest.mark.parametrize("settings", [[], TILTED, ["operation.misalignment=4 arcmin"]])
def test_the_line_of_loads_has_the_error_of_the_whole_contact(settings):
    rows, _ = solved(settings)
    whole = check.sliced_peak(rows.each[0])
    assert rows.sliced_peak_error[0] == approx(abs(whole.error), abs=0.01)


def test_sharp_end_is_told_of_slices():
    """Ends that the slices hardly press."""
    _, (note,) = told(SHALLOW)
    assert (note.grade, note.code) == ("outside validity", "sharp-roller-end")
    assert "of the slices leave out" in note.text


def test_profile_of_a_raceway_keeps_the_ends_apart_as_well():
    raceways = [f"bearing.{race}_raceway.{key}" for race in ("inner", "outer")
                for key in ("profile=logarithmic", "drop=3.5 um")]  # fmt: skip
    assert told([*STRAIGHT, *raceways])[1] == ()


@pytest.mark.parametrize("contact", [[], WHOLE], ids=["slices", "half_space"])
def test_corner_of_a_profile_is_told_whatever_solves_the_contact(contact):
    state, notes = told([*CORNER, *contact])
    note = notes[0]
    assert note.keys == (("bearing.roller.profile", "tangent_crowned"),)
    assert corner_rise(state) > 0.05
    smooth, others = told([*TANGENT, *contact])
    assert "profile-corner" not in {each.code for each in others}
    assert corner_rise(smooth) == 0.0


def test_corner_raises_the_pressure_of_smaller_cells_as_told():
    """By its share for every tenth of the size, found on cells that end at the corner."""
    from quasidynamic.outcome.whole_roller import whole_contact

    state, _ = told([*CORNER[:1], "bearing.roller.straight_length=4.8005 mm", *CORNER[2:]])
    coarse, fine = (whole_contact(state, 0, 0, (16, n)).peak_pressure for n in (256, 1024))
    rise = corner_rise(state) * state.peak_pressure.min()  # its share is largest on the outer one
    assert (fine - coarse) / rise == approx(0.602, rel=0.05)  # log10 of 4


def test_half_spaces_asked_for_need_no_check_of_slices():
    assert told([*HEAVY, *WHOLE])[1] == ()


def test_contact_that_is_not_solved_is_told(monkeypatch):
    def fails(*_):
        raise NotSolved("contact pressure: no step", "stalled")

    monkeypatch.setattr(notes, "sliced_peak", fails)
    _, (note,) = told([])
    assert (note.grade, note.code) == ("outside validity", "sliced-peak")
    assert "could not be checked" in note.text


def test_result_carries_the_note_of_its_answer_once():
    result = flexbearing.run(PLAIN, STRAIGHT)
    codes = [note["code"] for note in result.summary()["notes"]]
    assert codes.count("pressed-end") == 1
