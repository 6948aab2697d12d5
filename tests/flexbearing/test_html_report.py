"""Reports as HTML: every number is that of the file, nothing is loaded from elsewhere."""

import json
import re
import subprocess
import sys
from collections import Counter
from dataclasses import replace
from functools import cache
from importlib.resources import files

import numpy as np
import pytest
from pytest import approx

from flexbearing import api
from flexbearing.__main__ import command
from flexbearing.case import BadCase
from flexbearing.case.declarations import by_path
from flexbearing.case.differing import differing
from flexbearing.families import FAMILIES
from flexbearing.files import BadOutput
from flexbearing.findings import DANGER
from flexbearing.pages.make import report
from flexbearing.report.drawing.of_case import drawings
from flexbearing.report.html import IMPERIAL, METRIC, checks, html, keys, lives, of_result, rings, write
from flexbearing.report.html.plotly import layout, traces
from flexbearing.report.html.reader import Reader
from flexbearing.results import BadResult
from tests.flexbearing.hostile_cases import CONFIGS
from tests.flexbearing.html_pages import Numbers, Page, require_equal

pytestmark = pytest.mark.usefixtures("each_case_drawn_once")
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
    'outputs.probes.azimuths=["0 deg", "90 deg"]',
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


def test_defaults_of_other_kinds_of_parts_are_left_out(pages):
    text = pages("roller with fits")
    assert ">lubricant.film<" in text
    assert ">outer.tooth_radial<" not in text


def test_a_result_whose_case_cannot_be_read_is_refused(results):
    result = api.read(results("fast ball"))
    with pytest.raises(BadResult, match="the case in it is no TOML"):
        of_result(replace(result, attributes={**result.attributes, "case_text": "a = = b"}))


def test_texts_of_a_case_are_shown_and_not_run():
    title = "</script><script>alert(1)</script><img src=x>"
    result = api.run(CONFIGS / "harris218.toml", {"title": title})
    page = Page(html(of_result(result)))
    assert not any(tag == "img" for tag, _ in page.tags)
    assert title in "".join(page.text)
    assert sum(tag == "script" for tag, _ in page.tags) == 3


def test_imperial_units_are_exact_conversions(pages):
    cells = Page(pages("fast ball", IMPERIAL)).cells
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
    with pytest.raises(BadCase, match=r"^units furlong: it is metric or imperial"):
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
    svg = [drawing.svg for drawing in drawings(FAMILIES[case.kind], case, names=keys.name)]
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
    assert "no solution" in text


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


def test_deviations_are_those_at_mid_roller_and_the_load_is_at_its_azimuth(documents, results):
    figures = {each.name: each for each in documents("beams of a squirrel cage").figures}
    stored = api.read(results("beams of a squirrel cage")).flexible
    outer = next(line for line in figures["deformed"].lines if line.name == "outer raceway")
    middle = [np.interp(0.0, stored["slice_position"], row) for row in stored["outer_deviation"]]
    assert max(outer.y) == approx(1e6 * max(middle), rel=1e-5)
    for name in ("deformed", "around-inner-load"):
        assert layout(figures[name])["shapes"][-1]["x0"] == 0  # load_direction = 0


def test_maps_of_both_raceways_share_their_colour_scale(documents):
    figures = {each.name: each for each in documents("roller with fits").figures}
    inner, outer = (traces(figures[f"map-{race}-pressure"])[0] for race in ("inner", "outer"))
    assert inner["zmax"] == outer["zmax"] == max(max(row) for row in inner["z"] + outer["z"])


def test_the_radial_load_on_balls_is_marked_at_its_azimuth():
    result = api.run(CONFIGS / "6209.toml", {"operation.load.radial_y": "8.9 kN"})
    figures = {each.name: each for each in of_result(result).figures}
    assert layout(figures["around-contact-load"])["shapes"][0]["x0"] == approx(45, rel=1e-9)
    axial = api.run(CONFIGS / "harris218.toml")
    assert not any("shapes" in layout(figure) for figure in of_result(axial).figures)


def test_operating_system_and_revision_are_told(results):
    result = api.read(results("fast ball"))
    machine = {**result.attributes["machine"], "revision": "0123456789ab"}
    told = replace(result, attributes={**result.attributes, "machine": machine})
    text = "".join(Page(html(of_result(told))).text)
    assert f"operating system{machine['system']}" in text
    assert "revision of the program's source (git commit)0123456789ab" in text


