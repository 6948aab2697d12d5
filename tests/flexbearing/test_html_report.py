"""Reports as HTML: every number is that of the file, nothing is loaded from elsewhere."""

import re
import subprocess
import sys
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from pytest import approx

from flexbearing import api
from flexbearing.__main__ import command
from flexbearing.case import BadCase
from flexbearing.families import FAMILIES
from flexbearing.files import BadOutput
from flexbearing.findings import DANGER
from flexbearing.pages.make import report
from flexbearing.report.drawing.of_case import drawings
from flexbearing.report.html import IMPERIAL, METRIC, against_limits, html, of_result
from flexbearing.report.html.reader import Reader
from flexbearing.results import BadResult
from tests.flexbearing.hostile_cases import CONFIGS
from tests.flexbearing.html_pages import Numbers, Page, require_equal

CASES = {
    "roller with fits": ("nu209_fits.toml", ()),
    "beams of a squirrel cage": ("mao2016.toml", ("accuracy.structure=beam",)),
    "fast ball": ("harris218.toml", ()),
    "slow ball": ("heras2017_a1.toml", ()),
    "slow balls": ("joshi2015_qj309.toml", ()),
    "rollers on their way": (
        "nu209.toml",
        (
            "operation.roller_positions=3",
            "outputs.catalogue_life=true",
            "life.lubrication=a_ISO",
            "life.cleanliness=oil, in-line filter, -/15/12",
            "life.capacity=iso281",
        ),
    ),
}
COARSE = (
    "accuracy.mesh_size=8 mm", "accuracy.raceway_mesh_size=3.5 mm", "accuracy.patch_width=1.5 mm",
    "accuracy.slices=8", "accuracy.axial_shapes=2", "accuracy.threads=1", "outputs.stresses=true",
    "accuracy.element_order=2", "outer.bars=8", "outer.bar_width=10 mm", "inner.kind=rigid",
)  # fmt: skip
SLOW = {"squirrel cage": ("mao2016.toml", COARSE)}
QUICK = ("roller with fits", "fast ball", "slow balls")


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    folder = tmp_path_factory.mktemp("results")

    @cache
    def computed(name):
        file, settings = {**CASES, **SLOW}[name]
        path = folder / f"{name.replace(' ', '_')}.h5"
        api.run(CONFIGS / file, settings, output=path)
        return path

    return computed


UNITS = {units.name: units for units in (METRIC, IMPERIAL)}


@pytest.fixture(scope="module")
def documents(results):
    """What a report of a case holds, made once."""
    made = cache(lambda name, units: of_result(api.read(results(name)), UNITS[units]))
    return lambda name, units=METRIC: made(name, units.name)


@pytest.fixture(scope="module")
def pages(documents):
    """The same as HTML."""
    made = cache(lambda name, units: html(documents(name, UNITS[units])))
    return lambda name, units=METRIC: made(name, units.name)


ALL = [
    *QUICK,
    *(pytest.param(name, marks=pytest.mark.slow) for name in {**CASES, **SLOW} if name not in QUICK),
]
KINDS = [name for name in ALL if name in QUICK or name.values[0] in CASES]


@pytest.mark.parametrize("units", [METRIC, IMPERIAL], ids=lambda units: units.name)
@pytest.mark.parametrize("name", ALL)
def test_every_number_of_a_report_is_that_of_the_file_to_the_printed_digit(results, pages, name, units):
    path = results(name)
    cells = Page(pages(name, units)).cells
    assert len(cells) > 50
    require_equal(cells, Numbers(path))


@pytest.mark.slow
@pytest.mark.parametrize("name", ALL)
def test_lines_of_figures_are_those_of_the_file(results, pages, name):
    path = results(name)
    numbers, checked = Numbers(path), 0
    for figure in Page(pages(name)).figures:
        for trace in figure["traces"]:
            if "customdata" in trace and trace["type"] == "scatter":
                drawn = np.array(trace["y"], dtype=float)
                stored = numbers.array(trace["meta"])[trace["customdata"]]
                known = np.isfinite(drawn) & (drawn != 0)
                ratio = drawn[known] / stored[known]
                assert ratio == approx(np.median(ratio) if ratio.size else 1, rel=2e-5)
                checked += 1
    assert checked >= 4 or name == "slow ball"  # one alone, which has no lines


