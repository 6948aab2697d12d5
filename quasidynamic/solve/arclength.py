"""A branch of equilibria followed along its own length, around folds where the parameter turns back."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import StrEnum
from math import isfinite, nan
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

FIRST_STEP = 0.02
LONGEST_STEP = 0.1
SHORTEST_STEP = 1e-6
SMALLEST_COSINE = 0.9  # cosine between two tangents, below which a step is halved ...
CORNER_STEP = 1e-3  # ... unless it is this short: where a contact opens, a branch has a corner
STEPS_OVER_CORNER = (1e-4, 1e-3, 1e-2)  # over such a corner
MAX_STEPS = 400
MAX_CORRECTIONS = 10  # Newton steps back to the branch
FEW_CORRECTIONS = 4  # corrections up to which the next step may be longer
SMALLEST_DAMPING = 0.1  # of a Newton step
ROUNDING = 1e-9  # residual from where rounding decides whether a step looks smaller
MAX_LOCATIONS = 30  # evaluations for a point between two others
LOCATION_TOLERANCE = 1e-9  # of the distance between them


class BranchEnd(StrEnum):
    """Why a branch is not followed further."""

    RANGE_LEFT = "range left"
    STEP_TOO_SHORT = "step too short"
    LIMIT = "step limit"
    NO_START = "no solution to begin with"


@dataclass(frozen=True)
class LinearisedEquations:
    """Equations and their derivatives at a state."""

    residual: NDArray  # (N)
    by_parameter: NDArray  # (N)
    solve: Callable[[NDArray], NDArray]  # unknowns (N, R) for right-hand sides (N, R)
    converged: bool  # whether the residual is small enough


class ParametricEquations(Protocol):
    """Equations in N unknowns that depend on a parameter."""

    @property
    def weight(self) -> NDArray:
        """Weight (N) of the square of each unknown in the length of a branch; the parameter has one."""
        ...

    def at(self, state: NDArray, parameter: float) -> LinearisedEquations:
        """Equations at a state (N)."""
        ...

    def bounded(self, before: NDArray, after: NDArray) -> NDArray:
        """Keep a step from one state to another inside what makes sense."""
        ...


@dataclass(frozen=True)
class BranchDirection:
    """Tangent of a branch, of length one in the weighted norm."""

    state: NDArray  # (N)
    parameter: float

    def turned(self) -> "BranchDirection":
        """Return the opposite direction."""
        return BranchDirection(-self.state, -self.parameter)

    def along(self, weight: NDArray, state: NDArray, parameter: float) -> float:
        """Length of a displacement along this direction."""
        return float(self.state @ (weight * state)) + self.parameter * parameter


@dataclass(frozen=True)
class BranchPoint:
    """A solution on the branch."""

    state: NDArray  # (N)
    parameter: float
    tangent: BranchDirection
    corrections: int  # Newton steps it took
    fold: bool = False  # whether the parameter turns back here

    def cosine(self, problem: ParametricEquations, other: "BranchPoint") -> float:
        """Cosine between the tangents of two points."""
        return self.tangent.along(problem.weight, other.tangent.state, other.tangent.parameter)

    def distance(self, problem: ParametricEquations, other: "BranchPoint") -> float:
        """Distance of another point along the tangent of this one."""
        return self.tangent.along(problem.weight, other.state - self.state, other.parameter - self.parameter)


@dataclass(frozen=True)
class FollowedBranch:
    """A branch, point by point."""

    points: tuple[BranchPoint, ...]
    end: BranchEnd


@dataclass(frozen=True)
class CorrectedPoint:
    """Solution that the corrector found."""

    state: NDArray
    parameter: float
    equations: LinearisedEquations
    corrections: int

    def oriented(self, problem: ParametricEquations, sense: BranchDirection) -> BranchPoint:
        """Point of the branch with its tangent in the sense of a direction."""
        way = tangent(problem, self.equations)
        if sense.along(problem.weight, way.state, way.parameter) < 0:
            way = way.turned()
        return BranchPoint(self.state, self.parameter, way, self.corrections)


def follow(
    problem: ParametricEquations, state: NDArray, start: float, bounds: tuple[float, float], upwards: bool
) -> FollowedBranch:
    r"""Follow a branch from a solution at one parameter until the parameter leaves its bounds.

    Predictor along the tangent, corrector on the plane across it:

    .. math:: R(x, p) = 0,\qquad \dot x \cdot W (x - x_0) + \dot p\,(p - p_0) = \Delta s

    The step grows while few corrections are needed and is halved where the branch bends too much. Folds,
    where dp/ds changes its sign, are located and stand among the points.

    The state is near a solution at the parameter `start`, within the bounds (smallest, largest). Without a
    solution there the branch has no point; a branch that leaves the range ends exactly on its bound, which
    may be where it began.

    Source
    ------
    Keller (1977), pseudo-arclength continuation; Allgower and Georg, Introduction to Numerical
    Continuation Methods (2003), ch. 6.
    """
    begin = solved_at(problem, state, start)
    if begin is None:
        return FollowedBranch((), BranchEnd.NO_START)
    points = [begin if upwards else replace(begin, tangent=begin.tangent.turned())]
    length = FIRST_STEP
    for _ in range(MAX_STEPS):
        before = points[-1]
        after, length = _next_point(problem, before, length)
        if after is None:
            return FollowedBranch(tuple(points), BranchEnd.STEP_TOO_SHORT)
        for point in (*_folds_between(problem, before, after), after):
            inside = min(max(point.parameter, bounds[0]), bounds[1])
            if inside != point.parameter:
                last = at_parameter(problem, points[-1], point, inside)
                end = BranchEnd.STEP_TOO_SHORT if last is None else BranchEnd.RANGE_LEFT
                return FollowedBranch((*points, last) if last else tuple(points), end)
            points.append(point)
    return FollowedBranch(tuple(points), BranchEnd.LIMIT)


def _next_point(
    problem: ParametricEquations, before: BranchPoint, length: float
) -> tuple[BranchPoint | None, float]:
    """Next point and the length to try after it; none when the step became too short."""
    while length >= SHORTEST_STEP:
        after = advanced(problem, before, length)
        if after is not None and (before.cosine(problem, after) > SMALLEST_COSINE or length < CORNER_STEP):
            growth = 1.7 if after.corrections <= FEW_CORRECTIONS else 0.8
            return after, min(growth * length, LONGEST_STEP)
        length /= 2
    # Over a corner, from so near that shorter steps end within its rounding.
    for length in STEPS_OVER_CORNER:
        after = advanced(problem, before, length)
        if after is not None and after.distance(problem, before) < 0:
            return after, length
    return None, 0.0


def advanced(problem: ParametricEquations, before: BranchPoint, length: float) -> BranchPoint | None:
    """The point a length further along the tangent; none when Newton's method does not reach it."""
    way = before.tangent
    guess = problem.bounded(before.state, before.state + length * way.state)
    solution = corrected(problem, guess, before.parameter + length * way.parameter, way)
    after = solution and solution.oriented(problem, way)
    # Right on a fold the matrix may be singular.
    return after if after and np.isfinite(after.tangent.state).all() else None


