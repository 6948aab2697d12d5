"""Time and sureness of angular-contact solves.

Run from the project directory: python -m benchmarks.angular_contact [count [seed]] [KIND]

First the 218 bearing of the textbook, in CPU time of a warm interpreter on one core. Then bearings drawn at
random: size, conformity, contact angle, steel or ceramic balls, raceway control, loads over five decades, up
to about the static capacity in any direction from axial to radial, 10 to 500 000 mm/min; the ring free under
moments up to load times pitch radius, held against tilt, or held against tilt with an axial preload. Where
nothing holds the ring against such loads the outcome is "undetermined", under ellipses as wide as the balls
"out of range"; both count for themselves. KINDs: with
`coulomb`, friction of 0.03 to 0.12 moves the balls of the same bearings; with `pairs` they have a second row
in O, X or tandem arrangement, with play or preload; with `oil`, tractions of a random oil move them, with
`cage` in the pockets of a cage, too. What is not solved is printed as it comes.
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
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing, RingOperation
from quasidynamic.parts.ball import Ball, Groove
from quasidynamic.solve.step_length import SolverOutcome
from tests.random_balls import (
    RPM,
    STEEL,
    drawn,
    drawn_caged,
    drawn_oiled,
    drawn_pair,
    drawn_sliding,
    identities,
    unbalanced,
)

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
        kinds = {"coulomb": drawn_sliding, "pairs": drawn_pair, "oil": drawn_oiled, "cage": drawn_caged}
        numbers = [int(word) for word in sys.argv[1:] if word not in kinds]
        draw = next((draw for word, draw in kinds.items() if word in sys.argv), drawn)
        at_random(*numbers or (1000,), draw=draw)


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
    left, still = np.zeros(3), 0
    for seed in range(first, first + count):
        model, operation = draw(seed)
        began = time.process_time()
        try:
            state = model.solve(operation)
            seconds.append(time.process_time() - began)
        except NotSolved as found:
            seconds.append(time.process_time() - began)
            refused = found.outcome in (SolverOutcome.UNDETERMINED, SolverOutcome.OUT_OF_RANGE)
            print(f"seed {seed}, {seconds[-1]:.1f} s: {found}", flush=True)
            outcomes[f"{found.outcome}" + ("" if refused else f" (seed {seed})")] += 1
            continue
        evaluations.append(state.evaluations)
        worst = max(worst, unbalanced(state))
        unguided += not state.guided.all()
        if state.oil is not None:
            power, momentum, cage = identities(state)
            without = not state.oil.churning_heat.any()  # which brakes balls against the housing
            still += without
            left = np.maximum(left, np.abs([power, cage, momentum if without else 0.0]))
    print(
        f"{count} bearings at random from seed {first}: {len(evaluations)} solved "
        f"({unguided} with balls that the races do not guide), "
        f"worst imbalance {worst:.1e} of the largest force, others: {dict(outcomes)}; "
        f"power of the rings less heat by cause {left[0]:.1e}, torque left on a cage {left[1]:.1e}, "
        f"of the rings less that of the drag, of {still} without churning, {left[2]:.1e}; "
        f"evaluations: median {np.median(evaluations):.0f}, "
        f"99 % below {np.percentile(evaluations, 99):.0f}, largest {max(evaluations)}; "
        f"{np.mean(seconds) * 1e3:.1f} ms each, median {np.median(seconds) * 1e3:.1f} ms, "
        f"longest {max(seconds):.1f} s"
    )


if __name__ == "__main__":
    main()
