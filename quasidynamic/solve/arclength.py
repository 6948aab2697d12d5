"""A branch of equilibria followed along its own length, around folds where the parameter turns back."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import StrEnum
from math import isfinite, nan
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

FIRST_LENGTH = 0.02
LONGEST = 0.1
SHORTEST = 1e-6
STRAIGHT = 0.9  # cosine between two tangents, below which a step is halved ...
CORNER = 1e-3  # ... unless it is this short: where a contact opens, a branch has a corner
LEAPS = (1e-4, 1e-3, 1e-2)  # over such a corner
LIMIT = 400  # steps
CORRECTIONS = 10  # Newton steps back to the branch
EASY = 4  # corrections up to which the next step may be longer
SHORTEST_PART = 0.1  # of a Newton step
ROUNDING = 1e-9  # residual from where rounding decides whether a step looks smaller
LOCATIONS = 30  # evaluations for a place between two steps
SMALL_PLACE = 1e-9  # of the length between them


class End(StrEnum):
    """Why a branch is not followed further."""

    RANGE_LEFT = "range left"
    STEP_TOO_SHORT = "step too short"
    LIMIT = "step limit"
    NO_START = "no solution to begin with"


@dataclass(frozen=True)
class Local:
    """Equations and their derivatives at a state."""

    residual: NDArray  # (N)
    by_parameter: NDArray  # (N)
    solve: Callable[[NDArray], NDArray]  # unknowns (N, R) for right-hand sides (N, R)
    done: bool  # whether the residual is small enough


class Family(Protocol):
    """Equations in N unknowns that depend on a parameter."""

    @property
    def weight(self) -> NDArray:
        """Weight (N) of the square of each unknown in the length of a branch; the parameter has one."""
        ...

    def at(self, state: NDArray, parameter: float) -> Local:
        """Equations at a state (N)."""
        ...

    def bounded(self, before: NDArray, after: NDArray) -> NDArray:
        """Keep a step from one state to another inside what makes sense."""
        ...


@dataclass(frozen=True)
class Direction:
    """Tangent of a branch, of length one in the weighted norm."""

    state: NDArray  # (N)
    parameter: float

    def along(self, weight: NDArray, state: NDArray, parameter: float) -> float:
        """Length of a displacement along this direction."""
        return float(self.state @ (weight * state)) + self.parameter * parameter


@dataclass(frozen=True)
class Step:
    """A solved place on the branch."""

    state: NDArray  # (N)
    parameter: float
    tangent: Direction
    corrections: int  # Newton steps it took
    fold: bool = False  # whether the parameter turns back here


@dataclass(frozen=True)
class Followed:
    """A branch, step by step."""

    steps: tuple[Step, ...]
    end: End


@dataclass(frozen=True)
class Corrected:
    """Where the corrector ended."""

    state: NDArray
    parameter: float
    local: Local
    corrections: int

    def step(self, family: Family, sense: Direction) -> Step:
        """A step of the branch, looking in the sense of a direction."""
        way = tangent(family, self.local, sense)
        return Step(self.state, self.parameter, way, self.corrections)


def follow(
    family: Family, state: NDArray, start: float, bounds: tuple[float, float], upwards: bool
) -> Followed:
    r"""Follow a branch from a solution at one parameter until the parameter leaves its bounds.

    Predictor along the tangent, corrector on the plane across it:

    .. math:: R(x, p) = 0,\qquad \dot x \cdot W (x - x_0) + \dot p\,(p - p_0) = \Delta s

    The step grows while few corrections are needed and is halved where the branch bends too much.
    Folds, where dp/ds changes its sign, are located and stand between the steps.

    Parameters
    ----------
    family : Family
        equations
    state : array (N)
        near a solution at `start`
    start : float
        the parameter there, within the bounds
    bounds : pair of floats
        smallest and largest parameter
    upwards : bool
        whether the parameter goes off to larger values

    Returns
    -------
    Followed
        without any step when there is no solution near the start; a branch that leaves the range
        ends exactly on its bound, which may be where it began

    Source
    ------
    Keller (1977), pseudo-arclength continuation; Allgower and Georg, Introduction to Numerical
    Continuation Methods (2003), ch. 6.
    """
    begin = solved_at(family, state, start)
    if begin is None:
        return Followed((), End.NO_START)
    steps, length = [begin if upwards else _turned(begin)], FIRST_LENGTH
    for _ in range(LIMIT):
        here = steps[-1]
        ahead, length = _ahead(family, here, length)
        if ahead is None:
            return Followed(tuple(steps), End.STEP_TOO_SHORT)
        fold = _fold(family, here, ahead)
        for place in (ahead,) if fold is None else (fold, ahead):
            inside = min(max(place.parameter, bounds[0]), bounds[1])
            if inside != place.parameter:
                last = at_parameter(family, steps[-1], place, inside)
                end = End.STEP_TOO_SHORT if last is None else End.RANGE_LEFT
                return Followed((*steps, last) if last else tuple(steps), end)
            steps.append(place)
    return Followed(tuple(steps), End.LIMIT)


def _turned(step: Step) -> Step:
    """The same place, looking back."""
    return replace(step, tangent=Direction(-step.tangent.state, -step.tangent.parameter))


def _ahead(family: Family, here: Step, length: float) -> tuple[Step | None, float]:
    """Next step and the length to try after it; none when it became too short."""
    while length >= SHORTEST:
        ahead = advanced(family, here, length)
        if ahead is not None:
            bend = here.tangent.along(family.weight, ahead.tangent.state, ahead.tangent.parameter)
            if bend > STRAIGHT or length < CORNER:
                growth = 1.7 if ahead.corrections <= EASY else 0.8
                return ahead, min(growth * length, LONGEST)
        length /= 2
    return _leap(family, here)


def _leap(family: Family, here: Step) -> tuple[Step | None, float]:
    """A step over a corner, from so near that shorter steps end within its rounding, and its length."""
    for length in LEAPS:
        ahead = advanced(family, here, length)
        if ahead is not None:
            way = ahead.state - here.state, ahead.parameter - here.parameter
            if ahead.tangent.along(family.weight, *way) > 0:
                return ahead, length
    return None, 0.0


def advanced(family: Family, here: Step, length: float) -> Step | None:
    """The place a length further along the tangent; none when Newton's method does not reach it."""
    way = here.tangent
    guess = family.bounded(here.state, here.state + length * way.state)
    found = corrected(family, guess, here.parameter + length * way.parameter, way)
    ahead = found and found.step(family, way)
    # Right on a fold the matrix may be singular.
    return ahead if ahead and np.isfinite(ahead.tangent.state).all() else None


