"""One place decides how many threads and processes work at once."""

import os
import re
from pathlib import Path

import pytest
from threadpoolctl import threadpool_info

import flexbearing
from flexbearing import __main__ as program
from flexbearing.program import threads
from flexbearing.program.threads import linear_algebra_alone

PACKAGES = Path(flexbearing.__file__).parents[1]
PAPER = PACKAGES / "configs" / "mao2016.toml"


def test_cores_are_those_of_the_queue_then_of_the_user_then_of_the_system(monkeypatch):
    for name in threads.VARIABLES:
        monkeypatch.delenv(name, raising=False)
    assert threads.cores() == len(os.sched_getaffinity(0))
    monkeypatch.setenv("FLEXBEARING_THREADS", "6")
    assert threads.cores() == 6
    monkeypatch.setenv("SLURM_CPUS_PER_TASK", "3")
    assert threads.cores() == 3


@pytest.mark.parametrize("text", ["0", "two", "-1", "1.5", "²", "9" * 5000, "1e3", "4097"])
def test_a_number_of_cores_that_is_none_is_refused(monkeypatch, text):
    monkeypatch.setenv("SLURM_CPUS_PER_TASK", text)
    with pytest.raises(threads.BadCount, match=r"SLURM_CPUS_PER_TASK=.* is no number of cores"):
        threads.cores()


def test_threads_times_workers_are_no_more_than_the_cores(monkeypatch):
    monkeypatch.setenv("SLURM_CPUS_PER_TASK", "8")
    for jobs, each in ((1, 8), (3, 2), (8, 1), (20, 1)):
        variables = threads.environment(jobs)
        assert variables["FLEXBEARING_THREADS"] == str(each)
        assert variables["OPENBLAS_NUM_THREADS"] == "1"
        assert "SLURM_CPUS_PER_TASK" not in variables


def test_jobs_limit_the_cores_and_never_add_some(monkeypatch):
    monkeypatch.setenv("SLURM_CPUS_PER_TASK", "4")
    for jobs, most in ((None, 4), (1, 1), (3, 3), (9, 4)):
        with threads.limited_to(jobs):
            assert threads.cores() == most
            assert threads.environment(jobs or 4)["FLEXBEARING_THREADS"] == "1"
        assert (threads.cores(), os.environ["SLURM_CPUS_PER_TASK"]) == (4, "4")


def test_solids_take_what_a_case_asks_for_and_no_more_than_the_cores(monkeypatch):
    monkeypatch.setenv("SLURM_CPUS_PER_TASK", "3")
    assert [threads.of_solids(wanted) for wanted in (None, 1, 3, 64)] == [3, 1, 3, 3]


def test_linear_algebra_has_one_thread_inside_and_as_many_as_before_outside():
    before = {info["filepath"]: info["num_threads"] for info in threadpool_info()}
    with linear_algebra_alone():
        assert {info["num_threads"] for info in threadpool_info() if info["user_api"] == "blas"} == {1}
    assert {info["filepath"]: info["num_threads"] for info in threadpool_info()} == before


def test_a_number_of_cores_that_is_none_ends_a_command_as_bad_input(monkeypatch, capsys, tmp_path):
    monkeypatch.setenv("FLEXBEARING_THREADS", "many")
    solid = ["--set", "accuracy.structure=solid", "--set", "inner.kind=rigid"]
    assert program.command(["run", str(PAPER), "-o", str(tmp_path / "r.h5"), *solid]) == 2
    assert "FLEXBEARING_THREADS='many' is no number of cores" in capsys.readouterr().err


def test_no_other_module_asks_for_cores_or_limits_threads():
    asking = re.compile(r"cpu_count|sched_getaffinity|threadpool|SLURM_CPUS")
    names = "flexbearing", "fem", "quasidynamic"
    sources = [path for name in names for path in (PACKAGES / name).rglob("*.py")]
    assert [path.name for path in sources if asking.search(path.read_text())] == ["threads.py"]
