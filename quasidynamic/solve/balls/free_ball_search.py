"""Newton's method for the motion of balls that friction and inertia alone move."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.free_ball import FreeBallBalance, FreeBalls, gyroscopic, sliding_of
from quasidynamic.contact.ellipse.general_sliding import (
    COARSE,
    FINE,
    EllipsePoints,
    GeneralSliding,
    sliding_ellipse,
)
from quasidynamic.contact.ellipse.rigid_slip import ACROSS, CENTRE, PIVOT, ROLL, SPIN
from quasidynamic.motion.ball_slip import INNER, ORBIT, OUTER, TURN, BallContacts, turning_slip_by_motion
from quasidynamic.solve.step_length import shortened

LOAD, ANGLE = 0, 1  # what a contact is given by
ONE_STEP_AWAY = 1e-7  # of the largest friction: moments left from which one more Newton step ends in rounding
COARSE_TOLERANCE = 1e-4  # the same for the search with few points
LIMIT = 60  # evaluations in one search, rarely more than six
FIRST_PART, LEAST_PART = 1e-2, 1e-4  # of the moments, see `FreeBalls.balance`: first and least step of a path
GROWTH = 10.0  # of a step, once one has succeeded
CAUTION = np.array([0.0, 0.0, 1e-3, 1e-2, 0.1, 1.0, 10.0])  # share of the majorant in one try after the other
GAIN = 0.5  # of the work on a step or of the size of what is left: enough gained by a step
NEUTRAL = 0.347**2  # of the fall of the surface to the edge of a contact: lines of rolling without spin
SHARES = (0.01, 0.9)  # of the friction, across
NO_SPIN = 1e-6  # spin by the third unknown below which a race does not see it
LONGEST = 2.0  # of the speeds of the rolling ball: step
NEAR = 1e-5  # change of the logarithm of a load, of an angle [rad]: step of differences in oil

Nearby = Callable[[float, float], FreeBalls]  # balls by the growth of the logarithm of loads, of angles [rad]
LastStep = Callable[[FreeBalls, FreeBallBalance, NDArray], NDArray]  # (N, 4) from a balance at unknowns


class FreeBallMotion(NamedTuple):
    """N balls in balance; slopes by ln N_i, alpha_i, ln N_o and alpha_o. Not a number where none is found."""

    motion: NDArray  # (N, 4) over the speed of the inner against the outer ring
    motion_slopes: NDArray  # (N, 4, 4)
    across: NDArray  # (N, 2) [N] friction on the ball along the groove sections
    across_slopes: NDArray  # (N, 2, 4)
    power: NDArray  # (N, 2) [N m] heat over the speed of the inner against the outer ring
    cage: NDArray  # (N) speed of the cage over the same, from the base of `Pockets`; zero without one
    unknowns: NDArray  # (N, 4) of `FreeBalls`


class _Contact(NamedTuple):
    """What changes at one contact with its load or angle, the motion given: (N, 2, ...) load, then angle."""

    left: NDArray  # (N, 2, 4) by motion
    across: NDArray  # (N, 2) [N] derivative of the heat by the slip across


def free_ball_motion(balls: FreeBalls, nearby: Nearby | None = None, *starts: NDArray) -> FreeBallMotion:
    """Balance of balls with its slopes, by implicit differentiation; of balls in oil with those `nearby`.

    Of several motions that are balanced, as of a traction that falls with the slip, the one by Newton's
    method from unknowns of one of the `starts` (N, 4) after the other, where it finds one.
    """
    unknowns, lost = np.zeros((len(balls.rolling), 4)), np.full(len(balls.rolling), True)
    for start in starts:
        unknowns[lost], left = searched(balls.taken(lost), start[lost], 1.0, (FINE, ONE_STEP_AWAY))
        lost[lost] = ~(left <= ONE_STEP_AWAY)
        if not lost.any():
            break
    else:
        unknowns[lost] = nearly_balanced(balls.taken(lost))
    solution, left, unknowns = motion_at(balls, unknowns, nearby)
    for search in (None, None, searched_again):
        lost = ~(left <= ONE_STEP_AWAY)
        if not lost.any():
            break
        some, start = balls.taken(lost), unknowns[lost]
        near = nearby and (lambda *growth, keep=lost: nearby(*growth).taken(keep))
        again, left[lost], unknowns[lost] = motion_at(some, search(some, start) if search else start, near)
        for array, new in zip(solution, again, strict=True):
            array[lost] = new
    for array in solution:
        array[~(left <= ONE_STEP_AWAY)] = np.nan
    return solution


def motion_at(
    balls: FreeBalls, unknowns: NDArray, nearby: Nearby | None, further: LastStep | None = None
) -> tuple[FreeBallMotion, NDArray, NDArray]:
    """Balls after a last Newton step from unknowns (N, 4), what was left before it, and its end.

    The step is that of each ball for itself, or a `further` one, which slopes need not be exact with.
    """
    friction = balls.friction(unknowns)
    near_balance = balls.balance(unknowns, friction)
    motion, sliding = balls.motion(unknowns), sliding_of(friction)
    if nearby is None:
        by_contact = [_given(balls, race, motion, sliding) for race in (INNER, OUTER)]
    else:
        by_contact = _by_differences(nearby, motion, FINE if further is None else COARSE)
    changed = np.concatenate([change.left for change in by_contact], axis=1) @ balls.unknowns  # (N, 4, 4)
    moments = np.concatenate([np.swapaxes(changed, -1, -2), near_balance.left[..., None]], axis=-1)
    slopes, last = np.split(-near_balance.resolved(moments), [4], axis=-1)  # by contact, Newton step
    if further is not None:
        last = further(balls, near_balance, unknowns)[..., None]
    by_unknown = balls.force_slopes(friction)[:, :, [ACROSS]]  # (N, 2, 1, 4)
    across = -(by_unknown @ slopes[:, None])[:, :, 0]
    for race, change in enumerate(by_contact):
        across[:, race, 2 * race : 2 * race + 2] -= change.across
    solution = FreeBallMotion(
        motion=motion + (balls.unknowns @ last)[..., 0],
        motion_slopes=balls.unknowns @ slopes,
        across=-sliding.by_slip[..., ACROSS] - (by_unknown @ last[:, None])[..., 0, 0],
        across_slopes=across,
        power=sliding.power,
        cage=np.zeros(len(motion)),
        unknowns=unknowns + last[..., 0],
    )
    return solution, (np.abs(near_balance.left) / balls.scale).max(1), unknowns + last[..., 0]


def _by_differences(nearby: Nearby, motion: NDArray, points: EllipsePoints) -> list[_Contact]:
    """What changes at both contacts, the motion (N, 4) given."""
    left, across = [], []
    for kind in np.eye(2) * NEAR:
        more, less = (nearby(*way).powers(motion, points) for way in (kind, -kind))
        left.append((more.by_motion - less.by_motion) / (2 * NEAR))
        across.append((less.across - more.across) / (2 * NEAR))
    return [_Contact(np.stack(left, 2)[:, race], np.stack(across, 2)[:, race]) for race in (INNER, OUTER)]


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
    return _Contact(left, force[..., ACROSS])


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


def nearly_balanced(balls: FreeBalls) -> NDArray:
    """Unknowns (N, 4) of balls that most often leave less than `ONE_STEP_AWAY` of the largest friction.

    From whichever control makes the least heat, with few points in the contacts; then one step with all, and
    in oil, whose friction is less than what it is measured with, another one.
    """
    unknowns, _ = searched(balls, least_heat(balls), 1.0, (COARSE, COARSE_TOLERANCE))
    for _ in range(1 if balls.oil is None else 2):
        near_balance = balls.balance(unknowns, balls.friction(unknowns))
        unknowns = unknowns - near_balance.resolved(near_balance.left[..., None])[..., 0]
    return unknowns


def searched_again(
    balls: FreeBalls, start: NDArray, resolution: tuple[EllipsePoints, float] = (FINE, ONE_STEP_AWAY)
) -> NDArray:
    """Unknowns (N, 4) from a start, with all points; of balls that find no balance from other ones.

    These follow the moments from none to all; then they begin at each of the starts, as traction that falls
    with the slip lets a Newton step lead away from the balance.
    """
    unknowns, left = searched(balls, start, 1.0, resolution)
    lost = ~(left <= resolution[1])
    if lost.any():
        unknowns[lost], left[lost] = _along_moments(balls.taken(lost), resolution)
    for begin in _starts(balls):
        lost = ~(left <= resolution[1])
        if not lost.any():
            break
        unknowns[lost], left[lost] = searched(balls.taken(lost), begin[lost], 1.0, resolution)
    return unknowns


def _along_moments(balls: FreeBalls, resolution: tuple[EllipsePoints, float]) -> tuple[NDArray, NDArray]:
    """Unknowns (N, 4) at the end of a path to all moments, see `FreeBalls.balance`, and what is left (N).

    It begins at the minimum of a convex function: heat, with work of the pocket films; each ball has steps of
    its own.
    """
    path, left = searched(balls, least_heat(balls), 0.0, resolution)
    part, step = np.zeros(len(path)), np.where(left <= resolution[1], FIRST_PART, 0.0)
    left = np.full(len(path), np.inf)
    while (going := np.flatnonzero((part < 1.0) & (step >= LEAST_PART))).size:
        further = np.minimum(part[going] + step[going], 1.0)
        trial, size = searched(balls.taken(going), path[going], further, resolution)
        found = size <= resolution[1]
        path[going[found]], part[going[found]] = trial[found], further[found]
        step[going] *= np.where(found, GROWTH, 0.25)
        left[going[further == 1.0]] = size[further == 1.0]
    return path, left


def least_heat(balls: FreeBalls) -> NDArray:
    """Unknowns (N, 4) of the start with the least heat."""
    starts = _starts(balls)
    slips = np.array([balls.slip(start) for start in starts])
    heat = sliding_ellipse(slips, balls.ellipse, COARSE).power.sum(-1)
    return starts[heat.argmin(0), np.arange(starts.shape[1])]


def _starts(balls: FreeBalls) -> NDArray:
    """Unknowns (3, N, 4) near rolling without spin on the inner race, on the outer one, with equal ones.

    In both contacts the ball rolls on two lines; across it slips as friction would hold its gyroscopic
    moment were the slip along even: nowhere does the slip vanish all over a contact.
    """
    ellipse, spin, by_unknown = balls.ellipse, balls.base[..., SPIN], balls.by_unknown[..., SPIN, 2]
    by_unknown = np.where(np.abs(by_unknown) > NO_SPIN, by_unknown, np.inf)
    starts = np.zeros((3, len(spin), 4))
    starts[:2, :, 2] = -(spin / by_unknown).T
    starts[2, :, 2] = starts[:2, :, 2].mean(0)
    fall = balls.base[..., ROLL] * ellipse.across**2 / (2 * ellipse.radius)
    starts[..., :2] = NEUTRAL * fall
    for start in starts:
        moment = gyroscopic(balls.motion(start), balls.gyration, balls.outer_speed)[0][:, TURN]
        needed = moment / (balls.contacts.ball_radius * ellipse.traction.sum(1))
        share = np.clip(np.abs(needed), *SHARES)
        along = np.abs(fall) + np.abs(balls.slip(start)[..., SPIN]) * ellipse.across
        start[:, 3] = np.sign(needed) * share / np.sqrt(1 - share**2) * along.min(1) / 2
    return starts


def searched(
    balls: FreeBalls, start: NDArray, part: NDArray | float, resolution: tuple[EllipsePoints, float]
) -> tuple[NDArray, NDArray]:
    """Unknowns (N, 4) and what is left (N) with a part (N) of the moments, see `FreeBalls.balance`.

    Newton steps, shortened where they go too far; where that does not help, steps that a share of the
    majorant of the heat holds back.
    """
    points, tolerance = resolution

    def at(some: FreeBalls, unknowns: NDArray, part: NDArray) -> tuple[FreeBallBalance, NDArray]:
        moments = some.balance(unknowns, some.friction(unknowns, points), part)
        return moments, np.abs(moments.left) / some.scale

    solution, left, running = start.copy(), np.full(len(start), np.inf), np.arange(len(start))
    tries, shorter, evaluations = np.zeros(len(start), int), np.ones(len(start)), 1
    part = np.broadcast_to(part, len(start))
    state, size = at(balls, start, part)
    while True:
        left[running] = size.max(1)
        going = (left[running] > tolerance) & (tries < len(CAUTION))
        if not going.any() or evaluations >= LIMIT:
            return solution, left
        if not going.all():
            running, balls, state, size = running[going], balls.taken(going), state.taken(going), size[going]
            tries, shorter, part = tries[going], shorter[going], part[going]
        step = shorter[:, None] * _step(balls, state, CAUTION[tries])
        trial = solution[running] + step
        (trial_state, trial_size), evaluations = at(balls, trial, part), evaluations + 1
        ahead, past = (state.left * step).sum(1), (trial_state.left * step).sum(1)
        most, before = trial_size.max(1), size.max(1)
        closer = (
            (ahead < 0)
            & (past <= -GAIN * ahead)
            & (most > ONE_STEP_AWAY)
            & (most <= 2 * np.maximum(before, 1.0))
        )
        better = closer | (most < GAIN * before)
        solution[running[better]] = trial[better]
        state, size = trial_state.or_else(state, better), np.where(better[:, None], trial_size, size)
        tries = np.where(better, np.maximum(tries - 2, 0), tries + 1)
        shorter = np.where(better | (tries != 1), 1.0, shortened(ahead, past))


def _step(balls: FreeBalls, state: FreeBallBalance, caution: NDArray) -> NDArray:
    """Newton step (n, 4), held back by a share of the majorant."""
    step = -state.resolved(state.left[..., None], caution)[..., 0]
    speed = np.linalg.norm(balls.rolling, axis=1)
    long = np.linalg.norm((balls.unknowns @ step[..., None])[..., 0], axis=1) / (LONGEST * speed)
    return step / np.maximum(long, 1.0)[:, None]
