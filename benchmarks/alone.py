"""A job in a fresh process, so that its peak memory is its own."""

import resource
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from typing import Any

MEBIBYTE = 1024.0  # resource counts kibibytes on Linux


@dataclass(frozen=True)
class Cost:
    """Of a job, modules already loaded."""

    seconds: float  # on the clock
    processor_seconds: float
    memory: float  # [MiB] peak of the process, the modules included


def measured(job: Callable, *arguments, memory_limit: float | None = None) -> tuple[Any, Cost]:
    """Result and cost of a function that can be pickled; beyond the limit [GiB] it raises."""
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        return pool.submit(_measured, job, arguments, memory_limit).result()


def _measured(job, arguments, memory_limit):
    if memory_limit:
        limit = int(memory_limit * 2**30)
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    began, worked = time.perf_counter(), time.process_time()
    result = job(*arguments)
    cost = time.perf_counter() - began, time.process_time() - worked
    return result, Cost(*cost, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / MEBIBYTE)
