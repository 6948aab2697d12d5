"""Residuals to zero: damped Newton, and pseudo-time where Newton finds no way down."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.bearing import CAGE, BearingBalance, Evaluation, Y, Z
from quasidynamic.start import settled

Status = Literal["", "converged", "iteration limit", "not finite", "stalled"]

TOLERANCE = 1e-10  # of the reference force, or of the largest roller load if that is larger
ROUNDING = 1e-8  # residual from where rounding decides whether a step looks smaller
NEWTON_LIMIT = 60  # steps
SHORTEST_STEP = 2.0**-12

SEARCH_LIMIT = 40  # steps
SMALL_CHANGE = 3.0  # scaled displacement: 3 micrometres

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
    """Yield iterates: Newton's method; if it fails, pseudo-time from the start, then Newton again.

    Raceways that yield come first to touch the rollers that carry load, see `contact_search`.
    """
    if balance.yields:
        yield from _after(contact_search(balance, unknowns, film), balance)
        return
    failed = 0
    for step in newton(balance, unknowns, film):
        if step.status in ("", "converged"):
            yield step
        if step.status == "converged":
            return
        failed = step.number
    for step in _after(pseudo_time(balance, unknowns, film), balance):
        yield replace(step, number=failed + 1 + step.number)


def _after(first: Iterator[Step], balance: BearingBalance) -> Iterator[Step]:
    """Go through the first iterates, then on with Newton's method unless they came to an end."""
    step = None
    for step in first:
        yield step
    if step is None or step.status:
        return
    for last in newton(balance, step.unknowns, step.film):
        if last.number:
            yield replace(last, number=step.number + last.number)


def contact_search(balance: BearingBalance, unknowns: NDArray, film: NDArray) -> Iterator[Step]:
    """Yield undamped Newton steps, rollers settled after each, until displacements hardly change.

    Which rollers touch is decided here. The load law is nearly linear, so a full step solves the
    problem of the rollers that touched before it, however far it overshoots; a damped one crawls.
    """
    current = balance.evaluate(unknowns, film)
    yield Step(0, unknowns, film, current, "")
    for number in range(1, SEARCH_LIMIT + 1):
        change = _direction(current.jacobian, current.residual)
        unknowns = unknowns + change
        found = np.abs(change[balance.displacements]).max() < SMALL_CHANGE
        if not found:
            unknowns = settled(balance, unknowns, film)
        film = balance.film(balance.residual(unknowns, film)[1])
        current = balance.evaluate(unknowns, film)
        status = "" if np.isfinite(_size(current)) else "not finite"
        yield Step(number, unknowns, film, current, status)
        if status or found:
            return


def newton(balance: BearingBalance, unknowns: NDArray, film: NDArray) -> Iterator[Step]:
    """Yield Newton iterates until the residual is below `TOLERANCE`, or the solve has ended.

    The film is held during a step and renewed after it, so the last steps converge linearly, by a
    factor of about 1e-3 each. The step is halved until the residual falls; a step too short to help
    ends as `stalled`.
    """
    current, damping = balance.evaluate(unknowns, film), 1.0
    for number in range(NEWTON_LIMIT + 1):
        status = _judge(current, number, damping)
        yield Step(number, unknowns, film, current, status)
        if status:
            return
        damping, unknowns, rollers = _shortened(balance, unknowns, current, film)
        film = balance.film(rollers)
        current = balance.evaluate(unknowns, film)


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
    """Newton step; not a number where there is none, which ends the solve as `not finite`."""
    try:
        return -np.linalg.solve(jacobian, residual)
    except np.linalg.LinAlgError:
        return np.full(len(residual), np.nan)


def _size(evaluation: Evaluation) -> float:
    return float(np.linalg.norm(evaluation.residual))


def _shortened(balance: BearingBalance, unknowns: NDArray, current: Evaluation, film: NDArray):
    """Longest of the halved Newton steps that lowers the residual; damping 0 when none does."""
    direction, damping = _direction(current.jacobian, current.residual), 1.0
    while damping > SHORTEST_STEP:
        trial = unknowns + damping * direction
        residual, rollers = balance.residual(trial, film)
        size = np.linalg.norm(residual)
        if size <= max((1 - 1e-4 * damping) * _size(current), ROUNDING * current.loading):
            return damping, trial, rollers
        damping /= 2
    return 0.0, unknowns, current.rollers


def _judge(evaluation: Evaluation, number: int, damping: float) -> Status:
    size = np.abs(evaluation.residual).max()
    if not np.isfinite(size):
        return "not finite"
    if size <= TOLERANCE * evaluation.loading and number:
        return "converged"
    if damping == 0.0:
        return "stalled"
    return "iteration limit" if number == NEWTON_LIMIT else ""
