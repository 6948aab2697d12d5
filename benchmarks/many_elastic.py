"""Time of many bearings between the same elastic rings on one core: `python -m benchmarks.many_elastic`.

A map of 1000 loads and speeds of the paper's bearing between its rings, condensed before, against rigid
solves of a single bearing of the map in the same run; then how its bearings were solved, and how far they are
from single runs.
"""

import statistics
import time
from collections.abc import Callable
from dataclasses import replace
from typing import TypeVar

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.bearings import CASE, RPM
from benchmarks.machine import describe
from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.progress import Logged
from flexbearing.rings.condensed import condensed_raceways
from quasidynamic import Equilibria, RollerBearing, solve_many, solve_many_elastic

RUNS, SINGLE = 5, 101  # runs of the map, rigid solves in each of them
STRIDE = 37  # of the bearings that are compared with single runs

Answer = TypeVar("Answer")


def main() -> None:
    print(describe())
    case = read_case(CASE)
    model = roller_bearing.bearing(case)
    linear = condensed_raceways(case, model.bearing.azimuths, Logged()).linearised(model.solve().forces)
    bearings, elastic = loads_and_speeds(model), (linear.compliance, linear.initial_deviation)
    with threadpool_limits(limits=1, user_api="blas"):
        many = timed(bearings, *elastic)
        compared(bearings, many, *elastic)


def loads_and_speeds(model: RollerBearing) -> list[RollerBearing]:
    """40 loads from 2 to 30 kN, 25 speeds from 5000 to 40 000 rpm."""
    points = [
        (load, speed * RPM) for load in np.linspace(2e3, 30e3, 40) for speed in np.linspace(5e3, 40e3, 25)
    ]
    return [
        replace(model, operation=replace(model.operation, radial_load=float(load), inner_speed=float(speed)))
        for load, speed in points
    ]


def timed(bearings: list[RollerBearing], compliance, deviation) -> Equilibria:
    """Print processor times of a bearing of the map over that of a rigid solve alone."""
    rows = []
    for _ in range(RUNS):
        singles = [spent(replace(bearing).solve)[1] for bearing in bearings[:: len(bearings) // SINGLE]]
        rigid, rigid_seconds = spent(lambda: solve_many(bearings))
        many, seconds = spent(lambda start=rigid: solve_many_elastic(bearings, compliance, start, deviation))
        each = [statistics.median(singles), rigid_seconds / len(bearings), seconds / len(bearings)]
        rows.append(1e3 * np.array([*each, each[1] + each[2]]))
        print("rigid alone {:.2f} ms; side by side {:.2f} ms rigid, {:.2f} ms elastic".format(*rows[-1]))
    shares = np.median([row[1:] / row[0] for row in rows], axis=0)
    print(
        f"a case of {len(bearings)} loads and speeds over a rigid solve alone, medians of {RUNS} runs: "
        "rigid {:.3f}, elastic {:.3f}, both {:.3f}".format(*shares)
    )
    return many


def spent(job: Callable[[], Answer]) -> tuple[Answer, float]:
    """What a job returns, and its processor time [s]."""
    began = time.process_time()
    return job(), time.process_time() - began


def compared(bearings: list[RollerBearing], many: Equilibria, compliance, deviation) -> None:
    """Print how the map was solved, and its largest differences from single runs."""
    ways = ", ".join(f"{count} {way}" for way, count in many.ways.most_common())
    print(f"{len(many.unsolved)} unsolved, evaluations: mean {many.evaluations.mean():.1f}; {ways}")
    apart = []
    for place in range(0, len(bearings), STRIDE):
        *_, alone = bearings[place].iterate(compliance, replace(bearings[place]).solve(), deviation)
        state = many[place]
        loads = np.abs(state.loads - alone.loads).max() / alone.loads.max()
        apart.append((loads, abs(state.cage_slip - alone.cage_slip), abs(state.life / alone.life - 1)))
    loads, slip, life = np.max(apart, axis=0)
    print(
        f"{len(apart)} of them alone: loads apart by {loads:.1e} of the largest, slips by {slip:.1e}, "
        f"lives by a share of {life:.1e}"
    )


if __name__ == "__main__":
    main()
