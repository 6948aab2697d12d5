"""The scatter of a sampled study: its tables, what people read of them, and what a kill leaves."""

import csv
import re
from io import StringIO

import numpy as np
import pytest
from pytest import approx

from flexbearing.api import read_case, sensitivities
from flexbearing.pages.make import report
from flexbearing.report.html.scatter import SUBJECTS, TEXTS
from flexbearing.results import BadResult
from flexbearing.sampling.distribution import normal, uniform
from flexbearing.sampling.linear import Linear
from flexbearing.sampling.points import Design
from flexbearing.studies import messages
from flexbearing.studies.file.sampled import Drawn, Factor
from flexbearing.studies.prepare import compute, prepare_source
from flexbearing.studies.table import Column
from flexbearing.studies.table.scatter import Scatter
from tests.flexbearing.hostile_cases import CONFIGS
from tests.flexbearing.html_pages import Page

STUDY = f"""
case = "{CONFIGS / "nu209.toml"}"
name = "scatter"
[sample]
method = "sobol_indices"
count = 32
seed = 4
"operation.radial_load" = "uniform 9.9 kN, 10.1 kN"
"bearing.clearance" = "normal 30 um, 2 um"
"bearing.form_error.roller_diameters" = "ROLLERS x normal 0 um, 0.2 um"
"bearing.form_error.outer.waves" = 2
"bearing.form_error.outer.amplitude" = "0.5 um"
"bearing.form_error.outer.crest" = "uniform 0 deg, 180 deg"
[collect]
life = "life_L10 [h]"
load = "max_roller_load [N]"
slip = "cage_slip [%]"
"""
TABLES = "percentiles", "shares", "histogram"


@pytest.fixture(scope="module")
def study(tmp_path_factory):
    folder = tmp_path_factory.mktemp("scatter")
    rollers = read_case(CONFIGS / "nu209.toml").bearing.rollers
    file = folder / "study.toml"
    file.write_text(STUDY.replace("ROLLERS", str(rollers)), "utf-8")
    prepared = prepare_source(file)
    return folder, prepared, compute(prepared, folder / "whole")


def rows(text):
    return list(csv.DictReader(StringIO(text)))


@pytest.mark.slow
def test_every_input_and_output_has_its_shares(study):
    folder, prepared, table = study
    outputs, shares, bins = (each.rows for each in table.scatter)
    assert len(table) == 32 * (4 + 2)
    assert [row["output"] for row in outputs] == ["life", "load", "slip"]
    assert len(shares) == 3 * len(prepared.study.drawn.factors) == 3 * 4
    assert all(row["rows"] == 2 * 32 and row["unsolved"] == 0 for row in outputs)
    assert sum(row["rows"] for row in bins if row["output"] == "load") == 2 * 32
    for name in TABLES:
        assert rows((folder / "whole" / f"scatter_{name}.csv").read_text("utf-8"))
    assert (folder / "whole" / "scatter_scatter.png").stat().st_size > 10_000


def test_percentiles_are_those_of_the_independent_rows(study):
    """A and B of every base point; the others change one input of A and repeat the rest."""
    *_, table = study
    places = [row for row in range(len(table)) if row % 6 < 2]
    load = np.array(table["load [N]"].values)[places]
    row = next(row for row in table.scatter[0].rows if row["output"] == "load")
    assert row["mean"] == approx(load.mean(), rel=1e-12)
    assert row["P50_low"] <= np.median(load) <= row["P50_high"]
    assert (load < row["P10"]).mean() == approx(0.1, abs=0.02)


def test_linear_prediction_is_that_of_the_derivatives_at_the_means(study):
    """With derivatives by the diameter of each roller."""
    *_, table = study
    keys = ["operation.radial_load", "bearing.clearance", "bearing.form_error.roller_diameters"]
    rollers = read_case(CONFIGS / "nu209.toml").bearing.rollers
    settings = [
        "operation.radial_load=10 kN", "bearing.clearance=30 um", "bearing.form_error.outer.waves=2",
        "bearing.form_error.outer.amplitude=0.5 um", "bearing.form_error.outer.crest=90 deg",
        f"bearing.form_error.roller_diameters={['0 um'] * rollers}",
    ]  # fmt: skip
    found = sensitivities(read_case(CONFIGS / "nu209.toml", settings), ["max_roller_load [N]"], keys)
    slopes = {key.path: slope / key.size for key, slope in zip(found.keys, found.slopes[0], strict=True)}
    variances = {
        "operation.radial_load": (slopes["operation.radial_load"] * 200 / np.sqrt(12)) ** 2,
        "bearing.clearance": (slopes["bearing.clearance"] * 2e-6) ** 2,
        keys[2]: sum((slopes[f"{keys[2]}.{number}"] * 2e-7) ** 2 for number in range(1, rollers + 1)),
    }
    shares = {row["key"]: row["linear_share"] for row in table.scatter[1].rows if row["output"] == "load"}
    for key in keys[1:]:
        ratio = variances[key] / variances[keys[0]]
        assert shares[key] / shares[keys[0]] == approx(ratio, rel=1e-6)
    assert table.scatter[0].rows[1]["linear_mean"] == approx(found.outputs[0].value, rel=1e-9)
    assert 60 < table.scatter[0].rows[1]["linear_explains [%]"] < 100  # the largest of several loads bends


