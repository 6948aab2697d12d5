"""A body on points that hold it in one direction each: their forces, and which touch if they only push."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError, cholesky, solve_triangular
from scipy.optimize import linprog, nnls

from fem.assembly.factorisation import NotSolved
from fem.parts.boundary_conditions import HELD, free_translations
from fem.parts.material import ImpossiblePart

BALANCE = 1e4  # weight of balance against energy in the search for points in touch; 1e3 and 1e5 do as well
CORRECTIONS = 30  # of what pushing points leave out of balance; each leaves a small part of it
ROUNDING = 1e-9  # of the largest force or gap


@dataclass(frozen=True)
class SupportPoints:
    """P points outside of a body with loads; those that only push stand where the free body is."""

    azimuths: NDArray  # (P,) where they stand [rad]
    compliance: NDArray  # (P, P) outward displacement per outward force [m/N], symmetric
    motions: NDArray  # (P, A) outward displacement by rigid motions: along y, z [-]; tilts [m]
    loads: NDArray  # (P, L) outward displacement per load [m/N]
    load_motions: NDArray  # (L, A) displacement at the loads by rigid motions


def bordered_inverse(points: SupportPoints, touching: NDArray) -> NDArray:
    r"""Forces and rigid motions by displacements and loads.

    .. math:: \begin{pmatrix} C & R \\ R^T & 0 \end{pmatrix}^{-1}

    An array (p + A, p + A) for the p points in touch, symmetric; the points have the compliance C and the
    motions R.
    Raises `NotSolved` if these points let the body go.

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

    The points have the compliance C, motions R, loads X and their motions R_F. Where those that push leave
    the body a motion, as one line does under a load straight at it, as many more as hold it count: they touch
    without a force. Without a load all points do.
    Raises `NotSolved` if pushing cannot hold the load.

    Source
    ------
    Signorini's conditions at points; complementary energy.
    """
    if not load.any():
        return np.ones(len(points.compliance), dtype=bool)
    pushes = _least_energy(points, load)
    touching = pushes > ROUNDING * pushes.max()
    if not _holds(points, touching):
        touching = _completed(points, load, pushes, touching)
    _require_law(points, load, touching)
    return touching


def _completed(points: SupportPoints, load: NDArray, pushes: NDArray, touching: NDArray) -> NDArray:
    """Touching points with those (P,) that end a motion which these leave, at the least sum of gaps."""
    size = np.linalg.norm(points.motions, axis=0)
    motions, free = points.motions / size, points.compliance @ pushes - points.loads @ load
    unit = np.abs(free).max()
    uneven = 1 + np.arange(len(free)) / len(free)  # or places between two supports would be as good as at one
    place = linprog(
        -uneven @ motions,
        A_ub=motions[~touching], b_ub=free[~touching] / unit,
        A_eq=motions[touching], b_eq=free[touching] / unit,
        bounds=(None, None),
    )  # fmt: skip
    if place.x is None:
        raise NotSolved(
            f"only {np.count_nonzero(touching)} of {touching.size} support points push, and the body can "
            f"still move {_words(points, touching)}: no place of it leaves all others open"
        )
    gaps = free / unit - motions @ place.x
    held = touching.copy()
    for nearest in np.argsort(np.where(touching, np.inf, gaps)):
        if _holds(points, held):
            break
        both = held | (np.arange(held.size) == nearest)
        if np.linalg.matrix_rank(motions[both], HELD) > np.linalg.matrix_rank(motions[held], HELD):
            held = both
    return held


def _least_energy(points: SupportPoints, load: NDArray) -> NDArray:
    """Inward forces (P,) in balance with the load."""
    size = np.linalg.norm(points.motions, axis=0)
    balance, required = points.motions.T / size[:, None], points.load_motions.T @ load / size
    stiff, root = _energy(points)
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


def _energy(points: SupportPoints) -> tuple[float, NDArray]:
    """Mean compliance [m/N], and the root (P, P) of the compliance whose motions are held as stiffly."""
    balance = points.motions.T / np.linalg.norm(points.motions, axis=0)[:, None]
    stiff = np.trace(points.compliance) / len(points.compliance)
    try:
        return stiff, cholesky(points.compliance + stiff * balance.T @ balance, lower=True)
    except LinAlgError as refusal:
        raise ImpossiblePart(
            f"supports {_nearest(points):.2g} deg apart have no place: they would gain energy by pushing, as "
            "they have no width; allowed are supports further apart, by about the thickness of a ring"
        ) from refusal


def require_energy(points: SupportPoints) -> None:
    """Refuse supports that would gain energy by pushing: two of them as one, or a body too thick for them.

    Raises `ImpossiblePart` naming the smallest angle between them.
    """
    _energy(points)


def _nearest(points: SupportPoints) -> float:
    """Smallest angle between supports [deg]."""
    turn = 2 * np.pi
    around = np.unique(np.round(points.azimuths % turn, 9))
    return float(np.degrees(np.diff(around, append=around[0] + turn).min()))


def _require_law(points: SupportPoints, load: NDArray, touching: NDArray) -> None:
    """Refuse a choice of points by which one would pull, or enter the body."""
    X = np.concatenate([points.loads[touching] @ load, points.load_motions.T @ load])
    answer = bordered_inverse(points, touching) @ X
    count = np.count_nonzero(touching)
    pushes, motion = answer[:count], -answer[count:]
    least = pushes.min(initial=0.0)
    free = points.loads @ load
    gaps = points.compliance[:, touching] @ pushes - free - points.motions @ motion
    if least < -ROUNDING * np.abs(pushes).max(initial=0.0) or gaps.min() < -ROUNDING * np.abs(free).max():
        raise NotSolved(
            f"no set of pushing supports was found: least push {least:.3g} N, least gap {gaps.min():.3g} m"
        )


def _require_hold(points: SupportPoints, touching: NDArray) -> None:
    if not _holds(points, touching):
        raise NotSolved(
            f"only {np.count_nonzero(touching)} of {touching.size} support points push, "
            f"and the body can still move {_words(points, touching)}"
        )


def _holds(points: SupportPoints, touching: NDArray) -> bool:
    """Whether no rigid motion leaves these points where they are."""
    R = points.motions[touching] / np.linalg.norm(points.motions, axis=0)
    stretch = np.linalg.svd(np.vstack([R, np.zeros((R.shape[1],) * 2)]), compute_uv=False)
    return bool(stretch[-1] > HELD * stretch[0])


def _words(points: SupportPoints, touching: NDArray) -> str:
    return free_translations(points.azimuths[touching]) or "in tilt about y and z"
