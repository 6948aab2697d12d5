"""Studies in jobs of a SLURM queue: profiles, and a controller with two nodes on this machine."""

import os
import signal
import subprocess
from functools import partial

import pytest

from flexbearing.case import BadCase
from flexbearing.studies.engine.on_dask import NoConnection, connected
from flexbearing.studies.engine.on_slurm import NoQueue, OnSlurm
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.file.slurm_profile import profile
from flexbearing.studies.placement import Placement
from flexbearing.studies.run import Work, run
from tests import one_machine_slurm
from tests.flexbearing import toy_studies
from tests.flexbearing.toy_studies import cubes, no_ring, toy
from tests.places import ROOT

FORTY = '"operation.radial_load" = "2 kN .. 41 kN, 40"'
PROFILE = 'jobs = 2\nmemory = "1 GB"\ninterface = "lo"\nqueue = "debug"\n'


def written(folder, text=PROFILE):
    file = folder / "site.toml"
    logs = f'logs = "{folder / "logs"}"\nprologue = ["export PYTHONPATH={ROOT}"]\n'
    file.write_text(text + logs)
    return file


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (
            'memory = "1 GB"',
            r"site\.toml: jobs is missing; it is a whole number, at least 1 and at most 10000",
        ),
        ('jobs = 2\nmemory = "much"', r'site\.toml: memory = "much" is not allowed'),
        ('jobs = 2\nmemory = "1 GB"\nwalltime = "1 h"', r'site\.toml: walltime = "1 h" is not allowed'),
        ('jobs = 2\nmemory = "1 GB"\nqueuee = "x"', r'site\.toml: queuee = "x" is not a key here.*queue'),
        ("jobs =", r"site\.toml: is not valid TOML"),
    ],
)
def test_a_wrong_profile_is_told_before_anything_is_queued(tmp_path, text, words):
    file = tmp_path / "site.toml"
    file.write_text(text)
    with pytest.raises(BadCase, match=words):
        Placement(slurm=file).engine(toy(tmp_path).plan)


def test_a_study_is_computed_in_one_place(tmp_path):
    with pytest.raises(BadCase, match="--jobs and --slurm: a study is computed in one place"):
        Placement(jobs=2, slurm=written(tmp_path)).engine(toy(tmp_path).plan)


def test_where_there_is_no_queue_the_study_says_so(tmp_path, monkeypatch):
    monkeypatch.setattr("flexbearing.studies.engine.on_slurm.which", lambda name: None)
    start = Placement(slurm=written(tmp_path)).engine(toy(tmp_path).plan)
    with pytest.raises(BadCase, match="there is no sbatch here; start the study on a login node"):
        start(1)


SBATCH = """#!/bin/sh
[ "$1" = --test-only ] && exit 0
cp "$1" {folder}/job.$$
setsid sh {folder}/job.$$ > /dev/null 2>&1 &
echo "Submitted batch job $!"
"""


@pytest.mark.slow
def test_scheduler_and_workers_of_jobs_talk_by_tls_and_leave_no_key(tmp_path, monkeypatch):
    """In a queue that starts every job at once, here."""
    pytest.importorskip("cryptography")
    prepared = toy(tmp_path)
    commands = {"sbatch": SBATCH.format(folder=tmp_path), "scancel": "#!/bin/sh\nkill -9 -- -$1"}
    for name, text in commands.items():
        (tmp_path / name).write_text(text)
        (tmp_path / name).chmod(0o700)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    with pytest.raises(NoQueue, match=r"no scheduler starts here: .*interface"):
        OnSlurm(profile(written(tmp_path, PROFILE.replace('"lo"', '"none"'))), 4)
    engine = OnSlurm(profile(written(tmp_path)), 4)
    address = engine._client.cluster.scheduler_address
    (folder,) = (tmp_path / "logs").iterdir()
    assert folder.stat().st_mode & 0o77 == 0
    with pytest.raises(NoConnection):
        connected(address.replace("tls:", "tcp:"))
    work = Work(partial(cubes, texts=prepared.texts), no_ring)
    table = run(prepared, tmp_path, work, lambda tasks: engine)
    assert len(table) == 10
    assert all(f"dask_worker {address} " in job.read_text() for job in tmp_path.glob("job.*"))
    assert address.startswith("tls://")
    assert not folder.exists()


@pytest.fixture(scope="module")
def queue(tmp_path_factory):
    if not one_machine_slurm.is_possible():
        pytest.skip("needs root and the packages slurm-wlm and munge")
    with one_machine_slurm.running(tmp_path_factory.mktemp("slurm")):
        yield


@pytest.mark.slurm
def test_jobs_that_slurm_refuses_are_told_in_its_words(tmp_path, queue):
    settings = profile(written(tmp_path, PROFILE.replace("debug", "none")))
    with pytest.raises(NoQueue, match="invalid partition specified: none"):
        OnSlurm(settings, 4)


@pytest.mark.slurm
def test_forty_variants_arrive_though_a_worker_is_killed_and_a_job_cancelled(tmp_path, queue):
    place = tmp_path / "processes"
    place.mkdir()
    prepared = toy(tmp_path, FORTY)
    work = Work(partial(toy_studies.slow_cubes, texts=prepared.texts, place=place), no_ring)
    done = []

    def disturb(progress):
        done.append(progress.done)
        if progress.done >= 10 and "killed" not in done:
            done.append("killed")
            os.kill(max(int(path.name) for path in place.iterdir()), signal.SIGKILL)
        if progress.done >= 25 and "cancelled" not in done:
            done.append("cancelled")
            jobs = subprocess.run(
                ["squeue", "-h", "-t", "running", "-o", "%i"], capture_output=True, text=True
            )
            subprocess.run(["scancel", jobs.stdout.split()[0]], check=True)

    table = run(
        prepared, tmp_path, work, lambda tasks: OnSlurm(profile(written(tmp_path)), tasks), tell=disturb
    )
    assert {"killed", "cancelled"} <= {*done}
    alone = run(
        prepared, tmp_path / "alone", Work(partial(cubes, texts=prepared.texts), no_ring), lambda _: Serial()
    )
    assert len(table) == 40
    assert table.failed == 0
    assert str(table.rows) == str(alone.rows)
