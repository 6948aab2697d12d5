"""Newton's method for balls that find their own balance, the ring held."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.angular_contact import AngularBalance, BallBalance
from quasidynamic.balance.balls.ball_position import Vectors

TOLERANCE = 1e-12  # of the largest force: unbalanced force on a ball
ROUNDING = 16 * float(np.finfo(float).eps)  # of lengths: a force below stiffness times this is noise
LIMIT = 40  # evaluations of the balls at one place of the ring, rarely more than four ...
DEAR = 100  # ... and fewer of those that cost more than this many closed forms
STABLE = 0.1  # of the stiffness of a ball hanging in the outer groove: least one in a step
FLOATING = 1e-15  # of its stiffness, given to every ball
LEAST_STIFFNESS = 1e-9  # [N/m] the same where nothing touches: a long step, not an infinite one
NEAR_BOTTOM = 0.02  # of the reach: from the bottom of the groove, within which a free ball stays where it was
LONGEST = 0.3  # of the smaller reach: step of a ball
AGAIN = 4  # searches that follow one without a balance, later ones with the speeds of balls at its end
SHORTEST = 2.0**-12  # part of a Newton step


class ForceScales(NamedTuple):
    """Forces (C) [N] that unbalanced ones are measured with."""

    largest: NDArray  # load on ring or balls
    noise: NDArray  # force by which rounding of lengths, or the race control, unbalances a ball

    def allowed(self, share: NDArray | float = 0.0) -> NDArray:
        """Force (C, 1) on a ball that counts as balance, up to a `share` (C) of the largest force."""
        return np.maximum(np.maximum(TOLERANCE, share) * self.largest, self.noise)[:, None]


class BallsInBalance(NamedTuple):
    """Balls at their places, and what is left to balance there."""

    centres: Vectors  # (C, Z) [m]
    balls: BallBalance
    scales: ForceScales
    left: NDArray  # (C, Z) [N] size of the unbalanced force on a ball
    moving: NDArray  # (C, Z) balls that are not balanced as well as was requested
    evaluations: int

    @property
    def done(self) -> NDArray:
        """Whether all balls are balanced as well as was requested (C)."""
        return np.logical_not(self.moving.any(axis=1))


def at_places(
    balance: AngularBalance,
    grooves: Vectors,
    centres: Vectors,
    share: NDArray | float = 0.0,
    evaluations: int = 1,
    near: NDArray | None = None,
) -> BallsInBalance:
    """Balls where they are, see `balance_balls` for the share and `RaceControl` for `near`."""
    balls = balance.balls(grooves, centres, near)
    left, scales = np.abs(balls.excess), force_scales(balance, balls, grooves)
    return BallsInBalance(centres, balls, scales, left, ~(left <= scales.allowed(share)), evaluations)


def force_scales(balance: AngularBalance, balls: BallBalance, grooves: Vectors) -> ForceScales:
    """Forces that unbalanced ones on these balls are measured with."""
    largest = np.maximum(balance.largest_load, balls.loads.max((0, 2)))
    rounding = ROUNDING * np.abs(balls.by_ball[:, 0]).max((0, 2)) * np.abs(grooves).max(1)
    return ForceScales(largest, np.maximum(rounding, balance.control.noise * largest))


def balance_balls(
    balance: AngularBalance,
    grooves: Vectors,
    centres: Vectors,
    share: NDArray | float = 0.0,
    near: NDArray | None = None,
) -> BallsInBalance:
    """Balance of every ball for itself, the groove centres given.

    Balls may stay out of balance by a `share` (C) of the largest force. For `near` see `RaceControl`.
    """
    result = _newton_of_balls(balance, grooves, _start(balance, grooves, centres), share, near)
    places = balance.places
    for _ in range(AGAIN):  # from the places without friction
        if not (result.moving.any() and balance.pulled.any()):
            break
        near = result.balls.kinematics.near
        centres = np.where(result.moving, places.resting(grooves), result.centres)
        again = _newton_of_balls(balance, grooves, centres, share, near)
        result = again._replace(evaluations=result.evaluations + again.evaluations)
        driven = result.balls.kinematics.centrifugal
        places = replace(places, centrifugal=np.where(np.isfinite(driven), driven, places.centrifugal))
    return result


def _newton_of_balls(
    balance: AngularBalance,
    grooves: Vectors,
    centres: Vectors,
    share: NDArray | float,
    near: NDArray | None,
) -> BallsInBalance:
    """Damped Newton for each ball."""
    state = at_places(balance, grooves, centres, share, near=near)
    far = (state.left > balance.free_centrifugal) & balance.pulled & _closed(balance)
    if far.any():  # where they were is no better than a closed form
        centres = np.where(far, balance.places.resting(grooves), centres)
        state = at_places(balance, grooves, centres, share, 2, state.balls.kinematics.near)
    return _damped(balance, grooves, state, share) if state.moving.any() else state


def _damped(
    balance: AngularBalance, grooves: Vectors, state: BallsInBalance, share: NDArray | float
) -> BallsInBalance:
    """Damped Newton of balls from a state; cases that have ended are left out as soon as they are half."""
    places, unbalanced, count = state.centres.copy(), state.moving.copy(), state.evaluations
    cases, some, shares = np.arange(len(grooves)), balance, np.broadcast_to(share, len(grooves))
    at, centres, size, moving, good = grooves, state.centres, state.left, state.moving, ~state.moving
    step, damping = _ball_step(balance, state.balls), np.ones(centres.shape)
    ahead, near = _along(state.balls.excess, step), state.balls.kinematics.near
    nears = near.copy()
    while count < LIMIT * DEAR // max(balance.control.cost, DEAR):
        running = np.logical_and(
            moving.any(axis=1), np.logical_and(damping >= SHORTEST, np.isfinite(step)).all(axis=1)
        )
        if not running.any():
            break
        if 2 * running.sum() <= len(running):
            places[cases], unbalanced[cases], nears[cases] = centres, moving, near
            cases, some, shares = cases[running], some.take(running), shares[running]
            at, centres, size, moving = at[running], centres[running], size[running], moving[running]
            step, damping, ahead, near = step[running], damping[running], ahead[running], near[running]
            running = running[running]
        trial = along_arc(centres, np.where(moving & running[:, None], damping, 0.0) * step)
        state, count = at_places(some, at, trial, shares, near=near), count + 1
        left = _along(state.balls.excess, step)
        good = (left >= -0.5 * np.abs(ahead)) | (state.left < 0.5 * size)
        centres = np.where(good, trial, centres)
        near = np.where(good[..., None], state.balls.kinematics.near, near)
        step = np.where(good, _ball_step(some, state.balls), step)
        ahead = np.where(good, _along(state.balls.excess, step), ahead)
        size, damping = np.where(good, state.left, size), np.where(good, 1.0, damping / 2)
        moving = np.where(running[:, None], ~good | state.moving, moving)
    places[cases], unbalanced[cases], nears[cases] = centres, moving, near
    if len(cases) < len(places) or not good.all():
        state, count = at_places(balance, grooves, places, share, near=nears), count + 1
    return state._replace(moving=unbalanced, evaluations=count)


def along_arc(centres: Vectors, step: Vectors) -> Vectors:
    """Centres moved by a step whose part along the outer groove follows its arc."""
    length = np.abs(centres)
    out = centres / length
    part = out.conj() * step
    return (length + part.real) * out * np.exp(1j * part.imag / length)


def _along(force: Vectors, step: Vectors) -> NDArray:
    """Work of a force on a step [N m]."""
    return (force.conj() * step).real


def _start(balance: AngularBalance, grooves: Vectors, centres: Vectors) -> NDArray:
    """Balance of balls where it has a closed form, elsewhere where they were."""
    if not balance.pulled.all():
        near = balance.pulled if _closed(balance) else balance.pulled | balance.touching(grooves, centres)
        centres = np.where(near, centres, balance.places.resting(grooves))
    free = balance.places.free(grooves)
    if not balance.control.rolling_alone:
        far = NEAR_BOTTOM * balance.bearing.outer_reach
        free &= np.abs(centres - balance.places.bottom) > far
    return np.where(free, balance.places.bottom, centres) if free.any() else centres


def _closed(balance: AngularBalance) -> bool:
    """Whether places have closed forms: those of whole contacts."""
    return balance.races is None


def _ball_step(balance: AngularBalance, balls: BallBalance) -> Vectors:
    """Newton step of every ball; where its balance is unstable, one that forces do work on."""
    axial, radial = balls.by_ball[:, 0]
    half, product = (axial.real - radial.imag) / 2, axial.imag * radial.real
    loosest = (axial.real + radial.imag) / 2 + np.sqrt(np.maximum(half**2 + product, 0.0))  # eigenvalue
    hanging = balance.free_centrifugal / balance.bearing.outer_reach
    stiffer = np.maximum(loosest + STABLE * hanging, 0.0)
    step = -resolved(balls, balls.excess, stiffer)
    longest = LONGEST * min(balance.bearing.inner_reach, balance.bearing.outer_reach)
    return step / np.maximum(np.abs(step) / longest, 1.0)


def resolved(balls: BallBalance, force: Vectors, stiffer: NDArray | float = 0.0) -> Vectors:
    """Moves of balls under which their excess changes by a force (..., C, Z) [m].

    The derivatives are negative where a ball is held; elsewhere it is held lightly, and `stiffer` as asked.
    """
    axial, radial = balls.by_ball[:, 0]
    stiffer = stiffer + FLOATING * (np.abs(axial) + np.abs(radial)) + LEAST_STIFFNESS
    axial, radial = axial - stiffer, radial - 1j * stiffer
    size = (axial.conj() * radial).imag
    return ((axial.conj() * force).imag * 1j - (radial.conj() * force).imag) / size


def balanced(balance: AngularBalance, balls: BallBalance, grooves: Vectors) -> NDArray:
    """Balls (C, Z) that are in balance where they are."""
    return np.less_equal(np.abs(balls.excess), force_scales(balance, balls, grooves).allowed())
