"""Quantiles of an output with their confidence."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

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
