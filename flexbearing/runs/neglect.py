"""What the model of a kind of bearing neglects, over its largest load: values for findings."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from quasidynamic.outcome.neglected import friction_share, inertia_shares, tilting_share, weight_share

if TYPE_CHECKING:
    from flexbearing.runs.solved_rows import SolvedRows

INERTIA, MOMENT, WEIGHT, FRICTION = "inertia", "gyroscopic moment", "weight", "friction"
OF_BALLS, OF_ROLLERS = " of the balls", " of the rollers"


def of_fast_balls(solution: Any) -> Mapping[str, Any]:
    """Weight, and friction where a race controls the balls; centrifugal forces and moments are computed."""
    state, case = solution.state, solution.case
    bearing, total = state.bearing, state.loads.sum()
    if not total:
        return {}
    found = {WEIGHT + OF_BALLS: weight_share(bearing.ball.mass, state.loads.max())}
    torque = solution.friction.friction_torque
    if case.operation.control == "coulomb" or torque is None:
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


def of_rollers(rows: "SolvedRows") -> Mapping[str, Any]:
    """Gyroscopic moments of tilted rollers; centrifugal forces, weight and friction are computed."""
    return {"neglected": {MOMENT + OF_ROLLERS: _moments(rows)}}


def _moments(rows: "SolvedRows") -> NDArray:
    states, rollers = rows.states, [model.bearing.roller for model in rows.models]
    inertia = np.array([each.mass * each.diameter**2 / 8 for each in rollers])
    length = np.array([each.length for each in rollers])
    loads = states.loads[:, 0]
    speed, tilt = (
        np.abs(each).max(axis=1, where=loads > 0, initial=0.0)
        for each in (states.roller_speed, states.roller_tilt)
    )
    load = np.where(loads.max(axis=1) > 0, loads.max(axis=1), np.inf)
    return tilting_share(inertia, length, states.cage_speed, speed, tilt, load)
