"""Newton's method for balls that find their own balance, the ring held."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.angular import AngularBalance, BallBalance
from quasidynamic.balance.ball_place import Vectors

TOLERANCE = 1e-12  # of the largest force: unbalanced force on a ball
ROUNDING = 16 * np.finfo(float).eps  # of lengths: a force below stiffness times this is noise
LIMIT = 40  # evaluations of the balls at one place of the ring, rarely more than four
STABLE = 0.1  # of the stiffness of a ball hanging in the outer groove: least one in a step
FLOATING = 1e-15  # of its stiffness, given to every ball
LEAST_STIFFNESS = 1e-9  # [N/m] the same where nothing touches: a long step, not an infinite one
LONGEST = 0.3  # of the smaller reach: step of a ball
SHORTEST = 2.0**-12  # part of a Newton step


def settle(
    balance: AngularBalance, grooves: Vectors, centres: Vectors, share: NDArray | float = 0.0
) -> tuple[Vectors, BallBalance, NDArray, int]:
    """Balance of every ball for itself, the groove centres given.

    Balls may stay out of balance by a `share` (C) of the largest force. Returns their places, forces,
    which cases are balanced (C) and the number of evaluations.
    """
    centres = _start(balance, grooves, centres)
    found, balls, settled, count = _newton_of_balls(balance, grooves, centres, share)
    if not settled.all() and (balance.free_centrifugal > 0).any():  # again from the places without friction
        centres = np.where(settled, found, balance.places.resting(grooves))
        found, balls, settled, again = _newton_of_balls(balance, grooves, centres, share)
        count += again
    return found, balls, np.all(settled, axis=1), count


def _newton_of_balls(
    balance: AngularBalance, grooves: Vectors, centres: Vectors, share: NDArray | float
) -> tuple[Vectors, BallBalance, NDArray, int]:
    """Damped Newton for each ball: places, forces, which balls are balanced (C, Z), evaluations."""
    here, count = balance.balls(grooves, centres), 1
    far = (np.abs(here.excess) > balance.free_centrifugal) & (balance.free_centrifugal > 0)
    if far.any():  # where they were is no better than a closed form
        centres = np.where(far, balance.places.resting(grooves), centres)
        here, count = balance.balls(grooves, centres), 2
    size = np.abs(here.excess)
    moving, complete = size > _allowed(balance, here, grooves, share), True
    if not moving.any():
        return centres, here, ~moving, count
    step, damping = _ball_step(balance, here), np.ones(centres.shape)
    ahead = _along(here.excess, step)
    while moving.any() and count < LIMIT and not (damping < SHORTEST).any():
        trial = along_arc(centres, np.where(moving, damping, 0.0) * step)
        there, count = balance.balls(grooves, trial), count + 1
        left, new_size = _along(there.excess, step), np.abs(there.excess)
        good = (left >= -0.5 * np.abs(ahead)) | (new_size < 0.5 * size)
        complete, here = bool(good.all()), there
        centres = np.where(good, trial, centres)
        step = np.where(good, _ball_step(balance, there), step)
        ahead = np.where(good, _along(there.excess, step), ahead)
        size = np.where(good, new_size, size)
        damping = np.where(good, 1.0, damping / 2)
        moving = ~good | ~(size <= _allowed(balance, there, grooves, share))
    if not complete:
        here, count = balance.balls(grooves, centres), count + 1
    return centres, here, ~moving, count


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
    at_rest = balance.free_centrifugal == 0
    if at_rest.any():
        centres = np.where(at_rest, balance.places.resting(grooves), centres)
    lying, free = balance.places.lying(grooves)
    return np.where(free, lying, centres)


def _ball_step(balance: AngularBalance, here: BallBalance) -> Vectors:
    """Newton step of every ball; where its balance is unstable, one that forces do work on."""
    axial, radial = here.by_ball[:, 0]
    half, skew = (axial.real - radial.imag) / 2, (axial.imag + radial.real) / 2
    loosest = (axial.real + radial.imag) / 2 + np.sqrt(half**2 + skew**2)  # of the symmetric part
    hanging = balance.free_centrifugal / balance.bearing.outer_reach
    stiffer = np.maximum(loosest + STABLE * hanging, 0.0)
    step = -resolved(here, here.excess, stiffer)
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


def largest_force(balance: AngularBalance, balls: BallBalance) -> NDArray:
    """Largest load on ring or balls (C) [N]."""
    return np.maximum(np.abs(balance.load).max(1), balls.loads.max((0, 2)))


def _allowed(
    balance: AngularBalance, balls: BallBalance, grooves: Vectors, share: NDArray | float
) -> NDArray:
    """Force (C, 1) on a ball that counts as balance."""
    largest = np.maximum(TOLERANCE, share) * largest_force(balance, balls)
    return np.maximum(largest, noise(balls, grooves))[:, None]


def balanced(balance: AngularBalance, balls: BallBalance, grooves: Vectors, share: float = 0.0) -> NDArray:
    """Balls (C, Z) that are in balance where they are, up to a share of the largest force."""
    return np.less_equal(np.abs(balls.excess), _allowed(balance, balls, grooves, share))


def noise(balls: BallBalance, grooves: Vectors) -> NDArray:
    """Force (C) by which rounding of lengths unbalances a ball."""
    return ROUNDING * np.abs(balls.by_ball[:, 0]).max((0, 2)) * np.abs(grooves).max(1)
