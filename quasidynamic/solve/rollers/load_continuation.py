"""Down from a heavier load, where rollers drive the cage, to the load that is requested."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.solve.rollers.newton import newton
from quasidynamic.solve.step_length import SolverOutcome

FIRST_LOADS = (8.0, 64.0, 512.0, 4096.0)  # loads to begin from, over the load that is requested
FIRST_STEP = 0.7  # of the logarithm of the load
SHORTEST_STEP = 0.02
MAX_LOADS = 80  # loads


@dataclass(frozen=True)
class Continuation:
    """Where a continuation ended."""

    unknowns: NDArray | None  # (1, N) scaled, at the load that is requested; None when it was not reached
    evaluations: int


def from_heavier_load(
    balance: BearingBalance, start: Callable[[BearingBalance], NDArray], most: float = np.inf
) -> Continuation:
    """Equilibrium of one case, from that of a load many times as large in shrinking steps.

    Each step starts from an extrapolation of the last two equilibria over the logarithm of the load,
    and is halved until Newton's method succeeds; no further load is tried after `most` evaluations.
    """
    evaluations = 0
    for factor in FIRST_LOADS:
        heavy = loaded(balance, factor)
        unknowns, used = _newton(heavy, start(heavy))
        evaluations += used
        if evaluations >= most:
            break
        if unknowns is not None:
            lighter = _down(balance, np.log(factor), unknowns, most - evaluations)
            evaluations += lighter.evaluations
            if lighter.unknowns is not None:
                return Continuation(lighter.unknowns, evaluations)
    return Continuation(None, evaluations)


def loaded(balance: BearingBalance, factor: float) -> BearingBalance:
    """The same balance under a multiple of load and moment."""
    points = balance.points
    names = ("load_y", "load_z", "moment_y", "moment_z")
    return replace(
        balance, points=replace(points, **{name: factor * getattr(points, name) for name in names})
    )


def _down(balance: BearingBalance, log_factor: float, unknowns: NDArray, most: float) -> Continuation:
    """From the logarithm of a load factor down to zero."""
    step, slope, evaluations = FIRST_STEP, np.zeros_like(unknowns), 0
    for _ in range(MAX_LOADS):
        target = max(log_factor - step, 0.0)
        guess = unknowns + slope * (target - log_factor)
        solution, used = _newton(loaded(balance, np.exp(target)), guess)
        evaluations += used
        if solution is None:
            step /= 2
            if step < SHORTEST_STEP or evaluations >= most:
                break
            continue
        slope = (solution - unknowns) / (target - log_factor)
        log_factor, unknowns = target, solution
        if log_factor == 0.0:
            return Continuation(unknowns, evaluations)
        step *= 1.5
    return Continuation(None, evaluations)


def _newton(balance: BearingBalance, unknowns: NDArray) -> tuple[NDArray | None, int]:
    """Equilibrium (1, N) or None, and evaluations."""
    *_, last = newton(balance, unknowns)
    converged = last.outcomes[0] is SolverOutcome.CONVERGED
    return last.unknowns if converged else None, last.number + 1
