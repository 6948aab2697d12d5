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

    The first is a context manager by name, which gives a function to call with the finished fraction of the
    stage; the second are the seconds of the stages that have ended. `report` (stage, fraction) is called as a
    stage starts and ends, with None if the fraction is unknown.
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
