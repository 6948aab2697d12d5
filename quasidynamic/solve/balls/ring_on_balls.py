"""Newton's method for a ring on balls that find their own balance."""

from dataclasses import dataclass, replace

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
from quasidynamic.solve.balls.coulomb_control import CoulombControl
from quasidynamic.solve.balls.frozen_solve import frozen_solve
from quasidynamic.solve.balls.inertia_homotopy import BudgetSpent, inertia_homotopy
from quasidynamic.solve.balls.ring_on_springs import first_place, newton_step
from quasidynamic.solve.step_length import SolverOutcome

TOLERANCE = 1e-11  # of the largest force: unbalanced force on the ring
LIMIT = 60  # Newton steps of the ring, rarely more than ten
BALL_SHARE = 0.1  # of the imbalance before a step: what the balls may leave to the next one
SHORTEST = 2.0**-6  # part of a Newton step; a path of growing inertia is quicker than shorter ones
TOUCHING = 10  # times what may be left: least load that counts as contact of the ring
SLOWER = (0.7, 0.3, 0.1, 0.01)  # parts of the speed from which Newton's method is tried once more
LEAST_SPEED_STEP = 2e-3  # part of the speed by which rings become faster at least
BUDGET = 12000  # evaluations of all balls in one search, of closed forms, rarely more than two thousand
FIRST = 3  # parts of that: for the first search, as others are quicker where it does not succeed soon
FIRST_CAGE_STEP = 0.01  # of the speed of the rings: first step of a cage from rolling, each next five times
CAGE_STARTS = (1.0, 0.995, 0.95, 0.7)  # of the speed of rolling, of which the first with a balance is taken
LEAST_CAGE_STEP = 1e-4  # the same of shorter ones, where balls have no balance
SLOW_CAGE = 1e-3  # of the same: speed from which a cage may turn round
CLOSE = 0.1  # of the speed of a cage: step by which its balls move as by closed forms
SPEEDS = 6  # of a cage at least that twice the budget of other searches is enough for, mostly fewer than ten
LEAST_PART = 1e-2  # of what shoulders cut off: by which they close in on contacts at least
NEARLY = 1e-8  # of the torques around a cage: what is left where all may be in balance
CAGE_SPEED_ERROR = 1e-13  # of the speed of the rings
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


def solve(balance: AngularBalance) -> RingSolution:
    """Balance of all cases: in one go, else from rest, along a path of growing inertia, from slower rings.

    Or, of balls in a cage, by the speed of the cage. Where shoulders cut contacts off, from whole contacts.
    """
    whole = balance.of_whole_contacts
    with np.errstate(all="ignore"):  # places tried on the way may overflow: such a step is not taken
        solution = _solve(whole)
        return solution if balance.races is None else _on_shoulders(balance, whole, solution)


def _on_shoulders(balance: AngularBalance, whole: AngularBalance, solution: RingSolution) -> RingSolution:
    """Balance with the contacts cut off that reach over shoulders as whole ones."""
    over = balance.over_shoulders(solution.forces(whole)[0])
    reaching = np.array([outcome is SolverOutcome.CONVERGED for outcome in solution.outcomes]) & (over > 0)
    if not reaching.any():
        return solution
    outcomes, pieces, whole_ring = list(solution.outcomes), {}, solution.ring.copy()
    for case in np.flatnonzero(reaching):
        piece, count = _as_shoulders_close(balance.take(np.array([case])), solution, case, float(over[case]))
        solution.evaluations[case] += count
        if piece is None:
            outcomes[case] = SolverOutcome.OVER_SHOULDER
        else:
            pieces[case] = piece
    return replace(_replaced(solution, pieces, outcomes), whole_ring=whole_ring)


def _as_shoulders_close(
    balance: AngularBalance, whole: RingSolution, case: np.intp, over: float
) -> tuple[RingSolution | None, int]:
    """Balance of one case as shoulders close in on whole contacts, which reach over them [rad]; else None.

    And evaluations.
    """
    near = None if whole.near is None else whole.near[case, None]
    places, part, step, count = (whole.ring[case, None], whole.centres[case, None], near), 0.0, 1.0, 0
    budget = BUDGET // FIRST // balance.control.cost
    while step >= LEAST_PART:
        further = min(1.0, part + step)
        trial = newton(balance.withdrawn((1.0 - further) * over), *places, budget=budget)
        count += int(trial.evaluations[0])
        if trial.outcomes[0] is not SolverOutcome.CONVERGED:
            step /= 4
            continue
        if further == 1.0:
            return trial, count
        places, part, step = (trial.ring, trial.centres, trial.near), further, 2 * step
    return None, count