def solved_at(family: Family, state: NDArray, parameter: float) -> Step | None:
    """The place at a given parameter, near a state; its tangent points to larger parameters."""
    upwards = Direction(np.zeros_like(state), 1.0)
    found = corrected(family, state, parameter, upwards)
    return found and found.step(family, upwards)


def corrected(family: Family, state: NDArray, parameter: float, across: Direction) -> Corrected | None:
    r"""Newton's method on the equations with one more row, solved by the bordering lemma.

    .. math:: J u = -R,\; J v = R_p,\; \Delta x = u - v\,\Delta p,\;
              \Delta p = -\frac{\dot x \cdot W u}{\dot p - \dot x \cdot W v}

    Every step is taken `across` a direction: the tangent, or that of the parameter, which then keeps
    its value. A step is halved as long as the residual grows.
    """
    here, damping, step = family.at(state, parameter), 1.0, (np.zeros_like(state), 0.0)
    before, size = (state, parameter), np.inf
    for number in range(CORRECTIONS + 1):
        new = float(np.linalg.norm(here.residual))
        if not new < max(size, ROUNDING):  # also when it is not a number
            if (damping := damping / 2) < SHORTEST_PART:
                return None
        elif here.done:
            return Corrected(state, parameter, here, number)
        else:
            before, size, damping = (state, parameter), new, 1.0
            step = _newton_step(family, here, across)
            if not (isfinite(step[1]) and np.isfinite(step[0]).all()):
                return None
        state = family.bounded(before[0], before[0] + damping * step[0])
        parameter = before[1] + damping * step[1]
        here = family.at(state, parameter)
    return None


def _newton_step(family: Family, local: Local, across: Direction) -> tuple[NDArray, float]:
    u, v = local.solve(np.column_stack([-local.residual, local.by_parameter])).T
    along_u, along_v = (across.along(family.weight, part, 0.0) for part in (u, v))
    slope = across.parameter - along_v
    change = -along_u / slope if slope else nan  # no step leads across: not a number ends a correction
    return u - v * change, change


def tangent(family: Family, local: Local, sense: Direction) -> Direction:
    """Tangent of the branch at a solution, in the sense of another direction."""
    change = -local.solve(local.by_parameter[:, None])[:, 0]
    length = np.sqrt(change @ (family.weight * change) + 1.0)
    if sense.along(family.weight, change, 1.0) < 0:
        length = -length
    with np.errstate(invalid="ignore"):
        return Direction(change / length, float(1.0 / length))


# -- places between two steps ----------------------------------------------------------------------


def located(family: Family, here: Step, ahead: Step, measure: Callable[[Step], float]) -> Step:
    """The place between two steps where a measure changes its sign, by regula falsi (Illinois).

    The places are a variable length in front of the first step, so that it works around folds too.
    Where Newton's method fails in between it is the nearest place so far.
    """
    span = here.tangent.along(family.weight, ahead.state - here.state, ahead.parameter - here.parameter)
    low, high, below, above = 0.0, span, measure(here), measure(ahead)
    best, last = here if abs(below) < abs(above) else ahead, 0.0
    for _ in range(LOCATIONS):
        if abs(high - low) <= SMALL_PLACE * span or below == above or measure(best) == 0.0:
            break
        middle = high - above * (high - low) / (above - below)
        found = advanced(family, here, middle)
        if found is None:
            break
        value = measure(found)
        best = found if abs(value) < abs(measure(best)) else best
        if value * above < 0:
            low, below = high, above
        else:
            below = below / 2
        if abs(middle - last) <= SMALL_PLACE * span:
            break
        high, above, last = middle, value, middle
    return best


def _fold(family: Family, here: Step, ahead: Step) -> Step | None:
    """The fold between two steps; none when the parameter does not turn back."""
    if here.tangent.parameter * ahead.tangent.parameter >= 0:
        return None
    return replace(located(family, here, ahead, lambda step: step.tangent.parameter), fold=True)


def at_parameter(family: Family, here: Step, ahead: Step, parameter: float) -> Step | None:
    """The place between two steps at a given parameter; none when Newton's method does not reach it."""
    found = located(family, here, ahead, lambda step: step.parameter - parameter)
    return solved_at(family, found.state, parameter)
