"""Where a study is computed, and how long it usually takes."""

import shlex
import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from importlib.util import find_spec
from pathlib import Path

from flexbearing.case import BadCase
from flexbearing.files import require_folder_name
from flexbearing.printable import excerpt
from flexbearing.program.threads import cores, processes
from flexbearing.program.worker_processes import Processes
from flexbearing.studies.engine import Engine
from flexbearing.studies.engine.certificates import OPTIONS, Certificates, certificates
from flexbearing.studies.engine.on_dask import NoConnection, connected
from flexbearing.studies.engine.on_slurm import NoQueue, OnSlurm
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.file.slurm_profile import SlurmProfile, profile
from flexbearing.studies.plan import Plan
from flexbearing.studies.prepared_study import PreparedStudy

RING = 2.0  # [s] of a processor for an elastic ring
WORTH_WORKERS = 10.0  # [s] of work; starting worker processes takes two
NEEDED = {"--scheduler": ("distributed",), "--slurm": ("distributed", "dask_jobqueue", "cryptography")}


@dataclass(frozen=True)
class Cost:
    """Usual processor time of a task [s]."""

    task: float  # of its own, for any content
    variant: float  # of each variant in it


# By whether the rings are elastic: solved side by side, or each in a run of its own.
SIDE_BY_SIDE = {True: Cost(0.04, 0.004), False: Cost(0.01, 0.0015)}
ALONE = {True: Cost(0.0, 0.1), False: Cost(0.0, 0.02)}
IN_CELLS = {True: Cost(0.0, 0.6), False: Cost(0.0, 0.15)}  # with half-spaces, or friction that is solved for


@dataclass(frozen=True)
class Placement:
    """Where the variants of a study are computed."""

    jobs: int | None = None  # processes here; None: as many as are worth it
    scheduler: str | None = None  # address of a running Dask scheduler instead
    slurm: Path | None = None  # profile of a SLURM cluster instead
    tls: tuple[Path | None, ...] = ()  # files of `OPTIONS`, for both

    def engine(self, plan: Plan) -> Callable[[int], Engine]:
        """What starts the engine, given the number of tasks.

        Raises `BadCase` when several places are named, the profile is wrong, what they need is not installed,
        or nobody answers there.
        """
        options = {"--jobs": self.jobs, "--scheduler": self.scheduler, "--slurm": self.slurm}
        named = [name for name, value in options.items() if value is not None]
        if len(named) > 1:
            raise BadCase(f"{' and '.join(named)}: a study is computed in one place; give one of them")
        if self.scheduler is None and self.slurm is None:
            if any(self.tls):
                raise BadCase(f"{', '.join(OPTIONS)}: only --scheduler and --slurm have connections")
            return lambda tasks: self._here(tasks, plan)
        if missing := [name for name in NEEDED[named[0]] if find_spec(name) is None]:
            raise BadCase(f'{named[0]} needs {", ".join(missing)}: pip install "flexbearing[studies]"')
        found = certificates(*self.tls)
        if self.scheduler is not None:
            return partial(_connected, self.scheduler, found)
        assert self.slurm
        return partial(_queued, self.slurm, profile(self.slurm), found)

    def _here(self, tasks: int, plan: Plan) -> Engine:
        jobs = processes(self.jobs) if self.jobs else cores() if expected(plan) > WORTH_WORKERS else 1
        jobs = min(tasks, jobs)
        return Serial() if jobs == 1 else Processes(jobs)


def _queued(path: Path, settings: SlurmProfile, found: Certificates | None, tasks: int) -> Engine:
    try:
        return OnSlurm(settings, tasks, found)
    except NoQueue as problem:
        raise BadCase(f"--slurm {path}: {problem}") from problem


def _connected(address: str, found: Certificates | None, tasks: int) -> Engine:
    try:
        return connected(address, found)
    except NoConnection as problem:
        raise BadCase(f"--scheduler {excerpt(address)}: {problem}") from problem


def costs(plan: Plan) -> dict[bool, Cost]:
    """Usual costs of the variants of a study, by whether their rings are elastic."""
    if plan.side_by_side:
        return SIDE_BY_SIDE
    return IN_CELLS if plan.in_cells else ALONE


def expected(plan: Plan) -> float:
    """Usual processor time of all variants of a study [s]."""
    of, time = costs(plan), RING * len(plan.rings())
    for elastic, variants, tasks in plan.sizes:
        time += of[elastic].task * tasks + of[elastic].variant * variants
    choices = sum(len(corners.variants) for corners in plan.corners)  # some solves each
    return time + ALONE[True].variant * choices


USUAL = 10  # jobs


def sbatch(prepared: PreparedStudy, output: Path, jobs: int | None) -> str:
    """Write a script for SLURM: a job array whose jobs compute a part each, and one that gathers them."""
    count = min(len(prepared.plan.tasks(lambda variant: True)), jobs or USUAL)
    folder = require_folder_name(output)
    file, program = prepared.study.path.resolve(), f"{shlex.quote(sys.executable)} -m flexbearing"
    command = f"{program} study {shlex.quote(str(file))} -o {shlex.quote(str(folder))} --jobs 1"
    name = shlex.quote(prepared.study.name)
    return f"""\
#!/bin/bash
# {len(prepared.plan.variants)} variants in {count} jobs. After them the table is gathered by
#   sbatch --dependency=afterany:JOB --wrap {shlex.quote(command)}
#SBATCH --job-name={name}
#SBATCH --array=1-{count}
#SBATCH --cpus-per-task=1
#SBATCH --output={shlex.quote(str(folder / prepared.study.name))}.%a.log
exec {command} --part "$SLURM_ARRAY_TASK_ID/{count}"
"""
