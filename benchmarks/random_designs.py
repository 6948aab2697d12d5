"""Random designs, most of them far from good ones: `python -m benchmarks.random_designs --n 4000 --seed S`.

Envelope: see `wide_design` of `tests/random_rollers.py`; with `--envelope usual` that of `design`, 10 N to
100 kN, 100 to 100 000 rpm, clearance -50 to 300 um, 6 to 59 rollers, four traction laws, any direction of the
load, a third of them tilted by a moment; with `--envelope slow` those at 0.1 to 20 rpm on rough surfaces that
creep (`slow_design`), with `slow-rounded` the same under rounded Coulomb friction. Of every answer the arrays
are taken that a result file holds; each balance is summed up again from them alone, and a number that is not
finite or a warning counts as a silent fault.
"""

import argparse
import time
import warnings
from collections import Counter
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from flexbearing.coupled.states import EndStates
from flexbearing.coupling import LinearPair
from flexbearing.quantities.quantity import row, taken
from flexbearing.quantities.roller import LAYOUT
from flexbearing.results.checks import NotInLayout, require_finite
from quasidynamic import Equilibrium, RollerBearing, SolverOutcome, solve_many
from tests.balances import largest_imbalance
from tests.random_rollers import RPM, design, imbalance, slow_design, slow_rounded_design, wide_design

CHECKED_TO = 1e-8  # of the largest force on the bearing
RIGID = LinearPair(None, None)
QUANTITIES = LAYOUT.datasets("block").values()
ENVELOPES = {
    "wide": wide_design,
    "usual": design,
    "slow": slow_design,
    "slow-rounded": slow_rounded_design,
}


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--n", type=int, default=4000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--envelope", choices=ENVELOPES, default="wide")
    parser.add_argument("--first", type=int, default=0, help="number of the first design that is solved")
    parser.add_argument("--picture", type=Path)
    asked = parser.parse_args()
    print(describe())
    rows, kinds = [], Counter()
    with threadpool_limits(limits=1, user_api="blas"):
        began = time.perf_counter()
        for number in range(asked.first, asked.first + asked.n):
            rng = np.random.default_rng([asked.seed, number])
            model, words = ENVELOPES[asked.envelope](rng)
            kind, row = examined(model)
            kinds[kind.split(":")[0]] += 1
            rows.append(row)
            if kind != "converged":
                print(f"design {number}: {kind}; {words}; {described(model)}", flush=True)
        total = time.perf_counter() - began
    evaluations, seconds = np.array(rows)[:, 3], np.array(rows)[:, 4]
    print(
        f"{asked.n} {asked.envelope} designs from {asked.first}, seed {asked.seed}: "
        + ", ".join(f"{k} {v}" for k, v in kinds.most_common())
    )
    print(
        f"evaluations: median {np.median(evaluations):.0f}, 99 % {np.quantile(evaluations, 0.99):.0f}, "
        f"largest {evaluations.max():.0f}; time: median {np.median(seconds) * 1e3:.1f} ms, "
        f"99 % {np.quantile(seconds, 0.99) * 1e3:.0f} ms; {total:.0f} s in all"
    )
    if asked.picture:
        draw(np.array(rows), asked)


def examined(model: RollerBearing) -> tuple[str, tuple[float, ...]]:
    """How a design ended, in words, and its load, speed, whether it was solved, evaluations and seconds."""
    start = time.perf_counter()
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        state = solve_many([model])[0]
        seconds = time.perf_counter() - start
        kind = str(state.status)
        if state.status is SolverOutcome.CONVERGED:
            kind = faults(state) or kind
    if told and kind == "converged":
        kind = f"SILENT: warning {told[0].message}"
    speed = max(abs(model.operation.inner_speed), abs(model.operation.outer_speed)) / RPM
    return kind, (model.operation.radial_load, speed, kind == "converged", state.number, seconds)


def faults(state: Equilibrium) -> str:
    """What is wrong with a converged answer as a file would hold it; empty when nothing is."""
    states = state.cases
    parts = {"state": states, "losses": states.losses, "end": EndStates(states, RIGID)}
    some = [entry for entry in QUANTITIES if entry.path[0] in parts]
    arrays = row(taken(some, parts), 0)
    for name, values in arrays.items():
        try:
            require_finite(LAYOUT.datasets("block")[name], values, "rigid")
        except NotInLayout as problem:
            return f"SILENT: {problem}"
    left = largest_imbalance(arrays, state.balance.roller.bearing.cage.guidance)
    if not left <= CHECKED_TO:
        return f"WRONG BALANCE: {left:.1e} of the largest stored force"
    again = imbalance(state)  # friction and weights by their laws, not as they are stored
    return "" if again <= CHECKED_TO else f"WRONG BALANCE: {again:.1e} of the largest force by its law"


def described(model: RollerBearing) -> str:
    bearing, operation, roller = model.bearing, model.operation, model.bearing.roller
    return (
        f"{bearing.rollers} rollers {1e3 * roller.diameter:.3g} x {1e3 * roller.length:.3g} mm, "
        f"{operation.radial_load:.3g} N, {operation.moment:.2g} N m, {operation.inner_speed / RPM:.3g} and "
        f"{operation.outer_speed / RPM:.3g} rpm, clearance {bearing.clearance * 1e6:.2g} um, "
        f"gravity {operation.gravity:g} m/s2"
    )


def draw(rows: np.ndarray, asked) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
    load, speed, solved, evaluations, _ = rows.T
    points = axes.scatter(speed, load, c=np.log10(np.maximum(evaluations, 1)), s=5, cmap="viridis")
    bad = solved == 0
    axes.scatter(speed[bad], load[bad], c="red", marker="x", s=40, label=f"unsolved: {int(bad.sum())}")
    axes.set(xscale="log", yscale="log", xlabel="speed of the faster ring [rpm]", ylabel="radial load [N]")
    bar = figure.colorbar(points, ax=axes, label="evaluations of the bearing")
    bar.set_ticks([1, 2, 3], labels=["10", "100", "1000"])
    axes.set_title(f"{asked.n} random designs, seed {asked.seed}")
    axes.legend(loc="lower left")
    figure.savefig(asked.picture, dpi=130)


if __name__ == "__main__":
    main()
