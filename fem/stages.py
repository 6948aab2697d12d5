"""Stages of a computation: each is reported and timed."""

import time
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager

Report = Callable[[str, float | None], None]
Stage = Callable[[str], AbstractContextManager[Callable[[float], None]]]


def unheard(name: str, fraction: float | None = None) -> None:
    """Report to nobody."""


def stages(report: Report) -> tuple[Stage, dict[str, float]]:
    """Watch the stages of one computation.

    Parameters
    ----------
    report : callable (stage, fraction)
        called for each stage as it starts and ends, with the finished fraction, None if unknown

    Returns
    -------
    stage : callable (name)
        context manager around a stage; it gives a function to call with the finished fraction
    seconds : dict
        of the stages that have ended, by name; it fills as they end
    """
    seconds: dict[str, float] = {}

    @contextmanager
    def stage(name: str) -> Iterator[Callable[[float], None]]:
        report(name, None)
        start = time.perf_counter()
        yield lambda fraction: report(name, fraction)
        seconds[name] = time.perf_counter() - start
        report(name, 1.0)

    return stage, seconds
