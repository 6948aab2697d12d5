"""Dangers come first, carry a code, and end a strict run with 1."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest
from flexbearing.runs.dangers import (
    LEAST_OF_BALLS,
    LEAST_OF_ROLLERS,
    heavily_loaded,
    lightly_loaded,
    overloaded,
    pressed,
    short_lived,
    yielding,
)

import flexbearing
from flexbearing.api import read_case
from flexbearing.quantities.attributes import GRADES as STORED
from flexbearing.report import text
from flexbearing.report.html import strength_checks
from flexbearing.runs.notes import of_case
from quasidynamic.note import GRADES, Note, danger, graded, information, outside
from tests.flexbearing.noted import codes, texts

ROOT = Path(__file__).parents[2]
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
    assert re.search(r"million revolutions last \d\d\.\d minutes at 38,000 rpm", texts(paper)[0])
    assert text(paper).startswith("DANGER: life: ")


def test_the_paper_bearing_says_what_its_losses_hang_on(paper):
    (told,) = (note for note in texts(paper) if note.startswith("losses: "))
    assert told.startswith("losses: 79% are drag of the oil-air mixture")
    assert told.endswith("lubricant.oil_fraction = 0.3324, fitted")


def test_dents_are_a_danger(tmp_path):
    result = flexbearing.run(PLAIN, HEAVY, output=tmp_path / "out.h5")
    assert result.attributes["status"] == "converged"
    assert "contact-pressure" in codes(result, "danger")
    first = text(result).splitlines()[0]
    assert first.startswith("DANGER: contact pressure of ")
    assert result.summary()["notes"][0]["code"] == "contact-pressure"


def test_a_load_above_half_of_the_rating_is_beyond_the_life_formulas(paper):
    assert "heavy-load" in codes(paper, "outside validity")
    assert re.search(r"load of [\d,]+ N is above half of C_r = [\d,]+ N", "".join(texts(paper)))
    assert list(heavily_loaded(50.0, 100.0)) == []
    (note,) = heavily_loaded(50.1, 100.0)
    assert note.code == "heavy-load"


def test_a_load_below_the_minimum_is_said():
    result = flexbearing.run(PLAIN, {"operation.radial_load": "100 N"})
    assert "light-load" in codes(result, "information")
    assert list(lightly_loaded(2.0, 100.0, LEAST_OF_ROLLERS)) == []
    (note,) = lightly_loaded(1.9, 100.0, LEAST_OF_ROLLERS)
    assert note.text.startswith("minimum load: 2 N is below 0.02 C_r = 2 N")
    assert (LEAST_OF_ROLLERS, LEAST_OF_BALLS) == (
        strength_checks.LEAST_OF_ROLLERS,
        strength_checks.LEAST_OF_BALLS,
    )


def test_tooth_forces_that_the_pin_does_not_balance_are_outside_validity():
    planet = ROOT / "configs" / "planet.toml"
    unbalanced = {"outer.tooth_tangential": ["4 kN", "-4 kN"]}
    assert [
        [note.code for note in of_case(read_case(planet, settings))].count("unbalanced-teeth")
        for settings in ({}, unbalanced)
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


def test_limits_of_dangers():
    for limit in (4.0e9, 4.2e9):
        assert [note.code for note in pressed(1.001 * limit, limit)] == ["contact-pressure"]
        assert not [*pressed(0.999 * limit, limit)]
    found = [[(note.grade, note.code) for note in overloaded(safety, 1.5)] for safety in (0.99, 1.01, 1.49)]
    assert found == [[(grade, "static-safety")] for grade in ("danger", "information", "information")]
    assert not [*overloaded(1.51, 1.5), *overloaded(1.01, 1.0), *overloaded(float("inf"), 1.5)]
    turn = 2 * 3.141592653589793 * 10  # [rad/s] ten turns a second: 36 000 an hour
    assert [note.code for note in short_lived(0.0359, -turn)] == ["short-life"]
    assert not [*short_lived(0.0361, turn)]
    assert not [*short_lived(0.0, 0.0)]  # nothing turns
    assert [note.code for note in yielding("bars", 1001e6, 1000e6)] == ["yield-stress"]
    assert not [*yielding("bars", 999e6, 1000e6)]
    assert not [*yielding("bars", 5e9, None)]


def test_the_page_of_notes_names_every_code_under_its_grade():
    made = {
        (GRADE[grade], code)
        for package in ("quasidynamic", "flexbearing")
        for path in (ROOT / package).rglob("*.py")
        for grade, code in MADE.findall(path.read_text())
    }
    page, told, grade = (ROOT / "docs" / "howto" / "notes.md").read_text(), set(), ""
    for line in page.splitlines():
        if line.startswith("## "):
            grade = line[3:].lower()
        elif line.startswith("| `"):
            told.add((grade, line.split("`")[1]))
    assert told == made


def test_json_carries_grade_code_and_text(paper):
    notes = json.loads(json.dumps(paper.summary()))["notes"]
    assert all(note.keys() == {"grade", "code", "text"} for note in notes)
    assert [note["grade"] for note in notes] == sorted((note["grade"] for note in notes), key=GRADES.index)
