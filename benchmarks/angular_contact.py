"""Time and sureness of angular-contact solves.

Run from the project directory: python -m benchmarks.angular_contact [count [seed]] [KIND] [FILE.jsonl]

First the 218 bearing of the textbook, in CPU time of a warm interpreter on one core. Then bearings drawn at
random: size, conformity, contact angle, steel or ceramic balls, raceway control, loads over five decades, up
to about the static capacity in any direction from axial to radial, 10 to 500 000 mm/min; the ring free under
moments up to load times pitch radius, held against tilt, or held against tilt with an axial preload. Where
nothing holds the ring against such loads the outcome is "undetermined", under ellipses as wide as the balls
"out of range"; both count for themselves. KINDs: with
`coulomb`, friction of 0.03 to 0.12 moves the balls of the same bearings; with `pairs` they have a second row
in O, X or tandem arrangement, with play or preload; with `oil`, tractions of a random oil move them, with
`cage` in the pockets of a cage, too. What is not solved is printed as it comes. The file gets a line for each
bearing as soon as it ends; bearings that it has already are not solved again.
"""

import collections
import json
import statistics
import sys
import time
from collections.abc import Callable
from pathlib import Path

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

REFUSED = (f"{SolverOutcome.UNDETERMINED}", f"{SolverOutcome.OUT_OF_RANGE}")
SLOW = 6.0  # [s]
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
        numbers = [int(word) for word in sys.argv[1:] if word.isdigit()]
        draw = next((draw for word, draw in kinds.items() if word in sys.argv), drawn)
        stored = next((Path(word) for word in sys.argv[1:] if word.endswith(".jsonl")), None)
        at_random(*numbers or (1000,), draw=draw, stored=stored)


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


def at_random(
    count: int, first: int = 0, *, draw: Callable[[int], tuple[Model, RingOperation]], stored: Path | None
) -> None:
    rows = {} if stored is None or not stored.exists() else _read(stored)
    for seed in range(first, first + count):
        if seed in rows:
            continue
        rows[seed] = _row(seed, *draw(seed))
        if stored is not None:
            with stored.open("a") as file:
                file.write(json.dumps(rows[seed]) + "\n")
    summarise([row for seed, row in sorted(rows.items()) if first <= seed < first + count])


def _read(stored: Path) -> dict[int, dict]:
    return {row["seed"]: row for row in map(json.loads, stored.read_text().splitlines())}


def _row(seed: int, model: Model, operation: RingOperation) -> dict:
    """What became of one bearing; what is left of forces, power, cage and momentum is relative."""
    began = time.process_time()
    try:
        state = model.solve(operation)
    except NotSolved as found:
        row = {"seed": seed, "outcome": f"{found.outcome}", "seconds": time.process_time() - began}
        print(f"seed {seed}, {row['seconds']:.1f} s: {found}", flush=True)
        return row
    row = {"seed": seed, "outcome": "solved", "seconds": time.process_time() - began}
    row |= {"evaluations": state.evaluations, "imbalance": unbalanced(state)}
    row["guided"] = bool(state.guided.all())
    if state.oil is not None:
        power, momentum, cage = (abs(float(left)) for left in identities(state))
        row |= {"power": power, "cage": cage}
        if not state.oil.churning_heat.any():  # which brakes balls against the housing
            row["momentum"] = momentum
    return row


def summarise(rows: list[dict]) -> None:
    outcomes = collections.Counter(row["outcome"] for row in rows)
    unsolved = [row["seed"] for row in rows if row["outcome"] not in ("solved", *REFUSED)]
    seconds, unguided = np.array([row["seconds"] for row in rows]), [row.get("guided", True) for row in rows]
    print(
        f"{len(rows)} bearings at random from seed {rows[0]['seed']}: {dict(outcomes)}, unsolved seeds "
        f"{unsolved}, with balls that the races do not guide {unguided.count(False)}; "
        f"processor time median {np.median(seconds) * 1e3:.1f} ms, mean {np.mean(seconds) * 1e3:.1f} ms, "
        f"99 % below {np.percentile(seconds, 99):.1f} s, longest {seconds.max():.1f} s (seed "
        f"{rows[int(seconds.argmax())]['seed']}), {(seconds > SLOW).sum()} above {SLOW:g} s"
    )
    for name in ("evaluations", "imbalance", "power", "cage", "momentum"):
        known = [row for row in rows if name in row]
        if known:
            largest = max(known, key=lambda row: row[name])
            values = [row[name] for row in known]
            print(
                f"{name} of {len(known)}: median {np.median(values):.2g}, 99 % below "
                f"{np.percentile(values, 99):.2g}, largest {largest[name]:.2g} (seed {largest['seed']})"
            )


if __name__ == "__main__":
    main()
