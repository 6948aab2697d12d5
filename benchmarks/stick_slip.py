"""Balls with stick and slip beside those of Heras et al. (2017): `python -m benchmarks.stick_slip`.

`--grids` shows convergence with the cells of a contact, `--robustness N` solves N random balls,
`--slewing` the bearing of 156 balls of Joshi et al. (2015) on one core and on all.
"""

import argparse
import statistics
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

import flexbearing
from benchmarks.machine import describe
from flexbearing.program.threads import cores, limited_to
from quasidynamic.errors import NotSolved, OutOfRange
from quasidynamic.four_point import FourPointBallBearing
from quasidynamic.outcome.slow_balls import SlidingBalls
from quasidynamic.parts.ball import Ball, FourPointBearing, Groove
from quasidynamic.parts.ball_friction import constant_friction
from quasidynamic.parts.material import Material
from quasidynamic.solve.balls.refined_rolling import RefinedRolling, RollingModel

CASES = {  # osculation, friction, loads of both diagonals [kN]; printed torques [N m]: full sliding, FEM
    "nominal": (0.95, 0.10, (29.34,), 17.1, 16.9),
    "A1": (0.96, 0.09, (61.38,), 64.7, 73.4),
    "A2": (0.96, 0.09, (64.93, 64.93), 1165.4, 1228.9),
    "A3": (0.96, 0.09, (63.00, 1.605), 138.9, 158.3),
    "B1": (0.94, 0.13, (9.40,), 2.9, 1.7),
    "B2": (0.94, 0.13, (9.70, 9.70), 117.2, 121.0),
    "B3": (0.94, 0.13, (9.494, 0.893), 57.5, 59.4),
}
GRIDS = [(20, 40), (40, 80), (80, 160), (160, 320)]
RUNS = 5
SLEWING = Path(__file__).parents[1] / "configs" / "joshi2015_fourpoint.toml"


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("--grids", action="store_true")
    options.add_argument("--robustness", type=int, default=0, metavar="N")
    options.add_argument("--slewing", action="store_true")
    wanted = options.parse_args()
    print(describe())
    with threadpool_limits(limits=1, user_api="blas"):
        cases()
        if wanted.grids:
            grids()
        if wanted.robustness:
            robustness(wanted.robustness)
        if wanted.slewing:
            slewing()


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


def grids() -> None:
    print("half-spaces, torque [N m] +- told error and processor time [s], by cells along and across")
    for name in CASES:
        bearing, row = heras(name, "local"), []
        for cells in GRIDS:
            ball, seconds = timed(
                lambda bearing=bearing, name=name, cells=cells: rolled(bearing, name, "kalker", cells), 1
            )
            row.append(f"{cells[0]}x{cells[1]} {ball.torque:.4f} +- {ball.grid_error:.4f} ({seconds:.2f} s)")
        print(f"{name:7} {'; '.join(row)}; limit {ball.extrapolated_torque:.4f}", flush=True)


def robustness(count: int) -> None:
    unsolved, above, seconds = [], [], []
    for seed in range(count):
        bearing, balls = drawn(seed)
        most, began = balls.torque, time.process_time()
        try:
            (ball,) = bearing.roll(balls, "kalker", (20, 40)).rolled
        except (NotSolved, OutOfRange) as error:
            unsolved.append((seed, str(error)))
            continue
        seconds.append(time.process_time() - began)
        start = np.append(balls.sliding.motion[0], 0.0)
        if ball.torque > ball.fine.ball.full_sliding_power(start) * (1 + 1e-6):
            above.append((seed, ball.torque, most))
    print(f"{count} random balls on 20 by 40 cells: {len(unsolved)} unsolved {unsolved[:5]}")
    print(f"{len(above)} above full sliding {above[:5]}")
    print(f"mean {1e3 * statistics.mean(seconds):.0f} ms, most {1e3 * max(seconds):.0f} ms")


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


def timed(job: Callable[[], RefinedRolling], runs: int = RUNS) -> tuple[RefinedRolling, float]:
    """Result and the median of processor times."""
    ball, seconds = job(), []
    for _ in range(runs):
        began = time.process_time()
        ball = job()
        seconds.append(time.process_time() - began)
    return ball, statistics.median(seconds)


def rolled(
    bearing: FourPointBallBearing, name: str, model: RollingModel, cells: tuple[int, int]
) -> RefinedRolling:
    (ball,) = bearing.roll(sliding(bearing, name), model, cells).rolled
    return ball


def sliding(bearing: FourPointBallBearing, name: str) -> SlidingBalls:
    loads = 1e3 * np.array(CASES[name][2])
    load = np.broadcast_to(loads[None, :, None], (1, len(loads), 2))
    return bearing.slide(np.full(load.shape, np.pi / 4), load)


def heras(name: str, spin: str) -> FourPointBallBearing:
    osculation, friction, *_ = CASES[name]
    return slow_bearing((30e-3, 1.0), (0.5 / osculation, 0.5 / osculation), friction, spin)


def slow_bearing(diameters, conformities, friction, spin) -> FourPointBallBearing:
    steel = Material(youngs_modulus=200e9, poisson_ratio=0.3, density=7850)
    inner, outer = (Groove(conformity=float(each), material=steel) for each in conformities)
    bearing = FourPointBearing(
        ball=Ball(diameter=diameters[0], material=steel), inner=inner, outer=outer, balls=3,
        pitch_diameter=diameters[1], contact_angle=np.pi / 4,
    )  # fmt: skip
    return FourPointBallBearing(bearing=bearing, friction=constant_friction(friction), spin=spin)


def drawn(seed: int) -> tuple[FourPointBallBearing, SlidingBalls]:
    """Osculation 0.9 to 0.99, friction 0.005 to 0.5, loads over four decades, two or four contacts."""
    random = np.random.default_rng(seed)
    diameter, slender, friction = np.exp(random.uniform(*np.log([(5e-3, 6.0, 0.005), (60e-3, 80.0, 0.5)])))
    conformities = 0.5 / random.uniform(0.9, 0.99, size=2)
    bearing = slow_bearing(
        (float(diameter), float(slender * diameter)), conformities, float(friction), "local"
    )
    diagonals = 1 if random.random() < 0.4 else 2
    loads = 80e6 * diameter**2 * np.exp(random.uniform(np.log(1e-4), 0.0, size=diagonals))  # to 4 GPa or so
    angles = np.radians(random.uniform(25, 65, size=diagonals))
    shape = (1, diagonals, 2)
    angle, load = (np.broadcast_to(values[None, :, None], shape) for values in (angles, loads))
    return bearing, bearing.slide(angle, load)


if __name__ == "__main__":
    main()
