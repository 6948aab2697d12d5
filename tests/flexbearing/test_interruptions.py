"""Signals end every command in one line, wherever they come; nothing is left running."""

import os
import pty
import re
import signal
import subprocess
import sys
import time
from contextlib import suppress

import pytest

import flexbearing
from tests.places import ROOT

PAPER = ROOT / "configs" / "mao2016.toml"
PROGRAM = [sys.executable, "-m", "flexbearing"]
CODES = {signal.SIGINT: 130, signal.SIGTERM: 143, signal.SIGHUP: 129}
EVERY_SIGNAL = pytest.mark.parametrize(
    "number",
    [signal.SIGINT, *(pytest.param(n, marks=pytest.mark.slow) for n in (signal.SIGTERM, signal.SIGHUP))],
    ids=lambda number: number.name,
)
BEAM = ["inner.kind=rigid", "outer.kind=ring", "accuracy.structure=beam", "accuracy.slices=120"]
# Half a minute: progress is printed every three seconds.
LONG = ["coupling.method=relaxed", "coupling.relaxation=0.01", "coupling.max_iterations=100000"]

# A signal comes while a module is looked for; what happens then is `act`.
TRAP = """
import os, signal, sys
NUMBER, MODULE = signal.Signals[sys.argv.pop(1)], sys.argv.pop(1)
def act():
    os.kill(os.getpid(), NUMBER)
class Trap:
    armed = True
    def find_spec(self, name, *_):
        if self.armed and name == MODULE:
            self.armed = False
            act()
sys.meta_path.insert(0, Trap())
"""
MAIN = "\nfrom flexbearing.__main__ import main; main()"
IN_A_DESTRUCTOR = """
class Last:
    def __del__(self):
        os.kill(os.getpid(), NUMBER)
def act():
    Last()
"""
AS_ANOTHER_ERROR = """
def act():
    try:
        os.kill(os.getpid(), NUMBER)
    except BaseException as problem:
        raise ImportError("numpy failed to import") from problem
"""
CLEANING_UP_FOR_LONG = """
import time
def act():
    try:
        os.kill(os.getpid(), NUMBER)
    finally:
        print("cleaning up", flush=True)
        time.sleep(600)
"""


def sets(settings):
    return [word for setting in settings for word in ("--set", setting)]


def trapped(number, module, *words, code="", **options):
    arguments = [sys.executable, "-c", TRAP + code + MAIN, number.name, module, *map(str, words)]
    return subprocess.run(arguments, capture_output=True, text=True, check=False, cwd=ROOT, **options)


