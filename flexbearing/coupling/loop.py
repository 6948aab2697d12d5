"""The coupling iteration as a generator, with its ends."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Generic, Literal

import numpy as np
from numpy.typing import NDArray

from flexbearing.coupling.acceleration import Rule
from flexbearing.coupling.partners import Bearing, Linear, PartnerFailed, S, Structure

Status = Literal["", "converged", "iteration limit", "diverging", "not finite", "not solved"]

GROWTHS, FAR = 5, 10.0  # so many residuals in a row that grew, and so much above the least one: diverging
_GROWING = "the alternation grows: a structure that soft cannot be alternated with like that; newton can"


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
class Ending:
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


def alternate(
    bearing: Bearing[S], structure: Structure, start: S, ending: Ending, rule: Rule
) -> Iterator[Iteration[S]]:
    """Alternate: deviations to the bearing, loads to the structure, and back through a rule.

    The measure is what the structure answers less what the bearing was given, before the rule takes its
    share of it. An alternation whose residual only grows is ended: more iterations would not help.

    Parameters
    ----------
    bearing, structure : partners
    start : State
        the first loads, those of rigid raceways
    ending : Ending
        tolerance and limit
    rule : callable
        next deviations from those before and their residuals, such as those in `acceleration`

    Yields
    ------
    Iteration
    """
    deviation, state = structure.deviation(start.forces), start
    given, residuals, sizes = [], [], []
    deviation = rule(np.zeros((deviation.size, 1)), deviation.reshape(-1, 1)).reshape(deviation.shape)
    for number in range(1, ending.limit + 1):
        forces = state.forces
        try:
            state = bearing.solve(start=state, deviation=deviation)
        except PartnerFailed as failure:
            yield _failed(number, state, failure)
            return
        answer = structure.deviation(state.forces)
        given.append(deviation.ravel())
        residuals.append((answer - deviation).ravel())
        sizes.append(_part(residuals[-1], answer))
        change = load_change(state.forces - forces, state.forces)
        status = ending.judge(number, change, sizes[-1])
        if not status and _grows(residuals):
            status = "diverging"
        message = _GROWING if status == "diverging" else ""
        yield Iteration(number, state, change, sizes[-1], status, message, state.status)
        if status:
            return
        deviation = rule(np.array(given).T, np.array(residuals).T).reshape(deviation.shape)


def _part(residual: NDArray, answer: NDArray) -> float:
    """Largest residual over the largest deviation [-]; zero between raceways that do not yield."""
    largest = np.abs(answer).max()
    return float(np.abs(residual).max() / largest) if largest > 0 else 0.0


def _grows(residuals: list[NDArray]) -> bool:
    """Whether the last residuals only grew, far beyond the least one."""
    sizes = np.linalg.norm(residuals, axis=1)
    last = sizes[-GROWTHS - 1 :]
    return len(last) > GROWTHS and bool((np.diff(last) > 0).all()) and last[-1] > FAR * sizes.min()


def newton(bearing: Bearing[S], structure: Structure, start: S, ending: Ending) -> Iterator[Iteration[S]]:
    """Solve bearing and structure as one system, the structure linearised where it is not linear.

    Parameters
    ----------
    bearing, structure : partners
    start : State
        where to begin, the equilibrium of rigid raceways
    ending : Ending
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
                    status = ending.judge(number, step.load_change, mismatch)
                    step = replace(step, mismatch=mismatch, status=status)
                yield step
                if step.status:
                    return
    except PartnerFailed as failure:
        yield _failed(number + 1, state, failure)


def _in_one_system(
    bearing: Bearing[S], linear: Linear, start: S, ending: Ending, done: int
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


def _newton_step(number: int, state: S, size: float, ending: Ending) -> Iteration[S]:
    status, message = ending.judge(number, size, state.residual), ""
    if not status and state.status == "converged":
        # The bearing's own tolerance is the tighter one: its last step may still move the loads.
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
