"""Newton's method for a ring on balls between elastic grooves."""

from collections.abc import Callable, Generator, Iterator
from dataclasses import replace
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.angular_contact import AngularBalance, BallBalance, RingBalance, moved
from quasidynamic.balance.balls.ball_position import Vectors, groove_arm, turning
from quasidynamic.balance.balls.elastic_grooves import ElasticGrooves, shape_of
from quasidynamic.solve.balls.ball_equilibrium import (
    BallsInBalance,
    along_arc,
    at_places,
    balance_balls,
)
from quasidynamic.solve.balls.ring_newton import (
    ANSWERED,
    BALL_SHARE,
    RingSolution,
    forces_left,
    holds,
    moves_left,
)
from quasidynamic.solve.balls.ring_on_balls import solve, start
from quasidynamic.solve.balls.ring_on_springs import stiffened_step
from quasidynamic.solve.step_length import SolverOutcome

LIMIT = 80  # Newton steps for one compliance, rarely more than ten
LONGEST = 0.3  # of the smaller reach: step of a groove against a ball
FLOATING = 1e-9  # of the whole stiffness: what resists every direction of the ring, soft supports or none
SHORTEST = 2.0**-10  # part of a Newton step
PATIENCE = 3  # steps without a smaller imbalance; grooves that soften step by step arrive sooner
LIGHT = 1e-3  # of the largest force: left where light balls went to another balance, from which steps go on
LEAST_STEP = 2e-3  # part of the compliance by which grooves become softer at least
NEAR_LIMIT = 4 * LEAST_STEP  # part of the compliance beyond the last balance, within which a limit point is
TOLERANCE = 1e-10  # of the largest force: unbalanced force
ROUNDED = 1e-9  # the same, where a step no longer halves it: balls that only inertia presses go to and fro


Equations = Callable[[float], tuple[AngularBalance, ElasticGrooves]]  # by a part of what is continued
Steps = Generator["State", None, tuple["State", list[SolverOutcome]]]  # those on the way to the last state


class Places(NamedTuple):
    """Places of C cases, inner then outer race."""

    ring: NDArray  # (C, 5) [m] of the inner ring, rotations times R_i
    grooves: Vectors  # (C, 2, Z) [m] displacement of the grooves under the balls
    pressing: Vectors  # (C, 2, Z) [N] forces that would displace them so
    centres: Vectors  # (C, Z) [m] balls, from the displaced outer groove centres

    @property
    def shape(self) -> Vectors:
        """Inner grooves less outer ones beyond those of rigid rings (C, Z) [m]."""
        return self.grooves[:, 0] - self.grooves[:, 1]

    def further(self, steps: float, step: "Places") -> "Places":
        """Places so many steps away."""
        return Places(
            self.ring + steps * step.ring,
            self.grooves + steps * step.grooves,
            self.pressing + steps * step.pressing,
            self.centres + steps * step.centres,
        )

    def held(self, balance: AngularBalance) -> "Places":
        """The same with a ring that is held where a case holds it."""
        return self._replace(ring=np.where(balance.held, balance.place, self.ring))


class ElasticSolution(NamedTuple):
    """Balance between elastic grooves; C cases, Z balls, inner then outer race."""

    rings: RingSolution  # with the stiffness of grooves and balls
    moved: NDArray  # (C, 2, Z, 2) [m] axial and radial displacement of the grooves under the balls

    @property
    def places(self) -> Places:
        """Of ring, grooves and balls; without the forces that would displace the grooves so."""
        grooves = self.moved.view(complex)[..., 0]
        return Places(self.rings.ring, grooves, np.zeros_like(grooves), self.rings.centres)


