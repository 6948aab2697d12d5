"""How many cores a study may use."""

import os

VARIABLES = "SLURM_CPUS_PER_TASK", "FLEXBEARING_THREADS"  # of the environment, the first that is set counts
ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}


class BadCount(ValueError):
    """A number of cores that is none."""


def cores() -> int:
    """Cores that this process may use.

    Returns
    -------
    int
        what a queue or the user says in the environment, else those that the operating system gives

    Raises
    ------
    BadCount
        for a variable that holds no number above zero
    """
    for name in VARIABLES:
        if text := os.environ.get(name):
            if not (text.isascii() and text.isdigit() and int(text) > 0):
                raise BadCount(f"{name}={text!r} is no number of cores; it must be a whole number above 0.")
            return int(text)
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def environment(jobs: int) -> dict[str, str]:
    """Variables of a worker process, so that threads times workers are no more than the cores."""
    left = {name: value for name, value in os.environ.items() if name != VARIABLES[0]}
    return left | ONE_THREAD | {VARIABLES[1]: str(max(1, cores() // jobs))}
