r"""A start for contact without friction from an interior point method, which cannot cycle.

Without friction, contact is a convex problem: of all gaps :math:`d \ge 0`, those of least energy
:math:`\tfrac12 d^T S d + b^T d`. Newton's method on its kinks is fast when points hardly change, but may
cycle for a loose ring, whose few points of contact are unknown. Here the kinks are smooth,

.. math:: S d + b = p, \quad p_i d_i = \tau, \quad \tau \to 0

Source
------
Mehrotra (1992), SIAM J. Optim. 2, 575: predictor and corrector with one factorisation.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError, cho_factor, cho_solve

from fem.errors import NotSolved
from fem.joint.semismooth_newton import ContactEquations

CLOSE = 1e-10  # p d over that of the start, from which Newton's method goes on
LIMIT = 60  # steps; 15 to 25 are usual
BOUNDARY = 0.99  # of the way to the nearest p = 0 or d = 0


def frictionless_start(contact: ContactEquations, rest: NDArray, loads: NDArray) -> NDArray:
    """Gaps (P, A, 1) above zero [m], close to those of contact without friction.

    `rest` are the gaps without loads [m]; `loads` (P, A), forces per radian on the closed interface by
    rollers [N], give the size of pressure.
    Raises `NotSolved` if a matrix is singular or `LIMIT` steps do not suffice, as with a ring that nothing
    holds.
    """
    P, n = rest.shape[0], rest.shape[1]
    azimuth = np.arange(P)
    S = contact.interface.blocks[(azimuth[:, None] - azimuth) % P].transpose(0, 2, 1, 3).reshape(P * n, P * n)
    b = contact.offset.ravel()
    size = np.abs(loads).max()
    d, p = np.maximum(rest.ravel(), size / contact.weight.max()), np.full_like(b, size)
    first = np.mean(d * p)
    for _ in range(LIMIT):
        residual, product = S @ d + b - p, np.mean(d * p)
        if product <= CLOSE * first:
            return d.reshape(rest.shape)
        try:
            triangle = cho_factor(S + np.diag(p / d), check_finite=False)
        except LinAlgError as problem:
            raise NotSolved(f"nothing holds the ring in its fit: {problem}") from problem
        dd, dp = _step(triangle, residual, d, p, -d * p)
        reach = min(_reach(d, dd), _reach(p, dp))
        predicted = np.mean((d + reach * dd) * (p + reach * dp))
        target = (predicted / product) ** 3 * product - d * p - dd * dp
        dd, dp = _step(triangle, residual, d, p, target)
        reach = BOUNDARY * min(_reach(d, dd), _reach(p, dp))
        d, p = d + reach * dd, p + reach * dp
    raise NotSolved(f"contact without friction is not found in {LIMIT} steps: is the ring held?")


def _step(triangle, residual: NDArray, d: NDArray, p: NDArray, target: NDArray) -> tuple[NDArray, NDArray]:
    """Changes of gaps and forces towards a balance in which their products change by a target."""
    change = cho_solve(triangle, target / d - residual, check_finite=False)
    return change, (target - p * change) / d


def _reach(values: NDArray, change: NDArray) -> float:
    """Part of a change, at most one, that keeps values above zero."""
    return float(np.min(np.where(change < 0, -values / np.where(change < 0, change, -1.0), 1.0), initial=1.0))
