"""A roller's length cut into slices, and the axial modes that carry load and displacement."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import ImpossiblePart


@dataclass(frozen=True)
class Slices:
    """Equal slices along a roller, with Legendre polynomials as axial modes.

    A displacement along the roller is sum_m a_m L_m(2x/l); the force conjugate to a_m is
    F_m = sum_k q_k L_m(2 x_k/l) l/K. F_0 is the load, F_1 l/2 the moment about mid-roller.

    With one axial mode neither roller nor raceway tilts: both halves of the roller carry the same load, and
    only one of them is computed.
    """

    count: int
    length: float  # [m]
    axial_modes: int = 2  # how many Legendre polynomials; 1 is an aligned roller, 2 has a tilt

    def __post_init__(self):
        if self.count < 2 or self.axial_modes < 1:
            raise ImpossiblePart("a roller needs at least 2 slices and 1 axial mode")
        if self.axial_modes > self.count:
            raise ImpossiblePart(f"{self.axial_modes} axial modes need as many slices, found {self.count}")

    @property
    def halved(self) -> bool:
        """Whether one half stands for both."""
        return self.axial_modes == 1

    @cached_property
    def all_centres(self) -> NDArray:
        """Centres of all slices (count) from mid-roller [m]."""
        return (np.arange(self.count) + 0.5) * self.length / self.count - self.length / 2

    @cached_property
    def centres(self) -> NDArray:
        """Centres x (K) of the slices that are computed, from mid-roller [m]."""
        return self.all_centres[self.count // 2 :] if self.halved else self.all_centres

    @cached_property
    def widths(self) -> NDArray:
        """Length of roller (K) that each computed slice stands for [m]."""
        widths = np.full(len(self.centres), (1 + self.halved) * self.width)
        if self.halved and self.count % 2:
            widths[0] = self.width  # the middle slice has no twin
        return widths

    @property
    def width(self) -> float:
        """Width of a slice [m]."""
        return self.length / self.count

    @cached_property
    def modes(self) -> NDArray:
        r"""Legendre polynomials L_m at the computed slices (K, M) [-].

        .. math:: (m + 1)(L_{m+1} - L_m) = (2m + 1)(x - 1) L_m + m (L_m - L_{m-1})

        Source
        ------
        Bonnet's recurrence, in differences, which keep their digits at the ends of the roller.
        """
        x = 2 * self.centres / self.length
        difference, modes = x - 1, [np.ones_like(x), x]
        for m in range(1, self.axial_modes - 1):
            difference = (2 * m + 1) / (m + 1) * (x - 1) * modes[-1] + m / (m + 1) * difference
            modes.append(modes[-1] + difference)
        return np.stack(modes[: self.axial_modes], axis=-1)

    def spread(self, coefficients: NDArray) -> NDArray:
        """Values (K, ...) at the computed slices from coefficients (M, ...) of the axial modes."""
        return _product(self.modes, coefficients)

    def total(self, values: NDArray) -> NDArray:
        """Integral (...) along the roller of values (K, ...) per length."""
        return self.widths.dot(values.reshape(len(values), -1)).reshape(values.shape[1:])

    def summed(self, values: NDArray) -> NDArray:
        """Integrals (M, ...) of values (K, ...) per length times the axial modes."""
        return _product(self.weights.T, values)

    def paired(self, values: NDArray) -> NDArray:
        """Integrals (M, M, ...) of values (K, ...) per length times products of two axial modes."""
        return _product(self.products.T, values).reshape(
            self.axial_modes, self.axial_modes, *values.shape[1:]
        )

    @cached_property
    def weights(self) -> NDArray:
        """Forces from loads per length: shape times width (K, M) [m]."""
        return self.modes * self.widths[:, None]

    @cached_property
    def products(self) -> NDArray:
        """Products of two axial modes times width (K, M M), for stiffness sums [m]."""
        return (self.modes[:, :, None] * self.weights[:, None, :]).reshape(len(self.centres), -1)

    def unfolded(self, values: NDArray) -> NDArray:
        """Values (..., count) at all slices from those (..., K) at the computed ones."""
        if not self.halved:
            return values
        twins = values[..., self.count % 2 :]
        return np.concatenate([twins[..., ::-1], values], axis=-1)


def _product(matrix: NDArray, values: NDArray) -> NDArray:
    """Weighted sums (n, ...) over the first axis of values (K, ...), weights (n, K)."""
    # Quicker than `@` where it is small.
    return matrix.dot(values.reshape(len(values), -1)).reshape(-1, *values.shape[1:])
