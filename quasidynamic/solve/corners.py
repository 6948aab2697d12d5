"""A branch of piecewise smooth equations followed around its corners."""

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from quasidynamic.solve.arclength import Direction, End, Family, Step, corrected, follow

TURNS = 20  # corners on a path, rarely more than one
PEEKS = (1e-6, 1e-5, 1e-4)  # beyond a corner, to see the equations there
STRIDES = (10.0, 100.0, 1000.0)  # over that: length of the first step on the new piece
SAME = 0.99  # cosine between two directions that are no corner
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
    is swept away at once. There the equations beyond the corner tell the new direction.

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
        last = path.steps[-1]
        if path.end is End.RANGE_LEFT:
            return last if last.parameter == 1.0 else None
        turned = _around(family, last, first) if path.end is End.STEP_TOO_SHORT else last
        if turned is None:
            return None
        state, parameter, upwards = turned.state, turned.parameter, turned.tangent.parameter > 0
    return None


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
            sense = first * family.orientation(step.state, step.parameter)
            if near and sense * step.tangent.parameter > 0:
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
