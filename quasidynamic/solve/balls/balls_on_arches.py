"""Newton's method for balls that find their place between grooves that are held."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.four_contacts import BallsOnArches, FourContacts
from quasidynamic.errors import NotSolved
from quasidynamic.motion.ball_slip import OUTER

TOLERANCE = 1e-12  # of the largest load: unbalanced force on a ball
ROUNDING = 16 * float(np.finfo(float).eps)  # of lengths: a force below stiffness times this is noise
LONGEST = 0.3  # of the smaller reach: step of a ball
DESCENT = 0.1  # part of the linear fall of the unbalanced force that a shorter step must bring
SHORTEST = 2.0**-20  # part of a step
LIMIT = 100  # evaluations, rarely more than ten


def balls_in_balance(
    contacts: FourContacts,
    place: NDArray,
    shape: NDArray | float,
    near: NDArray | None,
    largest: float,
    share: float = 0.0,
) -> tuple[NDArray, BallsOnArches]:
    """Places of the balls (Z, 2) [m], the ring at a place (5) [m] and its grooves moved (Z, 2, 2, 2) [m].

    The search begins `near` places, or at the line of the groove centres; forces are measured with the
    `largest` [N], of which balls may leave a `share` out of balance.
    Raises `NotSolved` when a ball finds no balance.
    """
    centres = first_centres(contacts, place, shape) if near is None else near
    balls, left = _newton(contacts, place, shape, centres, largest, share)
    if left.any() and near is not None:
        centres = first_centres(contacts, place, shape)
        balls, left = _newton(contacts, place, shape, centres, largest, share)
    if left.any():
        ball = int(left.argmax())
        size = np.hypot(*balls[1].excess[ball])
        raise NotSolved(
            f"ball {ball} found no place between its grooves: {size:.2g} N are left unbalanced",
            "iteration limit",
        )
    return balls


def first_centres(contacts: FourContacts, place: NDArray, shape: NDArray | float) -> NDArray:
    """Places of balls (Z, 2) [m] to begin with: on the tighter diagonal, or outside in the middle."""
    middle = contacts.arms(place, np.zeros((len(contacts.moves), 2)), shape)
    apart = middle.sum(2)  # opposite groove centres
    apart[..., 1] = np.maximum(apart[..., 1], 0.0)  # grooves are open where they are far apart
    length = np.hypot(apart[..., 0], apart[..., 1])
    tight, ball = length.argmax(1), np.arange(len(length))
    approach = length.max(1) - contacts.reach.sum()
    soft = contacts.coefficient[0] ** (2 / 3) / (contacts.coefficient ** (2 / 3)).sum()
    share = np.where(approach > 0, soft, contacts.reach[OUTER] / contacts.reach.sum())
    from_outer = (contacts.reach[OUTER] + share * approach)[:, None] * (apart / length[..., None])[
        ball, tight
    ]
    side = np.array([[1.0, 1.0], [-1.0, 1.0]])[tight]
    pressed = side * (from_outer - middle[ball, tight, OUTER])
    at_bottom = contacts.free_centrifugal > contacts.in_series * np.maximum(approach, 0.0) ** 1.5
    return np.where(at_bottom[:, None], _bottom(contacts), pressed)


def _bottom(contacts: FourContacts) -> NDArray:
    """Place (2) [m] of a ball on the outer race alone, in the middle, rings without shape."""
    cosine, arches = contacts.start[0, OUTER, 1] / contacts.reach[OUTER], contacts.bearing.outer_arches
    load = contacts.free_centrifugal / (arches * cosine)
    return np.array([0.0, (load / contacts.coefficient[OUTER]) ** (2 / 3) / cosine])


def _newton(
    contacts: FourContacts,
    place: NDArray,
    shape: NDArray | float,
    centres: NDArray,
    largest: float,
    share: float,
) -> tuple[tuple[NDArray, BallsOnArches], NDArray]:
    """Places and balls, and which of these (Z) are not in balance."""
    balls = contacts.at(contacts.arms(place, centres, shape))
    step, part = ball_step(contacts, balls), np.ones(len(centres))
    ahead, size = (balls.excess * step).sum(1), np.hypot(*balls.excess.T)
    moving = size > _allowed(contacts, balls, largest, share)
    for _ in range(LIMIT):
        if not moving.any() or (part[moving] < SHORTEST).all():
            break
        trial = centres + np.where(moving, part, 0.0)[:, None] * step
        there = contacts.at(contacts.arms(place, trial, shape))
        new_size = np.hypot(*there.excess.T)
        good = (there.excess * step).sum(1) >= -0.5 * np.abs(ahead)
        good |= new_size < np.maximum(0.5, 1.0 - DESCENT * part) * size
        good &= moving
        balls = _chosen(good, there, balls)
        centres = np.where(good[:, None], trial, centres)
        step = np.where(good[:, None], ball_step(contacts, balls), step)
        ahead, size = np.where(good, (balls.excess * step).sum(1), ahead), np.where(good, new_size, size)
        part = np.where(good, 1.0, part / 3)
        moving &= size > _allowed(contacts, balls, largest, share)
    return (centres, balls), moving


def _allowed(contacts: FourContacts, balls: BallsOnArches, largest: float, share: float) -> NDArray:
    """Force (Z) [N] on a ball that counts as balance."""
    noise = ROUNDING * np.abs(balls.by_ball).max((1, 2)) * contacts.reach.max()
    part = max(TOLERANCE, share) * max(largest, float(balls.forces.loads.max()))
    return np.maximum(part, noise)


def ball_step(contacts: FourContacts, balls: BallsOnArches) -> NDArray:
    """Newton step of every ball (Z, 2) [m]; where its balance is unstable, one that forces do work on."""
    matrix = balls.by_ball
    half, product = (matrix[:, 0, 0] - matrix[:, 1, 1]) / 2, matrix[:, 0, 1] * matrix[:, 1, 0]
    loosest = (matrix[:, 0, 0] + matrix[:, 1, 1]) / 2 + np.sqrt(np.maximum(half**2 + product, 0.0))
    stiffer = balls.held_lightly + 2.0 * np.maximum(loosest, 0.0)
    step = -np.linalg.solve(matrix - stiffer[:, None, None] * np.eye(2), balls.excess[..., None])[..., 0]
    return step / np.maximum(np.hypot(*step.T) / (LONGEST * contacts.reach.min()), 1.0)[:, None]


def _chosen(good: NDArray, new: BallsOnArches, old: BallsOnArches) -> BallsOnArches:
    """New balls (Z) where they are good, else the old ones."""

    def either(there: NDArray, here: NDArray) -> NDArray:
        return np.where(good.reshape(-1, *[1] * (here.ndim - 1)), there, here)

    forces = type(old.forces)(*map(either, new.forces, old.forces))
    return BallsOnArches(
        either(new.arms, old.arms),
        forces,
        either(new.turn, old.turn),
        either(new.force_slopes, old.force_slopes),
        either(new.excess, old.excess),
        either(new.excess_slopes, old.excess_slopes),
    )
