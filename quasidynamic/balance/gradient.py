"""A quantity of every roller that carries its derivatives along."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Graded:
    """Values (Z) and their derivatives (Z, inputs): the chain rule, so that a balance reads like print."""

    value: NDArray
    gradient: NDArray

    def __add__(self, other: "Graded") -> "Graded":
        return Graded(self.value + other.value, self.gradient + other.gradient)

    def __sub__(self, other: "Graded") -> "Graded":
        return Graded(self.value - other.value, self.gradient - other.gradient)

    def __rmul__(self, factor: float) -> "Graded":
        return Graded(factor * self.value, factor * self.gradient)

    def rounded_abs(self, width: float) -> "Graded":
        """Smooth absolute value, sqrt(x^2 + width^2) - width, exact at zero."""
        root = np.hypot(self.value, width)
        return Graded(root - width, (self.value / root)[:, None] * self.gradient)
