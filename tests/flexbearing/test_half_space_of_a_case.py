"""bearing.contact = "half_space": from the case file to datasets, summary, notes and page."""

import json

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.coupling import LinearPair
from flexbearing.report.output import text, write_figures
from flexbearing.report.roller.figures import pictures
from flexbearing.runs import half_space, roller_findings
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic.errors import NotSolved
from quasidynamic.outcome import whole_roller
from tests.places import CONFIGS

PLAIN = CONFIGS / "nu209.toml"
WHOLE = ['bearing.contact="half_space"']
TILTED = ["operation.misalignment=3 arcmin"]
PROFILED = ["bearing.roller.profile=logarithmic", "bearing.roller.drop=3.5 um"]


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    folder = tmp_path_factory.mktemp("run")
    return tuple(
        flexbearing.run(PLAIN, [*settings, *TILTED], output=folder / f"{number}.h5")
        for number, settings in enumerate((WHOLE, []))
    )


def codes(result):
    return {note["code"] for note in result.summary()["notes"]}


def test_pressure_and_life_are_those_of_the_whole_roller_and_loads_those_of_slices(runs):
    whole, sliced = (run.rigid for run in runs)
    assert whole["inner_slice_load"] == approx(sliced["inner_slice_load"], rel=1e-12)
    assert whole["sliced_life"] == approx(sliced["life_L10"], rel=1e-12)
    assert whole["sliced_peak_pressure"] == approx(sliced["peak_pressure"], rel=1e-12)
    assert whole["peak_pressure"] == approx(whole["whole_roller_pressure"].max(axis=(1, 2)), rel=1e-12)
    assert abs(whole["life_L10"] / whole["sliced_life"] - 1) > 1e-3
    assert "whole_roller_pressure" not in sliced


def test_stored_pressure_carries_the_load_of_the_roller(runs):
    block = runs[0].rigid
    cell = np.diff(block["whole_roller_position"])[0]
    roller = int(block["whole_roller"])
    loads = [block["inner_load"][roller], block["outer_load"][roller]]
    assert block["whole_roller_line_load"].sum(axis=1) * cell == approx(loads, rel=1e-6)


def test_summary_page_and_notes_tell_of_the_whole_roller(runs):
    numbers = json.loads(json.dumps(runs[0].summary()))["rigid"]
    assert len(numbers["sliced_peak_pressure_MPa"]) == 2
    assert numbers["sliced_life_Mrev"] == approx(float(runs[0].rigid["sliced_life"]) / 1e6, rel=1e-12)
    assert "by slices alone, inner" in text(runs[0])
    assert "by slices alone" not in text(runs[1])
    assert "whole-roller" in codes(runs[0])
    assert "whole-roller" not in codes(runs[1])


@pytest.mark.slow
def test_picture_shows_both_contacts_beside_their_slices(runs, tmp_path):
    names = [path.name for path in write_figures(runs[0], tmp_path)]
    assert "0_whole_roller.png" in names
    figure = pictures(runs[0])["whole_roller"]
    line = figure.axes[1].get_lines()[-1]
    assert line.get_ydata() == approx(runs[0].rigid["whole_roller_line_load"][0] / 1e3, rel=1e-12)
    assert "whole_roller" not in pictures(runs[1])


def row_of(case, state):
    return SolvedRows.of(case, roller_bearing.bearing(case), state, LinearPair(None, None))


@pytest.mark.slow
def test_modified_life_starts_from_the_whole_roller():
    settings = [*TILTED, "life.capacity=iso281"]
    case = read_case(PLAIN, [*WHOLE, *settings])
    state = roller_bearing.bearing(case).solve()
    whole, _ = half_space.most_loaded(case, state)
    assert whole is not None
    rated, sliced = (row_of(each, state).life[0] for each in (case, read_case(PLAIN, settings)))
    assert rated is not None
    assert sliced is not None
    assert rated.basic == approx(whole.life, rel=1e-12)
    assert rated.modified / sliced.modified == approx(whole.life / state.life, rel=1e-2)