class State(NamedTuple):
    """Forces and derivatives at one place; moves are those of grooves against each other (2 Z)."""

    ring: NDArray  # (C, 5), as the next three of `Places`
    grooves: Vectors
    pressing: Vectors
    centres: Vectors
    ball_moves: Vectors  # (C, Z) [m] what the balls still have to move
    follow: Vectors  # (C, 2, Z) their move per axial and per radial move of their grooves
    forces: Vectors  # (C, 2, Z) [N] on the races, once the balls have moved
    by_moves: NDArray  # (C, 2, Z, 2, 2) [N/m] their change
    misfit: NDArray  # (C, 2, 2 Z) [m] grooves less where the forces displace them to
    deflection_by_moves: NDArray  # (C, 2, 2 Z, 2 Z) change by moves of where the forces displace them to
    excess: NDArray  # (C, 5) [N] once the balls have moved
    excess_after: NDArray  # (C, 5) [N] once balls and grooves have moved to their balance, the ring held
    stiffness: NDArray  # (C, 5, 5) [N/m] balls and grooves in balance
    carried: NDArray  # (C, 5) [N]
    by_ring: NDArray  # (C, 2 Z, 5) moves per ring displacement
    closing: NDArray  # (C, 2 Z) [m] moves that bring grooves to their balance, the ring held
    imbalance: NDArray  # (C)
    evaluations: NDArray  # (C) of all balls
    whole_ring: NDArray  # (C, 5) as the first of all, with whole contacts

    def of(self, cases: NDArray) -> "State":
        """Some of the cases."""
        return State(*(array[cases] for array in self))

    def put(self, cases: NDArray, others: "State") -> None:
        """Replace some of the cases."""
        for array, other in zip(self, others, strict=True):
            array[cases] = other

    @property
    def places(self) -> Places:
        """Where ring, grooves and balls are."""
        return Places(*self[: len(Places._fields)])

    def moves(self, ring: NDArray) -> NDArray:
        """Newton step (C, 2 Z) of the grooves against each other, given that of the ring (C, 5)."""
        return (self.by_ring @ ring[..., None])[..., 0] + self.closing

    def steps(self, ring: NDArray) -> Places:
        """Newton steps of all places, given that of the ring (C, 5)."""
        moves = self.moves(ring)
        return Places(
            ring,
            ((self.deflection_by_moves @ moves[:, None, :, None])[..., 0] - self.misfit).view(complex),
            self.forces - self.pressing + _vectors(self.by_moves @ _pairs(moves)[:, None, ..., None]),
            self.ball_moves + moved(np.moveaxis(self.follow, 1, 0), moves.view(complex)),
        )

    def work(self, step: NDArray, moves: Vectors) -> NDArray:
        """Work (C) [N m] of unbalanced forces on a step of the ring (C, 5) and of the grooves (C, 2, Z).

        Where forces are those of an energy, it falls along a Newton step up to the minimum.
        """
        return (self.excess * step).sum(1) + ((self.forces - self.pressing) * moves.conj()).real.sum((1, 2))


def solve_elastic(balance: AngularBalance, grooves: ElasticGrooves) -> ElasticSolution:
    r"""Balance of all cases between elastic grooves, from round ones.

    .. math:: v = v_0 + B a + s, \quad s = -C_i F_i(v) - C_o F_o(v), \quad P = B^T F_i(v)

    with the place v of the inner groove against the outer one, the ring place a, forces on balls F_i
    and on the outer race F_o with balls in balance, and compliances of grooves C, which follow the contact
    angles.

    Source
    ------
    Virtual work, balls eliminated from the ring and the grooves; derived here.
    """
    with np.errstate(all="ignore"):  # places tried on the way may overflow: such a step is not taken
        return as_solution(balance, *_last(_steps(balance, grooves)))


def iterate_elastic(
    balance: AngularBalance, grooves: ElasticGrooves
) -> Iterator[tuple[ElasticSolution, bool]]:
    """Newton iterates of one case, as if in balance, and whether they are what `solve_elastic` gives."""
    steps, last, equations = _steps(balance, grooves), False, balance.of_whole_contacts
    while not last:
        with np.errstate(all="ignore"):
            try:
                state, outcomes = next(steps), [SolverOutcome.CONVERGED]
            except StopIteration as end:
                (state, outcomes), last, equations = end.value, True, balance
        yield as_solution(equations, state, outcomes), last


