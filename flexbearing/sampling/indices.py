"""Sobol indices: which share of the variance of an output is due to each random input."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexbearing.sampling.distribution import CONFIDENCE

RESAMPLES = 1000
FEWEST = 8  # base points below which no interval is reported


@dataclass(frozen=True, eq=False)
class Indices:
    """Sobol indices of one output by K inputs."""

    first: NDArray  # (K) share of the variance by the input alone
    total: NDArray  # (K) share by the input with all its interactions
    first_interval: NDArray  # (2, K) between which each lies with `CONFIDENCE`
    total_interval: NDArray  # (2, K)
    points: int  # base points that have a result in all their rows


def sobol_indices(values: NDArray, seed: int) -> Indices:
    r"""Sobol indices of an output at the points of `Design`.

    .. math:: S_k = \frac{\overline{f_B (f_{A B_k} - f_A)}}{V}, \quad
        T_k = \frac{\overline{(f_A - f_{A B_k})^2}}{2 V}

    with the variance V of f_A and f_B together, both taken from their mean.

    Parameters
    ----------
    values : array (N, K + 2)
        f_A, f_B and f_AB of every base point; NaN where a row has no result: the base point is left out
    seed : int
        of the bootstrap

    Returns
    -------
    Indices
        NaN where the output does not vary

    Source
    ------
    Saltelli et al., Computer Physics Communications 181 (2010) 259-270, table 2 (b), (f);
    percentile intervals of the bootstrap: Archer et al., J. Stat. Comput. Simul. 58 (1997) 99-120.
    """
    known = values[np.isfinite(values).all(axis=1)]
    inputs = values.shape[1] - 2
    nothing = np.full(inputs, np.nan)
    if len(known) < FEWEST or np.ptp(known) == 0:
        return Indices(nothing, nothing, np.tile(nothing, (2, 1)), np.tile(nothing, (2, 1)), len(known))
    centred = known - known[:, :2].mean()
    a, b, mixed = centred[:, :1], centred[:, 1:2], centred[:, 2:]
    moments = np.hstack([b * (mixed - a), (a - mixed) ** 2 / 2, (a + b) / 2, (a**2 + b**2) / 2])
    drawn = np.array(list(_resampled(moments, seed)))
    tail = (1 - CONFIDENCE) / 2
    low, high = np.quantile(_shares(drawn), [tail, 1 - tail], axis=0)
    shares = _shares(moments.mean(axis=0))
    return Indices(
        shares[:inputs],
        shares[inputs:],
        np.array([low[:inputs], high[:inputs]]),
        np.array([low[inputs:], high[inputs:]]),
        len(known),
    )


def _shares(moments: NDArray) -> NDArray:
    """First and total indices (..., 2 K) from means of the products, of the outputs and of their squares."""
    variance = moments[..., -1:] - moments[..., -2:-1] ** 2
    return moments[..., :-2] / variance


def _resampled(moments: NDArray, seed: int) -> Iterator[NDArray]:
    """Yield means of moments over base points that are drawn again, with replacement."""
    random, count = np.random.default_rng(seed), len(moments)
    for _ in range(RESAMPLES):
        times = np.bincount(random.integers(count, size=count), minlength=count)
        yield times @ moments / count