def _solve(balance: AngularBalance) -> RingSolution:
    budget = BUDGET // FIRST // balance.control.cost
    solution = newton(balance, *start(balance), budget=budget)
    failed = np.flatnonzero([outcome not in ANSWERED for outcome in solution.outcomes])
    if not len(failed):
        return solution
    outcomes, pieces = list(solution.outcomes), {}
    for case in failed:
        piece, count = _sought_elsewhere(balance.take(np.array([case])))
        solution.evaluations[case] += count
        if piece is not None:
            pieces[case], outcomes[case] = piece, piece.outcomes[0]
    return _replaced(solution, pieces, outcomes)


def _replaced(
    solution: RingSolution, pieces: dict[int, RingSolution], outcomes: list[SolverOutcome]
) -> RingSolution:
    """A solution with other ones of some of its cases."""
    for case, piece in pieces.items():
        for name in ("ring", "centres", "imbalance", "near"):
            getattr(solution, name)[case] = getattr(piece, name)[0]
    return replace(solution, outcomes=outcomes, last_forces=None)


def _sought_elsewhere(balance: AngularBalance) -> tuple[RingSolution | None, int]:
    """Balance of one case that Newton's method does not find, else None, and evaluations."""
    control, (inner, outer) = balance.control, balance.speeds[:, 0, 0]
    searches = (along_path, from_slower_rings)
    if isinstance(control, CoulombControl) and control.in_one_cage and inner != outer:
        searches = (by_cage_speed,)  # no other one is known to succeed where it does not
    elif control.simpler is not None:
        searches = (from_rest, *searches)
    evaluations = 0
    for search in searches:
        piece, count = search(balance)
        evaluations += count
        if piece is not None:
            return piece, evaluations
    return None, evaluations


def start(balance: AngularBalance) -> tuple[NDArray, Vectors]:
    """First places of ring and balls: on springs, then under the forces that inertia has there.

    Or the balance under a simpler race control, where there is one.
    """
    if balance.control.simpler is not None:
        solution = _solve(replace(balance, control=balance.control.simpler))
        return solution.ring, solution.centres
    ring = first_place(balance)
    grooves = balance.grooves(ring)
    centres = balance.places.resting(grooves)
    if (balance.free_centrifugal > 0).any():
        ring, centres = frozen_solve(balance, (ring, centres), inertia_forces(balance, ring, centres))
    return ring, centres


def inertia_forces(balance: AngularBalance, ring: NDArray, centres: Vectors) -> tuple[Vectors, NDArray]:
    """Centrifugal forces and tractions on the balls (C, Z), their part of the load (C, 5) [N]."""
    balls = balance.balls(balance.grooves(ring), centres)
    return balls.pull, balance.dragged(balls)


def from_rest(balance: AngularBalance) -> tuple[RingSolution | None, int]:
    """Balance of one case by Newton's method from the place of a ring at rest, else None, and evaluations.

    Balls that friction cannot drive stay behind and have little inertia: those of a race control, which roll,
    lead away from such a balance.
    """
    known = newton(balance, *start(replace(balance, speeds=0.0 * balance.speeds)))
    converged = known.outcomes[0] is SolverOutcome.CONVERGED
    return known if converged else None, int(known.evaluations[0])


def from_slower_rings(balance: AngularBalance) -> tuple[RingSolution | None, int]:
    """Balance of one case by Newton's method from that of slower rings, else None, and evaluations.

    Slower rings have the ratio of inertia to load that a heavier load has at the full speed. The search
    ends when it has spent half of `BUDGET`, being quicker where it succeeds.
    """
    count, budget = 0, BUDGET // 2 // balance.control.cost
    for share in SLOWER:
        slow = replace(balance, speeds=share * balance.speeds)
        known = newton(slow, *start(slow))
        step, count = (1.0 - share) / 4, count + int(known.evaluations[0])
        if known.outcomes[0] is not SolverOutcome.CONVERGED:
            continue
        while share < 1.0 and step >= LEAST_SPEED_STEP and count < budget:
            faster = min(1.0, share + step)
            trial = newton(
                replace(balance, speeds=faster * balance.speeds), known.ring, known.centres, known.near
            )
            count += int(trial.evaluations[0])
            if trial.outcomes[0] is SolverOutcome.CONVERGED:
                share, known, step = faster, trial, 2 * step
            else:
                step /= 2
        if share == 1.0:
            return known, count
        if count >= budget:
            break
    return None, count


