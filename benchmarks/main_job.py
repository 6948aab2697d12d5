"""The main job cold, in processes of its own: `python -m benchmarks.main_job`."""

import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from benchmarks.machine import describe
from flexbearing.cache.store import VARIABLE

CASE = "configs/mao2016.toml"
RUNS = 3


def main() -> None:
    print(describe())
    with tempfile.TemporaryDirectory() as cache:
        for method, settings, folder in (
            ("newton", [], "off"),
            ("newton, rings from the cache", [], cache),
            ("newton, another load", ["--set", "operation.radial_load=15 kN"], cache),
            ("relaxed", ["--set", "coupling.method=relaxed"], cache),
        ):
            measured(method, settings, folder)


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
    program = [sys.executable, "-c", "from flexbearing.cli import main; main()"]
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
