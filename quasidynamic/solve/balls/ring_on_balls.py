"""Balance of a ring on balls, by one search after the other."""

from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.angular_contact import AngularBalance
from quasidynamic.balance.balls.ball_position import Vectors
from quasidynamic.solve.balls.cage_speed import by_cage_speed
from quasidynamic.solve.balls.coulomb_control import CoulombControl
from quasidynamic.solve.balls.frozen_solve import frozen_solve
from quasidynamic.solve.balls.inertia_homotopy import inertia_homotopy
from quasidynamic.solve.balls.ring_newton import ANSWERED, BUDGET, RingSolution, newton, solution_at
from quasidynamic.solve.balls.ring_on_springs import first_place
from quasidynamic.solve.step_length import SolverOutcome

SLOWER = (0.7, 0.3, 0.1, 0.01)  # parts of the speed from which Newton's method is tried once more
LEAST_SPEED_STEP = 2e-3  # part of the speed by which rings become faster at least
FIRST = 3  # parts of the budget: for the first search, as others are quicker where it does not succeed soon
LEAST_PART = 1e-2  # of what shoulders cut off: by which they close in on contacts at least


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
        searches = (partial(by_cage_speed, solve=_solve),)  # no other one succeeds where it does not
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
    return solution_at(balance, places, count), count + 1