def _steps(balance: AngularBalance, grooves: ElasticGrooves) -> Steps:
    """States from round grooves on, shoulders last."""
    whole = balance.of_whole_contacts
    state, outcomes = yield from _whole_steps(whole, grooves)
    if balance.races is None:
        return state, outcomes
    over = balance.over_shoulders(_balls(whole, state))
    for case in np.flatnonzero(over > 0):
        if outcomes[case] is not SolverOutcome.CONVERGED:
            continue
        one, begin, before = (
            balance.take(np.array([case])),
            state.of(np.array([case])).places,
            float(over[case]),
        )
        trial, ended = _last(_newton(one, grooves, begin))
        closer = partial(_closer, one, grooves, before)
        _by_parts(closer, begin, trial, ([SolverOutcome.CONVERGED], ended), softening=False)
        trial.evaluations[:] += state.evaluations[case]
        if ended[0] is SolverOutcome.CONVERGED:
            state.put(np.array([case]), trial._replace(whole_ring=begin.ring))
        else:
            outcomes[case] = SolverOutcome.OVER_SHOULDER
    return state, outcomes


def _closer(
    balance: AngularBalance, grooves: ElasticGrooves, over: float, part: float
) -> tuple[AngularBalance, ElasticGrooves]:
    """Equations with shoulders that cut off a part of what reaches over them [rad]."""
    return balance.withdrawn((1.0 - part) * over), grooves


def _balls(balance: AngularBalance, state: State) -> BallBalance:
    """Balls of a state where they are."""
    return balance.balls(balance.grooves(state.ring) + state.places.shape, state.centres)


def _whole_steps(balance: AngularBalance, grooves: ElasticGrooves) -> Steps:
    """States with whole contacts: from where balls of rigid rings start, else from their balance."""
    is_round = not balance.bearing.approaches
    first = balance if is_round else balance.out_of_round(0.0)
    state, outcomes = yield from _newton(first, grooves, _in_round_grooves(*start(first)))
    held = [
        outcome is SolverOutcome.CONVERGED and holds(stiffness, ~fixed)
        for outcome, stiffness, fixed in zip(outcomes, state.stiffness, balance.held, strict=True)
    ]
    failed = np.flatnonzero(~np.array(held))
    if len(failed):
        other, ended = yield from _from_rigid_rings(first.take(failed), grooves)
        other.evaluations[:] += state.evaluations[failed]
        state.put(failed, other)
        for case, outcome in zip(failed, ended, strict=True):
            outcomes[case] = outcome
    if not is_round:
        known, begin = outcomes, state.places
        spent = state.evaluations
        state, outcomes = yield from _newton(balance, grooves, begin)
        ended = known, outcomes
        _by_parts(lambda part: (balance.out_of_round(part), grooves), begin, state, ended, softening=False)
        outcomes = _after(known, outcomes)
        state.evaluations[:] += spent
    return state, outcomes


def _from_rigid_rings(balance: AngularBalance, grooves: ElasticGrooves) -> Steps:
    """States from the balance between rigid rings on, whose grooves become softer where they must."""
    rigid = solve(balance)
    begin = _in_round_grooves(rigid.ring, rigid.centres)
    state, outcomes = yield from _newton(balance, grooves, begin)
    ended = rigid.outcomes, outcomes
    _by_parts(lambda part: (balance, grooves.softened(part)), begin, state, ended, softening=True)
    state.evaluations[:] += rigid.evaluations
    return state, _after(rigid.outcomes, outcomes)


def _in_round_grooves(ring: NDArray, centres: Vectors) -> Places:
    """Places of ring and balls, grooves as they are without load."""
    rest = np.zeros((len(ring), 2, centres.shape[1]), complex)
    return Places(ring, rest, rest, centres)


def _last(steps: Steps) -> tuple[State, list[SolverOutcome]]:
    """The state that steps end with, and how each case ended."""
    while True:
        try:
            next(steps)
        except StopIteration as end:
            return end.value


