"""The coupling iteration as a generator, with its ends."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Generic, Literal

import numpy as np
from numpy.typing import NDArray

from flexbearing.coupling.acceleration import Rule
from flexbearing.coupling.history import History
from flexbearing.coupling.partners import (
    Bearing,
    Compliance,
    Condensed,
    Linear,
    PartnerFailed,
    S,
    Structure,
)

Status = Literal["", "converged", "iteration limit", "diverging", "stagnating", "not finite", "not solved"]

# Diverging: a residual grew so often in a row and is so much above the first, or above the smallest. Aitken's
# method jumps, but not five times.
DIVERGENCE_RATIO = 10.0
GROWTHS_OVER_FIRST, GROWTHS_OVER_LEAST = 3, 5
# Stagnating: so many iterations without a residual below this part of the smallest before them.
STAGNATION_LIMIT, STAGNATION_RATIO = 40, 0.9
BALANCED = 1e-10  # unbalanced force over the load at which newton has nothing left to improve
_REASONS = {
    "diverging": "diverging iterations are stopped: the structure is too soft for a fixed-point iteration; "
    "newton can solve it",
    "stagnating": f"no residual fell below {STAGNATION_RATIO:g} of the smallest in {STAGNATION_LIMIT} "
    "iterations; newton can solve it",
}


@dataclass(frozen=True)
class Iteration(Generic[S]):
    """One exchange; the last one has a status. `message` explains an end that is not convergence."""

    number: int
    state: S
    load_change: float  # largest change of a roller load over the largest load [-]
    mismatch: float  # answer of the structure less what the bearing had, over the largest deviation [-]
    status: Status
    message: str = ""
    ending: str = ""  # of the bearing's own solve, in its words


@dataclass(frozen=True, kw_only=True)
class StoppingCriterion:
    """When to stop."""

    tolerance: float  # on the load change and on the unbalanced force, both over the load
    limit: int  # iterations

    def judge(self, number: int, change: float, residual: float = 0.0) -> Status:
        """Name the end that is reached, or nothing. The limit is never convergence."""
        if not (np.isfinite(change) and np.isfinite(residual)):
            return "not finite"
        if max(change, residual) <= self.tolerance:
            return "converged"
        return "iteration limit" if number == self.limit else ""


def fixed_point(
    bearing: Bearing[S], structure: Structure, start: S, ending: StoppingCriterion, rule: Rule
) -> Iterator[Iteration[S]]:
    """Alternate: deviations to the bearing, loads to the structure, and back through a rule.

    The measure is what the structure answers less what the bearing was given, before the rule takes its
    share of it. An alternation whose residual only grows, or does not fall any more, is ended: more
    iterations would not help.

    Parameters
    ----------
    bearing, structure : partners
    start : State
        the first loads, those of rigid raceways
    ending : StoppingCriterion
        tolerance and limit
    rule : callable
        next deviations from those before and their residuals, such as those in `acceleration`

    Yields
    ------
    Iteration
    """
    state, history = start, History()
    try:
        deviation = _first(bearing, structure, start, rule)
    except PartnerFailed as failure:
        yield _failed(1, start, failure)
        return
    for number in range(1, ending.limit + 1):
        forces = state.forces
        try:
            state = bearing.solve(start=state, deviation=deviation)
            answer, compliance = _asked(structure, state.forces)
        except PartnerFailed as failure:
            yield _lost(_failed(number, state, failure), history.sizes)
            return
        history.add(deviation, answer - deviation, bearing.roller_stiffness(state))
        mismatch = _part(answer - deviation, answer)
        change = load_change(state.forces - forces, state.forces)
        status = ending.judge(number, change, mismatch) or _hopeless(history.sizes)
        yield Iteration(number, state, change, mismatch, status, _REASONS.get(status, ""), state.status)
        if status:
            return
        deviation = rule(history.seen(compliance)).reshape(answer.shape)


def _first(bearing: Bearing[S], structure: Structure, start: S, rule: Rule) -> NDArray:
    """First deviations (2, Z, M); what even raceways tell is too far from all that comes to be kept."""
    (answer, compliance), even = _asked(structure, start.forces), History()
    even.add(np.zeros_like(answer), answer, bearing.roller_stiffness(start))
    return rule(even.seen(compliance)).reshape(answer.shape)


def _asked(structure: Structure, forces: NDArray) -> tuple[NDArray, Compliance | None]:
    """What a structure answers, and how it yields there, which not every one tells."""
    if isinstance(structure, Condensed):
        linear = structure.linearised(forces)
        return linear.deviation(forces), linear.compliance
    return structure.deviation(forces), None


def _part(residual: NDArray, answer: NDArray) -> float:
    """Largest residual over the largest deviation [-]; zero between raceways that do not yield."""
    largest = np.abs(answer).max()
    return float(np.abs(residual).max() / largest) if largest > 0 else 0.0


def _hopeless(sizes: list[float]) -> Status:
    """Whether the last residuals only grew, and far, or none was less for long."""
    for growths, before in ((GROWTHS_OVER_FIRST, sizes[0]), (GROWTHS_OVER_LEAST, min(sizes))):
        last = sizes[-growths - 1 :]
        if len(last) > growths and (np.diff(last) > 0).all() and last[-1] > DIVERGENCE_RATIO * before:
            return "diverging"
    before = sizes[:-STAGNATION_LIMIT]
    return "stagnating" if before and min(sizes[-STAGNATION_LIMIT:]) > STAGNATION_RATIO * min(before) else ""


def _lost(failed: Iteration[S], sizes: list[float]) -> Iteration[S]:
    """A failure of the bearing where residuals had grown far is one of the alternation."""
    if not sizes or sizes[-1] <= DIVERGENCE_RATIO * min(sizes):
        return failed
    message = f"{_REASONS['diverging']} (at the last shape: {failed.message})"
    return replace(failed, status="diverging", message=message)


def newton(
    bearing: Bearing[S], structure: Condensed, start: S, ending: StoppingCriterion
) -> Iterator[Iteration[S]]:
    """Solve bearing and structure as one system, the structure linearised where it is not linear.

    Parameters
    ----------
    bearing, structure : partners
    start : State
        where to begin, the equilibrium of rigid raceways
    ending : StoppingCriterion
        tolerance and limit

    Yields
    ------
    Iteration
    """
    state, number = start, 0
    try:
        linear = structure.linearised(start.forces)
        while True:
            for step in _in_one_system(bearing, linear, state, ending, number):
                state, number = step.state, step.number
                if step.status == "converged":
                    before, linear = linear, structure.linearised(state.forces)
                    answer = linear.deviation(state.forces)
                    mismatch = _part(answer - before.deviation(state.forces), answer)
                    # Of one structure in balance nothing is left to change but what its tangent leaves out.
                    status = ending.judge(number, mismatch)
                    step = replace(step, mismatch=mismatch, status=status)
                yield step
                if step.status:
                    return
    except PartnerFailed as failure:
        yield _failed(number + 1, state, failure)


def _in_one_system(
    bearing: Bearing[S], linear: Linear, start: S, ending: StoppingCriterion, done: int
) -> Iterator[Iteration[S]]:
    """Newton iterates between raceways that yield linearly, numbered on from those that are done."""
    forces = start.forces
    # The first state is the start itself, before any step.
    for count, state in enumerate(bearing.iterate(linear.compliance, start, linear.unloaded)):
        if count:
            step = _newton_step(done + count, state, load_change(state.forces - forces, state.forces), ending)
            yield step
            if step.status:
                return
        forces = state.forces


def _newton_step(number: int, state: S, size: float, ending: StoppingCriterion) -> Iteration[S]:
    status, message = ending.judge(number, size, state.residual), ""
    if state.status == "converged" or state.residual <= BALANCED:
        # Such a force is tighter than any tolerance on loads, though the last step may still have moved them.
        status = "converged"
    elif not status and state.status:
        status, message = "not solved", state.failure()
    return Iteration(number, state, size, 0.0, status, message, state.status)


def _failed(number: int, state: S, failure: PartnerFailed) -> Iteration[S]:
    return Iteration(number, state, np.inf, np.inf, "not solved", str(failure), failure.ending)


def load_change(change: NDArray, forces: NDArray) -> float:
    """Largest change of a roller load over the largest load [-]; infinite while nothing is loaded."""
    largest = np.abs(forces[..., 0]).max()
    return float(np.abs(change[..., 0]).max() / largest) if largest > 0 else float("inf")
