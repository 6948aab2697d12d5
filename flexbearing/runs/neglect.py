"""What models of ball bearings neglect, over their largest load: values for findings."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from flexbearing.findings.neglected import MUCH_NEGLECTED
from quasidynamic.motion.ball_slip import OUTER
from quasidynamic.outcome.neglected import friction_share, inertia_shares, weight_share

INERTIA, MOMENT, WEIGHT, FRICTION = "inertia", "gyroscopic moment", "weight", "friction"
ORBIT = "orbit of the balls by friction"
OF_BALLS = " of the balls"
FAR = 0.5  # of the share that is a danger: bounds below it need no exact one


def of_fast_balls(solution: Any) -> Mapping[str, Any]:
    """Weight, and friction where a race controls the balls; centrifugal forces and moments are computed."""
    state, case = solution.state, solution.case
    bearing, total = state.bearing, state.loads.sum()
    if not total:
        return {}
    found = {WEIGHT + OF_BALLS: weight_share(bearing.ball.mass, state.loads.max())}
    torque = solution.friction.friction_torque
    if case.operation.by_friction or torque is None:
        return {"neglected": found}
    return {"neglected": found | {FRICTION: friction_share(torque, bearing.pitch_diameter, total / 2)}}


def of_slow_balls(solution: Any) -> Mapping[str, Any]:
    """Weight and friction; where the loads of contacts are given, also what inertia would do to them."""
    balls, bearing = solution.balls, solution.bearing
    ball, driven = bearing.ball, balls.driven
    loads = balls.load.sum(axis=(1, 2))
    if not driven.any():
        return {}
    largest = balls.load.max()
    return {"neglected": _inertia(solution, largest) | {
        WEIGHT + OF_BALLS: weight_share(ball.mass, largest),
        FRICTION: friction_share(balls.torque, bearing.pitch_diameter, loads.sum() / 2),
    }}  # fmt: skip


def danger_of_slow_balls(solution: Any) -> Mapping[str, Any]:
    """The same where only dangers are reported: bounds without the motion of the balls, far from a danger.

    Balls that roll have more heat than those that move freely, and no orbit is faster than the ring.
    """
    balls, bearing, distribution = solution.balls, solution.bearing, solution.distribution
    if distribution is None or not balls.driven.any():
        return of_slow_balls(solution)
    mass, pitch, largest = bearing.ball.mass, bearing.pitch_diameter, balls.load.max()
    fastest = max(solution.case.operation.speed**2, float(np.square(distribution.orbit).max()))
    bounds = {
        ORBIT: mass * pitch / 2 * fastest / largest,
        WEIGHT + OF_BALLS: weight_share(mass, largest),
        FRICTION: friction_share(balls.rolling_torque, pitch, balls.load.sum() / 2),
    }
    far = max(bounds.values()) < FAR * MUCH_NEGLECTED.limit
    return {"neglected": bounds} if far else of_slow_balls(solution)


def _inertia(solution: Any, largest: float) -> dict[str, Any]:
    """Shares in the largest load [N] of what friction would change in the centrifugal force by its orbit.

    Where no balance has them, of inertia and gyroscopic moment.
    """
    ball, pitch, balls = solution.bearing.ball, solution.bearing.pitch_diameter, solution.balls.sliding
    motion = np.abs(balls.motion[balls.driven]) * solution.case.operation.speed
    if solution.distribution is not None:
        slip = ball.mass * pitch / 2 * (motion[:, 0] ** 2 - solution.distribution.orbit[balls.driven] ** 2)
        return {ORBIT: np.abs(slip).max() / largest}
    outer, _, radial = motion.max(axis=0)
    inertia, moment = inertia_shares(ball.mass, ball.diameter, pitch, outer, radial, largest)
    return {INERTIA + OF_BALLS: inertia, MOMENT + OF_BALLS: moment}


def friction_of_moments(solution: Any) -> Mapping[str, Any]:
    """Friction that the gyroscopic moments need of the outer contacts, for a finding."""
    balls, distribution = solution.balls, solution.distribution
    loads = balls.load[..., OUTER].sum(1)
    if distribution is None or not loads.any():
        return {}
    loaded, diameter = loads > 0, solution.bearing.ball.diameter
    needed = np.abs(2 / diameter * distribution.gyroscopic[loaded]) / loads[loaded]
    limit = (balls.friction * balls.load)[loaded][..., OUTER].sum(1) / loads[loaded]
    worst = (needed / limit).argmax()
    return {"held_friction": needed[worst], "friction": limit[worst]}
