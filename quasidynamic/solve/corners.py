"""A branch of piecewise smooth equations followed around its corners."""

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from quasidynamic.solve.arclength import (
    LIMIT,
    SHORTEST,
    STRAIGHT,
    Direction,
    End,
    Family,
    Step,
    advanced,
    corrected,
    follow,
)

TURNS = 20  # corners on a path and stretches of short steps, rarely more than one
PEEKS = (1e-6, 1e-5, 1e-4)  # beyond a corner, to see the equations there
STRIDES = (10.0, 100.0, 1000.0)  # over that: length of the first step on the new piece
SAME = 0.99  # cosine between two directions that are no corner
GROWTH = 1.5  # of a step after one that kept the sense
NEAR = 0.7  # cosine between the direction of the new piece at the corner and after the first step


class OrientedFamily(Family, Protocol):
    """Equations in N unknowns whose derivatives have a determinant to be had."""

    def orientation(self, state: NDArray, parameter: float) -> float:
        """Sign of the determinant of the derivatives by the unknowns."""
        ...


def followed_through(family: OrientedFamily, state: NDArray) -> Step | None:
    r"""The place at parameter 1 of the branch that starts at parameter 0 near a state.

    Along a branch of piecewise smooth equations one sense is kept by

    .. math:: \operatorname{sign} \dot p = \pm \operatorname{sign} \det R_x

    also where the branch bends back on itself by a sharp corner, as when a body touches another one and
    is swept away at once. There the equations beyond the corner tell the new direction. A step that does
    not keep the sense has leapt to another branch nearby, and shorter ones take its place.

    Parameters
    ----------
    family : OrientedFamily
        equations
    state : array (N)
        near a solution at parameter 0

    Returns
    -------
    Step or None
        None where the branch is lost or comes back to parameter 0

    Source
    ------
    Allgower and Georg, Introduction to Numerical Continuation Methods (2003), ch. 2 and 12.
    """
    parameter, upwards, first = 0.0, True, family.orientation(state, 0.0)
    for _ in range(TURNS):
        path = follow(family, state, parameter, (0.0, 1.0), upwards)
        if not path.steps:
            return None
        steps = _in_sense(family, path.steps, first)
        if not steps:
            return None
        last = steps[-1]
        if len(steps) < len(path.steps):
            turned = _closely(family, last, path.steps[len(steps)], first)
        elif path.end is End.RANGE_LEFT:
            return last if last.parameter == 1.0 else None
        else:
            turned = _around(family, last, first) if path.end is End.STEP_TOO_SHORT else last
        if turned is None:
            return None
        state, parameter, upwards = turned.state, turned.parameter, turned.tangent.parameter > 0
    return None


def _in_sense(family: OrientedFamily, steps: tuple[Step, ...], first: float) -> tuple[Step, ...]:
    """Steps before the first one that does not keep the sense; right on a fold there is none to keep."""
    kept = 0
    for number, step in enumerate(steps, 1):
        if step.fold:
            continue
        if not _keeps(family, step, first):
            return steps[:kept]
        kept = number
    return steps


def _keeps(family: OrientedFamily, step: Step, first: float) -> bool:
    """Whether a step has the sense of the branch; `first` is the sign of det R_x where the branch starts."""
    return first * family.orientation(step.state, step.parameter) * step.tangent.parameter > 0


def _closely(family: OrientedFamily, here: Step, lost: Step, first: float) -> Step | None:
    """Place on the branch where a step was lost, after shorter ones, or around the corner there."""
    ahead = here.tangent.along(family.weight, lost.state - here.state, lost.parameter - here.parameter)
    length = ahead / 2
    for _ in range(LIMIT):
        if length < SHORTEST:
            return _around(family, here, first)
        found = advanced(family, here, length)
        if found is None or not _keeps(family, found, first) or _bend(family, here, found) <= STRAIGHT:
            length /= 2
            continue
        if not 0.0 <= found.parameter <= 1.0:
            return here
        here, ahead, length = found, ahead - length, GROWTH * length
        if ahead <= 0:
            return here
    return None


def _bend(family: OrientedFamily, here: Step, ahead: Step) -> float:
    """Cosine between the directions of two steps."""
    return here.tangent.along(family.weight, ahead.tangent.state, ahead.tangent.parameter)


def _around(family: OrientedFamily, here: Step, first: float) -> Step | None:
    """First place beyond the corner just ahead; `first` is the sign of det R_x where the branch starts."""
    for peek in PEEKS:
        state, parameter = _moved(here.state, here.parameter, here.tangent, peek)
        way = _direction(family, state, parameter, first)
        if not here.tangent.along(family.weight, way.state, way.parameter) < SAME:  # also not a number
            continue
        for stride in STRIDES:
            guess = _moved(state, parameter, way, stride * peek)
            found = corrected(family, *guess, way)
            if found is None:
                continue
            step = found.step(family, way)
            near = way.along(family.weight, step.tangent.state, step.tangent.parameter) > NEAR
            if near and _keeps(family, step, first):
                return step
    return None


def _moved(state: NDArray, parameter: float, way: Direction, length: float) -> tuple[NDArray, float]:
    return state + length * way.state, parameter + length * way.parameter


def _direction(family: OrientedFamily, state: NDArray, parameter: float, first: float) -> Direction:
    """Direction of a branch by the equations near it."""
    local = family.at(state, parameter)
    change = -local.solve(local.by_parameter[:, None])[:, 0]
    sense = first * family.orientation(state, parameter)
    length = sense * np.sqrt(change @ (family.weight * change) + 1.0)
    return Direction(change / length, float(1.0 / length))
