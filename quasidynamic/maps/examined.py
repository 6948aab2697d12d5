"""Whether states of a grid are stable and whether several are likely, where their neighbours do not tell."""

from itertools import product

import numpy as np
from numpy.typing import NDArray

from quasidynamic.maps.newton_states import Mapped, Reached, apart, tasks
from quasidynamic.maps.points import GridPoints
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.several.indicator import each_several_likely
from quasidynamic.solve.rollers.pseudo_time import growth_rates

EVERY = 2  # points along an axis one is examined without asking its neighbours
NEAR = 0.02  # of the largest load or of pure rolling: states that are alike


def examined(points: GridPoints, at: NDArray, states: Reached, mapped: Mapped = map) -> NDArray:
    """Largest growth rate [1/s] of states (n) at some points (n), and whether several are likely: (n, 2).

    The rate is not a number where the Jacobian is singular.
    """
    each = tasks(lambda some: points.at(at[some]), states.scaled)
    return np.concatenate([np.zeros((0, 2)), *mapped(_examined, each)])


def _examined(task) -> NDArray:
    balance, scaled = task
    states = BearingStates(balance, scaled, balance.roller.axial_modes)
    rates = np.real(growth_rates(balance, states.system)).max(axis=1)
    return np.stack([rates, each_several_likely(states)], axis=1)


def each_examined(points: GridPoints, states: Reached, mapped: Mapped = map) -> NDArray:
    """Whether the state of each point is stable, and whether several are likely: (C, 2), of bool.

    Every second point along each axis is examined, and every other one whose stability these do not imply;
    see `implied`.
    """
    every = np.arange(len(points.bearings)).reshape(points.shape)
    first = every[np.ix_(*(_examined_along(count) for count in points.shape))].ravel()
    found = np.full((len(every.ravel()), 2), np.nan)
    for some in (
        lambda: first,
        lambda: np.flatnonzero(np.isnan(found[:, 1]) & ~implied(points, states, found)),
    ):
        those = some()
        those = those[states.converged[those]]
        found[those] = examined(points, those, states.take(those), mapped)
    unknown = np.isnan(found[:, 1])
    return np.stack([unknown | (found[:, 0] < 0), ~unknown & (found[:, 1] > 0)], axis=1)


def implied(points: GridPoints, states: Reached, found: NDArray) -> NDArray:
    """Where the examined corners of a cell of the grid imply a stable state that is the only one (C).

    At none of them several are likely, their growth rates are further below zero than they differ among
    themselves, and the state is as near to them as they are to each other.
    """
    corners = _corners(points.shape)
    rates, likely = found[corners, 0], found[corners, 1]
    largest, smallest = rates.max(axis=1), rates.min(axis=1)
    far_below = (largest + (largest - smallest) < 0) & (likely == 0).all(axis=1)
    one, last = states.take(corners[:, 0]), states.take(corners[:, -1])
    between = np.array(
        [np.maximum(apart(one, other), apart(last, other)) for other in map(states.take, corners.T)]
    )
    own = np.array([apart(states, other) for other in map(states.take, corners.T)])
    return far_below & (own.max(axis=0) <= NEAR + between.max(axis=0))


def _examined_along(count: int) -> NDArray:
    return np.unique(np.append(np.arange(0, count, EVERY), count - 1))


def _corners(shape: tuple[int, ...]) -> NDArray:
    """Points (C, 2^d) around each one that are examined without asking their neighbours."""
    sides = []
    for count in shape:
        places, nodes = np.arange(count), _examined_along(count)
        above = np.searchsorted(nodes, places)
        below = np.where(nodes[above] == places, above, above - 1)
        sides.append((nodes[below], nodes[above]))
    corners = [
        np.ravel_multi_index(
            np.ix_(*(side[end] for side, end in zip(sides, ends, strict=True))), shape
        ).ravel()
        for ends in product((0, 1), repeat=len(shape))
    ]
    return np.stack(corners, axis=1)