def test_imperial_pages_say_what_keeps_its_units(pages):
    said = "Drawings, notes and texts of the case keep their own units"
    assert said in pages("fast ball", IMPERIAL)
    assert said not in pages("fast ball", METRIC)


@pytest.mark.parametrize("name", ALL)
def test_what_is_shown_is_short_and_each_fact_stands_once(results, pages, name):
    page, result = Page(pages(name)), api.read(results(name))
    assert len(page.words) <= 2000
    places = [given["data-of"] for given, _ in page.shown_cells if given["data-of"]]
    # one estimate may be of several outputs, and an azimuth is where an extreme is
    places = [place for place in places if "error" not in place and "azimuth" not in place]
    assert [place for place, count in Counter(places).items() if count > 1] == []
    shown = Counter(text.strip() for text in page.shown)
    reader = Reader(result, METRIC)
    for check in checks.ranked(reader):
        assert shown[check.what] <= 1
        assert shown[check.what] or check.code in ("required-life", "short-life")
    keys = by_path(result.family.case())
    for note in result.attributes["notes"]:
        assert sum(note["text"][:40] in text for text in page.shown) <= 1, note
        assert note.get("keys", {}).keys() <= keys.keys()
        assert not [key for key in keys if "." in key and f"{key} " in note["text"]]  # it has them as data


@pytest.mark.parametrize("name", ALL)
def test_the_first_page_has_the_life_at_most_eight_results_and_three_caveats(results, pages, documents, name):
    parts = documents(name).parts
    assert 2 <= len(parts["checks"].rows) <= 8
    if lives.lives(Reader(api.read(results(name)), METRIC)):
        assert parts["checks"].rows[0][4] == "required life of the case"
    first = pages(name).partition('<nav aria-label="contents">')[0]
    assert first.partition('class="caveats"')[2].count("<li>") <= 3
    assert first.index("<figure") < first.index("<table")


def test_who_signs_is_on_the_first_page_and_no_input():
    settings = {"report.author": "A. <Bauer>", "report.project": "G12"}
    result = api.run(CONFIGS / "catalogue" / "nu210.toml", settings)
    page = html(of_result(result))
    assert "<dt>author</dt><dd>A. &lt;Bauer&gt;</dd>" in page
    assert "<dt>checker</dt><dd></dd>" in page
    assert "assumed_effects" in result.attributes  # of the same inputs
    assert differing(result.attributes["case_si"], {**result.attributes["case_si"], "report": {}}) == {
        "report.author": ("A. <Bauer>", None), "report.project": ("G12", None),
    }  # fmt: skip


def test_templates_name_no_keys_in_their_sentences():
    folder = files("flexbearing.report.html") / "page"
    for template in (each for each in folder.iterdir() if each.name.endswith(".j2")):
        words = re.sub(r"{[{%].*?[}%]}|<[^>]*>", " ", template.read_text("utf-8"), flags=re.S)
        assert re.findall(r"\b[a-z]+\.[a-z_]+", words) == [], template.name
        for sentence in re.split(r"[.:;?]\s|\n", words):
            assert len(sentence.split()) <= 25, sentence


def test_limits_are_met_exceeded_or_not_checked(results):
    result = api.read(results("roller with fits"))
    pressure = "Peak contact pressure, inner raceway"
    for code, verdict in (("tilt", "met"), ("pressed-end", "met by slices")):
        noted = replace(
            result, attributes={**result.attributes, "notes": [{"code": code, "grade": "", "text": ""}]}
        )
        found = {check.what: check.verdict for check in checks.ranked(Reader(noted, METRIC))}
        assert found[pressure] == verdict
    overloaded = api.run(CONFIGS / "nu209.toml", {"operation.radial_load": "100 kN"})
    first = checks.ranked(Reader(overloaded, METRIC))[:4]
    assert {check.verdict for check in first} == {"EXCEEDED", "NOT MET"}
    assert {check.grade for check in first} == {DANGER}
    assert pressure in {check.what for check in first}
    assert checks.judged(Reader(overloaded, METRIC)) == checks.JUDGED[DANGER]
    balls = checks.ranked(Reader(api.read(results("fast ball")), METRIC))
    limits = {check.limit for check in balls if check.code == "contact-pressure"}
    assert limits == {"at most 4,200 MPa"}