def along_path(balance: AngularBalance) -> tuple[RingSolution | None, int]:
    """Balance of one case at the end of a path of growing inertia, else None, and evaluations."""
    places, count = inertia_homotopy(balance, BUDGET // balance.control.cost)
    if places is None:
        return None, count
    ring, centres = places
    state = _at(balance, ring, at_places(balance, balance.grooves(ring), centres))
    outcome = _outcome(balance, state, 0, 1.0, last=True)
    return RingSolution(
        ring, centres, [outcome], state.imbalance, np.array([count]), near=state.near
    ), count + 1


def by_cage_speed(balance: AngularBalance) -> tuple[RingSolution | None, int]:
    r"""Balance of one case by the speed of its only cage, else None, and evaluations.

    .. math:: M(\omega_c) = \sum_j M_{pj} + M_{land} = 0

    At a given speed of the cage balls have the centrifugal force of that speed and are in balance one by one:
    from rolling down to rest the place of the ring is a smooth function of it, also where that place turns
    back, as balls that become faster push the ring away. M drives a cage at rest and brakes one that rolls,
    but where a land does more: with one sign on either side there is a balance between.

    Source
    ------
    A fold passed by a parameter that it does not turn back in, as in Allgower and Georg, Introduction to
    Numerical Continuation Methods (2003), ch. 6; the zero by Brent's method.
    """
    from scipy.optimize import brentq  # takes long to load, for a search that few bearings need

    held = _HeldCage(balance)
    try:
        speed, torque = held.begin()
        step = FIRST_CAGE_STEP
        while step > LEAST_CAGE_STEP:
            further = speed + np.sign(torque) * step
            if further * speed < 0 and abs(speed) > SLOW_CAGE:
                further = speed / 5
            there = held.torque(further)
            if there * torque < 0:
                brentq(held.known_torque, speed, further, xtol=CAGE_SPEED_ERROR)
                break
            if np.isfinite(there):
                speed, torque, step = further, there, 5 * step
            else:
                step = abs(further - speed) / 4
    except _Balanced as balanced:
        return balanced.solution, held.evaluations
    except (_Lost, BudgetSpent):
        pass
    return None, held.evaluations


class _Lost(Exception):
    """Ring and balls have no known balance at a speed of the cage."""


class _Balanced(Exception):
    """A cage of the speed that was tried is in balance, too."""

    def __init__(self, solution: RingSolution):
        self.solution = solution


class _HeldCage:
    """One case at speeds of its cage that are given, over that of the inner against the outer ring."""

    def __init__(self, balance: AngularBalance):
        assert isinstance(balance.control, CoulombControl)
        self.balance, self.control = balance, balance.control
        self.evaluations = 0
        self.ahead = (balance.speeds[0] - balance.speeds[1]).item()
        self.known: dict[float, tuple[RingSolution, RingSolution]] = {}  # balances, the same of closed forms
        self.torques: dict[float, float] = {}
        self.simpler = replace(balance, control=self.control.simpler)
        balls, _ = self._closed(1.0).forces(self.simpler)
        load, orbit = balls.loads.min(0), balls.kinematics.orbit
        self.rolling = float(np.average(orbit, weights=load if load.any() else None)) / self.ahead

    def torque(self, speed: float) -> float:
        """M over the sum of the torques on rings and pockets; not a number without a balance of the balls.

        Raises `_Balanced` where M vanishes, `BudgetSpent`.
        """
        if speed not in self.torques:
            self.torques[speed] = self._torque(speed)
        return self.torques[speed]

    def known_torque(self, speed: float) -> float:
        """M as above; raises `_Lost` without a balance of the balls."""
        if not np.isfinite(torque := self.torque(speed)):
            raise _Lost
        return torque

    def begin(self) -> tuple[float, float]:
        """A speed near that of rolling, and M; raises `_Lost` without a balance of the balls there."""
        for part in CAGE_STARTS[:-1]:
            if np.isfinite(torque := self.torque(part * self.rolling)):
                return part * self.rolling, torque
        return CAGE_STARTS[-1] * self.rolling, self.known_torque(CAGE_STARTS[-1] * self.rolling)

    def _torque(self, speed: float) -> float:
        control = replace(self.control, cage_speed=speed)
        balance = replace(self.balance, control=control)
        solution = self._solved(balance, speed)
        if solution is None:
            return np.nan
        balls, _ = solution.forces(balance)
        oil = control.oiled(balls.contacts, balance.speeds, balance.free_centrifugal, solution.near)
        pitch = balance.bearing.pitch_diameter / 2
        size = np.abs(oil.ring_torque).sum() + pitch * np.abs(oil.pocket_force).sum()
        left = float((oil.land_torque - oil.pocket_torque).sum() / size)
        if abs(left) <= NEARLY:
            self._raise_if_balanced(solution)
        return np.sign(self.ahead) * left

    def _raise_if_balanced(self, solution: RingSolution) -> None:
        balance, grooves = self.balance, self.balance.grooves(solution.ring)
        state = _at(balance, solution.ring, at_places(balance, grooves, solution.centres, near=solution.near))
        outcome = _outcome(balance, state, 0, 1.0, last=True)
        self.evaluations += 1
        if outcome in ANSWERED:
            raise _Balanced(
                replace(
                    solution,
                    outcomes=[outcome],
                    imbalance=state.imbalance,
                    evaluations=np.array([self.evaluations]),
                    last_forces=None,
                    near=state.near,
                )
            )

    def _solved(self, balance: AngularBalance, speed: float) -> RingSolution | None:
        """Balance at a speed, from that by closed forms for slower rings and from the nearest speed."""
        closed = self._closed(abs(speed / self.rolling))
        starts, motion = [(closed.ring, closed.centres)], None
        if self.known:
            nearest = min(self.known, key=lambda known: abs(known - speed))
            near, like = self.known[nearest]
            starts, motion = [*starts, (near.ring, near.centres)], near.near
            if abs(nearest - speed) <= CLOSE * abs(speed):
                moved = closed.ring - like.ring, closed.centres - like.centres
                starts.insert(0, (near.ring + moved[0], near.centres + moved[1]))
        for start in starts:
            if self.evaluations >= (budget := 2 * BUDGET // balance.control.cost):
                raise BudgetSpent
            solution = newton(balance, *start, motion, budget=budget // SPEEDS)
            self.evaluations += int(solution.evaluations[0])
            if solution.outcomes[0] in ANSWERED:
                self.known[speed] = solution, closed
                return solution
        return None

    def _closed(self, part: float) -> RingSolution:
        """Balance of rings at a part of their speed, of balls by closed forms."""
        return _solve(replace(self.simpler, speeds=part * self.balance.speeds))


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
    if not free.any():
        return True
    scales = np.linalg.svd(state.balance.stiffness[case][np.ix_(free, free)], compute_uv=False)
    touching = state.pressing[case] > TOUCHING * tolerance_of(balance)
    return bool(touching and scales.min() > SINGULAR * scales.max())


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
    balls, scales = result.balls, result.scales
    moves = -resolved(balls, np.concatenate([balls.excess[None], balls.by_groove[:, 0]]))
    ball_moves, follow = moves[0], moves[1:]
    ball_moves[result.left <= scales.allowed()] = 0.0  # slopes of light balls do not reach far
    forces = balance.ring(balls, follow)
    _, force, traction = moved(balls.by_ball, ball_moves)
    excess = np.where(balance.held, 0.0, forces.excess - balance.on_ring(force, traction))
    tolerance = tolerance_of(balance)
    largest = np.maximum(np.maximum(scales.largest, scales.noise / tolerance), TINY)
    left = result.left.max(1)
    near = left[:, None] <= scales.allowed(tolerance)
    counted = np.where(near, forces.excess, excess)  # no balance by what balls would do
    return _RingState(
        ring=ring,
        centres=result.centres,
        ball_moves=ball_moves,
        balls=balls,
        follow=follow,
        near=balls.kinematics.near,
        balance=forces._replace(excess=excess),
        balls_done=result.done,
        imbalance=np.maximum(np.abs(counted).max(1), left) / largest,
        pressing=balls.loads[0].max(1) / largest,
        evaluations=result.evaluations,
    )


def followed(balls: BallBalance) -> NDArray:
    """Move of a ball per axial and per radial move of its groove (2, C, Z), by implicit differentiation."""
    return -resolved(balls, balls.by_groove[:, 0])