SHALLOW = ["bearing.roller.profile=crowned", "bearing.roller.straight_length=0 mm",
           "bearing.roller.crown_radius=1 m"]  # fmt: skip


def most_loaded(settings):
    """Whole roller of a case with those of its notes that are about its ends."""
    case = read_case(PLAIN, [*WHOLE, *settings])
    whole, told = half_space.most_loaded(case, roller_bearing.bearing(case).solve())
    assert whole is not None
    assert told[0].code == "whole-roller"
    return whole, told[1:]


@pytest.mark.sampled(2)
@pytest.mark.parametrize("tilt", [[], TILTED], ids=["aligned", "tilted"])
def test_largest_pressure_in_the_cells_at_a_sharp_end_is_called_no_number(tilt):
    whole, (note,) = most_loaded([*tilt, "bearing.roller.profile=straight"])
    ends = whole.pressure[:, :, [0, -1]].max(axis=(1, 2))
    assert ends == approx(whole.peak_pressure, rel=1e-12)
    assert (note.grade, note.code) == ("outside validity", "sharp-roller-end")
    assert "not usable" in note.text
    for pressure in (*whole.peak_pressure, *whole.coarser_peak_pressure):
        assert f"{pressure / 1e9:.3g} GPa" in note.text
    assert np.all(whole.peak_pressure > 1.25 * whole.coarser_peak_pressure)  # without bound


def test_contact_that_reaches_an_end_with_its_peak_elsewhere_has_a_peak():
    whole, (note,) = most_loaded([*SHALLOW, "operation.radial_load=12 kN"])
    assert (note.grade, note.code) == ("outside validity", "sharp-roller-end")
    assert "the largest is elsewhere" in note.text
    assert whole.peak_pressure == approx(whole.coarser_peak_pressure, rel=0.02)


def test_ends_that_are_kept_apart_need_no_note():
    whole, told = most_loaded([*SHALLOW, "operation.radial_load=6 kN"])
    assert told == ()
    assert not whole.at_ends


@pytest.mark.parametrize(
    ("profile", "of_slices"),
    [(["bearing.roller.profile=straight"], True), ([*SHALLOW, "operation.radial_load=12 kN"], False)],
    ids=["peak at the end", "peak elsewhere"],
)
def test_danger_of_pressure_is_that_of_slices_where_the_peak_is_no_number(profile, of_slices):
    case = read_case(PLAIN, [*WHOLE, *profile])
    state = roller_bearing.bearing(case).solve()
    whole, _ = half_space.most_loaded(case, state)
    assert whole is not None
    pressures = roller_findings.values_of_dangers(row_of(case, state))["contact_pressure"].values()
    assert max(each[0] for each in pressures) == (state if of_slices else whole).peak_pressure.max()


def test_roller_that_is_not_solved_leaves_the_slices_with_a_note(monkeypatch):
    def fails(state):
        raise NotSolved("contact pressure: no step", "stalled")

    monkeypatch.setattr(whole_roller, "whole_roller", fails)
    case = read_case(PLAIN, WHOLE)
    whole, (note,) = half_space.most_loaded(case, roller_bearing.bearing(case).solve())
    assert whole is None
    assert (note.grade, note.code) == ("outside validity", "no-whole-roller")


def test_edge_stress_of_the_standard_is_refused_beside_the_true_ends():
    with pytest.raises(BadCase, match=r"\[life\] edge_stress"):
        read_case(PLAIN, [*WHOLE, *PROFILED, "life.edge_stress=true", "accuracy.slices=30"])


def test_case_with_a_whole_roller_answers_a_study_like_its_own_run(runs):
    """Beside its like, apart from cases of slices."""
    from flexbearing.runs.side_by_side import solved_side_by_side

    cases = [read_case(PLAIN, [*WHOLE, *TILTED]), read_case(PLAIN, TILTED)]
    assert [solved.places for solved in solved_side_by_side(cases, {""})] == [[0], [1]]
