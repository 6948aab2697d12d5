"""Single runs beside a rigid solve, all in turns: `python -m benchmarks.single_runs [--cold]`.

The paper's bearing between known rings, modules imported: in memory, with a file, and rigid. With `--cold`
the whole command with empty caches, the rings one after the other and side by side. Processor time tells
what a run costs where others share the machine; it leaves out the disk, and counts every process.
"""

import argparse
import os
import resource
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from benchmarks.machine import describe
from flexbearing import read, run
from flexbearing.api import check
from flexbearing.build import roller_bearing
from flexbearing.program.threads import linear_algebra_alone

CASE = "configs/mao2016.toml"
RIGID = ["outer.kind=rigid", "inner.kind=rigid"]
ROUNDS, SOLVES, COLD_ROUNDS = 41, 5, 3


class Unheard:
    """Listens to nothing."""

    def stage(self, *_: object) -> None: ...

    def iteration(self, *_: object) -> None: ...


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--cold", action="store_true", help="also whole commands with empty caches")
    asked = parser.parse_args()
    print(f"{describe()}; load {os.getloadavg()[0]:.1f}")
    with TemporaryDirectory() as folder:
        warm(Path(folder))
        if asked.cold:
            cold(Path(folder))


def warm(folder: Path) -> None:
    model = roller_bearing.bearing(check(CASE))
    jobs: dict[str, Callable[[], object]] = {
        "rigid solve": lambda: [replace(model).solve() for _ in range(SOLVES)],
        "rigid, in memory": lambda: run(CASE, RIGID, report=Unheard()),
        "elastic rings, in memory": lambda: run(CASE, report=Unheard()),
        "elastic rings, with a file": lambda: run(CASE, output=folder / "out.h5", report=Unheard()),
        "reading that file": lambda: read(folder / "out.h5"),
    }
    with linear_algebra_alone():
        for job in list(jobs.values()) * 2:
            job()
        found: dict[str, list[tuple[float, float]]] = {name: [] for name in jobs}
        for _ in range(ROUNDS):
            for name, job in jobs.items():
                found[name].append(timed(job))
    print(f"medians of {ROUNDS} rounds; ratio to a rigid solve of the same rounds")
    unit = [statistics.median(times) / SOLVES for times in zip(*found["rigid solve"], strict=True)]
    for name, times in found.items():
        wall, processor = (statistics.median(each) for each in zip(*times, strict=True))
        if name == "rigid solve":
            wall, processor = unit
        print(
            f"{name:28} wall {1e3 * wall:7.2f} ms, {wall / unit[0]:5.1f} solves; "
            f"processor {1e3 * processor:7.2f} ms, {processor / unit[1]:5.1f} solves"
        )


def cold(folder: Path) -> None:
    """Whole commands, the rings condensed one after the other and side by side."""
    found: dict[str, list[tuple[float, float]]] = {"1": [], "2": []}
    results = {}
    for number in range(COLD_ROUNDS):
        for cores, times in found.items():
            out = folder / f"cold{cores}.h5"
            words = [sys.executable, "-m", "flexbearing", "run", CASE, "-o", str(out), "--quiet"]
            cache = {"FLEXBEARING_CACHE": str(folder / f"{number}-{cores}"), "FLEXBEARING_THREADS": cores}
            left = {name: value for name, value in os.environ.items() if name != "SLURM_CPUS_PER_TASK"}
            times.append(timed(lambda w=words, e=left | cache: subprocess.run(w, env=e, check=True)))
            results[cores] = read(out)
    names = {"1": "one after the other", "2": "side by side"}
    medians = {
        cores: [statistics.median(each) for each in zip(*times, strict=True)]
        for cores, times in found.items()
    }
    for cores, (wall, processor) in medians.items():
        print(f"cold command, rings {names[cores]}: wall {wall:.2f} s, processor {processor:.2f} s")
    words = "equal" if results["1"] == results["2"] else "DIFFER"
    print(f"wall {medians['2'][0] / medians['1'][0]:.2f} times that before; numbers {words}")


def timed(job: Callable[[], object]) -> tuple[float, float]:
    """Wall and processor time, that of ended children with it [s]."""
    began, spent = time.perf_counter(), _processor()
    job()
    return time.perf_counter() - began, _processor() - spent


def _processor() -> float:
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime


if __name__ == "__main__":
    main()
