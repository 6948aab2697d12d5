"""The main job cold, in processes of its own: `python -m benchmarks.main_job`."""

import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from benchmarks.machine import describe

CASE = "configs/mao2016.toml"
RUNS = 3


def main() -> None:
    print(describe())
    for method, settings in (
        ("newton", []),
        ("relaxed", ["--set", "coupling.method=relaxed"]),
    ):
        walls, found = [], {}
        for _ in range(RUNS if method == "newton" else 1):
            wall, found = run(settings)
            walls.append(wall)
        flexible = found["flexible"]
        print(
            f"{method:8s} {found['status']}, {found['iterations']} iterations, "
            f"largest load {flexible['max_roller_load_N']:.6f} N, "
            f"process wall {statistics.median(walls):.1f} s (median of {len(walls)})"
        )


def run(settings: list[str]) -> tuple[float, dict]:
    program = [sys.executable, "-c", "from flexbearing.cli import main; main()"]
    with tempfile.TemporaryDirectory() as folder:
        out = str(Path(folder) / "out.h5")
        began = time.perf_counter()
        subprocess.run([*program, "run", CASE, "-o", out, "--quiet", *settings], check=True)
        wall = time.perf_counter() - began
        text = subprocess.run(
            [*program, "summary", out, "--json"], check=True, capture_output=True, text=True
        ).stdout
    return wall, json.loads(text)


if __name__ == "__main__":
    main()
