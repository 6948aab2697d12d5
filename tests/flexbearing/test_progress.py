"""What a person sees while a command works: bars on a terminal, plain lines elsewhere."""

import logging
import os
import pty
import re
import sys
from io import StringIO
from subprocess import DEVNULL, Popen
from time import perf_counter, sleep
from types import SimpleNamespace

import numpy as np
import pytest
from rich.console import Console

from flexbearing import api, progress
from flexbearing.progress import Lines, Logged, OnTerminal
from tests.places import CONFIGS

BALLS = CONFIGS / "heras2017_b1.toml"
SILENT = 20.0  # [s]
FOUR = ["bearing.balls=4", "friction.model=fastsim", "friction.cells=[16, 16]"]


@pytest.fixture(autouse=True)
def every_three_seconds(monkeypatch):
    monkeypatch.setattr(progress, "EVERY", 3.0)


class Told(Logged):
    """Keeps what it is told."""

    def __init__(self):
        super().__init__()
        self.stages = []

    def stage(self, text, fraction):
        self.stages.append((text, fraction))
        super().stage(text, fraction)


def test_stick_and_slip_is_told_ball_by_ball():
    report = Told()
    api.compute(api.read_case(BALLS, FOUR), report=report)
    parts = [part for text, part in report.stages if text == "stick and slip, ball by ball"]
    assert parts == [0.25, 0.5, 0.75, 1.0]


def test_lines_tell_the_part_of_a_stage_that_goes_on(monkeypatch, caplog):
    caplog.set_level(logging.INFO, "flexbearing.run")
    clock = iter([0.0, 1.0, 2.0, 4.0, 5.0, 30.0, 31.0])
    monkeypatch.setattr(progress, "perf_counter", lambda: next(clock))
    report = Logged()
    report.stage("rings", None)
    for part in (0.1, 0.2, 0.55, 0.6, 0.975):
        report.stage("balls", part)
    report.stage("balls", None)
    assert caplog.messages == ["rings", "balls", "balls: 55 % done", "balls: 98 % done"]


def iteration(number):
    state = SimpleNamespace(loads=np.ones((2, 3)))
    return SimpleNamespace(number=number, load_change=1e-3, state=state)


def test_iterations_and_details_are_lines_only_after_a_while(monkeypatch, caplog):
    caplog.set_level(logging.INFO, "flexbearing.run")
    clock = iter([0.0, 1.0, 2.0, 4.0, 5.0])
    monkeypatch.setattr(progress, "perf_counter", lambda: next(clock))
    report = Logged()
    report.stage("coupled", None)
    report.stage("outer ring: taken from the cache", None)
    for number in (1, 2, 3):
        report.iteration(iteration(number))
    assert [message[:13] for message in caplog.messages] == ["coupled", "iteration   2"]


def test_nothing_of_the_progress_stays_on_a_terminal():
    file = StringIO()
    with OnTerminal(Console(file=file, force_terminal=True, width=120)) as report:
        report.stage("coupled", None)
        report.iteration(iteration(1))
        assert "coupled: iteration   1" in report._bars.tasks[0].description
    assert not report._bars.tasks
    assert "\x1b[2K" in file.getvalue()[-20:]  # the line is erased


@pytest.mark.parametrize("part", [0.25, 0.5])
def test_bar_on_a_terminal_is_as_full_as_the_stage(part):
    console = Console(file=StringIO(), force_terminal=True, width=80)
    with OnTerminal(console) as report:
        report.stage("balls", part)
        (bar,) = report._bars.tasks
        assert (bar.description, bar.percentage) == ("balls", 100 * part)


def test_lines_say_what_is_at_work_wherever_a_while_had_none(monkeypatch, capsys):
    monkeypatch.setattr(progress, "EVERY", 0.2)
    with Lines("map") as report:
        report.stage("grid", None)
        sleep(0.7)  # nothing more is heard of it
        report.line("one fold")
    lines = capsys.readouterr().err.splitlines()
    assert [re.sub("[0-9]+ s", "_ s", line) for line in lines] == ["grid, _ s"] * len(lines[:-1]) + [
        "one fold"
    ]
    assert 2 <= len(lines) - 1 <= 4


def test_what_ends_soon_needs_no_line(capsys):
    with Lines("run") as report:
        report.stage("grid", None)
        report.stage("grid: 3 of 4", 0.75)
    assert capsys.readouterr().err == ""


LONG_COMMANDS = {
    "run": ["run", "case.toml", "-o", "out.h5"],
    "study": ["study", "study.toml", "-o", "study"],
    "map": ["map", "case.toml", "--over", "operation.radial_load=1..9 kN,5", "-o", "map.csv"],
    "sensitivity": ["sensitivity", "case.toml", "--by", "bearing.clearance", "-o", "s.png"],
    "goal": ["goal", "case.toml", "--life", "x2"],
    "optimise": ["optimise", "optimum.toml", "-o", "optimum"],
    "pareto": ["pareto", "case.toml", "-o", "pareto"],
}
FILES = {
    "study.toml": 'case = "case.toml"\n[over]\n"operation.radial_load" = "1 kN .. 9 kN, 9"\n',
    "optimum.toml": 'case = "case.toml"\n[vary]\n"bearing.roller.drop" = "2 um .. 9 um"\n'
    '[maximise]\noutput = "life_L10 [h]"\n',
}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "terminal"),
    [
        *((name, False) for name in LONG_COMMANDS),
        *((name, True) for name in LONG_COMMANDS if name != "pareto"),  # for minutes; prints as a study does
    ],
)
def test_a_long_command_is_never_silent_and_prints_no_escape_code_as_text(name, terminal, tmp_path):
    """Some were for more than a minute; a pause is three seconds at most where nothing else is at work."""
    (tmp_path / "case.toml").write_text((BALLS.parent / "nu209.toml").read_text())
    for file, text in FILES.items():
        (tmp_path / file).write_text(text)
    pauses, errors = watched(LONG_COMMANDS[name], tmp_path, terminal=terminal)
    assert max(pauses) < SILENT
    assert "\\x1b" not in errors
    assert "\\r" not in errors
    assert ("\x1b" in errors) <= terminal


def watched(words, folder, *, terminal):
    """Pauses [s] between what a command prints, and the text on its error stream."""
    ours, its = pty.openpty() if terminal else os.pipe()
    command = [sys.executable, "-m", "flexbearing", *words]
    environment = os.environ | {"TERM": "xterm", "COLUMNS": "120"}
    with Popen(command, cwd=folder, env=environment, stdout=DEVNULL, stderr=its) as process:
        os.close(its)
        last, pauses, text = perf_counter(), [0.0], b""
        while part := _read(ours):
            now = perf_counter()
            pauses.append(now - last)
            last, text = now, text + part
        pauses.append(perf_counter() - last)
        os.close(ours)
    assert process.returncode == 0
    return pauses, text.decode()


def _read(stream):
    try:
        return os.read(stream, 65536)
    except OSError:  # a terminal whose other end is closed
        return b""