def _after(known: list[SolverOutcome], outcomes: list[SolverOutcome]) -> list[SolverOutcome]:
    """Outcomes of what began where others ended: theirs, where they found no balance."""
    return [
        each if before is SolverOutcome.CONVERGED else before
        for each, before in zip(outcomes, known, strict=True)
    ]


def _by_parts(
    equations: Equations, begin: Places, state: State,
    outcomes: tuple[list[SolverOutcome], list[SolverOutcome]], *, softening: bool,
) -> None:  # fmt: skip
    """Find what Newton's method did not, from where the cases began, by `equations` of growing parts."""
    known, ended = outcomes
    for case, outcome in enumerate(ended):
        if outcome in ANSWERED or known[case] is not SolverOutcome.CONVERGED:
            continue
        one = np.array([case])

        def of_case(part: float, one: NDArray = one) -> tuple[AngularBalance, ElasticGrooves]:
            balance, grooves = equations(part)
            return balance.take(one), grooves

        places = Places(*(array[one] for array in begin))
        reached, part, turns_back = _continuation(of_case, places, softening=softening)
        evaluations = state.evaluations[case] + reached.evaluations[0]
        if part == 1.0:
            ended[case] = SolverOutcome.CONVERGED
        elif softening:
            ended[case] = SolverOutcome.TOO_SOFT if turns_back else SolverOutcome.STALLED
        if ended[case] in (SolverOutcome.CONVERGED, SolverOutcome.TOO_SOFT):
            state.put(one, reached)
        state.evaluations[case] = evaluations


@np.errstate(all="ignore")  # a case that ended not finite has no forces
def as_solution(balance: AngularBalance, state: State, outcomes: list[SolverOutcome]) -> ElasticSolution:
    """Forces and displacements of a state in balance."""
    balls = _balls(balance, state)
    forces = balls, RingBalance(state.excess_after, state.stiffness, state.carried)
    rings = RingSolution(state.ring, state.centres, outcomes, state.imbalance, state.evaluations, forces)
    rings = replace(rings, whole_ring=state.whole_ring)
    return ElasticSolution(rings, state.grooves[..., None].view(float))


def _continuation(equations: Equations, places: Places, *, softening: bool) -> tuple[State, float, bool]:
    r"""Balance of one case at the largest part of its equations that is reached step by step, and this part.

    The last says whether the balances turn back there, at a limit point (fold), where the determinant of the
    tangent stiffness is

    .. math:: |J| \propto \sqrt{\lambda_c - \lambda}

    The evaluations of the state are those of all steps.

    Source
    ------
    Taylor series about a quadratic turning point; derived here.
    """
    balance, grooves = equations(0.0)
    reached, part, step, count = _at(balance, grooves, places), 0.0, 0.25, 0
    sizes = [(part, _size_of_tangent(balance, reached))]
    while part < 1.0 and step >= LEAST_STEP:
        further = min(1.0, part + step)
        balance, grooves = equations(further)
        kept = part / further if softening else 1.0  # what bends softer grooves as far
        begin = reached.places._replace(pressing=kept * reached.pressing)
        trial, (outcome,) = _last(_newton(balance, grooves, begin))
        count += int(trial.evaluations[0])
        if outcome is SolverOutcome.CONVERGED:
            reached, part, step = trial, further, 2 * step
            sizes.append((part, _size_of_tangent(balance, trial)))
        else:
            step /= 2
    reached.evaluations[:] = count
    return reached, part, _turns_back(sizes[-2:])


def _size_of_tangent(balance: AngularBalance, state: State) -> float:
    """Logarithm of the determinant of ring and grooves of one case, without its sign."""
    deflection, free = state.deflection_by_moves[0], ~balance.held[0]
    grooves = np.eye(deflection.shape[-1]) + np.nan_to_num(deflection[1] - deflection[0])
    ring = np.nan_to_num(state.stiffness[0][np.ix_(free, free)])
    return float(np.linalg.slogdet(grooves).logabsdet + np.linalg.slogdet(ring).logabsdet)