@pytest.mark.parametrize("name", KINDS)
def test_a_report_is_one_file_of_at_most_five_megabytes_that_loads_nothing(pages, name):
    text = pages(name)
    page = Page(text)
    assert len(text.encode()) < 5e6
    assert [given for _, given in page.tags if "src" in given] == []
    assert {given["href"][0] for _, given in page.tags if "href" in given} == {"#"}
    assert ("body", {"data-ready": "0"}) in page.tags
    identifiers = [given["id"] for _, given in page.tags if "id" in given]
    assert len(identifiers) == len(set(identifiers))


def test_marks_of_inputs_stand_in_their_table(pages):
    text = pages("roller with fits")
    row = next(line for line in text.splitlines() if ">bearing.roller.drop<" in line)
    assert ">assumed<" in row
    row = next(line for line in text.splitlines() if ">bearing.rollers<" in line)
    assert ">given<" in row


def test_limits_are_met_exceeded_or_said_to_be_unchecked(results):
    result = api.read(results("beams of a squirrel cage"))
    checked = {check.what: check.verdict for check in against_limits.ranked(Reader(result, METRIC))}
    assert checked["Static safety C_0/P_0"] == "met"
    bars = checked["Largest stress, bars of the squirrel cage (nominal)"]
    assert bars.startswith("not checked: yield_stress of the part")
    pressure = "Peak contact pressure, inner raceway"
    without, told = ([{"code": code}] for code in ("tilt", "pressed-end"))
    for notes, verdict in ((without, "met"), (told, "met by slices, not checked at the ends")):
        noted = replace(result, attributes={**result.attributes, "notes": notes})
        checks = against_limits.ranked(Reader(noted, METRIC))
        assert {check.what: check.verdict for check in checks}[pressure] == verdict
    overloaded = api.run(CONFIGS / "nu209.toml", {"operation.radial_load": "100 kN"})
    first = against_limits.ranked(Reader(overloaded, METRIC))[:4]
    assert {check.verdict.partition(":")[0] for check in first} == {"EXCEEDED", "NOT MET"}
    assert {check.grade for check in first} == {DANGER}
    assert pressure in {check.what for check in first}


def test_balls_are_held_to_the_limit_of_balls(results):
    checks = against_limits.ranked(Reader(api.read(results("fast ball")), METRIC))
    limits = {check.limit for check in checks if check.what.startswith("Peak contact pressure")}
    assert limits == {"at most 4,200 MPa (ISO 76)"}


def test_every_cause_of_heat_has_its_own_name(documents):
    document = documents("roller with fits")
    (heat,) = [section for section in document.sections if section.title == "Heat by cause"]
    names = [row[0] for row in heat.blocks[-1].rows]
    assert names[0] == "power lost by sliding"
    assert len(set(names)) == len(names)


def test_defaults_of_other_kinds_of_parts_are_left_out(pages):
    text = pages("roller with fits")
    assert ">lubricant.film<" in text
    assert ">outer.tooth_radial<" not in text


def test_a_result_whose_case_cannot_be_read_is_refused(results):
    result = api.read(results("fast ball"))
    with pytest.raises(BadResult, match="the case in it is no TOML"):
        of_result(replace(result, attributes={**result.attributes, "case_text": "a = = b"}))


def test_texts_of_a_case_are_shown_and_not_run(tmp_path):
    title = "</script><script>alert(1)</script><img src=x>"
    result = api.run(CONFIGS / "harris218.toml", {"title": title})
    page = Page(html(of_result(result)))
    assert not any(tag == "img" for tag, _ in page.tags)
    assert title in "".join(page.text)
    assert sum(tag == "script" for tag, _ in page.tags) == 3


