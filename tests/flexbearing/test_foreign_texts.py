"""Texts of cases, results and drawings are shown: they control no terminal and break no picture."""

import io
import json
import re
import subprocess
import sys
import warnings
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from rich.console import Console

import flexbearing
from flexbearing import __main__ as program
from flexbearing.progress import OnTerminal
from flexbearing.report.output import text, write_figures
from flexbearing.report.picture import picture_bytes, titled
from flexbearing.report.roller.deformed import deformed
from flexbearing.report.studies.branch_figure import draw_branch
from flexbearing.report.studies.pareto_table import Measured, Study, draw_pareto
from tests.places import CONFIGS, ROOT

CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u202e]")
TITLE = "Ring \x1b]0;owned\x07 \x9b31m\x7f \u202etxt $x_{$ \\frac{ [red]a[/red] 保 \ue000 %s {}"
IN_TOML = TITLE.translate({ord(c): f"\\u{ord(c):04x}" for c in "\x1b\x07\x9b\x7f\u202e"} | {92: "\\\\"})


@pytest.fixture(scope="module")
def case(tmp_path_factory):
    path = tmp_path_factory.mktemp("case") / "case.toml"
    lines = (CONFIGS / "nu209.toml").read_text().splitlines()
    path.write_text("\n".join(f'title = "{IN_TOML}"' if line.startswith("title") else line for line in lines))
    return path


@pytest.fixture(scope="module")
def result(case):
    return flexbearing.run(case, output=case.with_name("r.h5"))


def shown(words, capsys):
    assert program.command([str(word) for word in words]) == 0
    return capsys.readouterr().out


@pytest.mark.slow
def test_title_controls_no_terminal(case, result, tmp_path, capsys):
    assert result.attributes["title"] == TITLE
    commands = {
        "check": ["check", case],
        "run": ["run", case, "-o", tmp_path / "r.h5"],
        "summary": ["summary", result.path],
        "map": ["map", case, "--over", "operation.radial_load=5 kN..6 kN", "-o", tmp_path / "t.csv"],
        "plot": ["plot", result.path, "-o", tmp_path],
        "json": ["summary", result.path, "--json"],
    }
    told = {name: shown(words, capsys) for name, words in commands.items()}
    assert [name for name, words in told.items() if CONTROL.search(words)] == []
    assert json.loads(told["json"])["title"] == TITLE
    for name in ("check", "run", "summary", "map"):
        assert r"Ring \x1b]0;owned\x07 \x9b31m\x7f \u202etxt $x_{$ \frac{ [red]a[/red] 保" in told[name]


def test_every_text_of_a_page_is_shown(result):
    hostile = "\x1b[2J[bold]x\x9b"
    attributes = {
        **result.attributes,
        "notes": [{"grade": "danger", "code": hostile, "text": hostile}],
        "message": hostile, "assumed": (hostile,), "calibrated": {hostile: hostile},
        "status": "not solved", "ending": hostile, "regimes": {"rigid": {"inner": hostile, "outer": hostile}},
    }  # fmt: skip
    page = text(replace(result, attributes=attributes))
    assert not CONTROL.search(page)
    assert page.count(r"\x1b[2J[bold]x\x9b") >= 8
    assert replace(result, attributes=attributes).summary()["message"] == hostile  # JSON escapes it by itself


@pytest.mark.slow
def test_complaints_and_log_lines_control_no_terminal(tmp_path):
    name = "no\x1b[31m\x9b.toml"
    case = str(CONFIGS / "nu209.toml")
    words = {
        "no such case": ["check", name],
        "no such option": ["check", f"--{name}"],
        "no such key": ["check", case, "--set", f"{name}=1"],
        "no such command": [name],
        "no such result": ["summary", name],
        "impossible output": ["pareto", case, "-o", f"{name}.csv/x"],
        "with the traceback": ["--debug", "check", name],
    }
    (tmp_path / f"{name}.csv").touch()
    for arguments in words.values():
        command = [sys.executable, "-m", "flexbearing", *arguments]
        done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path, check=False)
        assert done.returncode == 2
        assert r"no\x1b[31m\x9b.toml" in done.stderr
        assert not CONTROL.search(done.stderr)
    code = (
        "import logging; from flexbearing import cli\n"
        "for everything in (True, False):\n"
        "    cli._log(everything=everything); logging.getLogger('flexbearing').warning('mesh \\x1b[31m')\n"
        "    logging.getLogger().handlers.clear()"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT)
    assert (done.stdout, done.stderr) == ("", 2 * "mesh \\x1b[31m\n")


def test_stages_on_a_terminal_are_neither_obeyed_nor_marked_up():
    file = io.StringIO()
    console = Console(file=file, force_terminal=True, width=100, color_system=None)
    with OnTerminal(console) as report:
        report.stage("[red]outer[/red] [/] \x1b]0;owned\x07", 0.5)
    assert r"[red]outer[/red] [/] \x1b]0;owned\x07" in file.getvalue()
    assert "\x07" not in file.getvalue()


@pytest.mark.slow
@pytest.mark.parametrize("name", ["nu209", "heras2017_a1", "rivera2021_7008"])
def test_pictures_draw_any_title(name, tmp_path):
    result = flexbearing.run(CONFIGS / f"{name}.toml", output=tmp_path / "r.h5")
    hostile = replace(result, attributes={**result.attributes, "title": TITLE + "x" * 5000})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        pictures = write_figures(hostile, tmp_path)
    assert pictures
    assert all(picture.read_bytes().startswith(b"\x89PNG") for picture in pictures)


@pytest.mark.slow
def test_pictures_of_studies_and_deformed_rings_draw_any_title():
    level = Measured(
        name="level", settings=(), times={"cold": 1.0, "cached": 1.0},
        errors=dict.fromkeys(("load", "slip", "life", "stiffness"), 0.01),
    )  # fmt: skip
    names = "load", "cage_slip", "stable", "fold"
    table = dict(zip(names, ([1.0, 2.0], [0.1, 0.2], [1, 1], [0, 0]), strict=True))
    corners = np.array([[[0, 1, 0], [0, 0, 1], [1, 0, 0]]]) * 0.05
    skin = SimpleNamespace(points=corners, displacement=corners * 1e-3, von_mises=np.ones((1, 3)) * 1e8)
    figures = [
        draw_branch(TITLE, "load", {name: np.array(values) for name, values in table.items()}),
        draw_pareto(Study(title=TITLE, reference=level, levels=(level,), left_out=())),
        deformed(TITLE, skin, 1e8),  # pyright: ignore[reportArgumentType]
    ]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for figure in figures:
            assert picture_bytes(figure).startswith(b"\x89PNG")


def test_titles_are_broken_and_bounded():
    assert titled("a $b_c$", 70) == "a $b_c$"
    assert titled("word " * 100, 20).count("\n") == 3
    assert titled("\x1b", 20) == r"\x1b"
