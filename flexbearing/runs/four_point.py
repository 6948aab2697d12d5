"""From a case to a slow ball bearing, and from its solution to the arrays of a result file."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

import quasidynamic as qd
from flexbearing.build.ball_parts import ball, groove
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.rings import bolted
from quasidynamic.solve.balls.elastic_load_distribution import ElasticBallLoads
from quasidynamic.solve.balls.load_distribution import BallLoads

FEWEST = 3  # balls of a ring; a single one has the same pitch circle
SIGN = np.array([1.0, -1.0])  # of the torques on inner and outer ring


@dataclass(frozen=True)
class Solution:
    """A solved case."""

    balls: qd.SlidingBalls
    distribution: BallLoads | None  # None when contact loads are given


def bearing(case: FourPointCase) -> qd.FourPointBallBearing:
    """The bearing of a case; raises `BadCase` when one of its rings cannot be."""
    parts, materials = case.bearing, case.materials
    for name in ("inner", "outer"):
        bolted.ring(case, name)
    return qd.FourPointBallBearing(
        bearing=qd.FourPointBearing(
            ball=ball(parts, materials.ball),
            inner=groove(parts, "inner", materials.inner_ring or materials.ball),
            outer=groove(parts, "outer", materials.outer_ring or materials.ball),
            balls=parts.balls or FEWEST,
            pitch_diameter=parts.pitch_diameter,
            contact_angle=parts.contact_angle,
            clearance=parts.clearance,
        ),
        friction=_friction(case),
        hysteresis_loss=case.friction.hysteresis_loss,
    )


def _friction(case: FourPointCase) -> qd.FrictionCurve:
    friction = case.friction
    if friction.coefficient is not None:
        return qd.constant_friction(friction.coefficient)
    assert friction.pressures is not None  # checked on reading
    assert friction.coefficients is not None
    return qd.FrictionCurve(pressures=friction.pressures, coefficients=friction.coefficients)


def solved(case: FourPointCase, compliance: NDArray | None = None) -> Solution:
    """Loads and motion of the balls between rigid rings, or between those of a compliance [m/N].

    Raises
    ------
    NotSolved, OutOfRange, ImpossiblePart
        see `qd.FourPointBallBearing.solve`
    """
    model = bearing(case)
    if case.operation.mode == "ring_load":
        load = case.operation.load
        equilibrium = model.solve(
            qd.RingLoad(
                axial=load.axial,
                radial_y=load.radial_y,
                radial_z=load.radial_z,
                moment_y=load.moment_y,
                moment_z=load.moment_z,
            ),
            compliance,
        )
        return Solution(equilibrium.balls, equilibrium.distribution)
    loads = np.array(case.operation.contact_loads)
    shape = (case.balls, len(loads), 2)
    angle = np.full(shape, case.bearing.contact_angle)
    return Solution(model.slide(angle, np.broadcast_to(loads[:, None], shape)), None)


def arrays(case: FourPointCase, solution: Solution) -> dict[str, ArrayLike]:
    """Datasets of the solution."""
    balls, speed = solution.balls, case.operation.speed
    count = len(balls.load)
    return (
        {
            "ball_azimuth": 2 * np.pi * np.arange(count) / count,
            "contact_load": balls.load,
            "contact_angle": balls.contacts.angle,
            "peak_pressure": balls.peak_pressure,
            "semi_axis_across": balls.ellipse.across,
            "semi_axis_along": balls.ellipse.along,
            "friction_coefficient": balls.friction,
            "ball_motion": -balls.sliding.motion * speed,  # a positive speed is right-handed about -x
            "ball_speed_ratio": balls.ball_speed,
            "ball_attitude": balls.axis_angle,
            "power_loss": balls.torque * speed,
            "ball_imbalance": balls.sliding.imbalance,
        }
        | _torques(case, balls)
        | _ring(case, solution.distribution)
        | _fields(case, balls)
    )


def _torques(case: FourPointCase, balls: qd.SlidingBalls) -> dict[str, ArrayLike]:
    parts = balls.torques
    sliding = parts.total if case.friction.torque == "exact" else parts.circumferential
    ball_torque = sliding + SIGN * balls.hysteresis[:, None]
    return {
        "spin_torque": parts.spin,
        "roll_torque": parts.roll,
        "circumferential_torque": parts.circumferential,
        "hysteresis_torque": balls.hysteresis,
        "ball_torque": ball_torque,
        "torque": ball_torque.sum(0),
    }


def _ring(case: FourPointCase, distribution: BallLoads | None) -> dict[str, ArrayLike]:
    if distribution is None:
        return {}
    arrays: dict[str, ArrayLike] = {
        "ring_load": case.operation.load.values,
        "ring_displacement": distribution.displacement,
        "stiffness_matrix": distribution.stiffness,
        "ring_imbalance": distribution.imbalance,
    }
    if isinstance(distribution, ElasticBallLoads):
        arrays["ring_yield"] = distribution.deflection
    return arrays


def _fields(case: FourPointCase, balls: qd.SlidingBalls) -> dict[str, ArrayLike]:
    """Slip and shear over every contact of the chosen balls."""
    chosen = case.fields.balls or (int(balls.load.sum((1, 2)).argmax()),)
    diagonals, points = balls.load.shape[1], case.fields.points
    names = {
        "field_across": "x",
        "field_along": "y",
        "slip_along": "slip_along",
        "slip_across": "slip_across",
        "shear_along": "shear_along",
        "shear_across": "shear_across",
    }
    fields = {name: np.zeros((len(chosen), diagonals, 2, points, points)) for name in names}
    for place in np.ndindex(len(chosen), diagonals, 2):
        contact = (chosen[place[0]], place[1], place[2])
        if balls.load[contact] > 0 and balls.sliding.driven[contact[0]]:
            field = balls.field(*contact, points)
            for name, value in names.items():
                scale = case.operation.speed if name.startswith("slip") else 1.0
                fields[name][place] = scale * field[value]
    return {"field_ball": chosen, **fields}


def notes(case: FourPointCase, solution: Solution) -> tuple[str, ...]:
    """What a user must know of the solution."""
    balls = solution.balls
    lines = balls.notes
    if solution.distribution is None:
        lines += ("contact loads are given: every ball carries them, at the contact angle without load",)
    lines += _on_shoulders(case, balls)
    idle = int((~balls.sliding.driven).sum())
    if idle:
        lines += (f"{idle} of {len(balls.load)} balls are not pressed on both rings: they make no torque",)
    if case.friction.torque == "circumferential":
        lines += (_apart(balls.torques.circumferential.sum(0), balls.torques.total.sum(0)),)
    return lines


def _on_shoulders(case: FourPointCase, balls: qd.SlidingBalls) -> tuple[str, ...]:
    """Contacts that reach over the arches of rings whose shoulders are known."""
    lines: tuple[str, ...] = ()
    for race, name in enumerate(("inner", "outer")):
        ring = getattr(case.rings, name)
        if ring.kind == "rigid":
            continue
        diameter = case.bearing.ball.diameter
        radius = getattr(case.bearing, name).over(diameter) * diameter
        over = int(balls.truncated(race, radius, ring.groove_end).sum())
        if over:
            lines += (
                f"{over} contacts of the {name} ring reach over its shoulders at "
                f"{np.degrees(ring.groove_end):.1f} deg; they are computed as if the arches went on",
            )
    return lines


def _apart(circumferential: NDArray, exact: NDArray) -> str:
    share = 100 * (circumferential / exact - 1)
    return (
        "torque: the circumferential formula leaves out the moment of lateral slip: "
        f"{share[0]:+.2f} % at the inner and {share[1]:+.2f} % at the outer ring against the exact one"
    )
