"""Balls with stick and slip beside those of Heras et al. (2017): `python -m benchmarks.stick_slip`.

Instead of that `--grids` shows convergence with the cells of a contact, `--slewing` the bearing of 156 balls
of Joshi et al. (2015) on one core and on all.
"""

import argparse
import statistics
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

import flexbearing
from benchmarks.machine import describe
from flexbearing.program.threads import cores, limited_to
from quasidynamic.contact.ellipse.rigid_slip import Spin
from quasidynamic.four_point import FourPointBallBearing
from quasidynamic.outcome.slow_balls import SlidingBalls
from quasidynamic.parts.ball import Ball, FourPointBearing, Groove, constant_friction
from quasidynamic.parts.material import Material
from quasidynamic.solve.balls.refined_rolling import RefinedRolling, RollingModel
from tests.literature import test_heras2017 as paper

CASES = {  # osculation, friction, loads of both diagonals [kN]; printed torques [N m]: full sliding, FEM
    name: (
        osculation,
        friction,
        tuple(load for load in paper.FITTED[name][0] if load),
        torque,
        paper.FINITE_ELEMENTS[name][-1],
    )
    for name, (osculation, friction, *_, torque) in paper.CASES.items()
}
GRIDS = [(20, 40), (40, 80), (80, 160), (160, 320)]
RUNS = 5
SLEWING = Path(__file__).parents[1] / "configs" / "joshi2015_fourpoint.toml"


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("--grids", action="store_true")
    options.add_argument("--slewing", action="store_true")
    wanted = options.parse_args()
    print(describe())
    with threadpool_limits(limits=1, user_api="blas"):
        if wanted.grids:
            grids()
        if wanted.slewing:
            slewing()
        if not (wanted.grids or wanted.slewing):
            cases()
            pressures()


def cases() -> None:
    print(
        "torque of a ball [N m]; processor time from its loads on, full sliding and both grids included [ms]"
    )
    print("        | printed         | full sliding    | FASTSIM 20x40   | half-spaces 40x80              |")
    print(
        "        |   LEB     FEM   | centre   local  | torque  err  ms | torque    err  limit ms stick | /FEM"
    )
    times: dict[RollingModel, list[float]] = {"fastsim": [], "kalker": []}
    for name, (*_, leb, fem) in CASES.items():
        bearing, centre = heras(name, "local"), sliding(heras(name, "centre"), name).torque
        local = sliding(bearing, name).torque
        fast, fast_time = timed(lambda bearing=bearing, name=name: rolled(bearing, name, "fastsim", (20, 40)))
        full, time_ = timed(lambda bearing=bearing, name=name: rolled(bearing, name, "kalker", (40, 80)))
        times["fastsim"].append(fast_time)
        times["kalker"].append(time_)
        stick = full.fine.rolled.stick_share.max()
        print(
            f"{name:7} | {leb:7.1f} {fem:7.1f} | {centre:7.2f} {local:7.2f} | {fast.torque:7.2f} "
            f"{fast.grid_error:4.2f} {1e3 * fast_time:3.0f} | {full.torque:8.3f} {full.grid_error:5.3f} "
            f"{full.extrapolated_torque:8.3f} {1e3 * time_:3.0f} {stick:.2f} | {full.torque / fem:.2f}"
        )
    for model, seconds in times.items():
        print(f"{model}: median {1e3 * statistics.median(seconds):.0f} ms, most {1e3 * max(seconds):.0f} ms")


