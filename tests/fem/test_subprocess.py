"""What ends a process of its own does not end the program, and is told."""

import contextlib
import os
import signal
import subprocess
import sys
import time
from threading import Event, Thread, get_ident

import numpy as np
import pytest
from pytest import approx

from fem import ClampedFace, ImpossiblePart, MeshSize, OuterRing, Patches
from fem.assembly.factorisation import NotSolved
from fem.condense import SOLID, condense, condense_in_process
from fem.subprocess import in_subprocess
from tests.fem.condensed import of_a_solid
from tests.fem.processes import (
    Lost,
    aborting,
    answering,
    deaf,
    killed,
    leaving,
    logging_of_meshes,
    silent,
    strange,
    wrong,
)
from tests.fem.test_parts import STEEL

RING = OuterRing(raceway_diameter=75e-3, thickness=8e-3, width=10e-3, elastic=STEEL, support=ClampedFace())

ROLLERS = Patches(azimuths=(0.0, 0.5), length=9e-3, axial_modes=2, width=4e-3)
COARSE = MeshSize(order=1, size=9e-3, raceway_size=7e-3)


def test_answer_and_reports_come_from_another_process():
    reports = []
    found = in_subprocess(answering, np.arange(3.0), report=lambda *told: reports.append(told))
    assert found.value == approx([0.0, 2.0, 4.0], abs=0)
    assert found.process != os.getpid()
    assert found.threads == "1"
    assert reports == [("halfway", 0.5)]


@pytest.mark.parametrize(
    ("function", "message"),
    [
        (aborting, r"signal 6 \(Aborted\); its last words: double free or corruption.*Gaps and walls"),
        (killed, r"signal 9 \(Killed\).*less memory"),
        (leaving, "exit code 7"),
        (strange, "KeyError: 'no such face'"),
    ],
)
def test_ending_is_told(function, message):
    with pytest.raises(NotSolved, match=message):
        in_subprocess(function)


def test_own_errors_stay_what_they_are():
    with pytest.raises(ImpossiblePart, match="bar_width = 1 is impossible"):
        in_subprocess(wrong)


def test_a_process_that_ends_before_it_takes_its_task_is_told():
    """More data than a pipe holds, for a function that cannot be unpacked."""
    with pytest.raises(NotSolved, match=r"(?s)exit code 1; its last words: .*nowhere"):
        in_subprocess(Lost(), bytes(10**6))


def gone(process):
    """Whether a process ends, long before its own work does."""
    gone_by = time.monotonic() + 120
    while time.monotonic() < gone_by:
        try:
            os.kill(process, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.05)
    return False


def test_silence_ends_the_process():
    with pytest.raises(NotSolved, match=r"silent for 0\.3 s and was ended"):
        in_subprocess(silent, wait=0.3)


def test_interrupt_ends_the_process():
    found = []

    def interrupted(stage, fraction):
        found.append(int(stage))
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        in_subprocess(silent, report=interrupted)
    assert gone(found[0])


def test_signals_to_all_processes_of_a_job_are_for_the_caller_alone():
    """A terminal or a queue sends them also to the process, whose end would be told as a failure."""

    def sent_to_all(stage, _):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            os.kill(int(stage), number)

    assert in_subprocess(deaf, report=sent_to_all) == "done"
    assert signal.pthread_sigmask(signal.SIG_BLOCK, ()) == set()


@pytest.mark.parametrize("thread", ["this thread", "another thread"])
def test_interrupt_while_the_process_begins_ends_it(monkeypatch, thread):
    began, over = [], Event()
    other = Thread(target=over.wait)
    other.start()
    receiver = get_ident() if thread == "this thread" else other.ident

    def stop(number, _):
        raise KeyboardInterrupt

    class Began(subprocess.Popen):
        def __init__(self, *arguments, **options):
            super().__init__(*arguments, **options)
            began.append(self.pid)
            signal.pthread_kill(receiver, signal.SIGTERM)  # held back until the process can be ended
            time.sleep(0.1)  # long enough for a handler that is not held back

    before = signal.signal(signal.SIGTERM, stop)
    try:
        monkeypatch.setattr(subprocess, "Popen", Began)
        with pytest.raises(KeyboardInterrupt):
            in_subprocess(silent)
    finally:
        signal.signal(signal.SIGTERM, before)
        over.set()
        other.join()
    assert gone(began[0])


def test_process_ends_with_its_parent():
    program = (
        f"import sys; sys.path[:] = {sys.path!r}; from tests.fem.processes import silent; "
        "from fem.subprocess import in_subprocess; "
        "in_subprocess(silent, report=lambda stage, _: print(stage, flush=True))"
    )
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as parent:
        assert parent.stdout is not None
        child = int(parent.stdout.readline())
        parent.kill()
    ended = gone(child)
    with contextlib.suppress(ProcessLookupError):
        os.kill(child, signal.SIGKILL)
    assert ended


def test_what_a_process_logs_is_logged_by_its_caller(caplog):
    with caplog.at_level("INFO", logger="fem"):
        in_subprocess(logging_of_meshes)
    assert ("fem.mesh.expense", 20, "about 12 unknowns") in caplog.record_tuples


@pytest.mark.slow
def test_condensing_in_a_subprocess_is_condensing():
    stages, asked = [], (RING, SOLID, of_a_solid(ROLLERS, COARSE, 1))
    found = condense(*asked, report=lambda stage, _: stages.append(stage))
    here = condense_in_process(*asked)
    assert found.absolute == approx(here.absolute, rel=1e-6, abs=1e-15)
    assert list(dict.fromkeys(stages)) == ["mesh", "factor", "condense"]
