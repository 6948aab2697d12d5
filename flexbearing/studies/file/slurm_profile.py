"""The profile of a SLURM cluster: what a job of workers requests."""

from pathlib import Path

from flexbearing import inputs
from flexbearing.case.problems import BadCase, validated
from flexbearing.case.quantity import Section, key
from flexbearing.case.read import LONGEST_NAME
from flexbearing.case.text import LARGEST, Unreadable, tables
from flexbearing.printable import excerpt


class SlurmProfile(Section):
    """A TOML file that is written once for a cluster."""

    jobs: int = key("most jobs at a time", example=10, ge=1, le=10_000)
    cores: int = key("cores of a job, each with a worker", 1, ge=1, le=1024)
    memory: str = key(
        "memory of a job, all its workers together", example="8 GB", pattern=r"^[0-9]+(\.[0-9]+)? ?[MGT]i?B$"
    )
    walltime: str = key(
        "longest time of a job, as HH:MM:SS or D-HH:MM:SS",
        "01:00:00",
        pattern=r"^([0-9]+-)?[0-9]{1,3}:[0-5][0-9]:[0-5][0-9]$",
    )
    queue: str | None = key("partition; without it that of the cluster", None, example="short")
    account: str | None = key("account that is charged", None, example="bearings")
    interface: str | None = key(
        "network interface that scheduler and workers talk over; without it that of the host name",
        None,
        example="ib0",
    )
    directives: tuple[str, ...] = key(
        "further options of sbatch", (), example=["--constraint=cascadelake"], strict=False
    )
    prologue: tuple[str, ...] = key(
        "shell lines in front of the workers", (), example=["module load python/3.11"], strict=False
    )
    logs: str = key("folder of the output and certificates of the jobs, which all nodes see", "slurm-logs")


def profile(path: str | Path) -> SlurmProfile:
    """Read the profile of a cluster.

    Raises `BadCase`, one line for each problem: file, key, value found, what is allowed, nearest valid name.
    """
    file = Path(path)
    try:
        raw = tables(inputs.text(file, LARGEST), "profile")
    except Unreadable as problem:
        raise BadCase(f"{excerpt(str(path), LONGEST_NAME)}: {problem}") from problem
    return validated(raw, excerpt(file.name, LONGEST_NAME), SlurmProfile, {})