def started(*words):
    """A program in a group of processes of its own."""
    return subprocess.Popen(
        [*PROGRAM, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        start_new_session=True, cwd=ROOT,
        env=os.environ | {"FLEXBEARING_CACHE": "off", "PYTHONUNBUFFERED": ""},
    )  # fmt: skip


def wait_for(stream, words):
    read = []
    for line in iter(stream.readline, ""):
        read.append(line)
        if words in line:
            return
    raise AssertionError(f"{words!r} is not in what was written: {''.join(read)}")


def last_line(errors):
    """Of the error stream: below those of its progress."""
    return errors.splitlines(keepends=True)[-1]


def ended(process):
    return last_line(process.communicate(timeout=120)[1])


def wait_for_iterations(folder):
    """Until the file of a run at work holds some."""
    for _ in range(600):
        with suppress(flexbearing.BadResult):
            if any(flexbearing.read(part).attributes["iterations"] for part in folder.glob("*.part")):
                return
        time.sleep(0.1)
    raise AssertionError("no iteration was stored")


@EVERY_SIGNAL
def test_signal_ends_a_run_in_one_line_with_its_exit_code(number, tmp_path):
    process = started("run", PAPER, "-o", tmp_path / "out.h5", *sets(BEAM + LONG))
    wait_for(process.stderr, "bearing and rings coupled")
    wait_for_iterations(tmp_path)
    process.send_signal(number)
    complaint = ended(process)
    assert process.returncode == CODES[number]
    (kept,) = tmp_path.iterdir()
    assert re.fullmatch(rf"interrupted: .* \d+ iterations kept in {kept}\n", complaint)
    assert kept.suffix == ".part"
    assert flexbearing.read(kept).attributes["status"] == "unfinished"


def test_what_the_terminal_sends_to_all_processes_ends_meshing_without_a_trace(tmp_path):
    solid = [
        "inner.kind=rigid", "accuracy.structure=solid", "accuracy.element_order=2", "outer.bars=8",
        "outer.bar_width=10 mm", "accuracy.mesh_size=8 mm", "accuracy.raceway_mesh_size=3.5 mm",
        "accuracy.patch_width=1.5 mm", "accuracy.slices=8", "accuracy.axial_shapes=2",
    ]  # fmt: skip
    process = started("run", PAPER, "-o", tmp_path / "out.h5", *sets(solid))
    wait_for(process.stderr, "outer ring")
    os.killpg(process.pid, signal.SIGINT)
    complaint = ended(process)
    assert process.returncode == 130
    (kept,) = tmp_path.iterdir()
    assert complaint == f"interrupted: the state with rigid raceways kept in {kept}\n"
    with pytest.raises(ProcessLookupError):  # nothing is left running
        os.killpg(process.pid, 0)


@pytest.mark.parametrize(
    ("number", "module"),
    [
        (signal.SIGINT, "typer"),
        (signal.SIGTERM, "flexbearing.families"),
        (signal.SIGHUP, "numpy.linalg"),
        (signal.SIGINT, "pydantic.types"),
    ],
)
def test_signal_during_imports_leaves_no_traceback(number, module):
    done = trapped(number, module, "check", PAPER)
    assert (done.returncode, done.stdout, done.stderr) == (CODES[number], "", "interrupted\n")


@pytest.mark.parametrize("code", [IN_A_DESTRUCTOR, AS_ANOTHER_ERROR], ids=["destructor", "another error"])
def test_signal_is_not_lost_where_an_exception_would_be(code):
    done = trapped(signal.SIGTERM, "quasidynamic", "check", PAPER, code=code)
    assert (done.returncode, done.stderr) == (143, "interrupted\n")


def test_second_signal_ends_at_once():
    words = [TRAP + CLEANING_UP_FOR_LONG + MAIN, "SIGINT", "typer", "check", str(PAPER)]
    process = subprocess.Popen(
        [sys.executable, "-c", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=ROOT
    )
    wait_for(process.stdout, "cleaning up")
    process.send_signal(signal.SIGTERM)
    _, complaint = process.communicate(timeout=120)
    assert (process.returncode, complaint) == (-signal.SIGTERM, "")


def test_ignored_signals_stay_ignored():
    """As `nohup` asks for it."""

    def ignore():
        signal.signal(signal.SIGHUP, signal.SIG_IGN)

    done = trapped(signal.SIGHUP, "quasidynamic", "check", PAPER, preexec_fn=ignore)
    assert (done.returncode, done.stderr) == (0, "")
    assert "no errors found" in done.stdout


@pytest.mark.slow
def test_interrupted_study_names_the_table_that_is_complete(tmp_path):
    words = ["map", PAPER, "--over", "operation.radial_load=5 kN..8 kN", "-o", tmp_path / "t.csv"]
    done = trapped(signal.SIGTERM, "matplotlib.figure", *words)
    assert done.returncode == 143
    assert last_line(done.stderr) == f"interrupted: the table is complete: {tmp_path / 't.csv'}\n"
    assert [path.name for path in tmp_path.iterdir()] == ["t.csv"]


@pytest.mark.slow
def test_interrupted_plot_names_the_pictures_that_are_complete(tmp_path):
    flexbearing.run(PAPER, BEAM, output=tmp_path / "r.h5")
    done = trapped(signal.SIGINT, "matplotlib.figure", "plot", tmp_path / "r.h5")
    assert (done.returncode, last_line(done.stderr)) == (130, "interrupted: nothing was kept\n")
    done = trapped(signal.SIGINT, "fem.assembly.factorisation", "plot", tmp_path / "r.h5", "-o", tmp_path)
    names = ("roller_loads", "convergence", "raceway_deviation", "pressure_map", "pressure_along")
    pictures = [tmp_path / f"r_{name}.png" for name in names]
    assert last_line(done.stderr) == f"interrupted: complete: {', '.join(map(str, pictures))}\n"
    assert (done.returncode, sorted(tmp_path.glob("*.png"))) == (130, sorted(pictures))


def test_interruption_after_a_result_was_written_names_it(tmp_path, monkeypatch):
    def stop(_):
        raise KeyboardInterrupt

    monkeypatch.setattr("flexbearing.results.write._remove_parts", stop)
    with pytest.raises(KeyboardInterrupt) as ending:
        flexbearing.run(PAPER, BEAM, output=tmp_path / "out.h5")
    assert ending.value.__notes__ == [f"complete: {tmp_path / 'out.h5'}"]
    assert flexbearing.read(tmp_path / "out.h5").attributes["status"] == "converged"


@pytest.mark.slow
def test_progress_bar_is_ended_before_the_line(tmp_path):
    ours, theirs = pty.openpty()
    words = [*PROGRAM, "run", str(PAPER), "-o", str(tmp_path / "out.h5"), *sets(BEAM + LONG)]
    environment = os.environ | {"TERM": "xterm", "COLUMNS": "200"}
    with subprocess.Popen(
        words, stdin=theirs, stdout=theirs, stderr=theirs, cwd=ROOT, env=environment
    ) as process:
        os.close(theirs)
        seen = b""
        while chunk := _read(ours):
            if b": iteration" in seen + chunk and b": iteration" not in seen:
                process.send_signal(signal.SIGINT)
            seen += chunk
    os.close(ours)
    assert process.returncode == 130
    bar, line = seen.decode().rsplit("\x1b[?25h", 1)  # the cursor is shown again
    assert "\x1b[?25l" in bar
    assert "\x1b" not in line
    assert line.lstrip("\r\n").startswith("interrupted: ")
    assert line.startswith(("\r\n", "\r\r\n"))  # what is typed is echoed there


def _read(terminal):
    try:
        return os.read(terminal, 65536)
    except OSError:  # nobody writes there any more
        return b""


def test_a_library_changes_no_signals_and_no_streams():
    code = (
        "import signal, sys, threading\n"
        "before = [signal.getsignal(n) for n in (2, 15, 1)], sys.stdout, sys.stderr\n"
        "import flexbearing.api, flexbearing.__main__ as program\n"
        f"flexbearing.api.check({str(PAPER)!r}); program.command(['check', {str(PAPER)!r}])\n"
        "from flexbearing.program import signals\n"
        "after = [signal.getsignal(n) for n in (2, 15, 1)], sys.stdout, sys.stderr\n"
        "assert before == after\n"
        "threading.Thread(target=signals.notice).start()\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, cwd=ROOT)
    assert (done.returncode, done.stderr) == (0, "")
