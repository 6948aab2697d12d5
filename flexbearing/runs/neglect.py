"""What models of ball bearings neglect, over their largest load: values for findings."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from quasidynamic.outcome.neglected import friction_share, inertia_shares, weight_share

INERTIA, MOMENT, WEIGHT, FRICTION = "inertia", "gyroscopic moment", "weight", "friction"
OF_BALLS = " of the balls"


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
    """Inertia, gyroscopic moment, weight and friction: loads are those of a bearing that stands."""
    balls, bearing, speed = solution.balls, solution.bearing, solution.case.operation.speed
    ball, driven = bearing.ball, balls.sliding.driven
    loads = balls.load.sum(axis=(1, 2))
    if not driven.any():
        return {}
    largest, motion = balls.load.max(), np.abs(balls.sliding.motion[driven]).max(axis=0) * speed
    inertia, moment = inertia_shares(
        ball.mass, ball.diameter, bearing.pitch_diameter, motion[0], motion[2], largest
    )
    return {"neglected": {
        INERTIA + OF_BALLS: inertia, MOMENT + OF_BALLS: moment,
        WEIGHT + OF_BALLS: weight_share(ball.mass, largest),
        FRICTION: friction_share(balls.torque, bearing.pitch_diameter, loads.sum() / 2),
    }}  # fmt: skip
