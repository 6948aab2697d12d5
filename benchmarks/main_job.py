"""The main job, cold and with known rings, in processes of its own: `python -m benchmarks.main_job`.

The last two rows stay in one process, as a study over loads does, and say which parts a second thickness
has to solve again.
"""

import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from flexbearing import run as compute
from flexbearing.cache.store import VARIABLE
from flexbearing.progress import Report

CASE = "configs/mao2016.toml"
RUNS = 3


THICKER = "outer.thickness=4 mm"  # the case has 3.6 mm


def main() -> None:
    print(describe())
    with tempfile.TemporaryDirectory() as cache:
        load = ["--set", "operation.radial_load=15 kN"]
        target = ["--set", "accuracy.target=3 %"]
        for method, settings, folder in (
            ("newton", [], "off"),
            ("target 3 %", target, "off"),
            ("newton, rings from the cache", [], cache),
            ("newton, another load", load, cache),
            ("target 3 %, another load", target + load, cache),
            ("relaxed", ["--set", "coupling.method=relaxed"], cache),
        ):
            measured(method, settings, folder)
        os.environ[VARIABLE] = cache
        in_one_process()


def in_one_process() -> None:
    """Print what a run takes when the program is loaded, and what a second thickness solves again."""
    with tempfile.TemporaryDirectory() as folder, threadpool_limits(limits=1, user_api="blas"):
        out = Path(folder) / "out.h5"
        walls = []
        for load in range(10, 31):
            began = time.perf_counter()
            compute(CASE, [f"operation.radial_load={load / 2} kN"], output=out, report=Heard())
            walls.append(time.perf_counter() - began)
        print(
            f"loaded program, another load   run and file {1e3 * statistics.median(walls):.0f} ms "
            f"(median of {len(walls)}; {1e3 * min(walls):.0f} to {1e3 * max(walls):.0f} ms)"
        )
        heard = Heard()
        began = time.perf_counter()
        compute(CASE, [THICKER], output=out, report=heard)
        print(f"loaded program, {THICKER}   {time.perf_counter() - began:.1f} s:")
        print("\n".join(f"  {stage}" for stage in heard.stages))


class Heard(Report):
    """Keeps the stages of a run."""

    def __init__(self):
        self.stages: list[str] = []

    def stage(self, name: str, fraction: float | None) -> None:
        """Keep a stage."""
        if fraction is None and ":" in name:
            self.stages.append(name)

    def iteration(self, step: object) -> None:
        """Nothing is kept of an iteration."""


def measured(method: str, settings: list[str], cache: str) -> None:
    """Print the median time of several runs; `cache` is a folder, or "off"."""
    if cache != "off":
        run(settings, cache)  # what is not in the cache yet gets there
    walls, found = [], {}
    for _ in range(RUNS):
        wall, found = run(settings, cache)
        walls.append(wall)
    flexible = found["flexible"]
    print(
        f"{method:29s} {found['status']}, {found['iterations']} iterations, "
        f"largest load {flexible['max_roller_load_N']:.6f} N, "
        f"process wall {statistics.median(walls):.1f} s (median of {len(walls)})"
    )


def run(settings: list[str], cache: str) -> tuple[float, dict]:
    program = [sys.executable, "-m", "flexbearing"]
    with tempfile.TemporaryDirectory() as folder:
        out = str(Path(folder) / "out.h5")
        began = time.perf_counter()
        subprocess.run(
            [*program, "run", CASE, "-o", out, "--quiet", *settings],
            check=True,
            env=os.environ | {VARIABLE: cache},
        )
        wall = time.perf_counter() - began
        text = subprocess.run(
            [*program, "summary", out, "--json"], check=True, capture_output=True, text=True
        ).stdout
    return wall, json.loads(text)


if __name__ == "__main__":
    main()
