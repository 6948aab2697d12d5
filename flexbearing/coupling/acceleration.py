"""From what an alternation has seen to the deviations that it tries next.

All rules look at the deviations x_k that the bearing was given and at the residuals r_k, what the structure
answers less x_k, measured before anything is accelerated.
"""

from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray

FIRST_STEP = 0.03  # fraction of the first residual that is taken over while nothing is known
SHORTEST_STEP, LONGEST_STEP = 1e-3, 1.0  # of Aitken's relaxation
PARALLEL = 0.03  # differences of which newer ones leave less than that are left out

Rule = Callable[[NDArray, NDArray], NDArray]  # (N, k) deviations and residuals, newest last -> (N) next


def relaxed(given: NDArray, residuals: NDArray, relaxation: float = FIRST_STEP) -> NDArray:
    r"""A constant fraction of the residual.

    .. math:: x_{k+1} = x_k + \omega\, r_k

    Parameters
    ----------
    given, residuals : array (N, k)
        the history, newest last
    relaxation : float
        omega in (0, 1]; above 2/(1 + rho), with rho the spectral radius of the alternation, it diverges

    Returns
    -------
    array (N)
        deviations to try next
    """
    return given[:, -1] + relaxation * residuals[:, -1]


def aitken(given: NDArray, residuals: NDArray) -> NDArray:
    r"""A fraction that follows from the last two residuals.

    .. math:: \omega_k = -\omega_{k-1} \frac{r_{k-1} \cdot (r_k - r_{k-1})}{|r_k - r_{k-1}|^2}

    Parameters
    ----------
    given, residuals : array (N, k)
        the history, newest last

    Returns
    -------
    array (N)
        deviations to try next

    Source
    ------
    Irons and Tuck, Int. J. Num. Meth. Eng. 1 (1969); Kuettler and Wall, Comp. Mech. 43 (2008).

    Valid
    -----
    The fraction is kept between `SHORTEST_STEP` and `LONGEST_STEP` in size.
    """
    fraction = FIRST_STEP
    for before, after in zip(residuals.T[:-1], residuals.T[1:], strict=True):
        change = after - before
        fraction *= -(before @ change) / max(change @ change, np.finfo(float).tiny)
        fraction = np.copysign(np.clip(abs(fraction), SHORTEST_STEP, LONGEST_STEP), fraction)
    return given[:, -1] + fraction * residuals[:, -1]


def least_squares(given: NDArray, residuals: NDArray, depth: int | None = None) -> NDArray:
    r"""The combination of what was seen whose residual would be least.

    .. math:: x_{k+1} = x_k + r_k + (X + V) \alpha,\quad \alpha = -V^+ r_k

    with differences X of the deviations and V of the residuals as columns, newest first; columns that are
    nearly combinations of newer ones are left out.

    Parameters
    ----------
    given, residuals : array (N, k)
        the history, newest last
    depth : int, optional
        how many differences are kept; without it all of them

    Returns
    -------
    array (N)
        deviations to try next

    Source
    ------
    All differences: interface quasi-Newton with inverse Jacobian from a least-squares model, Degroote,
    Bathe and Vierendeels, Computers and Structures 87 (2009). A few of them: Anderson, J. ACM 12 (1965).
    """
    if given.shape[1] == 1:
        return relaxed(given, residuals)
    newest_first = slice(None, None, -1)
    most = min(depth or len(given), len(given))
    X, V = (np.diff(each, axis=1)[:, newest_first][:, :most] for each in (given, residuals))
    X, V = _independent(X, V)
    share = -np.linalg.lstsq(V, residuals[:, -1], rcond=None)[0]
    return given[:, -1] + residuals[:, -1] + (X + V) @ share


def _independent(X: NDArray, V: NDArray) -> tuple[NDArray, NDArray]:
    """Columns of both whose V is no combination of the V before it, by the diagonal of a QR factorisation."""
    while V.shape[1] > 1:
        new = np.abs(np.diag(np.linalg.qr(V, mode="r")))
        dependent = np.flatnonzero(new <= PARALLEL * np.linalg.norm(V, axis=0))
        if not dependent.size:
            break
        X, V = np.delete(X, dependent[0], axis=1), np.delete(V, dependent[0], axis=1)
    return X, V


RULES: dict[str, Rule] = {
    "iqn-ils": least_squares,
    "anderson": partial(least_squares, depth=12),
    "aitken": aitken,
}
