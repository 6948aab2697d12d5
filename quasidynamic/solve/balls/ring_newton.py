"""Newton's method for a ring on balls that find their own balance."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.angular_contact import AngularBalance, BallBalance, RingBalance, moved
from quasidynamic.balance.balls.ball_position import Vectors
from quasidynamic.solve.balls.ball_equilibrium import (
    BallsInBalance,
    along_arc,
    at_places,
    balance_balls,
    resolved,
)
from quasidynamic.solve.balls.ring_on_springs import newton_step
from quasidynamic.solve.step_length import SolverOutcome

TOLERANCE = 1e-11  # of the largest force: unbalanced force on the ring
LIMIT = 60  # Newton steps of the ring, rarely more than ten
BALL_SHARE = 0.1  # of the imbalance before a step: what the balls may leave to the next one
SHORTEST = 2.0**-6  # part of a Newton step; a path of growing inertia is quicker than shorter ones
TOUCHING = 10  # times what may be left: least load that counts as contact of the ring
BUDGET = 12000  # evaluations of all balls in one search, of closed forms, rarely more than two thousand
TINY = float(np.finfo(float).tiny)
ANSWERED = (SolverOutcome.CONVERGED, SolverOutcome.UNDETERMINED)  # that no other path would change
SINGULAR = 1e-12  # of the whole stiffness: a direction that nothing holds


@dataclass(frozen=True)
class RingSolution:
    """Places of ring and balls, and how the search ended; C cases, Z balls."""

    ring: NDArray  # (C, 5) [m] rotations times R_i
    centres: NDArray  # (C, Z) [m] axial + i radial, from the outer groove centres
    outcomes: list[SolverOutcome]
    imbalance: NDArray  # (C) largest unbalanced force over the largest force
    evaluations: NDArray  # (C) of all balls
    last_forces: tuple[BallBalance, RingBalance] | None = None  # forces there, where all cases ended together
    near: NDArray | None = None  # (C, Z, k) motion of the balls, see `BallKinematics`; None: not known
    whole_ring: NDArray | None = None  # (C, 5) [m] with whole contacts, where shoulders cut some off

    def forces(self, balance: AngularBalance) -> tuple[BallBalance, RingBalance]:
        """Forces on balls and ring at these places."""
        if self.last_forces is not None:
            return self.last_forces
        with np.errstate(all="ignore"):  # a case that ended not finite has no forces
            balls = balance.balls(balance.grooves(self.ring), self.centres, self.near)
            return balls, balance.ring(balls, followed(balls))


@dataclass
class _RingState:
    """One place of the ring with balls in balance."""

    ring: NDArray
    centres: NDArray
    ball_moves: NDArray  # (C, Z) [m] what the balls still have to move
    balls: BallBalance
    follow: NDArray  # (2, C, Z) see `followed`
    near: NDArray  # (C, Z, k) see `BallKinematics`
    balance: RingBalance
    balls_done: NDArray  # (C) bool, whether all balls are balanced as well as was requested
    imbalance: NDArray  # (C)
    pressing: NDArray  # (C) largest load on the inner race over the largest force
    evaluations: int


@np.errstate(all="ignore")  # places tried on the way may overflow: such a step is not taken
def newton(
    balance: AngularBalance,
    ring: NDArray,
    centres: NDArray | None = None,
    near: NDArray | None = None,
    budget: int | None = None,
) -> RingSolution:
    """Damped Newton on the ring, all cases side by side; a case leaves as soon as it ends.

    `budget` is the number of evaluations after which it does, that of any search unless given.
    """
    if centres is None:
        centres = balance.places.resting(balance.grooves(ring))
    size = len(ring)
    out_ring, out_centres = ring.copy(), centres.copy()
    outcomes, imbalance, evaluations = (
        [SolverOutcome.RUNNING] * size,
        np.full(size, np.inf),
        np.zeros(size, int),
    )
    budget = budget or BUDGET // balance.control.cost
    cases, state = np.arange(size), _state(balance, ring, centres, BALL_SHARE, near)
    out_near = state.near.copy()
    evaluations += state.evaluations
    damping, number = np.ones(size), 0
    while True:
        last = (number == LIMIT) | (evaluations[cases] > budget)
        ended = [_outcome(balance, state, k, damping[k], last[k]) for k in range(len(cases))]
        for k, case in enumerate(cases):
            out_ring[case], out_centres[case], out_near[case] = state.ring[k], state.centres[k], state.near[k]
            outcomes[case], imbalance[case] = ended[k], state.imbalance[k]
        running = np.array([outcome is SolverOutcome.RUNNING for outcome in ended])
        if not running.any():
            together = (state.balls, state.balance) if len(cases) == size else None
            return RingSolution(out_ring, out_centres, outcomes, imbalance, evaluations, together, out_near)
        if not running.all():
            cases, balance, damping = cases[running], balance.take(running), damping[running]
            state = _taken(state, running)
        state, damping, count = _moved(balance, state, budget - evaluations[cases].max())
        evaluations[cases] += count
        number += 1


def solution_at(
    balance: AngularBalance, places: tuple[NDArray, Vectors], evaluations: int, near: NDArray | None = None
) -> RingSolution:
    """One case with ring and balls where another search has them, and whether they are in balance there."""
    ring, centres = places
    state = _at(balance, ring, at_places(balance, balance.grooves(ring), centres, near=near))
    outcome = _outcome(balance, state, 0, 1.0, last=True)
    return RingSolution(ring, centres, [outcome], state.imbalance, np.array([evaluations]), near=state.near)


def _outcome(
    balance: AngularBalance, state: _RingState, case: int, damping: float, last: bool
) -> SolverOutcome:
    if not np.isfinite(state.imbalance[case]):
        return SolverOutcome.NOT_FINITE
    if state.balls_done[case] and state.imbalance[case] <= tolerance_of(balance):
        return SolverOutcome.CONVERGED if _held(balance, state, case) else SolverOutcome.UNDETERMINED
    if damping < SHORTEST or not state.balls_done[case]:
        return SolverOutcome.STALLED
    return SolverOutcome.LIMIT if last else SolverOutcome.RUNNING


def tolerance_of(balance: AngularBalance) -> float:
    """Part of the largest force that may be left: forces of a race control may be less certain."""
    return max(TOLERANCE, balance.control.noise)


def _held(balance: AngularBalance, state: _RingState, case: int) -> bool:
    """Whether balls hold the ring in every direction in which it is free."""
    free = ~balance.held[case]
    touching = state.pressing[case] > TOUCHING * tolerance_of(balance)
    return not free.any() or bool(touching and holds(state.balance.stiffness[case], free))


def holds(stiffness: NDArray, free: NDArray) -> bool:
    """Whether a stiffness (5, 5) [N/m] holds a ring in every free direction (5)."""
    scales = np.linalg.svd(stiffness[np.ix_(free, free)], compute_uv=False)
    return not scales.size or bool(scales.min() > SINGULAR * scales.max())


def _moved(balance: AngularBalance, state: _RingState, budget: int) -> tuple[_RingState, NDArray, int]:
    """State after a Newton step; where it fails, balls are brought into balance and the step is halved.

    As long as it has not cost its `budget` of evaluations.
    """
    step, damping = (
        newton_step(balance, state.balance.excess, state.balance.stiffness, state.imbalance),
        np.ones(len(state.ring)),
    )
    trial, good = _tried(balance, state, step, damping, BALL_SHARE * state.imbalance)
    count = trial.evaluations
    if not good.all():
        state = _state(balance, state.ring, state.centres, 0.0, state.near)
        step, count = (
            newton_step(balance, state.balance.excess, state.balance.stiffness, state.imbalance),
            count + state.evaluations,
        )
    while not good.all() and (damping[~good] >= SHORTEST).any() and count <= budget:
        trial, good = _tried(balance, state, step, damping, 0.0)
        count += trial.evaluations
        damping = np.where(good, damping, damping / 2)
    return trial, damping, count


def _tried(
    balance: AngularBalance, state: _RingState, step: NDArray, damping: NDArray, share: NDArray | float
) -> tuple[_RingState, NDArray]:
    """State after a damped step, and the cases in which it does not run far past the balance on its way."""
    ring = state.ring + damping[:, None] * step
    shift = balance.grooves(ring) - balance.grooves(state.ring)
    move = damping[:, None] * state.ball_moves + moved(state.follow, shift)
    trial = _state(balance, ring, along_arc(state.centres, move), share, state.near)
    ahead, left = (state.balance.excess * step).sum(1), (trial.balance.excess * step).sum(1)
    good = (left >= -0.5 * np.abs(ahead)) | (trial.imbalance < 0.5 * state.imbalance)
    return trial, good & trial.balls_done


def _taken(state: _RingState, cases: NDArray) -> _RingState:
    """Part of the cases; of the forces only what the next step needs."""
    ring = RingBalance(*(array[cases] for array in state.balance))
    return replace(
        state,
        ring=state.ring[cases],
        centres=state.centres[cases],
        ball_moves=state.ball_moves[cases],
        follow=state.follow[:, cases],
        near=state.near[cases],
        balance=ring,
        balls_done=state.balls_done[cases],
        imbalance=state.imbalance[cases],
        pressing=state.pressing[cases],
    )


def _state(
    balance: AngularBalance,
    ring: NDArray,
    centres: NDArray,
    share: NDArray | float,
    near: NDArray | None,
) -> _RingState:
    """Ring at a place, balls in balance up to a share of the largest force."""
    grooves = balance.grooves(ring)
    return _at(balance, ring, balance_balls(balance, grooves, centres, share, near))


def _at(balance: AngularBalance, ring: NDArray, result: BallsInBalance) -> _RingState:
    """Ring and balls as they are."""
    balls = result.balls
    ball_moves, follow = moves_left(result)
    ball_moves[result.left <= result.scales.allowed()] = 0.0  # slopes of light balls do not reach far
    forces = balance.ring(balls, follow)
    left = forces_left(balance, result, forces, ball_moves)
    return _RingState(
        ring=ring,
        centres=result.centres,
        ball_moves=ball_moves,
        balls=balls,
        follow=follow,
        near=balls.kinematics.near,
        balance=forces._replace(excess=left.excess),
        balls_done=result.done,
        imbalance=left.force / left.largest,
        pressing=balls.loads[0].max(1) / left.largest,
        evaluations=result.evaluations,
    )


class ForcesLeft(NamedTuple):
    """What is left to balance of C cases [N]."""

    excess: NDArray  # (C, 5) on the ring, once the balls have moved
    force: NDArray  # (C) largest on ring and balls
    largest: NDArray  # (C) force that this is measured with


def forces_left(
    balance: AngularBalance, result: BallsInBalance, forces: RingBalance, ball_moves: Vectors
) -> ForcesLeft:
    """Unbalanced forces on ring and balls, `ball_moves` (C, Z) [m] being what balls still have to move."""
    scales, left, tolerance = result.scales, result.left.max(1), tolerance_of(balance)
    _, force, traction = moved(result.balls.by_ball, ball_moves)
    excess = np.where(balance.held, 0.0, forces.excess - balance.on_ring(force, traction))
    near = left[:, None] <= scales.allowed(tolerance)
    counted = np.where(near, forces.excess, excess)  # no balance by what balls would do
    largest = np.maximum(np.maximum(scales.largest, scales.noise / tolerance), TINY)
    return ForcesLeft(excess, np.maximum(np.abs(counted).max(1), left), largest)


def moves_left(result: BallsInBalance) -> tuple[Vectors, Vectors]:
    """What balls still have to move (C, Z) [m], and their move by their grooves, see `followed`."""
    balls = result.balls
    moves = -resolved(balls, np.concatenate([balls.excess[None], balls.by_groove[:, 0]]))
    return moves[0], moves[1:]


def followed(balls: BallBalance) -> NDArray:
    """Move of a ball per axial and per radial move of its groove (2, C, Z), by implicit differentiation."""
    return -resolved(balls, balls.by_groove[:, 0])
