"""How the motion of balls that stick and slip on both races follows their contacts."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.free_ball import FreeBalls, gyroscopic
from quasidynamic.balance.balls.rolling_ball import RollingBall
from quasidynamic.contact.ellipse.rigid_slip import ACROSS
from quasidynamic.contact.rolling.fastsim import FASTSIM
from quasidynamic.contact.rolling.rolling_contact import Rolled
from quasidynamic.motion.ball_slip import INNER, OUTER
from quasidynamic.solve.balls.free_ball_search import FreeBallMotion

TOLERANCE = 1e-10  # of the largest friction: moments left
UNSOLVED = 1e-8  # of these: more is no balance
LIMIT = 40  # evaluations, rarely more than six
GAIN = 0.2  # of what was left: more left after a step requires new slopes
NEAR = 1e-6  # change of the logarithm of a load, of an angle [rad]: step of differences


class _State(NamedTuple):
    """N balls at one motion."""

    motion: NDArray  # (N, 4)
    rolled: Rolled
    by_slip: NDArray  # (N, 2, 5) [N, N m] power of friction on a unit of each slip of the contacts
    left: NDArray  # (N, 4) moments that are not balanced, by unknown
    size: NDArray  # (N) these over the largest friction


def sticking_ball_motion(
    balls: FreeBalls, contacts_at: Callable[[float, float], RollingBall], start: NDArray
) -> FreeBallMotion:
    r"""Balance of balls whose contacts stick and slip as by FASTSIM, with its slopes.

    .. math:: -\sum_{contacts} \int \frac{\partial s}{\partial u_k} \cdot p\, dA
              = J \omega_m (0, 0, \omega_t, -\omega_r)_k

    the equations of `FreeBalls`, its derivatives of the heat replaced by the power of the tractions, which
    are no derivatives of any function of the motion: a contact that spins pushes across.

    The balls are in full sliding: their inertia, unknowns that no rounding spoils, and the motion (N, 4) to
    start from. `contacts_at` gives their contacts, inner then outer of each ball, by the growth of the
    logarithm of all loads and by that of all contact angles [rad]. The motion is not a number where no
    balance is found.

    Source
    ------
    Newton's method, slopes from the derivative of the sweep of FASTSIM, kept while they serve; slopes by
    loads and angles by implicit differentiation.
    """
    contacts = contacts_at(0.0, 0.0)
    state, slopes = _balanced(balls, contacts, start)
    count, unknowns = len(start), balls.unknowns
    changed, across_by_contact = np.zeros((count, 4, 4)), np.zeros((count, 2, 4))
    moments = _by_motion(state.by_slip, contacts)
    for kind, growth in enumerate(((NEAR, 0.0), (0.0, NEAR))):
        other = contacts_at(*growth)
        by_slip = _at(balls, other, state.motion).by_slip
        for race in (INNER, OUTER):
            column = 2 * race + kind
            more = _by_motion(by_slip, other) - moments
            changed[:, :, column] = more[:, race] / NEAR
            across_by_contact[:, race, column] = (by_slip - state.by_slip)[:, race, ACROSS] / NEAR
    by_contact = np.linalg.solve(slopes.left, np.swapaxes(unknowns, -1, -2) @ changed)  # (N, 4, 4)
    solution = FreeBallMotion(
        motion=state.motion,
        motion_slopes=unknowns @ by_contact,
        across=state.by_slip[..., ACROSS],
        across_slopes=across_by_contact + slopes.across @ by_contact,
        power=-(state.by_slip * contacts.contact_slip(_each(state.motion)).reshape(count, 2, 5)).sum(-1),
        cage=np.zeros(count),
        unknowns=np.zeros((count, 4)),
    )
    for array in solution:
        array[~(state.size <= UNSOLVED)] = np.nan
    return solution


class _Slopes(NamedTuple):
    """Derivatives by the unknowns."""

    left: NDArray  # (N, 4, 4) of the moments that are not balanced
    across: NDArray  # (N, 2, 4) [N] of the friction across


def _balanced(balls: FreeBalls, contacts: RollingBall, start: NDArray) -> tuple[_State, _Slopes]:
    """Balls in balance, or where the search has ended, and the slopes there."""
    state = _at(balls, contacts, start)
    slopes, part = _slopes(balls, contacts, state), np.ones(len(start))
    for _ in range(LIMIT):
        running = state.size > TOLERANCE
        if not running.any():
            break
        step = -np.linalg.solve(slopes.left, state.left[..., None])
        step[~running] = 0.0
        trial = _at(balls, contacts, state.motion + part[:, None] * (balls.unknowns @ step)[..., 0])
        better, slow = trial.size < state.size, trial.size > GAIN * state.size
        if not (better | ~running).all():
            motion = np.where(better[:, None], trial.motion, state.motion)
            trial = _at(balls, contacts, motion)
        part, state = np.where(better | ~running, 1.0, part / 2), trial
        if (slow & running).any():
            slopes = _slopes(balls, contacts, state)
    return state, _slopes(balls, contacts, state)


def _at(balls: FreeBalls, contacts: RollingBall, motion: NDArray) -> _State:
    """Balls at motions (N, 4); a contact through which material does not flow one way has no friction."""
    each = _each(motion)
    speed = contacts.material_speed(each)
    flows = np.all(speed * speed[:, :1] > 0.0, axis=1)
    rolled = FASTSIM.friction(contacts.contacts, contacts.creep(each))
    by_slip = np.where(flows[:, None], contacts.power_by_slip(each, rolled).sum(0), np.nan)
    by_slip = by_slip.reshape(len(motion), 2, 5)
    heat = -_by_motion(by_slip, contacts).sum(1)
    moments, _ = gyroscopic(motion, balls.gyration, balls.outer_speed)
    left = ((heat - moments)[:, None] @ balls.unknowns)[:, 0]
    size = (np.abs(left) / balls.scale).max(1)
    return _State(motion, rolled, by_slip, left, np.where(np.isfinite(size), size, np.inf))


def _slopes(balls: FreeBalls, contacts: RollingBall, state: _State) -> _Slopes:
    """Slopes, speed of the material and flexibility as they are."""
    count, each = len(state.motion), _each(state.motion)
    changes = FASTSIM.changes(state.rolled, contacts.creep_changes(each))
    by_slip = contacts.powers(changes, each)  # (2N, 4, 5)
    friction = np.einsum("cki,cij->cjk", by_slip, contacts.by_motion).reshape(count, 2, 4, 4).sum(1)
    _, turned = gyroscopic(state.motion, balls.gyration, balls.outer_speed)
    back = np.swapaxes(balls.unknowns, -1, -2)
    return _Slopes(
        left=-back @ (friction + turned @ balls.unknowns),
        across=by_slip[..., ACROSS].reshape(count, 2, 4),
    )


def _by_motion(by_slip: NDArray, contacts: RollingBall) -> NDArray:
    """Power of friction on a unit of each component of the motion, by contact (N, 2, 4)."""
    by_motion = contacts.by_motion.reshape(*by_slip.shape, 4)
    return np.einsum("nci,ncij->ncj", by_slip, by_motion)


def _each(motion: NDArray) -> NDArray:
    """Motion of the ball of each contact (2N, 4)."""
    return np.repeat(motion, 2, axis=0)
