"""A roller's length cut into slices, and the axial shapes that carry load and displacement."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from quasidynamic.errors import ImpossiblePart


@dataclass(frozen=True)
class Slices:
    """Equal slices along a roller, with Legendre polynomials as axial shapes.

    A displacement along the roller is sum_m a_m L_m(2x/l); the force conjugate to a_m is
    F_m = sum_k q_k L_m(2 x_k/l) l/K. F_0 is the load, F_1 l/2 the moment about mid-roller.
    """

    count: int
    length: float  # [m]
    shapes: int = 2  # how many Legendre shapes, at least load and tilt

    def __post_init__(self):
        if self.count < 2 or self.shapes < 2:
            raise ImpossiblePart("a roller needs at least 2 slices and 2 axial shapes")
        if self.shapes > self.count:
            raise ImpossiblePart(f"{self.shapes} axial shapes need as many slices, found {self.count}")

    @cached_property
    def centres(self) -> NDArray:
        """Slice centres x (K) from mid-roller [m]."""
        return (np.arange(self.count) + 0.5) * self.length / self.count - self.length / 2

    @property
    def width(self) -> float:
        """Width of a slice [m]."""
        return self.length / self.count

    @cached_property
    def shape(self) -> NDArray:
        """Legendre polynomials at the slice centres (K, M) [-]."""
        return legendre.legvander(2 * self.centres / self.length, self.shapes - 1)

    @cached_property
    def products(self) -> NDArray:
        """Products of two shapes at the slice centres (K, M M), for stiffness sums."""
        return (self.shape[:, :, None] * self.shape[:, None, :]).reshape(self.count, -1)