def test_a_cage_within_the_ribs_cannot_be_built_which_is_no_limit_of_damage(results):
    result = api.read(results("roller with fits"))
    note = {"code": "overlapping-dimensions", "grade": "outside validity", "text": "dimensions overlap: a"}
    noted = Reader(replace(result, attributes={**result.attributes, "notes": [note]}), METRIC)
    (check,) = [each for each in checks.ranked(noted) if each.grade == checks.BUILD]
    assert (check.verdict, check.meaning) == ("CANNOT BE BUILT", "dimensions overlap: a")
    assert checks.judged(noted) == checks.JUDGED[checks.BUILD]


@pytest.mark.parametrize(
    ("settings", "chosen"),
    [
        ((), "basic"),
        (("life.capacity=iso281",), "reference"),
        (("life.loads=rating",), "modified"),
        (("life.lubrication=a_ISO", "life.cleanliness=oil, in-line filter, -/15/12"), "modified"),
    ],
)
def test_the_most_detailed_life_of_the_case_comes_first(settings, chosen):
    known = lives.lives(Reader(api.run(CONFIGS / "nu209.toml", settings), METRIC))
    assert (known[0].key, [life.chosen for life in known].count(True)) == (chosen, 1)
    assert lives.rounded(known[0].turns).size == approx(known[0].turns.size, rel=5e-3)
    rated = {life.key for life in known if life.key.startswith("catalogue")}
    assert bool(rated) == ("life.loads=rating" not in settings)


def test_a_life_without_the_growth_of_its_factors_has_no_error(results):
    result = api.read(results("rollers on their way"))
    reader = Reader(result, METRIC)
    basic, modified = (lives.error(reader, name).size for name in ("life_L10", "modified_life"))
    assert modified > basic
    older = json.loads(json.dumps(result.attributes["life"]))
    for factor in older["rigid"]["factors"]:
        factor.pop("life_exponent", None)
    attributes = {**result.attributes, "life": older}
    assert (
        lives.error(Reader(replace(result, attributes=attributes), METRIC), "modified_life")
        == "not estimated"
    )


def test_clearance_has_its_steps_and_the_ends_of_its_tolerances():
    reader = Reader(api.run(CONFIGS / "catalogue" / "nu210.toml"), METRIC)
    rows = rings.tolerances(reader).rows
    assert [cell.text for cell in rows[-1][1:]] == ["8.9", "33.6", "58.3"]
    assert rows[-1][0] == "clearance, mounted and turning, all parts equally warm"
    assert rings.steps(reader).rows[-1][2].text == "33.6"


def test_lines_and_maps_that_look_the_same_are_drawn_once(results):
    result = api.read(results("roller with fits"))

    def drawn(**arrays):
        block = {**result.rigid, **arrays}
        return {each.name: each for each in of_result(replace(result, rigid=block, flexible={})).figures}

    inner = result.rigid["inner_load"]
    (line,) = drawn(outer_load=inner + 0.004 * inner.max())["around-inner-load"].lines
    assert line.name == "inner and outer load"
    assert len(drawn(outer_load=1.02 * inner + 50)["around-inner-load"].lines) == 2
    assert "map-outer-pressure" not in drawn(outer_pressure=1.001 * result.rigid["inner_pressure"])
    assert "around-roller-tilt" not in drawn()  # zero everywhere


def test_a_single_ball_has_no_figures_over_the_azimuth_and_lists_have_units(documents):
    document = documents("slow ball")
    assert not any(figure.name.startswith("around") for figure in document.figures)
    rows = {row[0]: row for row in document.parts["inputs"].rows}
    assert rows["operation.contact_loads"][2] == "56,137.2 N, 0 N"


def test_what_stands_between_backticks_is_code_and_nothing_else_is_markup():
    assert write.marked("a < b: `run`") == "a &lt; b: <code>run</code>"
    assert write.marked("[one](#two) [three](http://four)") == '<a href="#two">one</a> [three](http://four)'
