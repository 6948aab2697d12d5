"""Residuals to zero: damped Newton, and pseudo-time where Newton finds no way down."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import lu_factor, lu_solve

from quasidynamic.balance.bearing import CAGE, BearingBalance, Evaluation, Y, Z

Status = Literal["", "converged", "iteration limit", "not finite", "stalled"]

TOLERANCE = 1e-11  # of the reference force
NEWTON_LIMIT = 60  # steps
SHORTEST_STEP = 2.0**-12

PSEUDO_LIMIT = 600  # steps
PSEUDO_ENOUGH = 1e-6  # residual from which Newton's method takes over again
FIRST_PSEUDO_STEP = 1e-4  # [s]
LONGEST_SHIFT = 5.0  # scaled ring displacement a pseudo-time step may bring: 5 micrometres
LARGEST_SPEED_CHANGE = 0.1  # of the cage speed in a pseudo-time step


@dataclass(frozen=True)
class Step:
    """One iterate; the last one of a solve has a status."""

    number: int
    unknowns: NDArray  # (N) scaled
    film: NDArray  # (2, Z) [m] used in the evaluation
    evaluation: Evaluation
    status: Status

    @property
    def residual(self) -> float:
        """Largest unbalanced force over the reference force [-]."""
        return float(np.abs(self.evaluation.residual).max())


def solve(balance: BearingBalance, unknowns: NDArray, film: NDArray) -> Iterator[Step]:
    """Yield iterates: Newton's method; if it fails, pseudo-time from the start, then Newton again."""
    step = None
    for step in newton(balance, unknowns, film):
        if step.status in ("", "converged"):
            yield step
        if step.status == "converged":
            return
    taken = step.number if step else 0
    for step in pseudo_time(balance, unknowns, film):
        taken += 1
        yield replace(step, number=taken)
        if step.status:
            return
    if step:
        for last in newton(balance, step.unknowns, step.film):
            yield replace(last, number=taken + last.number + 1)


def newton(balance: BearingBalance, unknowns: NDArray, film: NDArray) -> Iterator[Step]:
    """Yield Newton iterates until the residual is below `TOLERANCE`, or the solve has ended.

    The film lags by one step, so the last steps converge linearly, by a factor below 1e-3 each.
    The step is halved until the residual falls; a step too short to help ends as `stalled`.
    """
    current, damping = balance.evaluate(unknowns, film), 1.0
    for number in range(NEWTON_LIMIT + 1):
        status = _judge(current, number, damping)
        yield Step(number, unknowns, film, current, status)
        if status:
            return
        film = balance.film(current.rollers)
        trial = unknowns + _direction(current.jacobian, current.residual)
        evaluation = balance.evaluate(trial, film)
        if _size(evaluation) < _size(current):
            damping = 1.0
        else:
            # Judge descent at one and the same film: the lagged one moves the residual by itself.
            current = balance.evaluate(unknowns, film)
            damping, trial, evaluation = _shortened(balance, unknowns, current, film)
        unknowns, current = trial, evaluation


def pseudo_time(balance: BearingBalance, unknowns: NDArray, film: NDArray) -> Iterator[Step]:
    """Yield implicit Euler steps of cage and roller spin with their inertias, ring and rollers following.

    The time step grows as the residual falls (switched evolution relaxation), and a ring that wants
    to run far, such as one balanced on a single roller, is led in short steps. Ends without a status
    as soon as Newton's method can take over.
    """
    inertia = _inertia(balance)
    current, pace = balance.evaluate(unknowns, film), FIRST_PSEUDO_STEP
    for number in range(PSEUDO_LIMIT):
        film = balance.film(current.rollers)
        change = _direction(current.jacobian - np.diag(inertia / pace), current.residual)
        hurry = max(
            np.abs(change[[Y, Z]]).max() / LONGEST_SHIFT, abs(change[CAGE]) / LARGEST_SPEED_CHANGE, 1.0
        )
        trial = balance.evaluate(unknowns + change / hurry, film)
        if not _size(trial) < 5 * _size(current) and pace > 1e-9:
            pace /= 5
            continue
        growth = float(np.clip(_size(current) / _size(trial), 0.5, 4.0))
        pace *= min(growth, 1.0) if hurry > 1 else growth
        unknowns, current = unknowns + change / hurry, trial
        yield Step(number, unknowns, film, current, "" if np.isfinite(_size(current)) else "not finite")
        if not _size(current) > PSEUDO_ENOUGH:
            return


def _inertia(balance: BearingBalance) -> NDArray:
    """Physical inertia (N) of the cage with its rollers and of the spins; none elsewhere, scaled."""
    bearing = balance.roller.bearing
    inertia = np.zeros(balance.size)
    orbiting = bearing.cage.mass + bearing.rollers * bearing.roller.mass
    inertia[CAGE] = orbiting * (bearing.pitch_diameter / 2) ** 2
    inertia[balance.roller_unknown(2)] = bearing.roller.inertia
    return inertia * balance.unknown_scale / balance.residual_scale


def _direction(jacobian: NDArray, residual: NDArray) -> NDArray:
    return -lu_solve(lu_factor(jacobian, check_finite=False), residual, check_finite=False)


def _size(evaluation: Evaluation) -> float:
    return float(np.linalg.norm(evaluation.residual))


def _shortened(balance: BearingBalance, unknowns: NDArray, current: Evaluation, film: NDArray):
    """Longest of the halved Newton steps that lowers the residual; damping 0 when none does."""
    direction, damping = _direction(current.jacobian, current.residual), 1.0
    while damping > SHORTEST_STEP:
        trial = unknowns + damping * direction
        evaluation = balance.evaluate(trial, film)
        if _size(evaluation) <= (1 - 1e-4 * damping) * _size(current):
            return damping, trial, evaluation
        damping /= 2
    return 0.0, unknowns, current


def _judge(evaluation: Evaluation, number: int, damping: float) -> Status:
    size = np.abs(evaluation.residual).max()
    if not np.isfinite(size):
        return "not finite"
    if size <= TOLERANCE and number:
        return "converged"
    if damping == 0.0:
        return "stalled"
    return "iteration limit" if number == NEWTON_LIMIT else ""
