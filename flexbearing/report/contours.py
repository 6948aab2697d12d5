"""Contours of an output over two keys."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Contours:
    """Values of an output that are drawn as lines."""

    limits: tuple[float, ...] = ()  # from where, or below which, the bearing is in danger
    levels: tuple[float, ...] = ()  # of what has no limit

    def within(self, values: NDArray) -> "Contours":
        """Those that lie between the smallest and the largest value."""
        finite = values[np.isfinite(values)]
        if not finite.size:
            return Contours()
        low, high = finite.min(), finite.max()
        limits, levels = (
            tuple(value for value in each if low < value < high) for each in (self.limits, self.levels)
        )
        return Contours(limits, levels)
