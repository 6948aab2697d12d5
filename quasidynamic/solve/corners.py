"""A branch of piecewise smooth equations followed around its corners."""

from typing import Protocol

from numpy.typing import NDArray

from quasidynamic.solve.arclength import (
    MAX_STEPS,
    SHORTEST_STEP,
    SMALLEST_COSINE,
    BranchDirection,
    BranchEnd,
    BranchPoint,
    ParametricEquations,
    advanced,
    corrected,
    follow,
    tangent,
)

MAX_CORNERS = 20  # corners on a path and stretches of short steps, rarely more than one
PROBES = (1e-6, 1e-5, 1e-4)  # distances beyond a corner at which the equations there are looked at
FIRST_STEPS = (10.0, 100.0, 1000.0)  # over that: length of the first step on the new piece
CORNER_COSINE = 0.99  # cosine between two directions that are no corner
STEP_GROWTH = 1.5  # of a step after one that kept the sense
NEW_PIECE_COSINE = 0.7  # between the direction of the new piece at the corner and after the first step


class OrientedEquations(ParametricEquations, Protocol):
    """Equations in N unknowns whose derivatives have a determinant to be had."""

    def orientation(self, state: NDArray, parameter: float) -> float:
        """Sign of the determinant of the derivatives by the unknowns."""
        ...


def followed_through(problem: OrientedEquations, state: NDArray) -> BranchPoint | None:
    r"""The point at parameter 1 of the branch that starts at parameter 0 near a state.

    Along a branch of piecewise smooth equations one sense is kept by

    .. math:: \operatorname{sign} \dot p = \pm \operatorname{sign} \det R_x

    also where the branch bends back on itself by a sharp corner, as when a body touches another one and is
    swept away at once. There the equations beyond the corner tell the new direction. A step that does not
    keep the sense has leapt to another branch nearby, and shorter ones take its place.

    None where the branch is lost or comes back to parameter 0.

    Source
    ------
    Allgower and Georg, Introduction to Numerical Continuation Methods (2003), ch. 2 and 12.
    """
    parameter, upwards, start_sense = 0.0, True, problem.orientation(state, 0.0)
    for _ in range(MAX_CORNERS):
        branch = follow(problem, state, parameter, (0.0, 1.0), upwards)
        points = _in_sense(problem, branch.points, start_sense)
        if not points:
            return None
        last = points[-1]
        if len(points) < len(branch.points):
            following = _in_short_steps(problem, last, branch.points[len(points)], start_sense)
        elif branch.end is BranchEnd.RANGE_LEFT:
            return last if last.parameter == 1.0 else None
        else:
            at_corner = branch.end is BranchEnd.STEP_TOO_SHORT
            following = _around(problem, last, start_sense) if at_corner else last
        if following is None:
            return None
        state, parameter, upwards = following.state, following.parameter, following.tangent.parameter > 0
    return None


def _in_sense(
    problem: OrientedEquations, points: tuple[BranchPoint, ...], start_sense: float
) -> tuple[BranchPoint, ...]:
    """Points before the first one that does not keep the sense; right on a fold there is none to keep."""
    kept = 0
    for number, point in enumerate(points, 1):
        if point.fold:
            continue
        if not _keeps_sense(problem, point, start_sense):
            return points[:kept]
        kept = number
    return points


def _keeps_sense(problem: OrientedEquations, point: BranchPoint, start_sense: float) -> bool:
    """Whether a point has the sense of the branch: the sign of det R_x where the branch starts."""
    return start_sense * problem.orientation(point.state, point.parameter) * point.tangent.parameter > 0


def _in_short_steps(
    problem: OrientedEquations, before: BranchPoint, lost: BranchPoint, start_sense: float
) -> BranchPoint | None:
    """Point on the branch where a step was lost, after shorter ones, or around the corner there."""
    ahead = before.distance(problem, lost)
    length = ahead / 2
    for _ in range(MAX_STEPS):
        if length < SHORTEST_STEP:
            return _around(problem, before, start_sense)
        after = advanced(problem, before, length)
        if (
            after is None
            or not _keeps_sense(problem, after, start_sense)
            or before.cosine(problem, after) <= SMALLEST_COSINE
        ):
            length /= 2
            continue
        if not 0.0 <= after.parameter <= 1.0:
            return before
        before, ahead, length = after, ahead - length, STEP_GROWTH * length
        if ahead <= 0:
            return before
    return None


def _around(problem: OrientedEquations, before: BranchPoint, start_sense: float) -> BranchPoint | None:
    """First point beyond the corner just ahead, in the direction that the equations there have."""
    for probe in PROBES:
        state, parameter = _moved(before.state, before.parameter, before.tangent, probe)
        beyond = tangent(problem, problem.at(state, parameter))
        if start_sense * problem.orientation(state, parameter) < 0:
            beyond = beyond.turned()
        cosine = before.tangent.along(problem.weight, beyond.state, beyond.parameter)
        if not cosine < CORNER_COSINE:  # also not a number
            continue
        for ratio in FIRST_STEPS:
            guess = _moved(state, parameter, beyond, ratio * probe)
            solution = corrected(problem, *guess, beyond)
            if solution is None:
                continue
            point = solution.oriented(problem, beyond)
            near = beyond.along(problem.weight, point.tangent.state, point.tangent.parameter)
            if near > NEW_PIECE_COSINE and _keeps_sense(problem, point, start_sense):
                return point
    return None


def _moved(state: NDArray, parameter: float, way: BranchDirection, length: float) -> tuple[NDArray, float]:
    return state + length * way.state, parameter + length * way.parameter
