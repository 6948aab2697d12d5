"""Random designs, most of them far from good ones: `python -m benchmarks.random_designs --n 4000 --seed S`.

Envelope: 10 N to 100 kN, 100 to 100 000 rpm, clearance -50 to 300 um, 6 to 59 rollers, four traction
laws, random direction of the load, a third of them tilted by a moment. Every answer is checked again
by a residual that the solver does not use: forces summed roller by roller from the reported loads,
tractions and speeds.
"""

import argparse
import time
from collections import Counter
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from quasidynamic import SolverOutcome
from tests.random_rollers import RPM, design, imbalance

CHECKED_TO = 1e-8  # of the largest force on the bearing


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--n", type=int, default=4000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--picture", type=Path)
    asked = parser.parse_args()
    print(describe())
    rng = np.random.default_rng(asked.seed)
    rows, kinds = [], Counter()
    with threadpool_limits(limits=1, user_api="blas"):
        began = time.perf_counter()
        for number in range(asked.n):
            model, traction = design(rng)
            start = time.perf_counter()
            state = model.solve_many([model.operation])[0]
            seconds = time.perf_counter() - start
            wrong = imbalance(state) if state.status is SolverOutcome.CONVERGED else 0.0
            kind = str(state.status) if wrong <= CHECKED_TO else "SILENT WRONG ANSWER"
            kinds[kind] += 1
            operation = model.operation
            rows.append(
                (
                    operation.radial_load,
                    operation.inner_speed / RPM,
                    kind == "converged",
                    state.number,
                    seconds,
                )
            )
            if kind != "converged":
                print(
                    f"design {number}: {kind}, {traction}, {operation.radial_load:.0f} N, "
                    f"{operation.inner_speed / RPM:.0f} rpm, "
                    f"clearance {model.bearing.clearance * 1e6:.0f} um, "
                    f"{model.bearing.rollers} rollers, {'tilted' if operation.free_tilt else 'aligned'}, "
                    f"residual {state.residual:.1e}, imbalance {wrong:.1e}"
                )
        total = time.perf_counter() - began
    evaluations, seconds = np.array(rows)[:, 3], np.array(rows)[:, 4]
    print(f"{asked.n} designs, seed {asked.seed}: " + ", ".join(f"{k} {v}" for k, v in kinds.most_common()))
    print(
        f"evaluations: median {np.median(evaluations):.0f}, 99 % {np.quantile(evaluations, 0.99):.0f}, "
        f"largest {evaluations.max():.0f}; time: median {np.median(seconds) * 1e3:.1f} ms, "
        f"99 % {np.quantile(seconds, 0.99) * 1e3:.0f} ms; {total:.0f} s in all"
    )
    if asked.picture:
        draw(np.array(rows), asked)


def draw(rows: np.ndarray, asked) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
    load, speed, solved, evaluations, _ = rows.T
    points = axes.scatter(speed, load, c=np.log10(evaluations), s=5, cmap="viridis")
    bad = solved == 0
    axes.scatter(speed[bad], load[bad], c="red", marker="x", s=40, label=f"unsolved: {int(bad.sum())}")
    axes.set(xscale="log", yscale="log", xlabel="inner speed [rpm]", ylabel="radial load [N]")
    bar = figure.colorbar(points, ax=axes, label="evaluations of the bearing")
    bar.set_ticks([1, 2, 3], labels=["10", "100", "1000"])
    axes.set_title(f"{asked.n} random designs, seed {asked.seed}")
    axes.legend(loc="lower left")
    figure.savefig(asked.picture, dpi=130)


if __name__ == "__main__":
    main()
