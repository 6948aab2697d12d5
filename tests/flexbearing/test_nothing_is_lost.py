"""Cases and results survive whatever users do to their names, and whatever ends a run."""

import os
import shutil
import signal
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from pathlib import Path
from time import monotonic, sleep

import numpy as np
import pytest

import flexbearing
from flexbearing.api import compute, read_case
from flexbearing.files import BadOutput
from flexbearing.runs.run_case import default_output
from tests.places import CONFIGS

pytestmark = pytest.mark.usefixtures("two_cores")

PAPER = CONFIGS / "mao2016.toml"
BALLS = PAPER.with_name("joshi2015_fag.toml")
RIGID = ["outer.kind=rigid", "inner.kind=rigid"]
RING = ["inner.kind=rigid", "outer.kind=ring", "accuracy.structure=beam"]  # nothing is meshed
COMMAND = [sys.executable, "-m", "flexbearing"]


@pytest.fixture
def case(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return Path(shutil.copy(PAPER, tmp_path / "mine.toml"))


def command(*words, limit=None):
    """A command in a process of its own; `limit` is the size of the largest file it can write."""
    limited = [] if limit is None else ["prlimit", f"--fsize={limit}"]
    return subprocess.Popen(
        [*limited, *COMMAND, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )


def settings(values):
    return [word for value in values for word in ("--set", value)]


def run_by_default_name(case, overrides=()):
    """As the command line does without -o."""
    wanted = read_case(case, overrides)
    return compute(wanted, output=default_output(wanted))


@pytest.mark.slow
def test_runs_without_a_name_of_the_output_do_not_meet(case):
    loads = ["5 kN", "10 kN", "15 kN", "20 kN"]
    runs = [
        command("run", case, "--quiet", *settings([*RIGID, f"operation.radial_load={load}"]))
        for load in loads
    ]
    assert [run.communicate()[1] for run in runs] == [""] * 4
    results = [flexbearing.read(path) for path in Path("results").iterdir()]
    stored = {result.attributes["case_overrides"][-1] for result in results}
    assert stored == {f"operation.radial_load={load}" for load in loads}
    assert all("radial_load=" in result.path.name for result in results)


@pytest.mark.slow
def test_pool_of_jobs_without_names_keeps_every_result(case):
    def job(number):
        return run_by_default_name(case, [*RIGID, f"operation.radial_load={5 + number} kN"])

    with ThreadPoolExecutor(4) as pool:
        paths = {result.path for result in pool.map(job, range(12))}
    assert len(paths) == len(list(Path("results").iterdir())) == 12


def test_default_names_are_plain_and_differ_for_settings_that_read_alike(case):
    one, other = (run_by_default_name(case, [*RIGID, f'title="{title}"']).path for title in ("a/b", "a:b"))
    assert one != other
    assert one.name == f"mine_outer.kind=rigid_inner.kind=rigid_title=ab_{one.stem[-8:]}.h5"


def test_case_of_the_same_name_in_another_folder_keeps_its_result(case):
    shutil.copy(BALLS, case)
    run_by_default_name(case)
    Path("other").mkdir()
    other = shutil.copy(case, "other/mine.toml")
    with pytest.raises(BadOutput, match=r"results/mine\.h5: is the result of .*mine\.toml; choose another"):
        run_by_default_name(other)
    run_by_default_name(case)
    case.unlink()
    assert run_by_default_name(other).path == Path("results/mine.h5")  # of nobody any more


@pytest.mark.slow
def test_case_named_like_an_unfinished_result_is_not_touched(tmp_path):
    for name in ("x.h5.part", "x.h5.lock"):
        case = Path(shutil.copy(PAPER, tmp_path / name))
        run = command("run", case, "-o", tmp_path / "x.h5", "--quiet", *settings(RIGID))
        errors = run.communicate()[1]
        assert case.read_text() == PAPER.read_text()
        assert run.returncode == (0 if name.endswith("part") else 2), errors


@pytest.mark.slow
def test_full_disk_ends_with_one_line_and_leaves_the_earlier_result(tmp_path):
    """The size of files is limited, which to a program is what a full disk is."""
    out = tmp_path / "out.h5"
    flexbearing.run(PAPER, RING, output=out)
    before = out.read_bytes()
    run = command("run", PAPER, "-o", out, "--quiet", *settings([*RING, "bearing.rollers=28"]), limit=20_000)
    errors = run.communicate()[1]
    assert (run.returncode, len(errors.splitlines())) == (3, 1), errors
    assert f"{out}: not written: File too large" in errors
    assert out.read_bytes() == before
    assert list(tmp_path.iterdir()) == [out]


SLOW = [*RING, "coupling.method=relaxed", "coupling.relaxation=0.01", "coupling.max_iterations=100000"]


@pytest.fixture
def at_work(tmp_path):
    """A run that has stored a part of itself and is held there, and its output."""
    out = tmp_path / "out.h5"
    flexbearing.run(PAPER, RIGID, output=out)
    run = command("run", PAPER, "-o", out, "--quiet", *settings(SLOW))
    with run:
        end = monotonic() + 300
        while not list(tmp_path.glob("*.part")):
            assert run.poll() is None, run.communicate()[1]
            assert monotonic() < end
            sleep(0.01)
        run.send_signal(signal.SIGSTOP)
        yield run, out
        run.kill()


@pytest.mark.slow
def test_second_run_to_an_output_is_refused_by_name(at_work):
    run, out = at_work
    second = command("run", PAPER, "-o", out, "--quiet", *settings(RIGID))
    errors = second.communicate()[1]
    assert (second.returncode, len(errors.splitlines())) == (2, 1), errors
    assert f"{out} is being written by process {run.pid} on {os.uname().nodename}" in errors
    assert run.poll() is None


@pytest.mark.slow
def test_killed_run_leaves_the_earlier_result_and_the_next_one_cleans_up(at_work):
    run, out = at_work
    before = out.read_bytes()
    run.send_signal(signal.SIGKILL)
    run.wait()
    assert out.read_bytes() == before
    (part,) = out.parent.glob("*.part")
    unfinished = flexbearing.read(part)
    assert unfinished.attributes["status"] == "unfinished"
    assert unfinished.rigid["inner_load"].max() > 0
    new = flexbearing.run(PAPER, RIGID, output=out)
    assert list(out.parent.iterdir()) == [out]
    old = unfinished.rigid["inner_load"]
    np.testing.assert_array_equal(new.rigid["inner_load"], old)


@pytest.mark.slow
def test_whoever_reads_an_unfinished_result_does_not_disturb_the_run(tmp_path):
    out = tmp_path / "out.h5"
    run = command("run", PAPER, "-o", out, "--quiet", *settings([*RING, "coupling.method=relaxed"]))
    while run.poll() is None:
        for part in tmp_path.glob("out.h5.*.part"):
            with suppress(FileNotFoundError), part.open("rb"):  # held open while the run replaces it
                sleep(0.05)
    assert (run.returncode, run.communicate()[1]) == (0, "")
    assert flexbearing.read(out).attributes["status"] == "converged"
