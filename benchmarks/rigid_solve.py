"""Time of rigid quasi-dynamic solves on one core: `python -m benchmarks.rigid_solve`.

A cold start in a warm interpreter (nothing of an earlier solve is used again), and a map of 1000 loads
and speeds solved side by side, checked against a few of its points solved alone.
"""

from dataclasses import replace

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.bearings import CASE, RPM
from benchmarks.machine import describe, median_seconds
from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from quasidynamic import solve_many


def main() -> None:
    print(describe())
    model = roller_bearing.bearing(read_case(CASE))
    with threadpool_limits(limits=1, user_api="blas"):
        alone(model)
        side_by_side(model)


def alone(model) -> None:
    median, fastest, slowest = median_seconds(lambda: replace(model).solve(), 101)
    print(
        f"rigid solve, {model.bearing.rollers} rollers, {model.slices} slices, "
        f"{model.solve().number} evaluations: median {median * 1e3:.1f} ms "
        f"({fastest * 1e3:.1f} to {slowest * 1e3:.1f} ms of 101 runs)"
    )


def side_by_side(model) -> None:
    operation = model.operation
    models = [
        replace(model, operation=replace(operation, radial_load=float(load), inner_speed=float(speed) * RPM))
        for load in np.geomspace(100.0, 20000.0, 40)
        for speed in np.linspace(1000.0, 38000.0, 25)
    ]
    median, fastest, slowest = median_seconds(lambda: solve_many(models), 5)
    found = solve_many(models)
    evaluations = found.evaluations
    print(
        f"map of {len(models)} loads (100 N to 20 kN) and speeds (1000 to 38 000 rpm): median {median:.2f} s "
        f"({fastest:.2f} to {slowest:.2f} s of 5 runs), {len(found.unsolved)} unsolved, "
        f"evaluations: mean {evaluations.mean():.1f}, largest {evaluations.max()}"
    )
    apart = []
    for place in range(0, len(models), 37):
        single = replace(models[place]).solve()
        apart.append(np.abs(single.loads - found[place].loads).max() / single.loads.max())
    print(f"largest difference from the same point solved alone: {max(apart):.1e} of its largest load")


if __name__ == "__main__":
    main()