def _turns_back(sizes: list[tuple[float, float]]) -> bool:
    """Whether the square of the determinant of two parts falls in a line to zero just beyond them."""
    (before, first), (part, last) = sizes[0], sizes[-1]
    left = np.exp(min(2 * (last - first), 0.0))
    return bool(left < 1.0 and (part - before) * left / (1 - left) <= NEAR_LIMIT)


def _newton(balance: AngularBalance, grooves: ElasticGrooves, begin: Places) -> Steps:
    """Damped Newton of ring and grooves, all cases side by side; a case leaves as soon as it ends."""
    outcomes, cases = [SolverOutcome.RUNNING] * len(begin.ring), np.arange(len(begin.ring))
    state, gained = _at(balance, grooves, begin, BALL_SHARE), np.full(len(cases), True)
    halved, least, without = gained, np.full(len(cases), np.inf), np.zeros(len(cases), int)
    whole = state.of(cases)  # arrays of its own
    for number in range(LIMIT + 1):
        without[cases] = np.where(state.imbalance < least[cases], 0, without[cases] + 1)
        least[cases] = np.fmin(least[cases], state.imbalance)
        going = (gained | (state.imbalance <= LIGHT)) & (without[cases] < PATIENCE)
        for case, left, goes, better in zip(cases, state.imbalance, going, halved, strict=True):
            outcomes[case] = _outcome(balance, left, TOLERANCE if better else ROUNDED, goes, number == LIMIT)
        running = np.array([outcomes[case] is SolverOutcome.RUNNING for case in cases])
        if not running.any():
            break
        if number:
            yield whole
        cases, balance = cases[running], balance if running.all() else balance.take(running)
        last = state if running.all() else state.of(running)
        state, gained = _next(balance, grooves, last)
        halved = state.imbalance < last.imbalance / 2
        rounded = ~halved & (last.imbalance <= ROUNDED)
        if rounded.any():
            state.put(rounded, last.of(rounded))
        if len(cases) == len(outcomes):
            whole = state
        else:
            whole.put(cases, state)
    return whole, outcomes


def _outcome(balance: AngularBalance, left: float, tolerance: float, goes: bool, last: bool) -> SolverOutcome:
    if not np.isfinite(left):
        return SolverOutcome.NOT_FINITE
    if left <= max(tolerance, balance.control.noise):
        return SolverOutcome.CONVERGED
    if not goes:
        return SolverOutcome.STALLED
    return SolverOutcome.LIMIT if last else SolverOutcome.RUNNING


def _next(balance: AngularBalance, grooves: ElasticGrooves, state: State) -> tuple[State, NDArray]:
    """State after a Newton step, each case halving it until it does not run far past the balance."""
    step = stiffened_step(balance, state.excess_after, state.stiffness, FLOATING)
    steps, against = state.steps(step), state.moves(step).view(complex)
    longest = LONGEST * min(balance.bearing.inner_reach, balance.bearing.outer_reach)
    damping = 1 / np.maximum(np.abs(against).max(1) / longest, 1.0)
    last, trial = SHORTEST * damping, state
    ahead = np.abs(state.work(step, steps.grooves))
    trying, gained = np.arange(len(damping)), np.zeros(len(damping), bool)
    while len(trying):
        part, some = damping[trying], balance if len(trying) == len(damping) else balance.take(trying)
        ring, moved_grooves, pressing, follow = (
            (part * array[trying].T).T
            for array in steps  # along the cases
        )
        at = Places(
            state.ring[trying] + ring,
            state.grooves[trying] + moved_grooves,
            state.pressing[trying] + pressing,
            along_arc(state.centres[trying], follow),
        )
        candidate = _at(some, grooves, at, BALL_SHARE * state.imbalance[trying])
        candidate.evaluations[:] += trial.evaluations[trying]
        if len(trying) == len(damping):
            trial = candidate
        else:
            trial.put(trying, candidate)
        left = candidate.work(step[trying], steps.grooves[trying])
        good = (left >= -0.5 * ahead[trying]) | (candidate.imbalance < 0.5 * state.imbalance[trying])
        good &= np.isfinite(candidate.imbalance)
        gained[trying] = good
        damping[trying] /= 2
        trying = trying[~good & (damping[trying] >= last[trying])]
    return trial, gained


