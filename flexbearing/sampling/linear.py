"""The scatter of an output by its derivatives alone."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Linear:
    """An output to first order about the means of D independent random numbers."""

    value: float  # at the means
    slopes: NDArray  # (D)
    means: NDArray  # (D)
    deviations: NDArray  # (D) standard deviations of the numbers

    @property
    def variances(self) -> NDArray:
        r"""Contribution of each number to the variance (D).

        .. math:: \sigma^2 = \sum_d \left(\frac{\partial f}{\partial x_d}\right)^2 \sigma_d^2

        Source
        ------
        JCGM 100:2008, Guide to the expression of uncertainty in measurement, eq. (10).
        """
        return (self.slopes * self.deviations) ** 2

    @property
    def deviation(self) -> float:
        """Standard deviation of the output."""
        return float(np.sqrt(self.variances.sum()))

    def at(self, numbers: NDArray) -> NDArray:
        """The output (n) at drawn numbers (n, D)."""
        return self.value + (numbers - self.means) @ self.slopes


def explained(sampled: NDArray, predicted: NDArray) -> float:
    """Share of the variance of sampled values that a prediction of the same rows explains."""
    variance = np.var(sampled)
    return float(1 - np.var(sampled - predicted) / variance) if variance else float("nan")
