"""Time and sureness of angular-contact solves.

Run from the project directory: python -m benchmarks.angular_contact [count [seed]] [coulomb]

First the 218 bearing of the textbook, in CPU time of a warm interpreter on one core. Then bearings drawn at
random: size, conformity, contact angle, steel or ceramic balls, raceway control, loads over five decades, up
to about the static capacity in any direction from axial to radial, 10 to 500 000 mm/min; the ring free under
moments up to load times pitch radius, held against tilt, or held against tilt with an axial preload. Where
nothing holds the ring against such loads the outcome is "undetermined", which counts for itself. With
`coulomb`, friction of 0.03 to 0.12 moves the balls of the same bearings.
"""

import collections
import statistics
import sys
import time
from collections.abc import Callable

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from quasidynamic.angular_contact import AngularContactBallBearing as Model
from quasidynamic.errors import NotSolved
from quasidynamic.outcome.angular_contact_state import AngularContactState
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing, RingOperation
from quasidynamic.parts.ball import Ball, Groove
from quasidynamic.parts.material import Material
from quasidynamic.solve.outcome import SolverOutcome

RPM = np.pi / 30
STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7800.0)
CERAMIC = Material(youngs_modulus=310e9, poisson_ratio=0.26, density=3200.0)
STRAIGHT = (None, None, None, 0.0, 0.0)
OPERATIONS = {
    "at rest, five loads": RingOperation(load=(8000.0, 1000.0, 3000.0, 100.0, -50.0)),
    "thrust, 10 000 rpm": RingOperation(load=(17800.0, 0.0, 0.0, 0.0, 0.0), inner_speed=10000 * RPM),
    "five loads, 10 000 rpm": RingOperation(
        load=(8000.0, 1000.0, 3000.0, 100.0, -50.0), inner_speed=10000 * RPM
    ),
    "half of the balls loaded, 10 000 rpm": RingOperation(
        load=(4000.0, 0.0, 8000.0, 0.0, 0.0), displacement=STRAIGHT, inner_speed=10000 * RPM
    ),
}


def main() -> None:
    print(describe())
    with threadpool_limits(limits=1, user_api="blas"):
        textbook()
        numbers = [int(word) for word in sys.argv[1:] if word != "coulomb"]
        at_random(*numbers or (1000,), draw=drawn_sliding if "coulomb" in sys.argv else drawn)


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
    model = Model(bearing=bearing)
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


def at_random(count: int, first: int = 0, *, draw: Callable[[int], tuple[Model, RingOperation]]) -> None:
    outcomes, evaluations, worst, unguided, seconds = collections.Counter(), [], 0.0, 0, []
    for seed in range(first, first + count):
        model, operation = draw(seed)
        began = time.process_time()
        try:
            state = model.solve(operation)
            seconds.append(time.process_time() - began)
        except NotSolved as found:
            seconds.append(time.process_time() - began)
            undetermined = found.outcome is SolverOutcome.UNDETERMINED
            outcomes[f"{found.outcome}" + ("" if undetermined else f" (seed {seed})")] += 1
            continue
        evaluations.append(state.evaluations)
        worst = max(worst, unbalanced(state))
        unguided += not state.guided.all()
    print(
        f"{count} bearings at random from seed {first}: {len(evaluations)} solved "
        f"({unguided} with balls that the races do not guide), "
        f"worst imbalance {worst:.1e} of the largest force, others: {dict(outcomes)}; "
        f"evaluations: median {np.median(evaluations):.0f}, "
        f"99 % below {np.percentile(evaluations, 99):.0f}, largest {max(evaluations)}; "
        f"{np.mean(seconds) * 1e3:.1f} ms each, median {np.median(seconds) * 1e3:.1f} ms, "
        f"longest {max(seconds):.1f} s"
    )


def unbalanced(state: AngularContactState) -> float:
    """Force left on ring or balls over the largest force, from the contact forces anew."""
    load, traction = state.loads, state.tractions
    axial = load * np.sin(state.contact_angles) + traction * np.cos(state.contact_angles)
    radial = load * np.cos(state.contact_angles) - traction * np.sin(state.contact_angles)
    ball = np.abs([axial[0] - axial[1], radial[0] - radial[1] + state.centrifugal_force])
    azimuth, own = state.bearing.azimuths, state.bearing
    lever = own.inner.conformity * own.ball.diameter / own.inner_groove_radius
    moment = axial[0] - lever * traction[0]
    arms = [axial[0], radial[0] * np.sin(azimuth), radial[0] * np.cos(azimuth)]
    arms += [moment * np.cos(azimuth), -moment * np.sin(azimuth)]
    scale = np.array([1.0, 1.0, 1.0, own.inner_groove_radius, own.inner_groove_radius])
    free = [place is None for place in state.operation.displacement]
    ring = np.abs(np.sum(arms, axis=1) - np.array(state.operation.load) / scale)[free]
    largest = max(load.max(), np.abs(state.operation.load / scale).max())
    return float(max(ball.max(), ring.max(initial=0.0)) / largest)


def drawn_sliding(seed: int) -> tuple[Model, RingOperation]:
    """The same bearing, its balls moved by Coulomb friction of 0.03 to 0.12."""
    model, operation = drawn(seed)
    friction = np.exp(np.random.default_rng([seed, 1]).uniform(np.log(0.03), np.log(0.12)))
    return Model(bearing=model.bearing, control="coulomb", friction=float(friction)), operation


def drawn(seed: int) -> tuple[Model, RingOperation]:
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
    lean, azimuth = np.radians(random.uniform(0.0, 90.0)), random.uniform(0.0, 2 * np.pi)
    size = bearing.balls * diameter**2 * 5e7 * 10 ** random.uniform(-5.0, 0.0)
    load = size * np.array([np.cos(lean), np.sin(lean) * np.sin(azimuth), np.sin(lean) * np.cos(azimuth)])
    moment = np.zeros(2)
    holding = ("free", "straight", "preloaded")[int(random.choice(3, p=[0.4, 0.3, 0.3]))]
    if holding == "free":
        about = random.uniform(0.0, 2 * np.pi)
        moment = random.uniform(0.0, 1.0) * size * pitch / 2 * -np.array([np.sin(about), np.cos(about)])
    if holding == "preloaded":
        load[0] = 0.0
    preload = random.uniform(0.0, 0.3) * min(bearing.inner_reach, bearing.outer_reach)
    operation = RingOperation(
        load=(float(load[0]), float(load[1]), float(load[2]), float(moment[0]), float(moment[1])),
        displacement={
            "free": (None,) * 5,
            "straight": (None, None, None, 0.0, 0.0),
            "preloaded": (float(preload), None, None, 0.0, 0.0),
        }[holding],
        inner_speed=speed,
    )
    control = ("outer", "inner", "equal")[int(random.integers(3))]
    return Model(bearing=bearing, control=control), operation


if __name__ == "__main__":
    main()
