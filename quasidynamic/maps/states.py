"""Known states of the points of a grid, and how each continues at the neighbouring points."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quasidynamic.maps.examined import each_examined, examined
from quasidynamic.maps.newton_states import Mapped, Reached, apart
from quasidynamic.maps.points import GridPoints

SAME = 1e-3  # of the largest load, or of the spin in pure rolling: closer states are one
UNKNOWN, ENDS, OUTSIDE = -1, -2, -3  # of a state at a neighbouring point


class States:
    """S states; more are added while a map is solved. A state has 2 d neighbouring points.

    A state `continues` (S, 2 d) as another one, or it `ENDS` on the way at a share (S, 2 d) of it, where a
    fold is.
    """

    def __init__(self, points: GridPoints, first: Reached, mapped: Mapped = map):
        """States of which every point has one at most; what did not converge is none."""
        self._points = points
        self.at_point: list[list[int]] = [[] for _ in points.bearings]
        self.point = np.zeros(0, int)  # (S)
        self.reached = first.take(np.zeros(0, int))  # (S)
        self.stable = np.zeros(0, bool)  # (S) whether small disturbances of cage and spins decay
        self.doubtful = np.zeros(0, bool)  # (S) whether they are likely to be one of several
        self.continues = np.zeros((0, 2 * len(points.shape)), int)
        self.share = np.zeros((0, 2 * len(points.shape)))
        self.last: dict[tuple[int, int], tuple[float, NDArray]] = {}  # share and unknowns before a side ends
        solved = np.flatnonzero(first.converged)
        self._append(solved, first.take(solved), each_examined(points, first, mapped)[solved])

    def __len__(self) -> int:
        return len(self.point)

    def add(self, points: NDArray, found: Reached) -> NDArray:
        """Add stable states (n) that are not known yet, and those that did not converge not at all."""
        names = np.array([self.known(point, found, n) for n, point in enumerate(points)], int)
        unknown = np.flatnonzero((names < 0) & found.converged)
        each = examined(self._points, points[unknown], found.take(unknown))
        for place, (rate, likely) in zip(unknown.tolist(), each, strict=True):
            some = np.array([place])
            if rate < 0 and self.known(points[place], found, place) < 0:  # by those before it
                self._append(points[some], found.take(some), np.array([[True, likely > 0]]))
            names[place] = self.known(points[place], found, place)
        return names

    def known(self, point: Any, found: Reached, place: int) -> int:
        """Which state at a point one of several that were found is; -1 where it is none."""
        there = np.array(self.at_point[point], int)
        if not len(there) or not found.converged[place]:
            return -1
        one = found.take(np.full(len(there), place))
        distance = apart(one, self.reached.take(there))
        return int(there[distance.argmin()]) if distance.min() < SAME else -1

    def connect(self, states: NDArray, sides: NDArray, others: NDArray) -> None:
        """Take note that states (n) continue towards sides (n) as others (n)."""
        self.continues[states, sides] = others
        self.continues[others, sides ^ 1] = states

    @property
    def waiting(self) -> tuple[NDArray, NDArray]:
        """States (n) and sides (n) towards which it is not known how they continue."""
        states, sides = np.nonzero(self.continues == UNKNOWN)
        return states, sides

    @property
    def stable_count(self) -> NDArray:
        """Number of stable states at each point (C)."""
        return np.bincount(self.point[self.stable], minlength=len(self.at_point))

    def _append(self, points: NDArray, found: Reached, examination: NDArray) -> None:
        begin = len(self.point)
        self.point = np.concatenate([self.point, points])
        self.reached = Reached.joined([self.reached, found])
        self.stable = np.concatenate([self.stable, examination[:, 0]])
        self.doubtful = np.concatenate([self.doubtful, examination[:, 1]])
        beside = self._points.neighbours[points]
        self.continues = np.concatenate([self.continues, np.where(beside < 0, OUTSIDE, UNKNOWN)])
        self.share = np.concatenate([self.share, np.full(beside.shape, np.nan)])
        for place, point in enumerate(points):
            self.at_point[point].append(begin + place)
