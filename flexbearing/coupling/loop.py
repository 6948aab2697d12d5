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
            yield _failed(number, state, failure)
            return
        change = state.forces - forces
        size = load_change(change, state.forces)
        status = ending.judge(number, size)
        yield Iteration(number, state, size, status, ending=state.status)
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
    forces, state, number = start.forces, start, 0
    try:
        # The first state is the start itself, before any step.
        for number, state in enumerate(bearing.iterate(structure.compliance, start)):
            if number == 0:
                continue
            step = _newton_step(number, state, load_change(state.forces - forces, state.forces), ending)
            yield step
            if step.status:
                return
            forces = state.forces
    except PartnerFailed as failure:
        yield _failed(number + 1, state, failure)


def _newton_step(number: int, state: S, size: float, ending: Ending) -> Iteration[S]:
    status, message = ending.judge(number, size, state.residual), ""
    if not status and state.status == "converged":
        # The bearing's own tolerance is the tighter one: its last step may still move the loads.
        status = "converged"
    elif not status and state.status:
        status, message = "not solved", state.failure()
    return Iteration(number, state, size, status, message, state.status)


def _failed(number: int, state: S, failure: PartnerFailed) -> Iteration[S]:
    return Iteration(number, state, np.inf, "not solved", str(failure), failure.ending)


def load_change(change: NDArray, forces: NDArray) -> float:
    """Largest change of a roller load over the largest load [-]; infinite while nothing is loaded."""
    largest = np.abs(forces[..., 0]).max()
    return float(np.abs(change[..., 0]).max() / largest) if largest > 0 else float("inf")
