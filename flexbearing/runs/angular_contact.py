"""From a case to a fast angular-contact bearing, and from its solution to the arrays of a result file."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import quasidynamic as qd
from flexbearing.build.ball_parts import ball, groove
from flexbearing.case.balls.angular_contact import AngularCase
from flexbearing.program.workers import shared_map
from flexbearing.quantities.angular_contact import LAYOUT
from flexbearing.quantities.quantity import taken
from flexbearing.runs import dangers, interface, shoulders
from quasidynamic.note import Note, information, outside
from quasidynamic.outcome.rolling_contact import RollingContact


@dataclass(frozen=True)
class Solution:
    """A solved case."""

    state: qd.AngularContactState
    contact: RollingContact
    rolling: qd.FastRollingBalls | None  # balls whose contacts stick and slip; None in full sliding

    @property
    def friction(self) -> qd.AngularContactState | qd.FastRollingBalls:
        """What tells heat and torque of friction."""
        return self.state if self.rolling is None else self.rolling


def bearing(case: AngularCase) -> qd.AngularContactBallBearing:
    """The bearing of a case."""
    parts, materials = case.bearing, case.materials
    return qd.AngularContactBallBearing(
        bearing=qd.AngularContactBearing(
            ball=ball(parts, materials.ball),
            inner=groove(parts, "inner", materials.inner_ring or materials.ball),
            outer=groove(parts, "outer", materials.outer_ring or materials.ball),
            balls=parts.balls,
            pitch_diameter=parts.pitch_diameter,
            contact_angle=parts.contact_angle,
            first_ball_azimuth=parts.first_ball_azimuth,
        ),
        control=case.operation.control,
        friction=case.friction.coefficient,
        spin=case.friction.spin,
        sticking=_sticking(case),
        interface_compliance=case.friction.interface_compliance or 0.0,
    )


def _sticking(case: AngularCase) -> tuple[int, int] | None:
    """Cells of FASTSIM in the balance: half of those of the contacts, as it asks for them again and again."""
    if case.operation.control != "coulomb" or case.friction.model == "full_sliding":
        return None
    along, across = case.friction.cells
    return along // 2, across // 2


def operation(case: AngularCase) -> qd.RingOperation:
    """Load, displacement and speeds of a case."""
    return qd.RingOperation(
        load=case.operation.load.values,
        displacement=case.operation.displacement.values,
        inner_speed=case.operation.inner_speed,
        outer_speed=case.operation.outer_speed,
    )


def build(case: AngularCase) -> tuple[qd.AngularContactBallBearing, qd.RingOperation]:
    """Bearing and operation of a case; raises `ImpossiblePart` or `OutOfRange` where they cannot be."""
    return bearing(case), operation(case)


def solved(case: AngularCase, told: Callable[[float], None] = lambda _: None) -> Solution:
    """Balance, pure rolling lines, and stick and slip where the case asks for them.

    The part of the balls whose stick and slip is found is `told`.

    Raises
    ------
    NotSolved, OutOfRange, ImpossiblePart
        see `qd.AngularContactBallBearing.solve` and `qd.AngularContactBallBearing.roll`
    """
    model, lines = bearing(case), case.rolling_lines
    state, rolling = model.solve(operation(case)), None
    if case.friction.model != "full_sliding":
        along, across = case.friction.cells
        with shared_map() as mapped:
            rolling = model.roll(state, case.friction.model, (along, across), told, mapped)
    return Solution(state, state.rolling_contact(spin=lines.spin, friction=lines.net_force), rolling)


def block(case: AngularCase, solution: Solution) -> dict[str, NDArray]:
    """Quantities of the solution."""
    state, contact = solution.state, solution.contact
    lines = _lines(case, state, contact) if len(contact.balls) else None
    free = {"yaw": state.yaw} if case.operation.control == "coulomb" else None
    parts = {
        "state": state,
        "friction": solution.friction,
        "rolling": solution.rolling,
        "fields": _fields(solution),
        "lines": lines,
        "free": free,
    }
    return taken(LAYOUT.quantities, parts)


def _fields(solution: Solution) -> dict[str, NDArray] | None:
    """Cells of both contacts of the ball that carries most; None in full sliding, or where none rolls."""
    rolling = solution.rolling
    if rolling is None or all(ball is None for ball in rolling.rolled):
        return None
    ball = int(np.where(solution.state.on_inner, solution.state.loads.sum(0), 0.0).argmax())
    fields = [rolling.field(ball, race) for race in range(2)]
    return {"ball": np.array(ball)} | {name: np.stack([each[name] for each in fields]) for name in fields[0]}


def _lines(case: AngularCase, state: qd.AngularContactState, contact: RollingContact) -> dict[str, NDArray]:
    """Pure rolling lines; not a number for balls without any."""

    def spread(values: NDArray) -> NDArray:
        whole = np.full((2, state.loads.shape[1], *values.shape[2:]), np.nan)
        whole[:, contact.balls] = values
        return whole

    position = np.linspace(-1.0, 1.0, case.rolling_lines.points)
    integral = contact.spin_torques(case.friction.coefficient)
    by_lines = contact.spin_torques(case.friction.coefficient, "lines")
    weight = np.sin(state.contact_angles[:, contact.balls])
    return {
        "line_parameter": spread(contact.parameter),
        "net_friction": spread(contact.net_force),
        "first_line": spread(contact.lines.first),
        "second_line": spread(contact.lines.second),
        "line_count": spread(contact.lines.count),
        "spin_torque": spread(integral),
        "spin_torque_by_lines": spread(by_lines),
        "spin_friction": (weight * integral).sum(),
        "spin_friction_by_lines": (weight * by_lines).sum(),
        "slip_position": position,
        "slip_profile": spread(contact.slip_velocity(position)),
    }


def notes(case: AngularCase, solution: Solution) -> tuple[Note, ...]:
    """What a user must know of the solution."""
    state = solution.state
    lines = tuple(dangers.pressed(float(state.peak_pressures.max())))
    lifted = int((~state.on_inner).sum())
    if lifted:
        lines += (
            information("idle-balls", f"{lifted} of {len(state.on_inner)} balls do not touch the inner race"),
        )
    for name, heights, angles in zip(
        ("inner", "outer"), state.needed_shoulders, state.contact_angles, strict=True
    ):
        shoulder = getattr(case.bearing, name).shoulder
        lines += shoulders.reached_over(name, heights, angles, case.bearing.ball.diameter, shoulder)
    unguided = int((state.on_inner & ~state.guided).sum())
    if unguided:
        far = "" if case.operation.control == "coulomb" else " or too far round"
        lines += (
            outside(
                "unguided-balls",
                f"{unguided} balls touch the inner race too lightly{far} for both races to guide them: "
                "their orbit, spin and tractions are estimates",
            ),
        )
    return lines + _lineless(solution) + _gyroscopic(case, state) + _stick(case, solution)


def _stick(case: AngularCase, solution: Solution) -> tuple[Note, ...]:
    """What stick makes of the friction torque, how exact it is, and what it leaves unbalanced."""
    rolling, torque, state = solution.rolling, solution.state.friction_torque, solution.state
    if rolling is None or not torque:
        return ()
    along, across = case.friction.cells
    balance = f"FASTSIM on {along // 2} by {across // 2} cells" if state.sticking else "full sliding"
    return (
        information(
            "stick-and-slip",
            f"friction torque: {case.friction.model} on {along} by {across} cells a contact, within "
            f"{rolling.grid_error.sum():.2g} N m of finer ones; "
            f"{100 * (rolling.friction_torque / torque - 1):+.1f} % against {balance} with the same "
            f'friction.spin = "{case.friction.spin}", of {torque:.5g} N m',
        ),
        information(
            "kept-motion",
            f"friction torque: loads and motion of the balls are those of {balance}; what "
            f"{case.friction.model} changes in the friction is not balanced, on a ball a moment of up to "
            f"{rolling.unbalanced_moment.max():.1%}, a force along the orbit of up to "
            f"{np.abs(rolling.unbalanced_force).max():.1%} and one in its section plane of up to "
            f"{rolling.unbalanced_section_force.max():.1%} of the most that friction can hold",
        ),
        *interface.compliant(case.friction.interface_compliance),
    )


def _lineless(solution: Solution) -> tuple[Note, ...]:
    """Balls that touch both races and have no pure rolling lines, and why."""
    contact, count = solution.contact, solution.state.loads.shape[1]
    if not (solution.state.loads > 0).all(0).any():
        return (information("no-rolling-lines", "no pure rolling lines: no ball touches both races"),)
    reasons = {
        "a contact is as wide as the surface it presses, nor is there a friction torque: the load is far too "
        "high": len(contact.wide),
        'their friction moments about the spin axis do not balance (rolling_lines.net_force = "balanced"), '
        "they slide on one race": len(contact.sliding),
    }
    return tuple(
        information("no-rolling-lines", f"no pure rolling lines of {balls} of {count} balls: {reason}")
        for reason, balls in reasons.items()
        if balls
    )


def _gyroscopic(case: AngularCase, state: qd.AngularContactState) -> tuple[Note, ...]:
    """Whether friction holds the gyroscopic moments."""
    if case.operation.control == "coulomb":
        lying = state.on_inner & ~state.upright
        if not lying.any():
            return ()
        return (
            information(
                "gyroscopic-moment",
                f"gyroscopic moment: friction does not hold the axes of {int(lying.sum())} balls, which turn "
                f"towards the shaft, down to {np.degrees(np.abs(state.attitude[lying]).min()):.1f} deg",
            ),
        )
    needed, coefficient = state.needed_friction.max(), case.friction.coefficient
    if needed <= coefficient:
        return ()
    return (
        outside(
            "gyroscopic-moment",
            f"gyroscopic moment: held by friction with a coefficient of up to {needed:.3g}, more than "
            f"friction.coefficient = {coefficient:g}: in reality balls would turn about the rolling "
            "direction",
        ),
    )
