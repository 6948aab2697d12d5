"""The coupling iteration as a generator, with its ends."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Generic, Literal

import numpy as np
from numpy.typing import NDArray

from flexbearing.coupling.partners import Bearing, PartnerFailed, S, Structure

Status = Literal["", "converged", "iteration limit", "not finite", "not solved"]


@dataclass(frozen=True)
class Iteration(Generic[S]):
    """One exchange; the last one has a status. `message` explains an end that is not convergence."""

    number: int
    state: S
    load_change: float  # largest change of a roller load over the largest load [-]
    status: Status
    message: str = ""


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


def relaxed(
    bearing: Bearing[S], structure: Structure, start: S, ending: Ending, relaxation: float
) -> Iterator[Iteration[S]]:
    """Alternate: loads to structure, deviations to bearing, and a fraction of the change of loads back.

    The measure is the change of the loads before relaxation: what the loads would still do, not the
    step that relaxation lets them take.

    Parameters
    ----------
    bearing, structure : partners
    start : State
        the first loads, those of rigid raceways
    ending : Ending
        tolerance and limit
    relaxation : float
        fraction of the change that is taken over, in (0, 1]; above 2/(1 + rho), with rho the
        spectral radius of the alternation, it diverges

    Yields
    ------
    Iteration
    """
    forces, state = start.forces, start
    for number in range(1, ending.limit + 1):
        try:
            state = bearing.solve(start=state, deviation=structure.deviation(forces))
        except PartnerFailed as failure:
            yield Iteration(number, state, np.inf, "not solved", str(failure))
            return
        change = state.forces - forces
        size = load_change(change, state.forces)
        status = ending.judge(number, size)
        yield Iteration(number, state, size, status)
        if status:
            return
        forces = forces + relaxation * change


def newton(bearing: Bearing[S], structure: Structure, start: S, ending: Ending) -> Iterator[Iteration[S]]:
    """Solve bearing and condensed structure as one system.

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
    forces = start.forces
    # The first state is the start itself, before any step.
    states = bearing.iterate(structure.compliance, start)
    next(states)
    for number, state in enumerate(states, start=1):
        size = load_change(state.forces - forces, state.forces)
        status = ending.judge(number, size, state.residual)
        message = ""
        if not status and state.status:
            # The bearing's own tolerance is the tighter one: its last step may still move the loads.
            status = "converged" if state.status == "converged" else "not solved"
            message = "" if status == "converged" else f"Newton's method ended: {state.status}"
        yield Iteration(number, state, size, status, message)
        if status:
            return
        forces = state.forces


def load_change(change: NDArray, forces: NDArray) -> float:
    """Largest change of a roller load over the largest load [-]; infinite while nothing is loaded."""
    largest = np.abs(forces[..., 0]).max()
    return float(np.abs(change[..., 0]).max() / largest) if largest > 0 else float("inf")
