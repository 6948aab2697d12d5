"""Whether a point is an optimum: multipliers of what is active there, and the gain that is left."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import nnls

from flexbearing.optimise.goals import Terms

ACTIVE = 1e-3  # relative distance within which a term counts as the worst
MET = 5e-3  # margin within which a constraint may be active, over the size of its bound
AT_END = 1e-6  # share of a range
STEP = 0.1  # share of the range of every key for which the gain is promised


@dataclass(frozen=True)
class Optimality:
    """Multipliers at a point, >= 0, of a merit that is made large."""

    terms: NDArray  # (T) weight of each term of the objective in its derivative, the sum is 1
    bounds: NDArray  # (M) gain of the merit by a larger margin of each constraint
    ends: NDArray  # (K) gain by the share of each variable beyond its bound; negative at the lower one
    gain: float  # that derivatives still promise for `STEP` of every range, and by margins left, over 1


def optimality(
    merits: Terms,
    margins: Terms,
    shares: NDArray,
    limits: tuple[NDArray | float, NDArray | float] = (0.0, 1.0),
    spare: float = 0.0,
) -> Optimality:
    r"""Multipliers that come closest to the conditions of Karush, Kuhn and Tucker.

    .. math::
        r = \sum_t w_t \nabla f_t + \sum_m \lambda_m \nabla g_m + \sum_k \mu_k n_k, \quad
        w, \lambda, \mu \ge 0, \; \sum w = 1, \; |r|_2 \to \min

    The merits f (T, K) are made large by their smallest, the margins g (M, K) are at least 0, n is the normal
    of a limit that is met, inwards. Shares (K) of the variables are from 0 to 1, within their limits; `spare`
    is the margin up to which a constraint counts as used up.

    Source
    ------
    Nocedal and Wright, Numerical Optimization (2006), sec. 12.3.
    """
    count = len(shares)
    near = merits.values <= merits.values.min() + ACTIVE
    met = margins.values <= MET
    low, high = limits
    at_end = np.where(shares <= low + AT_END, 1.0, 0.0) - np.where(shares >= high - AT_END, 1.0, 0.0)
    normals = np.diag(at_end)[at_end != 0].reshape(-1, count)
    columns = np.vstack([merits.slopes[near], margins.slopes[met].reshape(-1, count), normals]).T
    heavy = 1e3 * max(1.0, np.abs(columns).max(initial=0.0))
    weights = np.concatenate([np.full(near.sum(), heavy), np.zeros(columns.shape[1] - near.sum())])
    found, _ = nnls(np.vstack([columns, weights]), np.concatenate([np.zeros(count), [heavy]]))
    left = columns @ found
    of_terms, of_bounds, of_ends = np.zeros(len(near)), np.zeros(len(met)), np.zeros(count)
    of_terms[near], of_bounds[met] = found[: near.sum()], found[near.sum() : near.sum() + met.sum()]
    of_ends[at_end != 0] = found[near.sum() + met.sum() :]
    gain = STEP * np.abs(left).sum() + of_bounds @ (margins.values - spare).clip(min=0.0)
    return Optimality(of_terms, of_bounds, -at_end * of_ends, float(gain))