def _at(
    balance: AngularBalance, grooves: ElasticGrooves, places: Places, share: NDArray | float = 0.0
) -> State:
    """Ring and grooves at a place, balls in balance up to a share (C) of the largest force."""
    at = balance.grooves(places.ring) + places.shape
    result = balance_balls(balance, at, places.centres, share)
    return _with_balls(balance, grooves, places, result, exact=False)


def unmoved(balance: AngularBalance, grooves: ElasticGrooves, places: Places) -> State:
    """Ring, grooves and balls near their balance, where they are."""
    result = at_places(balance, balance.grooves(places.ring) + places.shape, places.centres)
    return _with_balls(balance, grooves, places, result, exact=True)


def _with_balls(
    balance: AngularBalance, grooves: ElasticGrooves, places: Places, result: BallsInBalance, *, exact: bool
) -> State:
    """Forces and derivatives with balls as they are; `exact` to first order in what they still have to move.

    Newton's method needs light balls that stay and contact angles that wait for the balls: slopes do not
    reach far there.
    """
    at, balls = balance.grooves(places.ring) + places.shape, result.balls
    ball_moves, follow = moves_left(result)
    if not exact:
        ball_moves[result.left <= result.scales.allowed()] = 0.0
    turns = _turns(at, result.centres, np.concatenate([ball_moves[None], follow]))
    if not exact:
        turns[..., 0] = 0.0
    forces, by_moves = _on_races(balance, result, at, ball_moves, follow)
    displaced, deflection_by_moves = _displaced(grooves, balls, forces, by_moves, turns)
    misfit = places.grooves.view(float).reshape(displaced.shape) - displaced
    to_groove = np.stack([balance.ring_to_groove.real, balance.ring_to_groove.imag], 1).reshape(-1, 5)
    closing = misfit[:, 1] - misfit[:, 0]
    columns = np.concatenate([np.tile(to_groove, (len(at), 1, 1)), closing[..., None]], axis=-1)
    relative_deflection = deflection_by_moves[:, 1] - deflection_by_moves[:, 0]
    relative_moves = np.linalg.solve(
        np.eye(relative_deflection.shape[1]) + np.nan_to_num(relative_deflection), columns
    )
    by_traction = balls.by_groove[:, 2] + moved(balls.by_ball[:, 2, None], follow[:, None])[:, 0]
    changes = _on_ring(balance, -by_moves[:, 0], by_traction, relative_moves)
    ring = balance.ring(balls, follow)
    left = forces_left(balance, result, ring, ball_moves)
    misfit_force = np.abs(by_moves).max((1, 2, 3, 4)) * np.abs(closing).max(1)
    imbalance = np.maximum(misfit_force, left.force) / left.largest
    return State(
        *places._replace(centres=result.centres),
        ball_moves=ball_moves,
        follow=follow.swapaxes(0, 1),
        forces=forces,
        by_moves=by_moves,
        misfit=misfit,
        deflection_by_moves=deflection_by_moves,
        excess=left.excess,
        excess_after=np.where(balance.held, 0.0, left.excess - changes[..., 5]),
        stiffness=changes[..., :5],
        carried=ring.carried,
        by_ring=relative_moves[..., :5],
        closing=relative_moves[..., 5],
        imbalance=np.where(result.done, imbalance, np.inf),
        evaluations=np.full(len(at), result.evaluations),
        whole_ring=places.ring.copy(),
    )


