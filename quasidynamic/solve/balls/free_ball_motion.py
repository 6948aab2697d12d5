"""How the motion of balls that friction moves follows their contacts."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.free_ball import FreeBalls
from quasidynamic.contact.ellipse.general_sliding import GeneralSliding
from quasidynamic.contact.ellipse.rigid_slip import ACROSS, CENTRE, PIVOT, ROLL
from quasidynamic.motion.ball_slip import INNER, ORBIT, OUTER, TURN, BallContacts, turning_slip_by_motion
from quasidynamic.solve.balls.free_ball_search import ONE_STEP_AWAY, nearly_balanced, searched_again

LOAD, ANGLE = 0, 1  # what a contact is given by


class FreeBallMotion(NamedTuple):
    """N balls in balance; slopes by ln N_i, alpha_i, ln N_o and alpha_o. Not a number where none is found."""

    motion: NDArray  # (N, 4) over the speed of the inner against the outer ring
    motion_slopes: NDArray  # (N, 4, 4)
    across: NDArray  # (N, 2) [N] friction on the ball along the groove sections
    across_slopes: NDArray  # (N, 2, 4)
    power: NDArray  # (N, 2) [N m] heat over the speed of the inner against the outer ring


class _Contact(NamedTuple):
    """What changes at one contact with its load or angle, the motion given: (N, 2, ...) load, then angle."""

    left: NDArray  # (N, 2, 4) by motion
    force: NDArray  # (N, 2, 5) derivative of the heat by the slip


def free_ball_motion(balls: FreeBalls) -> FreeBallMotion:
    """Balance of balls with its slopes, by implicit differentiation."""
    unknowns = nearly_balanced(balls)
    solution, left, unknowns = _motion_at(balls, unknowns)
    for search in (None, None, searched_again):
        lost = ~(left <= ONE_STEP_AWAY)
        if not lost.any():
            break
        some, start = balls.taken(lost), unknowns[lost]
        again, left[lost], unknowns[lost] = _motion_at(some, search(some, start) if search else start)
        for array, new in zip(solution, again, strict=True):
            array[lost] = new
    for array in solution:
        array[~(left <= ONE_STEP_AWAY)] = np.nan
    return solution


def _motion_at(balls: FreeBalls, unknowns: NDArray) -> tuple[FreeBallMotion, NDArray, NDArray]:
    """Balls after a last Newton step from unknowns (N, 4), what was left before it, and its end."""
    friction = balls.friction(unknowns)
    near_balance = balls.balance(unknowns, friction)
    motion = balls.motion(unknowns)
    by_contact = [_given(balls, race, motion, friction) for race in (INNER, OUTER)]
    changed = np.concatenate([change.left for change in by_contact], axis=1) @ balls.unknowns  # (N, 4, 4)
    moments = np.concatenate([np.swapaxes(changed, -1, -2), near_balance.left[..., None]], axis=-1)
    slopes, last = np.split(-near_balance.resolved(moments), [4], axis=-1)  # by contact, Newton step
    by_unknown = friction.curvature[:, :, [ACROSS]] @ balls.by_unknown  # (N, 2, 1, 4)
    across = -(by_unknown @ slopes[:, None])[:, :, 0]
    for race, change in enumerate(by_contact):
        across[:, race, 2 * race : 2 * race + 2] -= change.force[..., ACROSS]
    solution = FreeBallMotion(
        motion=motion + (balls.unknowns @ last)[..., 0],
        motion_slopes=balls.unknowns @ slopes,
        across=-friction.by_slip[..., ACROSS] - (by_unknown @ last[:, None])[..., 0, 0],
        across_slopes=across,
        power=friction.power,
    )
    return solution, (np.abs(near_balance.left) / balls.scale).max(1), unknowns + last[..., 0]


def _given(balls: FreeBalls, race: int, motion: NDArray, friction: GeneralSliding) -> _Contact:
    """What changes at the contacts with one race, the motion (N, 4) given."""
    seen = motion.copy()
    if race == INNER:
        seen[:, ORBIT] += 1.0
    by_slip, curvature = friction.by_slip[:, race], friction.curvature[:, race]
    higher, turned = _higher(balls, race), _turned(balls.contacts)[:, race]
    by_contact = np.stack([higher, turned], axis=1)  # (N, 2, 5, 4) slip by motion
    slip = (by_contact @ seen[:, None, :, None])[..., 0]
    force = slip @ curvature
    force[:, LOAD] += friction.by_load[:, race]
    left = force @ balls.by_motion[:, race] + np.einsum("nksj,ns->nkj", by_contact, by_slip)
    return _Contact(left, force)


def _higher(balls: FreeBalls, race: int) -> NDArray:
    """Slip (N, 5, 4) by motion that the height of the contact makes, by the logarithm of the load."""
    ellipse, ball = balls.ellipse, balls.contacts.ball_radius
    across, radius = ellipse.across[:, race], ellipse.radius[:, race]
    grown = across**2 / 3 * (1 / np.sqrt(radius**2 - across**2) - 1 / np.sqrt(ball**2 - across**2))
    slip = np.zeros_like(balls.by_motion[:, race])
    slip[:, CENTRE], slip[:, ACROSS] = balls.by_motion[:, race, ROLL], balls.by_motion[:, race, PIVOT]
    return grown[:, None, None] * slip


def _turned(contacts: BallContacts) -> NDArray:
    """Slip (N, 2, 5, 4) by motion, by the contact angle: that of normals a right angle further."""
    further = BallContacts(
        contacts.ball_radius, 0.0 * contacts.pitch_radius, contacts.angle + np.pi / 2, contacts.height
    )
    slip = turning_slip_by_motion(further)[:, 0]
    slip[..., TURN] = 0.0
    return slip
