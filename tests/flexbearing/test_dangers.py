"""Dangers come first, carry a code, and end a strict run with 1."""

import json
import re
import subprocess
import sys

import pytest

import flexbearing
from flexbearing.api import read_case
from flexbearing.findings.declared import DECLARED
from flexbearing.quantities.attributes import GRADES as STORED
from flexbearing.report.output import text
from flexbearing.runs import judged
from flexbearing.runs.notes import of_case
from quasidynamic.note import GRADES, Note, danger, graded, information, outside
from tests.flexbearing.noted import codes, keys, texts
from tests.places import ROOT

PAPER, PLAIN = ROOT / "configs" / "mao2016.toml", ROOT / "configs" / "nu209.toml"
RIGID = ["outer.kind=rigid", "inner.kind=rigid"]
HEAVY = ["operation.radial_load=100 kN"]
MADE = re.compile(r'\b(danger|outside|information)\(\s*"([a-z-]+)"')
GRADE = {"danger": "danger", "outside": "outside validity", "information": "information"}


@pytest.fixture(scope="module")
def paper(tmp_path_factory):
    return flexbearing.run(PAPER, RIGID, output=tmp_path_factory.mktemp("dangers") / "paper.h5")


def test_the_paper_bearing_says_that_it_lives_for_less_than_an_hour(paper):
    assert codes(paper, "danger") == ["short-life"]
    assert re.search(r"life after all factors: 0\.\d+ h, at least 1 h", texts(paper)[0])
    assert text(paper).startswith("DANGER: life after all factors: ")


def test_the_paper_bearing_says_what_its_losses_hang_on(paper):
    (told,) = (note for note in texts(paper) if note.startswith("losses: "))
    assert told.startswith("losses: 79% are drag of the oil-air mixture")
    assert told.endswith("0.3324, fitted")
    assert keys(paper, "drag-loss") == {"lubricant.oil_fraction": ""}


def test_dents_are_a_danger():
    result = flexbearing.run(PLAIN, HEAVY)
    assert result.attributes["status"] == "converged"
    assert "contact-pressure" in codes(result, "danger")
    first = text(result).splitlines()[0]
    assert first.startswith("DANGER: peak contact pressure, inner raceway and outer raceway: ")
    assert result.summary()["notes"][0]["code"] == "contact-pressure"


def test_a_load_above_half_of_the_rating_is_beyond_the_life_formulas(paper):
    assert "heavy-load" in codes(paper, "outside validity")
    words = "".join(texts(paper))
    assert re.search(r"equivalent load P: [\d.]+ kN, at most [\d.]+ kN \(half of C_r, ISO 281", words)


def test_a_load_below_the_minimum_is_said():
    result = flexbearing.run(PLAIN, {"operation.radial_load": "100 N"})
    assert "light-load" in codes(result, "information")


def test_tooth_forces_that_the_pin_does_not_balance_are_outside_validity():
    planet = ROOT / "configs" / "planet.toml"
    unbalanced = {"outer.tooth_tangential": ["4 kN", "-4 kN"]}
    assert [
        [note.code for note in of_case(read_case(planet, settings))].count("unbalanced-teeth")
        for settings in ({}, unbalanced)
    ] == [0, 1]


def test_axial_tooth_forces_that_the_moment_of_the_pin_does_not_balance_are_outside_validity():
    planet = ROOT / "configs" / "planet.toml"
    helical = {
        "outer.tooth_axial": ["650 N", "-650 N"],
        "operation.tilt": "free",
        "operation.tilt_direction": "90 deg",
    }
    assert [
        [note.code for note in of_case(read_case(planet, {**helical, **more}))].count("unbalanced-teeth")
        for more in ({"operation.moment": "62.4 N m"}, {"operation.moment": "50 N m"})
    ] == [0, 1]


@pytest.mark.slow
def test_only_a_strict_run_fails_for_a_danger(tmp_path):
    def ended(*words):
        line = [sys.executable, "-m", "flexbearing", "run", PLAIN, "-o", tmp_path / "out.h5", "--set", *HEAVY]
        return subprocess.run([*line, *words], capture_output=True, text=True, cwd=ROOT)

    assert ended("--quiet").returncode == 0
    strict = ended("--quiet", "--strict")
    assert strict.returncode == 1
    assert strict.stderr.count("\n") == 3  # a short life and a static overload as well
    assert "contact pressure" in strict.stderr


def test_notes_are_ordered_by_gravity():
    notes = [
        information("a", "1"),
        outside("b", "2"),
        danger("c", "3"),
        danger("unmet-target", "4"),
        danger("c", "3"),
    ]
    assert [note.text for note in graded(notes)] == ["4", "3", "2", "1"]
    assert danger("c", "3") == Note("danger", "c", "3")
    assert GRADES == STORED


def test_the_page_of_notes_names_every_code_under_its_grade():
    made = {
        (GRADE[grade], code)
        for package in ("quasidynamic", "flexbearing")
        for path in (ROOT / package).rglob("*.py")
        for grade, code in MADE.findall(path.read_text())
    } | {(judged._GRADES[each.grade], each.code) for each in DECLARED if each.noted}
    page, told, grade = (ROOT / "docs" / "howto" / "notes.md").read_text(), set(), ""
    for line in page.splitlines():
        if line.startswith("## "):
            grade = line[3:].lower()
        elif line.startswith("|`"):
            told.add((grade, line.split("`")[1]))
    assert told == made


def test_json_carries_grade_code_and_text(paper):
    notes = json.loads(json.dumps(paper.summary()))["notes"]
    assert all(note.keys() - {"keys"} == {"grade", "code", "text"} for note in notes)
    assert [note["grade"] for note in notes] == sorted((note["grade"] for note in notes), key=GRADES.index)


def test_dangers_of_rows_reach_the_end_of_a_study(tmp_path):
    from flexbearing.studies import messages
    from flexbearing.studies.prepare import compute, prepare_source

    case, file = ROOT / "configs" / "catalogue" / "7208.toml", tmp_path / "thrust.toml"
    file.write_text(f'case = "{case}"\n[over]\n"operation.load.axial" = ["3 kN", "-3 kN"]\n')
    prepared = prepare_source(file)
    words = messages.end(prepared, compute(prepared, tmp_path), tmp_path).splitlines()
    assert words[1].startswith(
        "converged rows with findings: 1 (reversed-thrust 1), the first is variant 2: danger: "
    )