def _on_races(
    balance: AngularBalance, result: BallsInBalance, at: Vectors, ball_moves: Vectors, follow: Vectors
) -> tuple[Vectors, NDArray]:
    """Forces on both races (C, 2, Z) once the balls have moved, and their change (C, 2, Z, 2, 2) by moves.

    The outer race carries the centrifugal force, too.
    """
    balls = result.balls
    on_ball = balls.forces[1] + moved(balls.by_ball[:, 1], ball_moves)
    by_relative_moves = _real(balls.by_groove[:, 1] + moved(balls.by_ball[:, 1, None], follow[:, None])[:, 0])
    pulled, pulled_by_ball = balance.centrifugal_by_place(balls, at, result.centres)
    pull = balls.kinematics.centrifugal + moved(pulled_by_ball, ball_moves)
    outer = by_relative_moves.copy()
    outer[:, :, 1] += np.moveaxis(pulled + moved(pulled_by_ball[:, None], follow), 0, -1)
    return np.stack([-on_ball, on_ball + 1j * pull], 1), np.stack([-by_relative_moves, outer], 1)


def _displaced(
    grooves: ElasticGrooves, balls: BallBalance, forces: Vectors, by_moves: NDArray, turns: NDArray
) -> tuple[NDArray, NDArray]:
    """Where forces displace both grooves to (C, 2, 2 Z) [m], and its change by moves (C, 2, 2 Z, 2 Z).

    Forces are those once the balls have moved; `turns` are as `_turns` gives them.
    """
    cases, _, count = forces.shape
    displaced = np.zeros((cases, 2, 2 * count))
    deflection_by_moves = np.zeros((cases, 2, 2 * count, 2 * count))
    for race, groove in enumerate(grooves):
        if groove is None:
            continue
        shape = shape_of(groove, balls.contacts.angles[race], forces[:, race])
        pressed = np.concatenate([np.zeros((cases, count, 2, 1)), by_moves[:, race]], axis=3)
        change = shape.after(np.concatenate([pressed, turns[race][:, :, None]], axis=2))
        displaced[:, race] = (shape.moved + change[:, :, 0].sum(1)).reshape(cases, -1)
        deflection_by_moves[:, race] = change[:, :, 1:].reshape(cases, 2 * count, -1).swapaxes(1, 2)
    return displaced, deflection_by_moves


def _on_ring(
    balance: AngularBalance, by_relative_moves: NDArray, by_traction: Vectors, moves: NDArray
) -> NDArray:
    """Change of the load that is carried (C, 5, Q) by moves of grooves against each other (C, 2 Z, Q)."""
    each = moves.reshape(len(moves), -1, 2, moves.shape[-1])
    force = by_relative_moves @ each
    traction = np.einsum("acz,czaq->czq", by_traction.real, each)
    carried = (balance.groove_to_ring.T @ (force[:, :, 0] + 1j * force[:, :, 1])).real
    return carried - balance.ring_to_lever.T @ traction


def _turns(grooves: Vectors, centres: Vectors, ball_moves: Vectors) -> NDArray:
    """Change of the contact angles (2, C, Z, 3) by moves of the balls (3, C, Z).

    The first [rad] is what the balls still have to move, then follow those that come with an axial and with a
    radial move of the groove [rad/m].
    """
    groove_moves, turns = np.array([0, 1, 1j])[:, None, None], []
    for arm, moves in ((grooves - centres, groove_moves - ball_moves), (centres, ball_moves)):
        along = groove_arm(arm)
        length = np.abs(along)
        tangent = (along / length) * -1j  # e^(-i alpha), towards growing angles
        turns.append(np.where(turning(arm), (tangent.conj() * moves).real, 0.0) / length)
    return np.moveaxis(np.array(turns), 1, -1)


def _real(by_groove: Vectors) -> NDArray:
    """Derivatives of a vector by an axial and a radial move (2, C, Z), complex, as matrices (C, Z, 2, 2)."""
    return np.moveaxis(np.stack([by_groove.real, by_groove.imag]), (2, 3), (0, 1))


def _pairs(vectors: NDArray) -> NDArray:
    """Real vectors (C, 2 Z) ball by ball (C, Z, 2)."""
    return vectors.reshape(len(vectors), -1, 2)


def _vectors(pairs: NDArray) -> Vectors:
    """Complex vectors (C, 2, Z) from columns (C, 2, Z, 2, 1)."""
    return pairs[..., 0, 0] + 1j * pairs[..., 1, 0]
