"""Ring on balls whose centrifugal forces and tractions stay what they are."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.angular import AngularBalance
from quasidynamic.balance.ball_place import Vectors, groove_arm, turning
from quasidynamic.solve.balls import LEAST_STIFFNESS, along_arc
from quasidynamic.solve.ring_on_springs import newton_step

ENOUGH = 0.02  # of the largest force: what may be left for the search with all forces
LIMIT = 40  # Newton steps; stopping early costs time later, not the answer
SHORTEST = 2.0**-40  # part of a Newton step
FLOATING = 1e-9  # of the stiffness of a ball, given to balls that touch nothing


class _Here(NamedTuple):
    """Forces at one place; vectors (..., 2) axial, radial."""

    ring: NDArray  # (C, 5) [N] load that is not carried
    ball: NDArray  # (C, Z, 2) [N] unbalanced force
    carried_late: NDArray  # (C, 5) [N] load not carried once the balls have moved
    late: NDArray  # (C, Z, 2) [m] move of the balls, the ring held
    follow: NDArray  # (C, Z, 2, 2) move of a ball per move of its groove
    stiffness: NDArray  # (C, 5, 5) [N/m] balls in balance
    imbalance: NDArray  # (C) over the largest force


def hung(
    balance: AngularBalance,
    place: tuple[NDArray, Vectors],
    frozen: tuple[Vectors, NDArray],
    enough: float = ENOUGH,
    limit: int = LIMIT,
) -> tuple[NDArray, Vectors]:
    """Ring (C, 5) and centres (C, Z) near the balance under constant forces on balls (C, Z), ring (C, 5).

    With such forces the energy of the contacts is convex in all displacements: one balance, which
    Newton's method finds when no step runs past the minimum. The balls are eliminated one by one.
    """
    ring, centres = place
    to_groove = balance.ring_to_groove.view(float).reshape(-1, 5, 2).swapaxes(1, 2)
    here = _forces(balance, to_groove, (ring, centres), frozen)
    for _ in range(limit):
        if (here.imbalance <= enough).all():
            break
        step = newton_step(balance, here.carried_late, here.stiffness, here.imbalance)
        shift = (to_groove @ step[:, None, :, None])[..., 0]
        moves = here.late + (here.follow @ shift[..., None])[..., 0]
        ahead = _work(here, step, moves)
        damping = np.where(here.imbalance > enough, 1.0, 0.0)
        while True:
            trial_ring = ring + damping[:, None] * step
            trial = along_arc(centres, damping[:, None] * (moves[..., 0] + 1j * moves[..., 1]))
            there = _forces(balance, to_groove, (trial_ring, trial), frozen)
            past = ~(_work(there, step, moves) >= -0.5 * np.abs(ahead))  # also not a number
            past &= damping > SHORTEST
            if not past.any():
                break
            damping = np.where(past, damping / 2, damping)
        ring, centres, here = trial_ring, trial, there
    return ring, centres


def _work(here: _Here, step: NDArray, moves: NDArray) -> NDArray:
    """Work (C) [N m] of the unbalanced forces on a step."""
    return (here.ring * step).sum(1) + (here.ball * moves).sum((1, 2))


def _forces(
    balance: AngularBalance,
    to_groove: NDArray,
    place: tuple[NDArray, Vectors],
    frozen: tuple[Vectors, NDArray],
) -> _Here:
    """Forces at a place; `to_groove` (Z, 2, 5) is the move of a groove per ring displacement."""
    (ring, centres), (pull, drag) = place, frozen
    arms = groove_arm(np.array([balance.grooves(ring) - centres, centres]))
    lengths = np.abs(arms)
    normals = (arms / lengths).view(float).reshape(*arms.shape, 2)
    loads, stiff = balance.pressed(lengths)
    forces = loads[..., None] * normals
    across = turning(arms) * loads / lengths
    matrix = (stiff - across)[..., None, None] * normals[..., :, None] * normals[..., None, :]
    matrix += across[..., None, None] * np.eye(2)
    ball = forces[0] - forces[1]
    ball[..., 0] += pull.real
    ball[..., 1] += pull.imag
    whole = matrix.sum(0)
    inverse = _inverse(whole, FLOATING * np.abs(whole).max() + LEAST_STIFFNESS)
    follow = inverse @ matrix[0]
    late = (inverse @ ball[..., None])[..., 0]
    held = matrix[0] - matrix[0] @ follow
    count = len(ring)
    flat = to_groove.reshape(-1, 5)
    stiffness = flat.T @ (held @ to_groove).reshape(count, -1, 5)
    carried = forces[0].reshape(count, -1) @ flat
    missed = (matrix[0] @ late[..., None]).reshape(count, -1) @ flat
    free = ~balance.held
    excess = np.where(free, balance.load - drag - carried, 0.0)
    excess_late = np.where(free, excess + missed, 0.0)
    largest = np.maximum(np.abs(balance.load).max(1), loads.max((0, 2)))
    worst = np.maximum(np.abs(excess_late).max(1), np.abs(ball).max((1, 2)))
    return _Here(excess, ball, excess_late, late, follow, stiffness, worst / largest)


def _inverse(matrix: NDArray, floating: float) -> NDArray:
    """Inverse of symmetric matrices (..., 2, 2) that are held lightly."""
    first, second = matrix[..., 0, 0] + floating, matrix[..., 1, 1] + floating
    size = first * second - matrix[..., 0, 1] ** 2
    found = np.empty_like(matrix)
    found[..., 0, 0], found[..., 1, 1] = second, first
    found[..., 0, 1] = found[..., 1, 0] = -matrix[..., 0, 1]
    return found / size[..., None, None]
