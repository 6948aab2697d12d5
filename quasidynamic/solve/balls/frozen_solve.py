"""Ring on balls whose centrifugal forces and tractions stay what they are."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.angular_contact import AngularBalance
from quasidynamic.balance.balls.ball_position import Vectors, groove_arm, turning
from quasidynamic.solve.balls.ball_equilibrium import LEAST_STIFFNESS, along_arc
from quasidynamic.solve.balls.ring_on_springs import newton_step

REFINEMENTS = 1  # of a solution, for balls near the point where they jump
TOLERANCE = 0.02  # of the largest force: what may be left for the search with all forces
LIMIT = 40  # Newton steps; stopping early costs time later, not the answer
SHORTEST = 2.0**-40  # part of a Newton step
FLOATING = 1e-9  # of the stiffness of a ball, given to balls that touch nothing


class BorderedMatrix(NamedTuple):
    r"""Derivatives of the forces on a ring in F directions and on Z balls in two.

    .. math:: A = \begin{pmatrix} K & L \\ M & D \end{pmatrix},\quad
              D = \operatorname{diag}(D_1 \dots D_Z),\quad S = K - L D^{-1} M

    Source
    ------
    Golub and Van Loan, Matrix Computations, 4th ed. (2013), sec. 3.2, Schur complement.
    """

    ring: NDArray  # (F, F) K
    ring_by_balls: NDArray  # (F, 2 Z) L
    balls_by_ring: NDArray  # (2 Z, F) M
    balls: NDArray  # (Z, 2, 2) D_j

    def solved(self, right: NDArray) -> NDArray:
        """Unknowns (F + 2 Z, R) for right-hand sides (F + 2 Z, R); not a number where A is singular."""
        try:
            solution = self._eliminated(right)
            for _ in range(REFINEMENTS):
                solution = solution + self._eliminated(right - self.times(solution))
        except np.linalg.LinAlgError:
            return np.full_like(right, np.nan)
        return solution

    def times(self, unknowns: NDArray) -> NDArray:
        """Product (F + 2 Z, R) with unknowns (F + 2 Z, R)."""
        ring, balls = np.split(unknowns, [len(self.ring)])
        own = (self.balls @ balls.reshape(-1, 2, balls.shape[-1])).reshape(balls.shape)
        return np.concatenate(
            [self.ring @ ring + self.ring_by_balls @ balls, self.balls_by_ring @ ring + own]
        )

    def sign(self) -> float:
        """Sign of the determinant; zero where a ball or A is singular."""
        try:
            reduced = self.ring - self.ring_by_balls @ self._of_balls(self.balls_by_ring)
        except np.linalg.LinAlgError:
            return 0.0
        return float(np.linalg.slogdet(self.balls)[0].prod() * np.linalg.slogdet(reduced)[0])

    def _eliminated(self, right: NDArray) -> NDArray:
        count = len(self.ring)
        both = self._of_balls(np.concatenate([self.balls_by_ring, right[count:]], axis=1))
        by_ring, alone = both[:, :count], both[:, count:]
        ring = np.linalg.solve(
            self.ring - self.ring_by_balls @ by_ring, right[:count] - self.ring_by_balls @ alone
        )
        return np.concatenate([ring, alone - by_ring @ ring])

    def _of_balls(self, right: NDArray) -> NDArray:
        """Unknowns (2 Z, R) of the balls alone."""
        return np.linalg.solve(self.balls, right.reshape(len(self.balls), 2, right.shape[-1])).reshape(
            right.shape
        )


class _FrozenState(NamedTuple):
    """Forces at one place; vectors are complex numbers, axial + i radial."""

    ring: NDArray  # (C, 5) [N] load that is not carried
    ball: Vectors  # (C, Z) [N] unbalanced force
    excess_after: NDArray  # (C, 5) [N] load not carried once the balls have moved
    ball_moves: Vectors  # (C, Z) [m] move of the balls, the ring held
    follow: tuple[Vectors, Vectors]  # (C, Z) p, q of the move p v + q conj(v) of a ball by its groove's v
    stiffness: NDArray  # (C, 5, 5) [N/m] balls in balance
    imbalance: NDArray  # (C) over the largest force


def frozen_solve(
    balance: AngularBalance,
    place: tuple[NDArray, Vectors],
    frozen: tuple[Vectors, NDArray],
    tolerance: float = TOLERANCE,
    limit: int = LIMIT,
) -> tuple[NDArray, Vectors]:
    """Ring (C, 5) and centres (C, Z) near the balance under constant forces on balls (C, Z), ring (C, 5).

    With such forces the energy of the contacts is convex in all displacements: one balance, which
    Newton's method finds when no step runs past the minimum. The balls are eliminated one by one.
    """
    ring, centres = place
    state = _forces(balance, (ring, centres), frozen)
    for _ in range(limit):
        if (state.imbalance <= tolerance).all():
            break
        step = newton_step(balance, state.excess_after, state.stiffness, state.imbalance)
        shift, (along, across) = step @ balance.ring_to_groove.T, state.follow
        moves = state.ball_moves + along * shift + across * shift.conj()
        ahead = _work(state, step, moves)
        damping = np.where(state.imbalance > tolerance, 1.0, 0.0)
        while True:
            trial_ring = ring + damping[:, None] * step
            trial = along_arc(centres, damping[:, None] * moves)
            trial_state = _forces(balance, (trial_ring, trial), frozen)
            past = ~(_work(trial_state, step, moves) >= -0.5 * np.abs(ahead))  # also not a number
            past &= damping > SHORTEST
            if not past.any():
                break
            damping = np.where(past, damping / 2, damping)
        ring, centres, state = trial_ring, trial, trial_state
    return ring, centres


def _work(state: _FrozenState, step: NDArray, moves: Vectors) -> NDArray:
    """Work (C) [N m] of the unbalanced forces on a step."""
    return (state.ring * step).sum(1) + (state.ball.conj() * moves).real.sum(1)


def _forces(
    balance: AngularBalance, place: tuple[NDArray, Vectors], frozen: tuple[Vectors, NDArray]
) -> _FrozenState:
    """Forces at a place.

    A symmetric matrix acts on a complex vector v as m v + d conj(v), m real; the stiffness of a contact,
    k along its normal n and h across it, has m = (k + h)/2 and d = n^2 (k - h)/2.
    """
    (ring, centres), (pull, drag), to_groove = place, frozen, balance.ring_to_groove
    arms = groove_arm(np.array([balance.grooves(ring) - centres, centres]))
    lengths = np.abs(arms)
    normals = arms / lengths
    loads, stiff = balance.pressed(lengths)
    across = turning(arms) * loads / lengths
    even, odd = 0.5 * (stiff + across), 0.5 * (stiff - across) * normals**2
    on_inner, on_outer = loads * normals
    ball = on_inner - on_outer + pull
    floating = FLOATING * 2 * even.max() + LEAST_STIFFNESS
    mean, skew = even[0] + even[1] + floating, odd[0] + odd[1]
    size = mean**2 - np.abs(skew) ** 2
    ball_moves = (mean * ball - skew * ball.conj()) / size
    p = (mean * even[0] - skew * odd[0].conj()) / size
    q = (mean * odd[0] - skew * even[0]) / size
    held_even = even[0] * (1 - p) - odd[0] * q.conj()
    held_odd = odd[0] * (1 - p.conj()) - even[0] * q
    to_ring = balance.groove_to_ring
    resisted = held_even[..., None] * to_groove + held_odd[..., None] * to_ring
    missed = ((even[0] * ball_moves + odd[0] * ball_moves.conj()) @ to_ring).real
    excess = np.where(balance.held, 0.0, balance.load - drag - (on_inner @ to_ring).real)
    excess_after = np.where(balance.held, 0.0, excess + missed)
    largest = np.maximum(balance.largest_load, loads.max((0, 2)))
    worst = np.maximum(np.abs(excess_after).max(1), np.abs(ball).max(1))
    return _FrozenState(
        excess, ball, excess_after, ball_moves, (p, q), (to_ring.T @ resisted).real, worst / largest
    )