def pressures() -> None:
    print(
        "half-spaces 40x80 with the local spin, by contact pressure: torque [N m] +- told error, limit, time"
    )
    print(
        "        | printed |  full | Hertz   | offset arcs                  | moved ring           | offset"
    )
    print("        |   LEB   | slide | limit   | torque    err    limit    ms | torque    err  limit | /FEM")
    for name, (*_, leb, fem) in CASES.items():
        hertz = heras(name, "local")
        limit, slide = rolled(hertz, name, "kalker").extrapolated_torque, sliding(hertz, name).torque
        offset, moved = (replace(hertz, contact_pressure=kind) for kind in ("offset", "translation"))
        ball, seconds = timed(lambda bearing=offset, name=name: rolled(bearing, name, "kalker"))
        other = rolled(moved, name, "kalker")
        print(
            f"{name:7} | {leb:7.1f} | {slide:7.2f} | {limit:7.2f} | {ball.torque:8.3f} "
            f"{ball.grid_error:5.3f} {ball.extrapolated_torque:8.3f} {1e3 * seconds:4.0f} | "
            f"{other.torque:8.3f} {other.grid_error:5.3f} {other.extrapolated_torque:8.3f} | "
            f"{ball.torque / fem:.2f}",
            flush=True,
        )


def grids() -> None:
    print("half-spaces: torque [N m] +- told error (processor time [s], once), by cells along and across")
    print("last column: orders of convergence by three grids each")
    for name in CASES:
        bearing, torques = heras(name, "local"), []
        rolled(bearing, name, "kalker", GRIDS[0])  # what the first call prepares is not counted
        print(f"{name:7}", end="")
        for cells in GRIDS:
            began = time.process_time()
            ball = rolled(bearing, name, "kalker", cells)
            seconds = time.process_time() - began
            torques.append(ball.torque)
            told = f"{ball.torque:.4f} +- {ball.grid_error:.4f} ({seconds:.2f})"
            print(f" | {cells[0]}x{cells[1]} {told}", end="", flush=True)
        changes = np.abs(np.diff(torques))
        orders = ", ".join(f"{order:.1f}" for order in np.log2(changes[:-1] / changes[1:]))
        print(f" | {orders}", flush=True)


def slewing() -> None:
    """Whole runs of a case, no result of a ball used for another one."""
    print("156 balls, radial and moment load, half-spaces 40x80 and 20x40 for the error; wall time")
    results = []
    for jobs in sorted({1, cores()}):
        with limited_to(jobs):
            began = time.perf_counter()
            results.append(flexbearing.run(SLEWING, {"friction.model": "kalker"}))
        torque = results[-1].summary()["rigid"]["torque_Nm"]["inner"]
        print(f"{jobs} cores: {time.perf_counter() - began:.1f} s, torque {torque:.1f} N m", flush=True)
    print(f"all results are identical: {all(each == results[0] for each in results)}")


def timed(job: Callable[[], RefinedRolling]) -> tuple[RefinedRolling, float]:
    """Result and the median of processor times, without the first."""
    ball, seconds = job(), []
    for _ in range(RUNS):
        began = time.process_time()
        ball = job()
        seconds.append(time.process_time() - began)
    return ball, statistics.median(seconds)


def rolled(
    bearing: FourPointBallBearing, name: str, model: RollingModel, cells: tuple[int, int] = (40, 80)
) -> RefinedRolling:
    (ball,) = filter(None, bearing.roll(sliding(bearing, name), model, cells).rolled)
    return ball


def sliding(bearing: FourPointBallBearing, name: str) -> SlidingBalls:
    loads = 1e3 * np.array(CASES[name][2])
    load = np.broadcast_to(loads[None, :, None], (1, len(loads), 2))
    return bearing.slide(np.full(load.shape, np.pi / 4), load)


def heras(name: str, spin: Spin) -> FourPointBallBearing:
    osculation, friction, *_ = CASES[name]
    steel = Material(youngs_modulus=200e9, poisson_ratio=0.3, density=7850)
    groove = Groove(conformity=0.5 / osculation, material=steel)
    bearing = FourPointBearing(
        ball=Ball(diameter=30e-3, material=steel), inner=groove, outer=groove, balls=3, pitch_diameter=1.0,
        contact_angle=np.pi / 4,
    )  # fmt: skip
    return FourPointBallBearing(bearing=bearing, friction=constant_friction(friction), spin=spin)


if __name__ == "__main__":
    main()
