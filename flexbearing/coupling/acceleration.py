"""Rules that choose the next deviations of a fixed-point coupling.

All rules look at the deviations x_k that the bearing was given and at the residuals r_k, what the structure
answers less x_k, measured before anything is accelerated. Q are the loads that the bearing answers with to
deviations w, C is the compliance of the structure.
"""

from collections.abc import Callable
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from flexbearing.coupling.history import CouplingHistory
from flexbearing.coupling.partners import Compliance
from flexbearing.coupling.raceway_pair import OUTWARD

FIRST_STEP = 0.03  # fraction of the first residual that is taken over while nothing is known
SHORTEST_STEP, LONGEST_STEP = 1e-3, 1.0  # of Aitken's relaxation
PARALLEL = 0.03  # a difference that is less than this part new beside newer ones is left out

Rule = Callable[[CouplingHistory], NDArray]  # next deviations (N)


def relaxed(history: CouplingHistory, relaxation: float = FIRST_STEP) -> NDArray:
    r"""A constant fraction of the residual.

    .. math:: x_{k+1} = x_k + \omega\, r_k
    """
    return history.deviations[-1] + relaxation * history.residuals[-1]


def aitken(history: CouplingHistory) -> NDArray:
    r"""A fraction that follows from the last two residuals.

    .. math:: \omega_k = -\omega_{k-1} \frac{r_{k-1} \cdot (r_k - r_{k-1})}{|r_k - r_{k-1}|^2}

    Source
    ------
    Irons and Tuck, Int. J. Num. Meth. Eng. 1 (1969); Kuettler and Wall, Comp. Mech. 43 (2008).

    Valid
    -----
    The fraction is kept between `SHORTEST_STEP` and `LONGEST_STEP` in size.
    """
    fraction = FIRST_STEP
    for previous, residual in pairwise(history.residuals):
        change = residual - previous
        fraction *= -(previous @ change) / max(change @ change, np.finfo(float).tiny)
        fraction = np.copysign(np.clip(abs(fraction), SHORTEST_STEP, LONGEST_STEP), fraction)
    return history.deviations[-1] + fraction * history.residuals[-1]


def anderson(history: CouplingHistory, depth: int = 12) -> NDArray:
    r"""The combination of the last residuals that would be least.

    .. math:: x_{k+1} = x_k + r_k + (X + V) \alpha,\quad \alpha = -V^+ r_k

    with differences X of the deviations and V of the residuals as columns, newest first; columns that are
    nearly combinations of newer ones are left out.

    Source
    ------
    Anderson, J. ACM 12 (1965); with all differences it is the interface quasi-Newton method of Degroote,
    Bathe and Vierendeels, Computers and Structures 87 (2009).
    """
    if len(history.deviations) == 1:
        return relaxed(history)
    X, V = _differences(history, depth)
    alpha = -np.linalg.lstsq(V, history.residuals[-1], rcond=None)[0]
    return history.deviations[-1] + history.residuals[-1] + (X + V) @ alpha


def least_squares(history: CouplingHistory) -> NDArray:
    r"""Interface quasi-Newton: differences of iterations where they are known, an estimate for the rest.

    .. math:: x_{k+1} = x_k + X \alpha + G (r_k + V \alpha),\quad \alpha = -V^+ r_k

    with X and V as in `anderson`, but only of iterations in which the same rollers touch both raceways:
    those before a contact opened or closed belong to another slope. What is left of the residual moves
    the deviations by the estimate :math:`G \approx (1 - C\,\partial Q/\partial w)^{-1}`. A step is never
    longer than the residual: rollers push back, so the root is closer than the answer.

    Where the compliance of the structure is not known, G is 1, and all differences count: with so rough a
    G what is left of the residual must be small.

    Source
    ------
    Degroote, Bathe and Vierendeels, Computers and Structures 87 (2009), where G is 1; a starting inverse
    Jacobian as in Lindner et al., VI Coupled Problems (2015).
    """
    if history.compliance is None or history.force_by_deviation is None:
        return anderson(history, len(history.deviations))
    residual = history.residuals[-1]
    step, remainder = np.zeros_like(residual), residual
    if history.same_contacts > 1:
        X, V = _differences(history, history.same_contacts - 1)
        alpha = -np.linalg.lstsq(V, residual, rcond=None)[0]
        step, remainder = X @ alpha, residual + V @ alpha
    estimate = change_per_residual(history.compliance, history.force_by_deviation)
    step = step + estimate @ remainder
    longest, length = np.linalg.norm(residual), np.linalg.norm(step)
    return history.deviations[-1] + step * min(1.0, longest / max(length, np.finfo(float).tiny))


def change_per_residual(compliance: Compliance, by_deviation: NDArray) -> NDArray:
    r"""Estimate how far deviations are from the root of C Q(w) = w where a residual is left.

    .. math:: G = \left(1 - s\,C \frac{\partial Q}{\partial w}\right)^{-1}

    with the sign s of an outward force, -1 on the inner and 1 on the outer raceway.

    Source
    ------
    The derivative of C Q(w).

    Valid
    -----
    Derivatives of the loads may be rough: only a step is chosen with them, the root stays the same.
    """
    answer = np.zeros_like(by_deviation)
    for half, sign, matrix in zip(np.split(np.arange(len(answer)), 2), OUTWARD, compliance, strict=True):
        if matrix is not None:
            answer[half] = sign * matrix.reshape(len(half), -1) @ by_deviation[half]
    return np.linalg.inv(np.eye(len(answer)) - answer)


def springs_between_raceways(stiffness: NDArray, shapes: int) -> NDArray:
    r"""Change of forces by deviations (2 Z M, 2 Z M) [N/m] of uniform springs between raceways held fixed.

    .. math:: K_{jm} = \frac{k_j}{2m + 1}

    Every roller follows the outer deviation less the inner one over its length, and pushes the raceways
    apart: stiffness k (Z) [N/m], M Legendre shapes.

    Source
    ------
    Legendre shapes share a uniform stiffness as 1/(2m + 1).

    Valid
    -----
    Rollers without tilt and slip.
    """
    spring = (stiffness[:, None] / (2 * np.arange(shapes) + 1)).ravel()
    return np.kron(np.array([[1.0, -1.0], [1.0, -1.0]]), np.diag(spring))


def _differences(history: CouplingHistory, most: int) -> tuple[NDArray, NDArray]:
    """Differences of deviations and residuals as columns, newest first, without dependent ones.

    A column is dependent when its V is nearly a combination of newer ones, by the diagonal of a QR
    factorisation.
    """
    X, V = (
        np.diff(np.array(vectors), axis=0).T[:, ::-1][:, : min(most, len(vectors[0]))]
        for vectors in (history.deviations, history.residuals)
    )
    while V.shape[1] > 1:
        new = np.abs(np.diag(np.linalg.qr(V, mode="r")))
        dependent = np.flatnonzero(new <= PARALLEL * np.linalg.norm(V, axis=0))
        if not dependent.size:
            break
        X, V = np.delete(X, dependent[0], axis=1), np.delete(V, dependent[0], axis=1)
    return X, V


RULES: dict[str, Rule] = {"iqn-ils": least_squares, "anderson": anderson, "aitken": aitken}
