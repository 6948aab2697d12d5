"""What is told while a case runs: bars on a terminal, plain lines elsewhere."""

import logging
from io import StringIO
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from rich.console import Console

from flexbearing import api, progress
from flexbearing.progress import Logged, OnTerminal

BALLS = Path(__file__).parents[2] / "configs" / "heras2017_b1.toml"
FOUR = ["bearing.balls=4", "friction.model=fastsim", "friction.cells=[16, 16]"]


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
    clock = iter([0.0, 1.0, 2.0, 11.0, 12.0, 30.0, 31.0])
    monkeypatch.setattr(progress, "perf_counter", lambda: next(clock))
    report = Logged()
    report.stage("rings", None)
    for part in (0.1, 0.2, 0.55, 0.6, 0.975):
        report.stage("balls", part)
    report.stage("balls", None)
    assert caplog.messages == ["rings", "balls", "balls: 55 % done", "balls: 98 % done"]


def iteration(number):
    state = SimpleNamespace(forces=np.ones((2, 3, 1)))
    return SimpleNamespace(number=number, load_change=1e-3, state=state)


def test_iterations_and_details_are_lines_only_after_a_while(monkeypatch, caplog):
    caplog.set_level(logging.INFO, "flexbearing.run")
    clock = iter([0.0, 1.0, 2.0, 11.0, 12.0])
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
