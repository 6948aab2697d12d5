"""The card of a result: short, alike for all kinds of bearing, with numbers of the report's first page."""

import re
from dataclasses import astuple, is_dataclass
from pathlib import Path

import pytest
from pytest import approx

import flexbearing
from flexbearing.__main__ import command
from flexbearing.findings.running import REQUIRED_LIFE
from flexbearing.report.html import METRIC, checks, html, of_result
from flexbearing.report.html.document import Number
from flexbearing.report.html.reader import Reader
from tests.places import CONFIGS

pytestmark = pytest.mark.usefixtures("each_case_drawn_once")
APART = ("drawings", "case", "origin")  # parts of the report
KINDS = ["catalogue/nu210", "mao2016", "planet", "catalogue/6208", "joshi2015_qj309"]
EACH_KIND = pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.slow] * (name == "mao2016")) for name in KINDS]
)


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    folder = tmp_path_factory.mktemp("card")
    known = {}

    def of(name):
        if name not in known:
            known[name] = flexbearing.run(CONFIGS / f"{name}.toml", output=folder / f"{Path(name).stem}.h5")
        return known[name]

    return of


def numbers_in(result):
    """All numbers that stand in the report, as they are printed."""
    document = of_result(result)
    shown = {name: part for name, part in document.parts.items() if name not in APART}
    return set(sizes(" ".join(texts(shown))))


def sizes(words):
    """Numbers in words; those of versions and dates are none."""
    return [
        float(text.replace(",", "")) for text in re.findall(r"\d[\d,.]*\d|\d", words) if text.count(".") < 2
    ]


def texts(value):
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        yield from texts(list(value.values()))
    elif isinstance(value, list | tuple):
        for each in value:
            yield from texts(each)
    elif is_dataclass(value) and not isinstance(value, type):
        yield from texts(astuple(value))


def printed(item):
    """Numbers of a fact."""
    values = [item.value] if isinstance(item.value, Number) else []
    words = " ".join([*(each.text for each in (*values, *(item.ends or ()))), item.remark])
    words += item.label if " by " in item.label else ""  # factors of an input
    return sizes(words.replace("..", " "))


@EACH_KIND
def test_a_card_has_few_lines_and_words(name, results, capsys):
    assert command(["summary", str(results(name).path)]) == 0
    card = capsys.readouterr().out
    assert len(card.splitlines()) <= 15
    assert len(card.split()) <= 120
    assert all(len(line) <= 100 for line in card.splitlines())
    assert "nan" not in card
    assert card.splitlines()[0] == results(name).attributes["title"]


@EACH_KIND
def test_numbers_and_verdict_are_those_of_the_report(name, results):
    result, rounded = results(name), re.compile(r"life|usual minimum|with supports|kappa")
    known = numbers_in(result)
    for line in (line for line in result.card.lines if line.subject not in ("rigid", "notes")):
        for item in (item for item in line.items if not rounded.search(item.words)):
            assert set(printed(item)) <= known, item.words
    lines = {line.subject: line.items for line in result.card.lines}
    assert checks.judged(Reader(result, METRIC))[0] == lines["usable"][0].label


def test_what_is_assumed_of_loads_and_speeds_is_marked(results):
    lines = {line.subject: line.words for line in results("planet").card.lines}
    assert lines[""].startswith("assumed radial load 10,000 N; assumed outer ring 3,000 rpm; ")


@pytest.mark.slow
def test_what_overlaps_and_peaks_without_their_ends_are_named(results):
    lines = {line.subject: line.words for line in results("mao2016").card.lines}
    assert "; cage dimensions overlap; " in lines["usable"]
    assert lines["load"].endswith(" MPa, ends left out")
    assert " at assumed " in lines[""]
    assert checks.judged(Reader(results("mao2016"), METRIC))[1].endswith("; dimensions overlap")


@pytest.mark.slow
def test_rigid_rings_are_compared_where_rings_are_elastic(results):
    known = {name: {line.subject: line.items for line in results(name).card.lines} for name in KINDS}
    assert [name for name in KINDS if "rigid" in known[name]] == ["mao2016", "planet"]
    result = results("mao2016")
    load, life = known["mao2016"]["rigid"]
    assert float(load.value.text.replace(",", "")) == approx(result.rigid["inner_load"].max(), abs=0.5)
    assert float(life.value.text) == approx(result["rigid.life_L10 [h]"].number, rel=1e-2)
    assert life.label == "basic life L10:"


@pytest.mark.parametrize(
    ("required", "said"),
    [("20000 h", "met"), ("100000 h", "met, not at the low end"), ("500000 h", "not met")],
)
def test_life_is_judged_by_the_required_one(required, said):
    result = flexbearing.run(CONFIGS / "catalogue/nu210.toml", {"life.required": required})
    (record,) = [each for each in result.attributes["findings"] if each["code"] == "required-life"]
    assert (record["verdict"], record["source"]) == (said.partition(",")[0], REQUIRED_LIFE.source)
    assert record["value"] / 3600 == approx(result["modified_life [h]"].number)
    lines = {line.subject: line.items for line in result.card.lines}
    _, against, _ = lines["life"]
    assert (against.label, against.remark) == ("required", said)
    assert lines["usable"][0].label == ("No" if said == "not met" else "Yes, as far as checked")
    assert "required-life" in {note["code"] for note in result.dangers} or said != "not met"
    low_end_is_told = "low end does not reach" in html(of_result(result))
    assert low_end_is_told == ("low end" in said)
    assert "assumed_effects" in result.attributes  # which do not depend on it


def test_what_is_not_known_is_left_out(results):
    subjects = [line.subject for line in results("heras2017_a1").card.lines]
    assert subjects == ["", "usable", "life", "load", "bearing", "uncertain", "notes"]
    (life,) = next(line.items for line in results("heras2017_a1").card.lines if line.subject == "life")
    assert (life.label, "do not rate" in life.value) == ("none:", True)
    words = repr(results("heras2017_a1"))
    assert "kappa" not in words
    assert "degC" not in words


def test_all_numbers_and_notes_are_printed_above_the_card(results, capsys):
    path, shown = str(results("catalogue/nu210").path), {}
    for options in ((), ("--notes",), ("--all",)):
        assert command(["summary", path, *options]) == 0
        shown[options] = capsys.readouterr().out
    notes = [note["text"].split()[0] for note in results("catalogue/nu210").attributes["notes"]]
    for options in (("--notes",), ("--all",)):
        assert shown[options].endswith(shown[()])
        assert all(word in shown[options] for word in notes)
    assert "tangent stiffness" in shown["--all",]
    assert "tangent stiffness" not in shown["--notes",]


def test_shoulders_that_nobody_checked_are_named(tmp_path):
    result = flexbearing.run(CONFIGS / "joshi2015_fourpoint.toml", output=tmp_path / "r.h5")
    lines = {line.subject: line.words for line in result.card.lines}
    assert lines["usable"].endswith("; shoulders of races, not checked")
    assert len(result.card.text().split()) <= 120
