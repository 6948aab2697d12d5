"""Worker processes: answers, exceptions, deaths, starts that fail, and the end."""

import os
from contextlib import closing

import pytest

from flexbearing.program import interpreter
from flexbearing.program.interpreter import Interpreter, NeverStarted
from flexbearing.program.worker_processes import STARTS, Processes
from tests.flexbearing.process_calls import own_process, second
from tests.flexbearing.test_interpreter import await_gone, both, with_a_child

pytestmark = pytest.mark.usefixtures("two_cores")


def test_answers_exceptions_and_deaths_are_handed_back():
    with closing(Processes(1)) as processes:
        for call in ((abs, -3), (int, "three"), (os._exit, 1), (abs, -4)):
            processes.submit(*call)
        ends = [*processes.as_completed()]
    assert [done.answer for done in ends] == [3, None, None, 4]
    assert isinstance(ends[1].raised, ValueError)
    assert [done.died for done in ends] == [False, False, True, False]


def test_two_processes_take_calls_that_are_submitted_meanwhile(tmp_path):
    """Both are at work at once; a third call comes when one of them is free."""
    with closing(Processes(2)) as processes:
        for _ in range(2):
            processes.submit(second, tmp_path)
        ends = processes.as_completed()
        numbers = {next(ends).answer}
        processes.submit(own_process, tmp_path)
        numbers |= {done.answer for done in ends}
    assert len(numbers) == 2
    assert os.getpid() not in numbers
    await_gone(numbers)


def test_few_calls_start_few_processes(monkeypatch):
    started = []
    monkeypatch.setattr(
        "flexbearing.program.worker_processes.Interpreter",
        lambda *given: started.append(given) or Interpreter(*given),
    )
    with closing(Processes(8)) as processes:
        assert not started
        for number in (1, 2):
            processes.submit(abs, number)
        assert {done.answer for done in processes.as_completed()} == {1, 2}
    assert len(started) == 2


def test_processes_that_never_start_are_given_up_with_their_last_words(monkeypatch, tmp_path):
    starts, broken = [], os.environ | {"PYTHONHOME": str(tmp_path)}
    monkeypatch.setattr(interpreter, "environment", lambda jobs: starts.append(jobs) or broken)
    with closing(Processes(2)) as processes:
        for number in range(4):
            processes.submit(abs, number)
        with pytest.raises(NeverStarted, match=r"worker processes end with 1: .*encodings"):
            list(processes.as_completed())
    assert 2 * STARTS < len(starts) <= 2 * STARTS + 2


def test_the_end_is_that_of_whatever_is_computed(tmp_path):
    processes, place = Processes(1), tmp_path / "processes"
    processes.submit(abs, -3)
    ends = processes.as_completed()
    next(ends)
    processes.submit(with_a_child, place)
    numbers = both(place)
    processes.submit(abs, -4)
    processes.close()
    await_gone(numbers)
    assert not list(ends)
