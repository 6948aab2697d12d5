"""What a figure was measured with."""

import os
import platform
import statistics
import time
from collections.abc import Callable
from importlib.metadata import version
from pathlib import Path


def describe() -> str:
    packages = ", ".join(f"{name} {version(name)}" for name in ("flexbearing", "ngsolve", "numpy", "scipy"))
    return f"{_processor()}, {os.cpu_count()} cores; Python {platform.python_version()}, {packages}"


def _processor() -> str:
    information = Path("/proc/cpuinfo")
    if information.exists():
        for line in information.read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or "unknown processor"


def median_seconds(job: Callable[[], object], runs: int) -> tuple[float, float, float]:
    """Median, fastest and slowest of several runs, after one that does not count."""
    job()
    seconds = []
    for _ in range(runs):
        began = time.perf_counter()
        job()
        seconds.append(time.perf_counter() - began)
    return statistics.median(seconds), min(seconds), max(seconds)