@pytest.mark.slow
def test_a_study_that_was_killed_ends_with_the_same_scatter(study):
    folder, prepared, _ = study
    (folder / "torn").mkdir()
    lines = (folder / "whole" / "scatter.journal.jsonl").read_bytes().splitlines(keepends=True)
    torn = b"".join(lines[: len(lines) // 2]) + lines[-1][:40]
    (folder / "torn" / "scatter.journal.jsonl").write_bytes(torn)
    compute(prepared, folder / "torn")
    for name in TABLES:
        both = [(folder / each / f"scatter_{name}.csv").read_text("utf-8") for each in ("whole", "torn")]
        numbers = [[float(n) for n in re.findall(r"(?<=,)-?[0-9.e-]+", text)] for text in both]
        assert numbers[0] == approx(numbers[1], rel=1e-9, abs=1e-12)


def test_the_end_of_the_command_names_what_to_tighten_first(study):
    folder, prepared, table = study
    words = messages.end(prepared, table, folder / "whole")
    assert re.search(r"\nload N: P10 [\d.]+ \([\d.]+ to [\d.]+\), P50 .*; linear: P10 .* explains \d", words)
    assert words.count("tighten first: ") == 3
    assert "scatter_scatter.png" in words


def test_the_report_shows_the_scatter_with_the_numbers_of_its_tables(study, tmp_path):
    folder, *_ = study
    (written,) = report(folder / "whole" / "scatter.csv", tmp_path / "scatter.html")
    page = Page(written.read_text("utf-8"))
    tables = {name: rows((folder / "whole" / f"scatter_{name}.csv").read_text("utf-8")) for name in TABLES}
    cells = [(given["data-of"], text) for given, text in page.cells if given["data-of"].startswith(TABLES)]
    assert len(cells) == 3 * 16 + 12 * 10 + 3
    for place, text in cells:
        name, row, heading = place.split("/")
        stored = tables[name][int(row)][heading]
        if stored:
            assert float(text.replace(",", "")) == approx(float(stored), rel=1e-3)
    assert sum("lines at P10" in text for text in page.text) == 3
    assert not any(
        "roller_diameters" in str(figure["layout"]) for figure in page.figures
    )  # a list is no axis
    assert any("... (" in text for text in page.text)  # and is cut short in its cells


def two_inputs(method, count):
    """Two drawn keys at the points of a design, and their numbers."""
    drawn = Drawn((Factor("a", uniform(0, 1)), Factor("b", normal(0, 1))), Design(method, count, 1))
    points = drawn.design.points([1, 1])[:]
    numbers = [
        each.distribution.quantile(column) for each, column in zip(drawn.factors, points.T, strict=True)
    ]
    return drawn, np.array(numbers).T


def test_a_scatter_with_an_output_twice_is_refused(study, tmp_path):
    folder, _, table = study
    for file in (folder / "whole").glob(f"{table.name}*.csv"):
        (tmp_path / file.name).write_text(file.read_text("utf-8"), "utf-8")
    shares = tmp_path / f"{table.name}_shares.csv"
    lines = shares.read_text("utf-8").splitlines()
    shares.write_text("\n".join([*lines, lines[-1]]) + "\n", "utf-8")
    with pytest.raises(BadResult, match="several rows of"):
        report(tmp_path / f"{table.name}.csv", tmp_path / "r.html")


@pytest.mark.parametrize("part", TABLES)
def test_empty_cells_of_a_scatter_are_gaps_of_its_figures(part, study, tmp_path):
    folder, _, table = study
    for file in (folder / "whole").glob(f"{table.name}*.csv"):
        (tmp_path / file.name).write_text(file.read_text("utf-8"), "utf-8")
    file = tmp_path / f"{table.name}_{part}.csv"
    found = rows(file.read_text("utf-8"))
    kept = {*TEXTS, *SUBJECTS}
    lines = [",".join(row[name] if name in kept else "" for name in row) for row in found]
    file.write_text("\n".join([",".join(found[0]), *lines]) + "\n", "utf-8")
    (written,) = report(tmp_path / f"{table.name}.csv", tmp_path / "r.html")
    assert Page(written.read_text("utf-8")).figures


def test_rows_without_a_number_are_counted_and_constant_outputs_left_out():
    drawn, numbers = two_inputs("sobol_indices", 64)
    life = numbers @ [3.0, 0.1]
    life[[0, 9]] = np.nan  # A of the first base point, B of the third
    outputs = Column("life", "h", tuple(life)), Column("same", "N", tuple(2 + 1e-13 * numbers[:, 0]))
    percentiles, shares, _ = (each.rows for each in Scatter("toy", drawn, numbers, outputs).tables())
    assert [(row["output"], row["rows"], row["unsolved"]) for row in percentiles] == [("life", 126, 2)]
    assert [row["points"] for row in shares] == [62, 62]
    assert np.isnan(percentiles[0]["linear_P10"])


def test_half_the_scatter_of_the_only_cause_halves_that_of_the_output():
    drawn, numbers = two_inputs("sobol", 4096)
    outputs = (Column("life", "h", tuple(numbers @ [0.0, 5.0])),)
    _, shares, _ = (each.rows for each in Scatter("toy", drawn, numbers, outputs).tables())
    assert [row["by"] for row in shares] == ["rows", "rows"]
    assert shares[0]["narrower [%]"] == approx(0, abs=1)
    assert shares[1]["narrower [%]"] == approx(50, abs=1)


def test_a_linear_prediction_that_no_float_holds_is_left_out_with_a_word():
    drawn, numbers = two_inputs("sobol", 64)
    life = np.exp(numbers @ [0.0, 1.0])
    steep = Linear(1.0, np.array([0.0, 1e4]), np.full(2, 0.5), np.full(2, 0.3))
    scatter = Scatter("toy", drawn, numbers, (Column("life", "h", tuple(life)),), linear={"life": steep})
    (row,) = next(each.rows for each in scatter.tables())
    assert row["linear_of"] == "logarithm: beyond the range of numbers"
    assert np.isnan([row[name] for name in ("linear_mean", "linear_deviation", "linear_P10")]).all()
    assert np.isfinite([row["mean"], row["P10"], row["P90"]]).all()
