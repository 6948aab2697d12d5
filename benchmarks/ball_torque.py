"""Time of slow ball bearings on one core: `python -m benchmarks.ball_torque`.

One ball of two and of four contacts, then load distribution and torque of a slewing bearing with 156 balls.
"""

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe, median_seconds
from quasidynamic.four_point import FourPointBallBearing, RingLoad
from quasidynamic.parts.ball import Ball, FourPointBearing, Groove, constant_friction
from quasidynamic.parts.material import Material
from quasidynamic.solve.balls.load_distribution import ball_loads
from quasidynamic.solve.balls.sliding_motion import sliding_motion

STEEL = Material(youngs_modulus=210e9, poisson_ratio=0.3, density=7850)
LOAD = RingLoad(radial_z=36_200, radial_y=-31_400, moment_z=328_601, moment_y=378_833)
RUNS = 51


def main() -> None:
    print(describe())
    groove = Groove(conformity=0.525, material=STEEL)
    slewing = FourPointBallBearing(
        bearing=FourPointBearing(
            ball=Ball(diameter=35e-3, material=STEEL), inner=groove, outer=groove, balls=156,
            pitch_diameter=1.9, contact_angle=np.radians(45), clearance=-15.2e-6,
        ),
        friction=constant_friction(0.12),
    )  # fmt: skip
    with threadpool_limits(limits=1, user_api="blas"):
        single(slewing, "two contacts", [[3000.0, 3000.0]])
        single(slewing, "four contacts", [[3000.0, 3000.0], [600.0, 600.0]])
        whole(slewing)


def single(slewing: FourPointBallBearing, name: str, loads: list[list[float]]) -> None:
    load = np.array([loads])
    balls = slewing.slide(np.full(load.shape, np.radians(45)), load)
    seconds = median_seconds(lambda: sliding_motion(balls.contacts, balls.ellipse), RUNS)
    report(f"one ball, {name}", seconds, f"{balls.sliding.evaluations} evaluations")


def whole(slewing: FourPointBallBearing) -> None:
    found = ball_loads(slewing.bearing, LOAD.vector())
    seconds = median_seconds(lambda: ball_loads(slewing.bearing, LOAD.vector()), RUNS)
    report("load distribution, 156 balls", seconds, f"{found.iterations} evaluations")
    state = slewing.solve(LOAD)
    seconds = median_seconds(lambda: slewing.solve(LOAD), 11)
    evaluations = state.balls.sliding.evaluations
    report("loads and torque, 156 balls", seconds, f"{evaluations} evaluations, {state.torque:.1f} N m")


def report(name: str, seconds: tuple[float, float, float], more: str) -> None:
    median, fastest, slowest = (1e3 * value for value in seconds)
    print(f"{name}: median {median:.1f} ms ({fastest:.1f} to {slowest:.1f} ms), {more}")


if __name__ == "__main__":
    main()