def solved_at(problem: ParametricEquations, state: NDArray, parameter: float) -> BranchPoint | None:
    """The point at a given parameter, near a state; its tangent points to larger parameters."""
    upwards = BranchDirection(np.zeros_like(state), 1.0)
    solution = corrected(problem, state, parameter, upwards)
    return solution and solution.oriented(problem, upwards)


def corrected(
    problem: ParametricEquations, state: NDArray, parameter: float, across: BranchDirection
) -> CorrectedPoint | None:
    r"""Newton's method on the equations with one more row, solved by the bordering lemma.

    .. math:: J u = -R,\; J v = R_p,\; \Delta x = u - v\,\Delta p,\;
              \Delta p = -\frac{\dot x \cdot W u}{\dot p - \dot x \cdot W v}

    Every step is taken `across` a direction: the tangent, or that of the parameter, which then keeps
    its value. A step is halved as long as the residual grows.

    Source
    ------
    Keller (1977); Allgower and Georg, Introduction to Numerical Continuation Methods (2003).
    """
    equations, damping, step = problem.at(state, parameter), 1.0, (np.zeros_like(state), 0.0)
    start, smallest = (state, parameter), np.inf
    for corrections in range(MAX_CORRECTIONS + 1):
        residual = float(np.linalg.norm(equations.residual))
        if not residual < max(smallest, ROUNDING):  # also when it is not a number
            if (damping := damping / 2) < SMALLEST_DAMPING:
                return None
        elif equations.converged:
            return CorrectedPoint(state, parameter, equations, corrections)
        else:
            start, smallest, damping = (state, parameter), residual, 1.0
            step = _newton_step(problem, equations, across)
            if not (isfinite(step[1]) and np.isfinite(step[0]).all()):
                return None
        state = problem.bounded(start[0], start[0] + damping * step[0])
        parameter = start[1] + damping * step[1]
        equations = problem.at(state, parameter)
    return None


