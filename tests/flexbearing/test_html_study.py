"""Reports of studies: every row and every point is that of the table."""

import csv
import json
from io import StringIO

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.case import BadCase
from flexbearing.files import as_csv
from flexbearing.findings.row import RowFinding, information, written
from flexbearing.inputs import Unreadable
from flexbearing.pages.make import report
from flexbearing.report.html.parquet import sealed
from flexbearing.report.html.table import HANDED_OUT, MOST_ROWS, table_text
from flexbearing.results import BadResult
from tests.flexbearing.hostile_cases import CONFIGS
from tests.flexbearing.html_pages import Page, require_equal

STUDY = f"""
case = "{CONFIGS / "nu209.toml"}"
name = "sweep"
[over]
"bearing.clearance" = ["10 um", "30 um", "50 um"]
"operation.radial_load" = ["5 kN", "10 kN"]
[collect]
life = "life_L10 [h]"
load = "max_roller_load [kN]"
"""
DUTY = f"""
case = "{CONFIGS / "nu209.toml"}"
name = "cycle"
[duty]
time = ["20 %", "80 %"]
"operation.radial_load" = ["5 kN", "12 kN"]
"operation.inner_speed" = ["4000 rpm", "2000 rpm"]
required_life = "5000 h"
"""


@pytest.fixture(scope="module")
def tables(tmp_path_factory):
    folder = tmp_path_factory.mktemp("studies")
    for name, text in (("sweep", STUDY), ("cycle", DUTY)):
        (folder / f"{name}.toml").write_text(text, "utf-8")
        flexbearing.study(folder / f"{name}.toml", folder / name, jobs=1)
    return folder


class Rows:
    """Numbers of tables by their places, "rows/0/life [h]"."""

    def __init__(self, **files):
        self.rows = {
            name: list(csv.DictReader(StringIO(path.read_text("utf-8")))) for name, path in files.items()
        }

    def __call__(self, place):
        if place.startswith("ratio/"):
            value, base = map(self, place.removeprefix("ratio/").split(":"))
            return value / base
        table, row, heading = place.split("/", 2)
        text = self.rows[table][int(row)][heading]
        return float(text) if text else None


@pytest.mark.parametrize("units", ["metric", "imperial"])
def test_every_number_of_a_study_is_that_of_its_table(tables, tmp_path, units):
    (written,) = report(tables / "sweep", tmp_path / "sweep.html", units=units)
    page = Page(written.read_text("utf-8"))
    assert len(page.cells) == 6 * 5  # rows by keys, outputs and seconds
    require_equal(page.cells, Rows(rows=tables / "sweep" / "sweep.csv"))


def test_a_damaged_parquet_table_is_refused_before_pyarrow_reads_it(tables, tmp_path):
    """A byte changed anywhere: at some of them pyarrow ends the process."""
    whole = (tables / "sweep" / "sweep.parquet").read_bytes()
    damaged = tmp_path / "sweep.parquet"
    for place in np.linspace(0, len(whole) - 1, 400).astype(int):
        damaged.write_bytes(whole[:place] + bytes([whole[place] ^ 0x5A]) + whole[place + 1 :])
        with pytest.raises(Unreadable, match=r"is damaged|has no digest"):
            table_text(damaged)


def test_a_parquet_table_has_the_report_of_its_csv(tables, tmp_path):
    pytest.importorskip("pyarrow")
    pages = [
        report(tables / "sweep" / f"sweep.{form}", tmp_path / f"{form}.html")[0].read_text("utf-8")
        for form in ("csv", "parquet")
    ]
    assert pages[0] == pages[1].replace("sweep.parquet", "sweep.csv")


