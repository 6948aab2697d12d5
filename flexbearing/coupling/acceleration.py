"""From what an alternation has seen to the deviations that it tries next.

All rules look at the deviations x_k that the bearing was given and at the residuals r_k, what the structure
answers less x_k, measured before anything is accelerated. Q are the loads that the bearing answers with to
deviations w, C is the compliance of the structure.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FIRST_STEP = 0.03  # fraction of the first residual that is taken over while nothing is known
SHORTEST_STEP, LONGEST_STEP = 1e-3, 1.0  # of Aitken's relaxation
PARALLEL = 0.03  # differences of which newer ones leave less than that are left out


@dataclass(frozen=True)
class Seen:
    """What an alternation knows when it chooses the next deviations."""

    given: NDArray  # (N, k) deviations that the bearing was given, newest last [m]
    residuals: NDArray  # (N, k) what the structure answered less what was given [m]
    alike: int  # so many of the newest, at least one, that tell of the present slope
    # (N, N) estimated change of the root per residual, to be used once; None where that is unknown
    estimate: Callable[[], NDArray] | None


Rule = Callable[[Seen], NDArray]  # next deviations (N)


def relaxed(seen: Seen, relaxation: float = FIRST_STEP) -> NDArray:
    r"""A constant fraction of the residual.

    .. math:: x_{k+1} = x_k + \omega\, r_k

    Parameters
    ----------
    seen : Seen
        the history
    relaxation : float
        omega in (0, 1]; above 2/(1 + rho), with rho the spectral radius of the alternation, it diverges

    Returns
    -------
    array (N)
        deviations to try next
    """
    return seen.given[:, -1] + relaxation * seen.residuals[:, -1]


def aitken(seen: Seen) -> NDArray:
    r"""A fraction that follows from the last two residuals.

    .. math:: \omega_k = -\omega_{k-1} \frac{r_{k-1} \cdot (r_k - r_{k-1})}{|r_k - r_{k-1}|^2}

    Parameters
    ----------
    seen : Seen
        the history

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
    for before, after in zip(seen.residuals.T[:-1], seen.residuals.T[1:], strict=True):
        change = after - before
        fraction *= -(before @ change) / max(change @ change, np.finfo(float).tiny)
        fraction = np.copysign(np.clip(abs(fraction), SHORTEST_STEP, LONGEST_STEP), fraction)
    return seen.given[:, -1] + fraction * seen.residuals[:, -1]


def anderson(seen: Seen, depth: int = 12) -> NDArray:
    r"""The combination of the last residuals that would be least.

    .. math:: x_{k+1} = x_k + r_k + (X + V) \alpha,\quad \alpha = -V^+ r_k

    with differences X of the deviations and V of the residuals as columns, newest first; columns that are
    nearly combinations of newer ones are left out.

    Parameters
    ----------
    seen : Seen
        the history
    depth : int
        how many differences are kept

    Returns
    -------
    array (N)
        deviations to try next

    Source
    ------
    Anderson, J. ACM 12 (1965); with all differences it is the interface quasi-Newton method of Degroote,
    Bathe and Vierendeels, Computers and Structures 87 (2009).
    """
    if seen.given.shape[1] == 1:
        return relaxed(seen)
    X, V = _differences(seen, depth)
    share = -np.linalg.lstsq(V, seen.residuals[:, -1], rcond=None)[0]
    return seen.given[:, -1] + seen.residuals[:, -1] + (X + V) @ share


def least_squares(seen: Seen) -> NDArray:
    r"""Interface quasi-Newton: differences where they tell something, an estimate for the rest.

    .. math:: x_{k+1} = x_k + X \alpha + G (r_k + V \alpha),\quad \alpha = -V^+ r_k

    with X and V as in `anderson`, but only of iterates in which the same rollers touch both raceways:
    those before a contact opened or closed tell of another slope. What is left of the residual moves
    the deviations by the estimate :math:`G \approx (1 - C\,\partial Q/\partial w)^{-1}`. A step is never
    longer than the residual: rollers push back, so the root is nearer than the answer.

    Of a structure that does not tell how it yields nothing is estimated: G is 1, and all differences count,
    as with so rough a G what is left of the residual must be small.

    Parameters
    ----------
    seen : Seen
        the history

    Returns
    -------
    array (N)
        deviations to try next

    Source
    ------
    Degroote, Bathe and Vierendeels, Computers and Structures 87 (2009), where G is 1; a starting inverse
    Jacobian as in Lindner et al., VI Coupled Problems (2015).
    """
    if seen.estimate is None:
        return anderson(seen, seen.given.shape[1])
    residual = seen.residuals[:, -1]
    step, left = np.zeros_like(residual), residual
    if seen.alike > 1:
        X, V = _differences(seen, seen.alike - 1)
        share = -np.linalg.lstsq(V, residual, rcond=None)[0]
        step, left = X @ share, residual + V @ share
    step = step + seen.estimate() @ left
    longest, length = np.linalg.norm(residual), np.linalg.norm(step)
    return seen.given[:, -1] + step * min(1.0, longest / max(length, np.finfo(float).tiny))


def _differences(seen: Seen, most: int) -> tuple[NDArray, NDArray]:
    """Differences of deviations and residuals, newest first, those that tell something new."""
    X, V = (np.diff(each, axis=1)[:, ::-1][:, :most] for each in (seen.given, seen.residuals))
    return _independent(X[:, : len(X)], V[:, : len(V)])


def _independent(X: NDArray, V: NDArray) -> tuple[NDArray, NDArray]:
    """Columns of both whose V is no combination of the V before it, by the diagonal of a QR factorisation."""
    while V.shape[1] > 1:
        new = np.abs(np.diag(np.linalg.qr(V, mode="r")))
        dependent = np.flatnonzero(new <= PARALLEL * np.linalg.norm(V, axis=0))
        if not dependent.size:
            break
        X, V = np.delete(X, dependent[0], axis=1), np.delete(V, dependent[0], axis=1)
    return X, V


RULES: dict[str, Rule] = {"iqn-ils": least_squares, "anderson": anderson, "aitken": aitken}
