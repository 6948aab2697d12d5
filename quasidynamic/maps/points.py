"""Operating points on a grid, and any point between two neighbours, as bearings side by side."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.columns import kinds_and_numbers, with_columns
from quasidynamic.errors import OutOfRange
from quasidynamic.roller import Compliance, RollerBearing
from quasidynamic.solve.rollers.parametric_balance import between

RIGID: Compliance = (None, None)


@dataclass(frozen=True)
class GridPoints:
    """C operating points of a bearing on a grid, the last axis of which changes fastest."""

    shape: tuple[int, ...]
    bearings: tuple[RollerBearing, ...]  # (C)
    numbers: NDArray  # (C, n) what may differ between the bearings
    aligned: bool  # whether no roller can tilt anywhere
    compliance: Compliance = RIGID
    deviation: NDArray | None = None  # (C, 2, Z, M) of the raceways without load, outward [m]

    @classmethod
    def of(
        cls,
        shape: tuple[int, ...],
        bearings: Sequence[RollerBearing],
        compliance: Compliance = RIGID,
        deviation: NDArray | None = None,
    ) -> "GridPoints":
        """Points of bearings that differ in numbers only.

        Raises `OutOfRange` where not the same equations hold at all points.
        """
        kinds, numbers = kinds_and_numbers(bearings)
        if len(kinds) > 1 or len({each.operation.on_ribs for each in bearings}) > 1:
            raise OutOfRange("not the same equations hold at all points: more than numbers differs")
        rigid = deviation is None and compliance[0] is compliance[1] is None
        tilts = any(bearing.operation.tilts for bearing in bearings)
        aligned = rigid and not tilts and bearings[0].bearing.symmetric
        return cls(shape, tuple(bearings), numbers, aligned, compliance, deviation)

    @property
    def axial_modes(self) -> int:
        """Axial modes M that raceways exchange with the rollers."""
        return self.bearings[0].axial_modes

    @property
    def rigid(self) -> bool:
        """Whether both raceways are rigid."""
        return self.compliance[0] is self.compliance[1] is None

    def at(self, points: NDArray) -> BearingBalance:
        """Balance of bearings at some points (n)."""
        return self._balance.take(points)

    @cached_property
    def _balance(self) -> BearingBalance:
        return self._with(self.numbers, self.deviation)

    def between(self, first: NDArray, second: NDArray, share: NDArray) -> BearingBalance:
        """Balance of bearings at shares (n) of the ways from some points (n) to others (n).

        See `within`.
        """
        ends = (np.transpose(np.unravel_index(each, self.shape)) for each in (first, second))
        one, other = ends
        return self.within(one + share[:, None] * (other - one))

    def within(self, places: NDArray) -> BearingBalance:
        """Balance of bearings at places (n, d) within the grid, in steps from its first point.

        Numbers of the bearings are interpolated linearly along each axis: exact for loads, speeds and
        dimensions, nearly so for what follows from temperatures.
        """
        last = np.array(self.shape) - 1
        first = np.clip(np.floor(places).astype(int), 0, np.maximum(last - 1, 0))
        share, corners = places - first, list(product((0, 1), repeat=len(self.shape)))
        points = [
            np.ravel_multi_index(tuple(np.minimum(first + each, last).T), self.shape) for each in corners
        ]
        parts = [np.where(each, share, 1 - share).prod(axis=1) for each in corners]

        def interpolated(values: NDArray) -> NDArray:
            each = zip(parts, points, strict=True)
            return np.sum([(part * values[at].T).T for part, at in each], axis=0)

        deviation = None if self.deviation is None else interpolated(self.deviation)
        return self._with(interpolated(self.numbers), deviation)

    def _with(self, numbers: NDArray, deviation: NDArray | None) -> BearingBalance:
        bearing = with_columns(self.bearings[0], numbers, own=self.numbers[0])
        balance = bearing.balance(len(numbers), aligned=self.aligned)
        if len(numbers) == 1:
            balance = balance.take(np.array([0]))  # whose numbers are no columns
        if self.rigid:
            return replace(balance, deviation=deviation)
        return between(balance, self.compliance, deviation)

    @cached_property
    def neighbours(self) -> NDArray:
        """Neighbour (C, 2 d) of each point, down and up each of the d axes; -1 beyond the end."""
        places = np.arange(len(self.bearings)).reshape(self.shape)
        padded = np.pad(places, 1, constant_values=-1)
        middle = (slice(1, -1),) * len(self.shape)
        beside = [
            np.roll(padded, step, axis)[middle].ravel() for axis in range(len(self.shape)) for step in (1, -1)
        ]
        return np.stack(beside, axis=1)
