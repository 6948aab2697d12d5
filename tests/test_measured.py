"""Measurements: predictions first, printed values in later commits, one rule for the verdict."""

import shutil
import subprocess
from dataclasses import replace
from math import inf

import numpy as np
import pytest
from pytest import approx

from evidence import sources
from evidence.measured.declared import Prediction, Printed
from evidence.measured.draws import computed, digest, predicted
from evidence.measured.experiments import EXPERIMENTS
from evidence.measured.page import page
from evidence.measured.stored import (
    EVERY,
    changed,
    moved_rows,
    prediction_file,
    printed,
    registered,
    rows_of,
    value_file,
)
from evidence.measured.verdict import verdict
from evidence.sources import loaded, touched
from evidence.stored import DOCS, ROOT

EACH = pytest.mark.parametrize("experiment", EXPERIMENTS.values(), ids=EXPERIMENTS.keys())


@EACH
def test_page_is_what_its_declaration_and_its_files_say(experiment):
    assert (DOCS / f"{experiment.name}.md").read_text() == page(
        experiment, registered(experiment), printed(experiment)
    )


@EACH
def test_every_input_has_a_reason_and_every_page_what_would_refute_it(experiment):
    assert experiment.refuted.endswith(".")
    assert all(each.reason and each.low < each.high for each in experiment.inputs)
    assert printed(experiment) or experiment.needed


@EACH
def test_registered_prediction_is_of_this_case_and_these_inputs(experiment):
    assert registered(experiment).digest == digest(experiment)


@EACH
def test_registered_band_is_that_of_its_stored_rows(experiment):
    assert (
        changed(experiment, registered(experiment), predicted(experiment, rows_of(experiment), blind=True))
        == []
    )


@pytest.fixture(scope="module")
def to_check():
    return touched(EXPERIMENTS)


@pytest.mark.slow
@EACH
def test_the_program_still_gives_every_fourth_row(experiment, to_check):
    """Of predictions whose files changed since `python -m evidence --check` passed."""
    if experiment.name not in to_check:
        pytest.skip("computed from the same files before")
    assert moved_rows(experiment, computed(experiment, EVERY)) == []


def test_a_changed_module_touches_the_predictions_that_were_computed_from_it(tmp_path, monkeypatch):
    now = loaded()
    module = "quasidynamic/outcome/life.py"
    assert sources.digest_of(module) == digest_of_text(tmp_path, monkeypatch, "# said\n", module)
    assert sources.digest_of(module) != digest_of_text(tmp_path, monkeypatch, "\nMORE = 1\n", module)
    monkeypatch.setattr(sources, "CHECKED", tmp_path / "checked.json")
    assert touched(["a"]) == ["a"]
    sources.write({"a": now, "b": {**now, module: "others"}})
    sources.write({"c": {"quasidynamic/gone.py": "before"}})
    assert touched("abc") == ["b", "c"]


def digest_of_text(folder, monkeypatch, more, module):
    """Digest of a module with more text below it."""
    file = folder / module
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text((ROOT / module).read_text() + more)
    with monkeypatch.context() as patched:
        patched.setattr(sources, "ROOT", folder)
        return sources.digest_of(module)


def test_a_row_that_moved_or_is_no_longer_solved_is_reported():
    experiment = EXPERIMENTS["planet-helical-couple"]
    rows = rows_of(experiment)[::EVERY]
    assert moved_rows(experiment, rows) == []
    may = experiment.moves * registered(experiment).width + 1e-3 * rows[1]
    less, more, first = (may * np.eye(len(rows))[1] * share for share in (0.9, 1.1, np.nan))
    assert moved_rows(experiment, rows + less) == []
    assert len(moved_rows(experiment, rows + more)) == 1
    assert len(moved_rows(experiment, rows + first)) == len(rows)


def test_no_prediction_and_no_value_is_left_over():
    assert {path.stem for path in (DOCS / "predictions").glob("*")} == set(EXPERIMENTS)
    assert {path.stem for path in (DOCS / "rows").glob("*")} == set(EXPERIMENTS)
    assert {path.stem for path in (DOCS / "values").glob("*")} <= set(EXPERIMENTS)


def test_nine_measurements_have_a_value_that_their_prediction_came_before():
    judged = [each for each in EXPERIMENTS.values() if printed(each) and registered(each).blind]
    assert len(judged) >= 9


def git(*arguments):
    return subprocess.run(["git", *arguments], cwd=ROOT, capture_output=True, text=True, check=False)


def has_history():
    return (
        shutil.which("git") is not None
        and git("rev-parse", "--is-shallow-repository").stdout.strip() == "false"
    )


def commits(path, *only):
    """Commits that changed a file, the last one first."""
    return git("log", "--format=%H", *only, "--", str(path)).stdout.split()


def is_older(prediction, value):
    """Whether the last commit of a prediction is an ancestor of the first one of its value."""
    return prediction != value and git("merge-base", "--is-ancestor", prediction, value).returncode == 0


@pytest.mark.skipif(not has_history(), reason="needs the commits of the repository")
@EACH
def test_blind_prediction_was_committed_before_the_value(experiment):
    added = commits(value_file(experiment), "--diff-filter=A")
    if added and registered(experiment).blind:
        assert is_older(commits(prediction_file(experiment))[0], added[-1])


BAND = Prediction(
    digest="", version="", date="", blind=True, rows=32, unsolved=0, low=1.0, median=1.5, high=2.0, shares={}
)


@pytest.mark.parametrize(
    ("low", "high", "changes", "expected"),
    [
        (2.0, 2.0, {}, "inside the band"),
        (2.5, 2.5, {}, "outside by 0.5 widths"),
        (0.0, 0.0, {}, "outside by 1 widths"),
        (-inf, 3.0, {}, "inside the band"),
        (-inf, 1.5, {}, "not decided: the band lies on both sides"),
        (3.0, inf, {}, "outside by 1 widths"),
        (2.0, 2.0, {"high": 2.1}, "inside the band, band wider than a factor of 2"),
        (0.0, 0.0, {"low": -1.0}, "inside the band, band wider than a factor of 2"),
        (2.0, 2.0, {"low": 1.0, "high": 1.0}, "outside a band without width"),
        (2.0, 2.0, {"blind": False}, "inside the band, registered after the value"),
    ],
)
def test_verdict_follows_from_band_and_value(low, high, changes, expected):
    value = Printed(text="", where="", low=low, high=high)
    assert verdict(replace(BAND, **changes), value) == expected


def test_a_band_without_a_value_is_no_agreement():
    assert verdict(BAND, None) == "prediction without a value"


def test_end_that_moved_by_more_than_the_page_allows_is_reported():
    experiment = EXPERIMENTS["planet-helical-couple"]
    may = experiment.moves * BAND.width + 1e-3 * BAND.high
    assert changed(experiment, BAND, replace(BAND, high=2.0 + 0.9 * may)) == []
    assert len(changed(experiment, BAND, replace(BAND, high=2.0 + 1.1 * may))) == 1
    assert len(changed(experiment, BAND, replace(BAND, digest="other"))) == 1


def test_couple_of_helical_teeth_over_the_row_distance():
    """358.6 kN on a pin and 9.29 kN m: at 100 mm a row carries 13 % more."""
    couple = EXPERIMENTS["planet-helical-couple"]
    (distance,) = couple.inputs
    at_100 = replace(couple, inputs=(replace(distance, low=100, high=100.0001),))
    assert predicted(at_100, computed(at_100), blind=True).median == approx(1.126, abs=1e-3)
