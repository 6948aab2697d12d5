"""Where a study is computed, and how long it usually takes."""

from collections.abc import Callable
from dataclasses import dataclass
from importlib.util import find_spec

from flexbearing.case import BadCase
from flexbearing.studies.engine import Engine
from flexbearing.studies.engine.cores import BadCount, cores
from flexbearing.studies.engine.local import Local
from flexbearing.studies.engine.on_dask import connected
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.plan import Plan

RING, ELASTIC, RIGID = 5.0, 0.1, 0.005  # [s] a ring, a variant between elastic rings and between rigid ones
WORTH_WORKERS = 5.0  # [s] of work; starting worker processes takes two


@dataclass(frozen=True)
class Where:
    """Where the variants of a study are computed."""

    jobs: int | None = None  # processes here; None: as many as are worth it
    scheduler: str | None = None  # address of a running Dask scheduler instead

    def engine(self, plan: Plan) -> Callable[[int], Engine]:
        """What starts the engine, given the number of tasks.

        Raises
        ------
        BadCase
            when what it needs is not installed, or nobody answers at the address
        """
        if self.scheduler is None and self.jobs == 1:
            return lambda tasks: Serial()
        if find_spec("distributed") is None:
            if self.scheduler is None and self.jobs is None:
                return lambda tasks: Serial()
            raise BadCase(
                'several jobs and schedulers need Dask: pip install "flexbearing[studies]", or --jobs 1'
            )
        return lambda tasks: self._on_dask(tasks, plan)

    def _on_dask(self, tasks: int, plan: Plan) -> Engine:
        if self.scheduler is not None:
            return _connected(self.scheduler)
        try:
            most = self.jobs or (cores() if expected(plan) > WORTH_WORKERS else 1)
        except BadCount as problem:
            raise BadCase(str(problem)) from None
        jobs = min(tasks, most)
        return Serial() if jobs == 1 else Local(jobs)


def _connected(address: str) -> Engine:
    try:
        return connected(address)
    except (OSError, ValueError) as problem:
        raise BadCase(f"--scheduler {address}: nobody answers there: {problem}") from problem


def expected(plan: Plan) -> float:
    """Usual time of all variants of a study on one core [s]."""
    elastic = sum(bool(variant.rings) for variant in plan.variants)
    return RING * len(plan.rings()) + ELASTIC * elastic + RIGID * (len(plan.variants) - elastic)
