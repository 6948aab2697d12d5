"""The scatter of an output by its derivatives alone."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

NARROW = 0.1  # standard deviation over the mean up to which a logarithm makes no difference


@dataclass(frozen=True, eq=False)
class Linear:
    """An output, or its logarithm, to first order about the means of D independent random numbers."""

    value: float  # at the means
    slopes: NDArray  # (D) of the output
    means: NDArray  # (D)
    deviations: NDArray  # (D) standard deviations of the numbers
    logarithmic: bool = False  # whether the logarithm is linear; the value is above zero then

    @property
    def variances(self) -> NDArray:
        r"""Contribution of each number to the variance (D) of the output, or of its logarithm.

        .. math:: \sigma^2 = \sum_d \left(\frac{\partial f}{\partial x_d}\right)^2 \sigma_d^2

        Source
        ------
        JCGM 100:2008, Guide to the expression of uncertainty in measurement, eq. (10).
        """
        return (self._slopes * self.deviations) ** 2

    @property
    def mean(self) -> float:
        r"""Mean of the output; of a logarithm :math:`f e^{\sigma^2/2}`, that of a logarithmic normal law."""
        if not self.logarithmic:
            return self.value
        with np.errstate(over="ignore"):  # infinite, as that of the law is to the digits of a float
            return self.value * float(np.exp(self.variances.sum() / 2))

    @property
    def deviation(self) -> float:
        r"""Standard deviation of the output; of a logarithm :math:`\bar f \sqrt{e^{\sigma^2} - 1}`."""
        variance = float(self.variances.sum())
        if not self.logarithmic:
            return np.sqrt(variance)
        with np.errstate(over="ignore"):
            return self.mean * np.sqrt(np.expm1(variance))

    def at(self, numbers: NDArray) -> NDArray:
        """The output (n) at drawn numbers (n, D)."""
        change = (numbers - self.means) @ self._slopes
        with np.errstate(over="ignore"):
            return self.value * np.exp(change) if self.logarithmic else self.value + change

    @property
    def _slopes(self) -> NDArray:
        return self.slopes / self.value if self.logarithmic else self.slopes


def is_skewed(values: NDArray) -> bool:
    """Whether values above zero scatter widely, their logarithms more evenly about the mean."""
    if (values <= 0).any() or values.std() < NARROW * values.mean():
        return False
    return abs(_skewness(np.log(values))) < abs(_skewness(values))


def _skewness(values: NDArray) -> float:
    """Third moment about the mean over the third power of the standard deviation [-]."""
    from_mean = values - values.mean()
    return float((from_mean**3).mean() / (from_mean**2).mean() ** 1.5)


def explained(sampled: NDArray, predicted: NDArray) -> float:
    """Share of the variance of sampled values that a prediction of the same rows explains."""
    variance = np.var(sampled)
    return float(1 - np.var(sampled - predicted) / variance) if variance else float("nan")
