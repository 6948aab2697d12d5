"""A process beside this one: answers, exceptions and ends, its own and those of the one that called."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from flexbearing.program import interpreter
from flexbearing.program.interpreter import Died, Interpreter, NeverStarted
from tests.fem.processes import Lost
from tests.places import ROOT

pytestmark = pytest.mark.usefixtures("two_cores")

CALLER = """
import sys
from flexbearing.program.interpreter import Interpreter
from tests.flexbearing.test_interpreter import with_a_child
process = Interpreter(1)
process.await_start()
process.send(with_a_child, sys.argv[1])
process.answer()
"""


@pytest.fixture
def process():
    one = Interpreter(1)
    yield one
    one.end()


def with_a_child(place):
    """As long as a test takes; the process and the one that it started stand in a file."""
    child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)"])
    unfinished = Path(f"{place}.unfinished")
    unfinished.write_text(f"{os.getpid()} {child.pid}")
    unfinished.rename(place)
    time.sleep(600)


def both(place):
    gone_by = time.monotonic() + 120
    while not place.exists():
        assert time.monotonic() < gone_by
        time.sleep(0.02)
    return place.read_text().split()


def running(number):
    """Whether a process is there that is more than its entry in the table of processes."""
    try:
        return Path(f"/proc/{number}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


def await_gone(processes):
    gone_by = time.monotonic() + 120
    while any(map(running, processes)):
        assert time.monotonic() < gone_by
        time.sleep(0.02)


def no_pickle(_):
    return lambda: None


def test_whatever_becomes_of_a_call_the_next_one_is_answered(process):
    """Of two calls with nothing to send back, one fails on arrival."""
    process.await_start()
    for call in ((abs, -3), (int, "three"), (no_pickle, 0), (Lost(), 0), (abs, -4)):
        process.send(*call)
    ends = [process.answer() for _ in range(5)]
    assert [answer for answer, _ in ends] == [3, None, None, None, 4]
    assert isinstance(ends[1][1], ValueError)
    assert "pickle" in str(ends[2][1])
    assert "nowhere to be found" in str(ends[3][1])


def test_a_death_is_told_with_its_code(process):
    process.await_start()
    assert process.code is None
    process.send(os._exit, 7)
    with pytest.raises(Died, match="without a result"):
        process.answer()
    process.send(abs, -3)
    with pytest.raises(Died, match="without a result"):
        process.answer()
    process.end()
    assert process.code == 7


def test_a_process_that_never_starts_is_told(monkeypatch, tmp_path):
    broken = os.environ | {"PYTHONHOME": str(tmp_path)}
    monkeypatch.setattr(interpreter, "environment", lambda workers: broken)
    process = Interpreter(1)
    with pytest.raises(NeverStarted, match=r"worker processes end with 1: .*encodings"):
        process.await_start()
    process.end()


def test_the_end_takes_along_what_the_process_started(process, tmp_path):
    place = tmp_path / "processes"
    process.send(with_a_child, place)
    processes = both(place)
    process.end()
    await_gone(processes)


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGKILL])
def test_the_end_of_the_caller_ends_the_process_in_the_middle_of_a_call(number, tmp_path):
    place = tmp_path / "processes"
    with subprocess.Popen([sys.executable, "-c", CALLER, place], cwd=ROOT) as caller:
        processes = both(place)
        caller.send_signal(number)
    await_gone(processes)
