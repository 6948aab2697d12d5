"""Distributions of a random input."""

from dataclasses import dataclass
from math import log
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Distribution:
    """A distribution with one peak, and the value about which its spread can be made smaller."""

    law: Any  # frozen distribution of scipy.stats
    centre: float
    logarithmic: bool = False  # whether the spread is a factor of the centre, else a difference from it

    def quantile(self, probability: NDArray) -> NDArray:
        """Values below which a variable lies with some probabilities (...)."""
        return self.law.ppf(probability)

    @property
    def mean(self) -> float:
        """Expected value."""
        return float(self.law.mean())

    @property
    def deviation(self) -> float:
        """Standard deviation."""
        return float(self.law.std())

    def halving_weights(self, values: NDArray) -> NDArray:
        r"""Weights of drawn values with which they are those of a variable of half the spread.

        .. math:: w = \frac{f(x')}{f(x)} \frac{dx'}{dx}, \quad x' = c + 2 (x - c)
            \quad\text{or}\quad x' = c\,(x / c)^2

        with the density f and the centre c; the second form is that of a spread by a factor.

        Parameters
        ----------
        values : array (...)
            x, drawn from this distribution

        Returns
        -------
        array (...)
            w [-], from 0 to 2, of mean 1

        Source
        ------
        Importance sampling: Owen, Monte Carlo theory, methods and examples (2013), ch. 9.
        """
        if self.logarithmic:
            there, stretch = self.centre * (values / self.centre) ** 2, 2 * values / self.centre
        else:
            there, stretch = self.centre + 2 * (values - self.centre), 2.0
        return stretch * self.law.pdf(there) / self.law.pdf(values)


def uniform(low: float, high: float) -> Distribution:
    """Every value between two is as likely as any other."""
    from scipy import stats

    return Distribution(stats.uniform(low, high - low), (low + high) / 2)


def normal(mean: float, deviation: float) -> Distribution:
    """The normal distribution."""
    from scipy import stats

    return Distribution(stats.norm(mean, deviation), mean)


def truncated_normal(mean: float, deviation: float, low: float, high: float) -> Distribution:
    """The part of a normal distribution between two values; mean and deviation are those before the cut."""
    from scipy import stats

    law = stats.truncnorm((low - mean) / deviation, (high - mean) / deviation, mean, deviation)
    return Distribution(law, min(max(mean, low), high))


def lognormal(median: float, factor: float) -> Distribution:
    """A variable whose logarithm is normal: 68 % lie between median / factor and median x factor."""
    from scipy import stats

    return Distribution(stats.lognorm(log(factor), scale=median), median, logarithmic=True)


def weighted_quantile(values: NDArray, weights: NDArray, probability: float) -> float:
    """Value below which a share of the weights lies."""
    order = np.argsort(values)
    share = np.cumsum(weights[order])
    middle = (share - weights[order] / 2) / share[-1]
    return float(np.interp(probability, middle, values[order]))


CONFIDENCE = 0.95


@dataclass(frozen=True)
class Quantile:
    """A quantile and between what it lies with `CONFIDENCE`; infinite where too few rows tell."""

    value: float
    low: float
    high: float


def quantile(values: NDArray, unsolved: int, probability: float) -> Quantile:
    """Quantile of an output.

    Source
    ------
    Conover, Practical Nonparametric Statistics (1999), sec. 3.2: the ranks of a binomial variable. Rows of a
    Latin hypercube scatter less: Stein, Technometrics 29 (1987) 143-151.
    """
    if not len(values):
        return Quantile(np.nan, -np.inf, np.inf)
    low, _ = _interval(np.concatenate([np.full(unsolved, -np.inf), values]), probability)
    _, high = _interval(np.concatenate([values, np.full(unsolved, np.inf)]), probability)
    return Quantile(float(np.quantile(values, probability, method="median_unbiased")), low, high)


def _interval(values: NDArray, probability: float) -> tuple[float, float]:
    from scipy.stats import quantile_test

    low, high = quantile_test(values, p=probability).confidence_interval(CONFIDENCE)
    return (-np.inf if np.isnan(low) else float(low)), (np.inf if np.isnan(high) else float(high))
