"""A body on points that hold it in one direction each: their forces, and which touch if they only push."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError, cholesky, solve_triangular
from scipy.optimize import nnls

from fem.assembly.factorisation import NotSolved
from fem.parts.boundary_conditions import HELD, free_translations

BALANCE = 1e4  # weight of balance against energy in the search for points in touch; 1e3 and 1e5 do as well
CORRECTIONS = 30  # of what pushing points leave out of balance; each leaves a small part of it
ROUNDING = 1e-9  # of the largest force or gap


@dataclass(frozen=True)
class SupportPoints:
    """P points outside of a body with loads."""

    azimuths: NDArray  # (P,) where they stand [rad]
    compliance: NDArray  # (P, P) outward displacement per outward force [m/N], symmetric
    motions: NDArray  # (P, A) outward displacement by rigid motions: along y, z [-]; tilts [m]
    loads: NDArray  # (P, L) outward displacement per load [m/N]
    load_motions: NDArray  # (L, A) displacement at the loads by rigid motions


def bordered_inverse(points: SupportPoints, touching: NDArray) -> NDArray:
    r"""Forces and rigid motions by displacements and loads.

    .. math:: \begin{pmatrix} C & R \\ R^T & 0 \end{pmatrix}^{-1}

    Parameters
    ----------
    points : SupportPoints
        with compliance C and motions R
    touching : array (P,) of bool
        which of them hold

    Returns
    -------
    array (p + A, p + A)
        for the p points in touch, symmetric

    Raises
    ------
    NotSolved
        if these points let the body go

    Source
    ------
    Flexibility method: forces of the supports from compatibility, rigid motions from balance; derived here.
    """
    C, R = points.compliance[np.ix_(touching, touching)], points.motions[touching]
    _require_hold(points, touching)
    p, A = R.shape
    unit = np.concatenate([np.ones(p), np.abs(C).max() / np.linalg.norm(R, axis=0)])
    bordered = np.block([[C, R], [R.T, np.zeros((A, A))]])
    inverse = unit[:, None] * np.linalg.inv(unit[:, None] * bordered * unit) * unit
    return (inverse + inverse.T) / 2


def pushing_points(points: SupportPoints, load: NDArray) -> NDArray:
    r"""Points in touch when all of them can only push, and stand where the free body is.

    .. math:: g = C p - X F - R a \ge 0, \quad p \ge 0, \quad p^T g = 0, \quad R^T p = R_F^T F

    with inward forces p and gaps g. They make the complementary energy least, which non-negative least
    squares and the method of multipliers find; then the law is checked.

    Parameters
    ----------
    points : SupportPoints
        with compliance C, motions R, loads X and their motions R_F
    load : array (L,)
        F

    Returns
    -------
    array (P,) of bool
        all points for no load

    Raises
    ------
    NotSolved
        if pushing cannot hold the load, or lets the body go

    Source
    ------
    Signorini's conditions at points; complementary energy.
    """
    if not load.any():
        return np.ones(len(points.compliance), dtype=bool)
    pushes = _least_energy(points, load)
    touching = pushes > ROUNDING * pushes.max()
    _require_law(points, load, touching)
    return touching


def _least_energy(points: SupportPoints, load: NDArray) -> NDArray:
    """Inward forces (P,) in balance with the load."""
    size = np.linalg.norm(points.motions, axis=0)
    balance, required = points.motions.T / size[:, None], points.load_motions.T @ load / size
    stiff = np.trace(points.compliance) / len(points.compliance)
    try:
        root = cholesky(points.compliance + stiff * balance.T @ balance, lower=True)
    except LinAlgError as refusal:
        raise NotSolved(
            "supports would gain energy by pushing: the body is too thick, it deflects less at its supports "
            "than a half-space does"
        ) from refusal
    weight = BALANCE * np.sqrt(stiff)
    matrix = np.vstack([root.T, weight * balance])
    goal = solve_triangular(root, points.loads @ load + stiff * balance.T @ required, lower=True)
    correction = np.zeros_like(required)
    for _ in range(CORRECTIONS):
        pushes = nnls(matrix, np.concatenate([goal, weight * (required + correction)]))[0]
        missing = required - balance @ pushes
        if np.linalg.norm(missing) <= ROUNDING * max(np.linalg.norm(required), pushes.max()):
            return pushes
        correction += missing
    resultant = ", ".join(f"{force:.4g}" for force in points.load_motions[:, :2].T @ load)
    raise NotSolved(
        f"supports that only push cannot hold this load of ({resultant}) N along y and z: "
        "the body would lift off them"
    )


def _require_law(points: SupportPoints, load: NDArray, touching: NDArray) -> None:
    """Refuse a choice of points by which one would pull, or enter the body."""
    X = np.concatenate([points.loads[touching] @ load, points.load_motions.T @ load])
    answer = bordered_inverse(points, touching) @ X
    count = np.count_nonzero(touching)
    pushes, motion = answer[:count], -answer[count:]
    free = points.loads @ load
    gaps = points.compliance[:, touching] @ pushes - free - points.motions @ motion
    if pushes.min() < -ROUNDING * pushes.max() or gaps.min() < -ROUNDING * np.abs(free).max():
        raise NotSolved(
            f"no set of pushing supports was found: least push {pushes.min():.3g} N, "
            f"least gap {gaps.min():.3g} m"
        )


def _require_hold(points: SupportPoints, touching: NDArray) -> None:
    R = points.motions[touching] / np.linalg.norm(points.motions, axis=0)
    stretch = np.linalg.svd(np.vstack([R, np.zeros((R.shape[1],) * 2)]), compute_uv=False)
    if stretch[-1] <= HELD * stretch[0]:
        motion = free_translations(points.azimuths[touching]) or "in tilt about y and z"
        raise NotSolved(
            f"only {np.count_nonzero(touching)} of {touching.size} support points push, "
            f"and the body can still move {motion}"
        )