def test_imperial_units_are_exact_conversions(results):
    path = results("fast ball")
    cells = Page(html(of_result(api.read(path), IMPERIAL))).cells
    load = next(text for given, text in cells if given["data-of"] == "case/operation.load.axial")
    assert load == "4,001.6"  # 17.8 kN / 4.4482216 N
    assert {given["data-unit"] for given, _ in cells}.isdisjoint({"N", "mm", "MPa", "um", "W", "degC"})


def test_the_command_writes_the_report_beside_the_result(results, capsys):
    path = results("fast ball")
    assert command(["report", str(path)]) == 0
    written = path.with_name(f"{path.stem}_report.html")
    assert capsys.readouterr().out == f"report: {written}\n"
    assert written.read_text("utf-8").startswith("<!DOCTYPE html>")


def test_other_units_are_refused_before_anything_is_read(tmp_path):
    with pytest.raises(BadCase, match="--units furlong: it is metric or imperial"):
        report(tmp_path / "nothing.h5", units="furlong")


def test_a_report_loads_no_finite_elements(results):
    path = results("roller with fits")
    program = (
        "import sys\nfrom flexbearing.__main__ import command\n"
        f"assert command(['report', {str(path)!r}]) == 0\n"
        "print(*{'ngsolve', 'netgen'} & set(sys.modules))"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == ""


def test_two_results_are_compared_key_by_key_and_output_by_output(results, tmp_path):
    path, other = results("fast ball"), tmp_path / "faster.h5"
    api.run(CONFIGS / "harris218.toml", {"operation.inner_speed": "12000 rpm"}, output=other)
    (written,) = report(path, tmp_path / "both.html", against=other)
    page = Page(written.read_text("utf-8"))
    numbers = Numbers(path, other)
    require_equal(page.cells, numbers)
    shown = {given["data-of"]: text for given, text in page.cells}
    assert shown["case/operation.inner_speed"] == "10,000"
    assert shown["other/case/operation.inner_speed"] == "12,000"
    figure = next(each for each in page.figures if each["name"] == "against-loads")
    for trace in figure["traces"]:
        stored = numbers.array(trace["meta"])[trace["customdata"]]
        assert np.array(trace["y"], dtype=float) == approx(stored, rel=2e-5)
    assert {trace["meta"].partition("/")[0] for trace in figure["traces"]} == {"rigid", "other"}


def test_a_study_is_not_compared_with_a_result(tmp_path):
    with pytest.raises(BadCase, match="only results are compared"):
        report(tmp_path, against=tmp_path / "a.h5")


def test_without_chromium_nothing_is_read_for_a_pdf(tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("PATH", str(tmp_path))
    assert command(["report", str(tmp_path / "nothing.h5"), "--pdf"]) == 2
    assert capsys.readouterr().err == (
        "--pdf: no Chromium is installed that could print; the HTML report needs none.\n"
    )


def test_a_report_replaces_neither_its_case_nor_its_result(tmp_path):
    case = tmp_path / "case.toml"
    case.write_text((CONFIGS / "harris218.toml").read_text("utf-8"), "utf-8")
    result = api.run(case, output=tmp_path / "case.h5")
    for taken in (case, result.path):
        with pytest.raises(BadOutput):
            report(result.path, taken)


@pytest.mark.parametrize("name", KINDS)
def test_the_bearing_is_drawn_as_for_its_case(pages, name):
    file, settings = CASES[name]
    case = api.read_case(CONFIGS / file, settings)
    svg = [drawing.svg for drawing in drawings(FAMILIES[case.kind], case, resized=True)]
    text = pages(name)
    assert svg
    assert all(drawing in text for drawing in svg)


@pytest.mark.slow
@pytest.mark.parametrize("name", KINDS)
def test_a_run_without_an_answer_is_reported_as_such(results, name):
    result = api.read(results(name))
    attributes = {**result.attributes, "status": "not solved", "message": "no balance was found"}
    empty = replace(result, rigid={}, flexible={}, iterations=(), attributes=attributes)
    text = "".join(Page(html(of_result(empty))).text)
    assert "Not converged (not solved): no balance was found" in text
    assert "Bearing report" in text


@pytest.mark.slow
@pytest.mark.parametrize("name", KINDS)
def test_numbers_that_are_not_finite_are_dashes(results, name):
    result = api.read(results(name))
    lost = {
        key: np.full_like(array, np.nan) if "pressure" in key or "load" in key else array
        for key, array in result.rigid.items()
    }
    attributes = {**result.attributes, "status": "not finite", "notes": []}
    page = Page(html(of_result(replace(result, rigid=lost, flexible={}, attributes=attributes))))
    assert {
        text for given, text in page.cells if given["data-of"].startswith("summary/rigid/peak_pressure_MPa")
    } <= {"–"}


def test_host_and_cores_of_the_computation_are_told(results, pages):
    machine = api.read(results("fast ball")).attributes["machine"]
    text = "".join(Page(pages("fast ball")).text)
    assert machine["cores"] >= 1
    assert f"host of the computation{machine['host']}" in text


def test_raceways_are_drawn_with_azimuth_zero_down_and_the_load_at_its_azimuth(documents):
    figures = {each.name: each for each in documents("beams of a squirrel cage").figures}
    deformed = figures["deformed"]
    assert deformed.layout["yaxis"]["autorange"] == "reversed"  # z grows downwards
    first = deformed.traces[0]
    assert (first["x"][0], first["y"][0] > 0) == (approx(0, abs=1e-9), True)  # azimuth 0 on the z axis
    (arrow,) = deformed.layout["annotations"]
    assert (arrow["x"], arrow["y"] > 0) == (approx(0, abs=1e-9), True)  # load_direction = 0
    assert figures["around-inner-load"].layout["shapes"][0]["x0"] == 0


def test_maps_of_both_raceways_share_their_colour_scale(documents):
    figures = {each.name: each for each in documents("roller with fits").figures}
    inner, outer = (figures[f"map-{race}-pressure"].traces[0] for race in ("inner", "outer"))
    assert inner["zmax"] == outer["zmax"] == max(max(row) for row in inner["z"] + outer["z"])


def test_a_figure_of_equal_values_is_left_out_and_a_line_says_so(documents):
    document = documents("roller with fits")
    (section,) = [each for each in document.sections if each.name == "elements"]
    assert "around-roller-tilt" not in {figure.name for figure in document.figures}
    told = [words for block in section.blocks if block.kind == "words" for words in block.paragraphs]
    assert "Not drawn: tilt of the rollers [mrad] is 0 everywhere." in told


@pytest.mark.slow
def test_lines_that_cannot_be_told_apart_are_drawn_once_and_the_caption_says_so(results):
    result = api.read(results("roller with fits"))
    near = {
        **result.rigid,
        "outer_load": result.rigid["inner_load"] + 0.004 * result.rigid["inner_load"].max(),
    }
    figures = {each.name: each for each in of_result(replace(result, rigid=near, flexible=near)).figures}
    (line,) = figures["around-inner-load"].traces
    assert line["name"] == "inner and outer load"
    assert "Inner and outer load differ by at most" in figures["around-inner-load"].caption
    apart = {**near, "outer_load": 1.02 * near["inner_load"] + 50}
    figures = {each.name: each for each in of_result(replace(result, rigid=apart, flexible=apart)).figures}
    assert len(figures["around-inner-load"].traces) == 2
    equal = {**near, "outer_load": near["inner_load"]}
    figures = {each.name: each for each in of_result(replace(result, rigid=equal, flexible=equal)).figures}
    assert "Inner and outer load are the same: drawn as one line." in figures["around-inner-load"].caption


@pytest.mark.slow
def test_load_per_length_is_drawn_of_both_raceways_only_where_they_differ(results):
    result = api.read(results("beams of a squirrel cage"))
    names = {figure.name for figure in of_result(result).figures}
    assert {"map-inner-slice-load", "map-outer-slice-load"} <= names
    same = {**result.flexible, "outer_slice_load": 1.001 * result.flexible["inner_slice_load"]}
    document = of_result(replace(result, flexible=same))
    assert "map-outer-slice-load" not in {figure.name for figure in document.figures}
    assert "Not drawn: load per length of the outer contacts; it differs by at most" in html(document)


def test_the_radial_load_on_balls_is_marked_at_its_azimuth():
    result = api.run(CONFIGS / "6209.toml", {"operation.load.radial_y": "8.9 kN"})
    figures = {each.name: each for each in of_result(result).figures}
    assert figures["around-contact-load"].layout["shapes"][0]["x0"] == approx(45, rel=1e-9)
    axial = api.run(CONFIGS / "harris218.toml")
    assert not any("shapes" in figure.layout for figure in of_result(axial).figures)


@pytest.mark.parametrize("name", ["roller with fits", "fast ball"])
def test_a_bearing_between_rigid_rings_tells_how_far_it_is_from_balance(documents, name):
    (section,) = [each for each in documents(name).sections if each.name == "convergence"]
    (words,) = [block.paragraphs[0] for block in section.blocks if block.kind == "words"]
    found = re.search(r"in balance to (\S+) (N|of the largest force)", words)
    assert float(found[1]) < 1e-6


@pytest.mark.slow
def test_without_temperatures_no_clearance_is_called_operating():
    result = api.run(CONFIGS / "catalogue" / "nu210.toml")
    sections = {each.name: each for each in of_result(result).sections}
    page = Page(html(of_result(result)))
    told = "".join(page.text)
    assert "the clearance, mounted and turning, all parts equally warm" in told
    assert "8.9 to 58.3 µm mounted and turning, all parts equally warm" in told
    tables = [block for block in sections["clearance"].blocks if block.kind == "table"]
    assert "positive where the shaft is larger than the bore" in tables[1].note
    ends, warmer = tables[2:]
    assert [[cell.text for cell in row[1:5]] for row in ends.rows] == [
        ["1.93", "0.824", "1.05", "1.26"], ["0.598", "1.15", "0.944", "0.972"]
    ]  # fmt: skip
    assert [row[2].text for row in warmer.rows] == [
        "40",
        "10",
    ]  # [K], 33.6 and 8.9 µm over 70.5 mm, rounded down
    named = {"interference on the shaft, k5", "interference in the housing, H7"}
    assert {row[0] for row in tables[1].rows} >= named


@pytest.mark.parametrize("name", KINDS)
def test_the_sense_of_azimuth_is_told(pages, name):
    assert "left-handed about +x" in "".join(Page(pages(name)).text)


def test_operating_system_and_revision_are_told(results):
    result = api.read(results("fast ball"))
    machine = {**result.attributes["machine"], "revision": "0123456789ab"}
    told = replace(result, attributes={**result.attributes, "machine": machine})
    text = "".join(Page(html(of_result(told))).text)
    assert f"operating system{machine['system']}" in text
    assert "revision of the program's source (git commit)0123456789ab" in text


def test_lists_of_inputs_have_their_units(documents):
    document = documents("slow ball")
    (section,) = [each for each in document.sections if each.name == "inputs"]
    rows = {row[0]: row for block in section.blocks if block.kind == "table" for row in block.rows}
    assert rows["operation.contact_loads"][1] == "56,137.2 N, 0 N"


def test_imperial_pages_say_what_keeps_its_units(pages):
    said = "Drawings, notes and texts of the case keep their own units"
    assert said in pages("fast ball", IMPERIAL)
    assert said not in pages("fast ball", METRIC)


def test_values_of_a_single_ball_are_no_figures_over_the_azimuth(documents):
    document = documents("slow ball")
    assert not any(figure.name.startswith("around") for figure in document.figures)
    assert "of a single rolling element: contact load [N]" in html(document)