@pytest.mark.parametrize("form", ["csv", "parquet"])
def test_a_large_table_is_counted_whole_and_left_in_its_file(tmp_path, form):
    pyarrow = pytest.importorskip("pyarrow")
    count = HANDED_OUT + 1
    ends = {"status": ["converged"] * (count - 1) + ["error"], "message": [""] * (count - 1) + ["no =1+1"],
            "findings": [""] * count}  # fmt: skip
    loads = {"operation.radial_load [N]": np.arange(1.0, 1 + count), "life [h]": np.ones(count)}
    columns = loads | ends | {"seconds": np.ones(count)}
    place = tmp_path / f"large.{form}"
    if form == "csv":
        place.write_text(as_csv([[*columns], *zip(*columns.values(), strict=True)]))
    else:
        place.write_bytes(sealed(pyarrow.table(columns)))
    page = report(place)[0].read_text("utf-8")
    assert f"{count - 1} of {count} variants converged" in page
    assert f"row {count}: error: no =1+1" in page
    assert (
        f"The first {MOST_ROWS} of {count} rows are shown, here and in the figures; {place.name} has all"
        in page
    )
    assert 'id="download"' not in page


def test_arrays_of_a_study_are_refused_with_the_name_of_their_table(tables):
    with pytest.raises(BadCase, match=r"name the table beside it: sweep\.csv"):
        report(tables / "sweep" / "sweep.nc")


def test_figures_of_a_study_have_a_line_for_each_value_of_the_other_key(tables, tmp_path):
    (written,) = report(tables / "sweep", tmp_path / "sweep.html")
    rows = Rows(rows=tables / "sweep" / "sweep.csv")
    figures = [figure for figure in Page(written.read_text("utf-8")).figures]
    assert len(figures) == 2  # each output over the first key
    first = figures[0]
    assert [trace["name"] for trace in first["traces"]] == ["radial load 5000 N", "radial load 10000 N"]
    for figure in figures:
        for trace in figure["traces"]:
            stored = [rows(f"rows/{row - 1}/{trace['meta']}") for row in trace["customdata"]]
            assert trace["y"] == approx(np.array(stored), rel=1e-5)
            assert trace["x"] == sorted(trace["x"])


def test_a_large_table_shows_its_first_rows_and_says_so(tables, tmp_path, monkeypatch):
    from flexbearing.report.html import study

    monkeypatch.setattr(study, "MOST_ROWS", 4)
    (written,) = report(tables / "sweep", tmp_path / "sweep.html")
    page = Page(written.read_text("utf-8"))
    assert len(page.cells) == 4 * 5
    assert any("The first 4 of 6 rows are shown" in text for text in page.text)
    assert "6 variants" in "".join(page.text)


def test_of_many_duty_cycles_the_first_are_shown(tables, tmp_path, monkeypatch):
    from flexbearing.report.html import study

    monkeypatch.setattr(study, "MOST_ROWS", 3)
    (tmp_path / "cycle.csv").write_text((tables / "cycle" / "cycle.csv").read_text("utf-8"), "utf-8")
    head, row = (tables / "cycle" / "cycle_duty.csv").read_text("utf-8").splitlines()
    (tmp_path / "cycle_duty.csv").write_text("\n".join([head, *(5 * [row])]) + "\n", "utf-8")
    (written,) = report(tmp_path / "cycle.csv", tmp_path / "cycle.html")
    page = Page(written.read_text("utf-8"))
    assert {given["data-of"].split("/")[1] for given, _ in page.cells if "duty/" in given["data-of"]} == {
        *"012"
    }
    assert any("first 3 duty cycles" in text for text in page.text)


def test_lives_under_a_duty_cycle_stand_above_its_rows(tables, tmp_path):
    folder = tables / "cycle"
    (written,) = report(folder / "cycle.csv", tmp_path / "cycle.html")
    page = Page(written.read_text("utf-8"))
    require_equal(page.cells, Rows(rows=folder / "cycle.csv", duty=folder / "cycle_duty.csv"))
    assert any(given["data-of"] == "duty/0/life [h]" for given, _ in page.cells)


