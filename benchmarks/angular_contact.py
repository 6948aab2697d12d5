"""Time and sureness of angular-contact solves on one core: `python -m benchmarks.angular_contact [count]`.

First the 218 bearing of the textbook, in CPU time of a warm interpreter. Then bearings drawn at random: size,
conformity, contact angle, steel or ceramic balls, raceway control, loads over five decades up to about the
static capacity and up to 60 degrees from the axis, ring free to tilt or not, 10 to 500 000 mm/min. The load
is raised where it is less than three tenths of the centrifugal forces, below which balls skid.
"""

import collections
import statistics
import sys
import time

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.errors import NotSolved
from quasidynamic.parts.angular import AngularContactBearing, RingOperation
from quasidynamic.parts.ball import Ball, Groove
from quasidynamic.parts.material import Material

RPM = np.pi / 30
STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7800.0)
CERAMIC = Material(youngs_modulus=310e9, poisson_ratio=0.26, density=3200.0)
LEAST_LOAD = 0.3  # of the centrifugal forces
STRAIGHT = (None, None, None, 0.0, 0.0)
OPERATIONS = {
    "at rest, five loads": RingOperation(load=(3000.0, 1000.0, 8000.0, 50.0, -100.0)),
    "thrust, 10 000 rpm": RingOperation(load=(0.0, 0.0, 17800.0, 0.0, 0.0), inner_speed=10000 * RPM),
    "five loads, 10 000 rpm": RingOperation(
        load=(3000.0, 1000.0, 8000.0, 50.0, -100.0), inner_speed=10000 * RPM
    ),
    "half of the balls loaded, 10 000 rpm": RingOperation(
        load=(8000.0, 0.0, 4000.0, 0.0, 0.0), displacement=STRAIGHT, inner_speed=10000 * RPM
    ),
}


def main() -> None:
    print(describe())
    with threadpool_limits(limits=1, user_api="blas"):
        textbook()
        at_random(int(sys.argv[1]) if len(sys.argv) > 1 else 1000)


def textbook() -> None:
    groove = Groove(conformity=11.63 / 22.23, material=STEEL)
    bearing = AngularContactBearing(
        ball=Ball(diameter=22.23e-3, material=STEEL),
        inner=groove,
        outer=groove,
        balls=16,
        pitch_diameter=125.26e-3,
        contact_angle=np.radians(40.0),
    )
    model = AngularContactBallBearing(bearing=bearing)
    for name, operation in OPERATIONS.items():
        seconds = []
        for _ in range(51):
            began = time.process_time()
            state = model.solve(operation)
            seconds.append(time.process_time() - began)
        print(
            f"218, {name}: median {statistics.median(seconds) * 1e3:.1f} ms, "
            f"fastest {min(seconds) * 1e3:.1f} ms, "
            f"{state.evaluations} evaluations of all balls"
        )


def at_random(count: int) -> None:
    endings, evaluations, unbalanced = collections.Counter(), [], []
    began = time.process_time()
    for seed in range(count):
        model, operation = drawn(seed)
        try:
            state = model.solve(operation)
        except NotSolved as found:
            endings[f"{found.ending} (seed {seed})"] += 1
            continue
        evaluations.append(state.evaluations)
        unbalanced.append(np.abs(state.ring_load - operation.load)[:3].max() / state.loads.max())
    spent = time.process_time() - began
    print(
        f"{count} bearings at random: {len(evaluations)} solved, worst imbalance "
        f"{max(unbalanced):.1e} of the "
        f"largest load, others: {dict(endings)}; "
        f"evaluations: median {np.median(evaluations):.0f}, "
        f"99 % below {np.percentile(evaluations, 99):.0f}, largest {max(evaluations)}; "
        f"{spent / count * 1e3:.1f} ms each"
    )


def drawn(seed: int) -> tuple[AngularContactBallBearing, RingOperation]:
    random = np.random.default_rng(seed)
    balls_of = STEEL if random.random() < 0.7 else CERAMIC
    diameter, ratio = np.exp(random.uniform(np.log(3e-3), np.log(40e-3))), random.uniform(0.08, 0.3)
    pitch = diameter / ratio
    most = int(np.pi / np.arcsin(ratio) * 0.98)
    bearing = AngularContactBearing(
        ball=Ball(diameter=diameter, material=balls_of),
        inner=Groove(conformity=random.uniform(0.505, 0.55), material=STEEL),
        outer=Groove(conformity=random.uniform(0.505, 0.55), material=STEEL),
        balls=int(random.integers(max(3, most // 2), most + 1)),
        pitch_diameter=pitch,
        contact_angle=np.radians(random.uniform(5.0, 45.0)),
    )
    speed = 10 ** random.uniform(1.0, np.log10(5e5)) / (pitch * 1e3) * RPM
    lean, azimuth = np.radians(random.uniform(0.0, 60.0)), random.uniform(0.0, 2 * np.pi)
    centrifugal = bearing.balls * bearing.ball.mass * pitch / 2 * (speed / 2) ** 2
    load = bearing.balls * diameter**2 * 5e7 * 10 ** random.uniform(-5.0, 0.0)
    load = max(load, LEAST_LOAD * centrifugal / np.cos(lean))
    straight = random.random() < 0.6
    moments = np.zeros(2) if straight else random.normal(size=2) * 0.025 * load * pitch
    aside, about = load * np.sin(lean), moments
    operation = RingOperation(
        load=(
            float(aside * np.cos(azimuth)),
            float(aside * np.sin(azimuth)),
            float(load * np.cos(lean)),
            float(about[0]),
            float(about[1]),
        ),
        displacement=STRAIGHT if straight else (None,) * 5,
        inner_speed=speed,
    )
    control = ("outer", "inner", "equal")[int(random.integers(3))]
    return AngularContactBallBearing(bearing=bearing, control=control), operation


if __name__ == "__main__":
    main()
