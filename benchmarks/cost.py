"""Cost against number of slices and rollers: `python -m benchmarks.cost [--picture FILE]`.

Time of one evaluation with its Newton step, sixteen operating points at once so that what a call of
NumPy costs by itself does not hide the growth.
"""

import argparse
from dataclasses import replace
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.bearings import changed, paper_bearing
from benchmarks.machine import describe, median_seconds
from quasidynamic.solve.rollers.newton import step
from quasidynamic.solve.start import static_start

AT_ONCE = 16


def seconds(model) -> float:
    """Of an evaluation and a step, for one operating point."""
    balance = model.balance(AT_ONCE)
    start = static_start(balance)
    median, _, _ = median_seconds(lambda: step(balance, balance.evaluate(start)), 21)
    return median / AT_ONCE


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--picture", type=Path)
    asked = parser.parse_args()
    print(describe())
    paper = paper_bearing()
    wide = changed(paper, outer_raceway_diameter=0.6)
    slices = np.array([10, 20, 50, 100, 150, 200])
    rollers = np.array([15, 30, 75, 150, 225, 300])
    with threadpool_limits(limits=1, user_api="blas"):
        series = {
            "slices (30 rollers)": (slices, [seconds(replace(paper, slices=int(n))) for n in slices]),
            "rollers (20 slices)": (rollers, [seconds(changed(wide, rollers=int(n))) for n in rollers]),
        }
    for name, (count, times) in series.items():
        slope, base = np.polyfit(count, times, 1)
        off = np.abs(np.array(times) - base - slope * count).max() / max(times)
        print(f"{name}: " + ", ".join(f"{n}: {1e6 * t:.0f} us" for n, t in zip(count, times, strict=True)))
        print(f"  {1e6 * base:.0f} us + {1e6 * slope:.2f} us each; furthest from the line {100 * off:.0f} %")
    if asked.picture:
        draw(series, asked.picture)


def draw(series: dict, path: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.5, 4), layout="constrained")
    for (name, (count, times)), marker in zip(series.items(), "os", strict=True):
        axes.plot(count, 1e6 * np.array(times), marker, label=name)
        axes.plot(
            count, np.polyval(np.polyfit(count, 1e6 * np.array(times), 1), count), "-", lw=0.8, c="grey"
        )
    axes.set(xlabel="number", ylabel="time of an evaluation and a step [us]", xlim=(0, None), ylim=(0, None))
    axes.legend()
    figure.savefig(path, dpi=130)


if __name__ == "__main__":
    main()