def test_a_duty_cycle_has_its_worst_row_and_its_life_over_the_required_one(tables, tmp_path):
    folder = tables / "cycle"
    (written,) = report(folder / "cycle.csv", tmp_path / "cycle.html")
    page, numbers = (
        Page(written.read_text("utf-8")),
        Rows(rows=folder / "cycle.csv", duty=folder / "cycle_duty.csv"),
    )
    (figure,) = page.figures  # keys that change together are no axes
    (bars,) = figure["traces"]
    stored = [numbers(f"rows/{row - 1}/damage_share [%]") for row in bars["customdata"]]
    assert bars["y"] == approx(stored, rel=1e-5)
    assert bars["y"] == sorted(bars["y"], reverse=True)
    shown = {given["data-of"]: text for given, text in page.shown_cells}
    ratio = numbers("duty/0/life [h]") / numbers("duty/0/required_life [h]")
    assert numbers("duty/0/required_life [h]") == approx(5000, rel=1e-12)
    (over,) = [float(text) for place, text in shown.items() if place.startswith("ratio/")]
    assert over == approx(ratio, rel=5e-3)
    assert f"Row {bars['customdata'][0]} is the worst" in "".join(page.shown)


def test_notes_of_rows_stand_once_with_the_range_of_their_values(tmp_path):
    """Found by their data: the message, which says the same in words, may be any text."""
    lives = [RowFinding("short-life", "danger", value=seconds, limit=3600.0) for seconds in (1044.0, 1080.0)]
    cells = [written([lives[0]]), written([information("seen", "seen")]), written([lives[1]])]
    rows = [("converged", "danger: life: 7 h", cell, 1) for cell in cells]
    place = tmp_path / "lives.csv"
    place.write_text(as_csv([["status", "message", "findings", "seconds"], *rows]))
    page = report(place)[0].read_text("utf-8")
    said = "danger: life after all factors: 0.29 to 0.3 h, at least 1 h (an hour, limit of this program): "
    assert f"rows 1, 3: {said}" in page
    assert "row 2: seen" in page


def test_a_table_without_findings_is_refused(tmp_path):
    """Of an earlier version: its dangers are words alone, and would be left out."""
    place = tmp_path / "old.csv"
    place.write_text("life [h],status,message,seconds\n1.0,converged,danger: life,1.0\n")
    with pytest.raises(BadResult, match="it has no rows with status, message, findings, seconds"):
        report(place)


def test_of_many_outputs_twelve_are_shown(tables, tmp_path, monkeypatch):
    from flexbearing.report.html import study

    monkeypatch.setattr(study, "FIGURES", 1)
    (written,) = report(tables / "sweep", tmp_path / "sweep.html")
    text = written.read_text("utf-8")
    assert (
        text.index('id="figure-over-0"') < text.index("1 further outputs") < text.index('id="figure-over-1"')
    )


def test_the_page_hands_out_the_table_itself(tables, tmp_path):
    (written,) = report(tables / "sweep", tmp_path / "sweep.html")
    download = json.loads(Page(written.read_text("utf-8")).scripts["download"])
    assert download == {"name": "sweep.csv", "text": (tables / "sweep" / "sweep.csv").read_text("utf-8")}


@pytest.mark.parametrize(
    ("content", "reason"),
    [("a,b\n1\n", "no table of a study"), ("", "no table of a study"), ("a\n1\n", "it has no rows")],
)
def test_other_tables_are_refused(tmp_path, content, reason):
    path = tmp_path / "other.csv"
    path.write_text(content, "utf-8")
    with pytest.raises(BadResult, match=reason):
        report(path)


def test_a_folder_with_several_tables_is_refused_by_their_names(tmp_path):
    for name in ("a.csv", "b.csv"):
        (tmp_path / name).touch()
    with pytest.raises(BadResult, match=r"holds several tables, name one: a\.csv, b\.csv"):
        report(tmp_path)


@pytest.mark.parametrize("ending", ["", ".csv", ".parquet"])
def test_a_name_that_is_too_long_is_refused_in_a_line(ending, tmp_path):
    with pytest.raises(BadResult, match="File name too long") as problem:
        report(tmp_path / f"{300 * 'n'}{ending}", tmp_path / "r.html")
    assert "\n" not in str(problem.value)
