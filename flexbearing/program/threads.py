"""How many threads and processes may work at once: the one place that decides.

The cores are those of `--jobs` where a command has it, else what a queue says (`SLURM_CPUS_PER_TASK`), else
what the user says (`FLEXBEARING_THREADS`), else those that the operating system lets this process use. Worker
processes share them. NGSolve takes those of its process for whole solids, one for everything smaller. Linear
algebra of NumPy has one thread: the matrices of a bearing are small, and threads would wait for each other.
"""

import logging
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import lru_cache
from typing import Any

from flexbearing import inputs
from flexbearing.case import BadCase
from flexbearing.printable import excerpt

VARIABLES = "SLURM_CPUS_PER_TASK", "FLEXBEARING_THREADS"  # of the environment, the first that is set counts
MOST = 4096  # cores of a machine
ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}
log = logging.getLogger(__name__)


class BadCount(BadCase):
    """A number of cores that is none."""


def cores() -> int:
    """Cores that this process may use.

    Raises `BadCount` for a variable that holds no whole number from 1 to `MOST`.
    """
    for name in VARIABLES:
        if text := os.environ.get(name):
            try:
                return inputs.whole(text, 1, MOST)
            except inputs.BadNumber as problem:
                raise BadCount(
                    f"{name}={excerpt(text)!r} is no number of cores from 1 to {MOST}: {problem}"
                ) from None
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def processes(jobs: int) -> int:
    """Processes that compute for `--jobs`: with more than one on a core a warning says how many there are."""
    if jobs > (most := cores()):
        log.warning("--jobs %d: only %d compute, one on each core that this program may use", jobs, most)
    return min(jobs, most)


@contextmanager
def limited_to(jobs: int | None) -> Iterator[None]:
    """Let this process and those that it starts use no more cores than `--jobs` says, where it is given."""
    if jobs is None:
        yield
        return
    most = min(jobs, cores())
    before = {name: os.environ.pop(name) for name in VARIABLES if name in os.environ}
    os.environ[VARIABLES[1]] = str(most)
    try:
        yield
    finally:
        del os.environ[VARIABLES[1]]
        os.environ |= before


def environment(jobs: int) -> dict[str, str]:
    """Variables of a worker process, so that threads times workers are no more than the cores."""
    left = {name: value for name, value in os.environ.items() if name != VARIABLES[0]}
    return left | ONE_THREAD | {VARIABLES[1]: str(max(1, cores() // jobs))}


def of_solids(wanted: int | None) -> int:
    """Threads of NGSolve for a whole solid: what a case requires, or else all; never more than the cores."""
    return min(wanted or cores(), cores())


@contextmanager
def linear_algebra_alone() -> Iterator[None]:
    """Give the linear algebra of NumPy and SciPy one thread inside."""
    with _libraries("ngsolve" in sys.modules, "scipy" in sys.modules).limit(limits=1, user_api="blas"):
        yield


@lru_cache(maxsize=4)
def _libraries(*loaded: bool) -> Any:
    """Libraries of this process that have threads, looked for again when packages bring others."""
    from threadpoolctl import ThreadpoolController

    return ThreadpoolController()