def _newton_step(
    problem: ParametricEquations, equations: LinearisedEquations, across: BranchDirection
) -> tuple[NDArray, float]:
    """Change of state and parameter; not a number where no step leads across."""
    u, v = equations.solve(np.column_stack([-equations.residual, equations.by_parameter])).T
    along_u, along_v = (across.along(problem.weight, part, 0.0) for part in (u, v))
    slope = across.parameter - along_v
    change = -along_u / slope if slope else nan
    return u - v * change, change


def tangent(problem: ParametricEquations, equations: LinearisedEquations) -> BranchDirection:
    """Tangent of the branch at a solution, towards larger parameters."""
    change = -equations.solve(equations.by_parameter[:, None])[:, 0]
    length = np.sqrt(change @ (problem.weight * change) + 1.0)
    with np.errstate(invalid="ignore"):
        return BranchDirection(change / length, float(1.0 / length))


# -- points between two others ---------------------------------------------------------------------


def located(
    problem: ParametricEquations,
    before: BranchPoint,
    after: BranchPoint,
    measure: Callable[[BranchPoint], float],
) -> BranchPoint:
    """The point between two others where a measure changes its sign, by regula falsi (Illinois).

    Points are a variable length in front of the first one, so that it works around folds too.
    Where Newton's method fails in between it is the nearest point so far.
    """
    span = before.distance(problem, after)
    low, high, below, above = 0.0, span, measure(before), measure(after)
    best, last = before if abs(below) < abs(above) else after, 0.0
    for _ in range(MAX_LOCATIONS):
        if abs(high - low) <= LOCATION_TOLERANCE * span or below == above or measure(best) == 0.0:
            break
        middle = high - above * (high - low) / (above - below)
        between = advanced(problem, before, middle)
        if between is None:
            break
        value = measure(between)
        best = between if abs(value) < abs(measure(best)) else best
        if value * above < 0:
            low, below = high, above
        else:
            below = below / 2
        if abs(middle - last) <= LOCATION_TOLERANCE * span:
            break
        high, above, last = middle, value, middle
    return best


def _folds_between(
    problem: ParametricEquations, before: BranchPoint, after: BranchPoint
) -> tuple[BranchPoint, ...]:
    """The fold between two points, where the parameter turns back; empty when it does not."""
    if before.tangent.parameter * after.tangent.parameter >= 0:
        return ()
    return (replace(located(problem, before, after, lambda point: point.tangent.parameter), fold=True),)


def at_parameter(
    problem: ParametricEquations, before: BranchPoint, after: BranchPoint, parameter: float
) -> BranchPoint | None:
    """The point between two others at a given parameter; none when Newton's method does not reach it."""
    near = located(problem, before, after, lambda point: point.parameter - parameter)
    return solved_at(problem, near.state, parameter)
