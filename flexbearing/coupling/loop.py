"""The coupling iteration as a generator, and when it stops."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Generic, Literal

import numpy as np
from numpy.typing import NDArray

from flexbearing.coupling.acceleration import Rule
from flexbearing.coupling.history import CouplingHistory
from flexbearing.coupling.line_search import Tangent, next_tangent
from flexbearing.coupling.partners import Bearing, Iterating, LinearStructure, PartnerFailed, S, Structure

Status = Literal["", "converged", "iteration limit", "diverging", "stagnating", "not finite", "not solved"]

# Diverging: a residual grew so often in a row and is so much above the first, or above the smallest. Aitken's
# method jumps, but not five times.
DIVERGENCE_RATIO = 10.0
GROWTHS_OVER_FIRST, GROWTHS_OVER_LEAST = 3, 5
# Stagnating: so many iterations without a residual below this part of the smallest before them.
STAGNATION_LIMIT, STAGNATION_RATIO = 40, 0.9
MOST_TANGENTS = 40  # of a structure that is not linear
BALANCED = 1e-10  # unbalanced force over the load at which newton has nothing left to improve
_REASONS = {
    "diverging": "diverging iterations are stopped: the structure is too soft for a fixed-point iteration; "
    "newton solves both in one system",
    "tangents": f"the rings are not linear, and {MOST_TANGENTS} tangents of them led to no balance",
    "stagnating": f"no residual fell below {STAGNATION_RATIO:g} of the smallest in {STAGNATION_LIMIT} "
    "iterations; newton solves both in one system",
}


@dataclass(frozen=True)
class Iteration(Generic[S]):
    """One exchange; the last one has a status. `message` explains an end that is not convergence."""

    number: int
    state: S
    load_change: float  # largest change of a load over the largest load [-]
    mismatch: float  # answer of the structure less what the bearing had, over the largest deviation [-]
    status: Status
    message: str = ""
    ending: str = ""  # of the bearing's own solve, in its words


@dataclass(frozen=True, kw_only=True)
class StoppingCriterion:
    """When a coupling has converged, and when it has iterated for long enough."""

    tolerance: float  # on the load change, the mismatch and the unbalanced force
    limit: int  # iterations

    def status(self, number: int, *errors: float) -> Status:
        """Status of an iteration with such errors [-]; empty to go on.

        Reaching the iteration limit is not convergence.
        """
        if not np.isfinite(errors).all():
            return "not finite"
        if max(errors) <= self.tolerance:
            return "converged"
        return "iteration limit" if number == self.limit else ""


def fixed_point(
    bearing: Bearing[S], structure: Structure, start: S, criterion: StoppingCriterion, rule: Rule
) -> Iterator[Iteration[S]]:
    """Exchange arrays: deviations to the bearing, loads to the structure, and back through a rule.

    The measure is what the structure answers less what the bearing was given, before the rule takes its
    share of it. Diverging and stagnating iterations are stopped: more of them would not help.
    """
    state, history = start, CouplingHistory()
    try:
        # A root to start from is too far away to be kept: rigid raceways tell the first deviations only.
        answer, compliance = structure.answer(start.forces)
        by_deviation = bearing.force_by_deviation(start)
        rigid = history.extended(np.zeros_like(answer), answer, by_deviation, compliance)
        deviation = rule(rigid).reshape(answer.shape)
    except PartnerFailed as failure:
        yield _failed(1, start, failure)
        return
    for number in range(1, criterion.limit + 1):
        previous = state.loads
        try:
            state = bearing.solve(start=state, deviation=deviation)
            answer, compliance = structure.answer(state.forces)
        except PartnerFailed as failure:
            yield _failed_after(history.residual_norms, _failed(number, state, failure))
            return
        history = history.extended(deviation, answer, bearing.force_by_deviation(state), compliance)
        mismatch = _relative(answer - deviation, answer)
        change = load_change(state.loads - previous, state.loads)
        status = criterion.status(number, change, mismatch) or _trend(history.residual_norms)
        yield Iteration(number, state, change, mismatch, status, _REASONS.get(status, ""), state.status)
        if status:
            return
        deviation = rule(history).reshape(answer.shape)


def _relative(residual: NDArray, answer: NDArray) -> float:
    """Largest residual over the largest deviation [-]; one beside no deviation, zero without either."""
    largest, left = np.abs(answer).max(), np.abs(residual).max()
    if largest > 0:
        return float(left / largest)
    return 1.0 if left > 0 else 0.0


def _trend(norms: list[float]) -> Status:
    """Whether the last residuals grew in a row, and far, or none was smaller for long."""
    for growths, reference in ((GROWTHS_OVER_FIRST, norms[0]), (GROWTHS_OVER_LEAST, min(norms))):
        last = norms[-growths - 1 :]
        if len(last) > growths and (np.diff(last) > 0).all() and last[-1] > DIVERGENCE_RATIO * reference:
            return "diverging"
    earlier = norms[:-STAGNATION_LIMIT]
    if earlier and min(norms[-STAGNATION_LIMIT:]) > STAGNATION_RATIO * min(earlier):
        return "stagnating"
    return ""


def _failed_after(norms: list[float], failed: Iteration[S]) -> Iteration[S]:
    """A failure of the bearing after residuals had grown far is a divergence of the coupling."""
    if not norms or norms[-1] <= DIVERGENCE_RATIO * min(norms):
        return failed
    message = f"{_REASONS['diverging']} (at the last deviations: {failed.message})"
    return replace(failed, status="diverging", message=message)


def newton(
    bearing: Iterating[S], structure: Structure, start: S, criterion: StoppingCriterion
) -> Iterator[Iteration[S]]:
    """Solve bearing and structure as one system, the structure linearised where it is not linear."""
    state, number = start, 0
    try:
        tangent = Tangent(start.forces, structure.linearised(start.forces), start.deviation)
        for count in range(1, MOST_TANGENTS + 1):
            balanced = tangent
            for iteration in _in_one_system(bearing, tangent.linear, state, criterion, number):
                state = iteration.state
                if iteration.status == "converged":
                    balancing = tangent.linear.deviation(state.forces)
                    balanced = Tangent(state.forces, structure.linearised(state.forces), balancing)
                    answer = balanced.linear.deviation(state.forces)
                    mismatch = _relative(answer - balancing, answer)
                    # In balance with one tangent, only what the tangent leaves out can still change.
                    status = criterion.status(number, mismatch)
                    if not status and count == MOST_TANGENTS:
                        status = "stagnating"
                    message = _REASONS["tangents"] if status == "stagnating" else ""
                    iteration = replace(iteration, mismatch=mismatch, status=status, message=message)
                yield iteration
                number = iteration.number  # of the last one that was reported: the structure may fail before
                if iteration.status:
                    return
            tangent = next_tangent(structure, tangent, balanced)
    except PartnerFailed as failure:
        yield _failed(number + 1, state, failure)


def _in_one_system(
    bearing: Iterating[S], linear: LinearStructure, start: S, criterion: StoppingCriterion, done: int
) -> Iterator[Iteration[S]]:
    """Newton iterates between linear elastic raceways, numbered on from those that are done."""
    previous = start.loads
    # The first state is the start itself, before any step.
    for count, state in enumerate(bearing.iterate(linear.compliance, start, linear.initial_deviation)):
        if count:
            change = load_change(state.loads - previous, state.loads)
            iteration = _newton_iteration(done + count, state, change, criterion)
            if iteration.status == "converged" and state.residual > BALANCED:
                # One step gains many digits here: answers do not depend on where the iteration began.
                iteration = replace(iteration, state=state.refined())
            yield iteration
            if iteration.status:
                return
        previous = state.loads


def _newton_iteration(number: int, state: S, change: float, criterion: StoppingCriterion) -> Iteration[S]:
    status, message = criterion.status(number, change, state.residual), ""
    if state.status == "converged" or state.residual <= BALANCED:
        # Such a force is tighter than any tolerance on loads, though the last step may still have moved them.
        status = "converged"
    elif not status and state.status:
        status, message = "not solved", state.failure()
    return Iteration(number, state, change, 0.0, status, message, state.status)


def _failed(number: int, state: S, failure: PartnerFailed) -> Iteration[S]:
    return Iteration(number, state, np.inf, np.inf, "not solved", str(failure), failure.ending)


def load_change(change: NDArray, loads: NDArray) -> float:
    """Largest change of a load over the largest load [-]; infinite while nothing is loaded."""
    largest = np.abs(loads).max()
    return float(np.abs(change).max() / largest) if largest > 0 else float("inf")
