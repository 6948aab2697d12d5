"""Motion of slow balls that slide on all their contacts."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.ellipse.full_sliding import CENTRE, ROLL, SPIN, Ellipse, sliding_friction
from quasidynamic.errors import NotSolved
from quasidynamic.motion.ball_slip import (
    INNER,
    OUTER,
    BallContacts,
    rolling_motion,
    slip_by_motion,
    slip_of,
    spinning_motion,
)

TOLERANCE = 1e-10  # unbalanced power over the power of friction
ENOUGH = 1e-7  # the same, where rounding keeps a step from lowering it any more
LIMIT = 300  # evaluations; half of all balls need six, one in a hundred fifty
ENOUGH_SLOPE = 0.5  # of the slope at the start of a step that may be left at its end
ROUNDING = 1e-13  # of the power: too small to tell two powers apart
LINES = 0.347**2 / 2  # of A a^2/R: slip of the centre of a contact that rolls on two lines, without spin
CAUTION = np.array([0.0, 0.0, 0.0, 0.0, 0.01, 0.1, 1.0])  # share of the majorant in one try after the other
_RIDGE = 1e-13 * np.eye(3)  # added to the curvature, whose diagonal is scaled to one


@dataclass(frozen=True)
class Attitude:
    """How balls move when the inner ring turns by one rad/s against the outer ring. N balls, G diagonals.

    Balls that are not pressed on both rings take part in nothing: their motion is not a number.
    """

    motion: NDArray  # (N, 3) [rad/s] outer ring, ball axial, ball radial, from the orbiting ball centre
    slip: NDArray  # (N, G, 2, 3) centre slip [m/s], roll and spin [rad/s], ball minus race
    power: NDArray  # (N) [W] heat of friction, the torque of the ball [N m]
    driven: NDArray  # (N) whether the ball is pressed on both rings
    imbalance: NDArray  # (N) [-] unbalanced power over the power of friction
    evaluations: int


class _Heat(NamedTuple):
    """Heat of friction of balls near one motion."""

    power: NDArray  # (n)
    slope: NDArray  # (n, 3)
    curved: NDArray  # (n, 3, 3)
    above: NDArray  # (n, 3, 3) curvature of the parabola that touches the heat and lies above everywhere

    def taken(self, keep: NDArray) -> "_Heat":
        """Return that of some of the balls."""
        return _Heat(*(array[keep] for array in self))

    def or_else(self, other: "_Heat", better: NDArray) -> "_Heat":
        """Return that of this motion where it is better (n), else of the other."""
        shapes = (better.reshape(-1, *[1] * (array.ndim - 1)) for array in self)
        return _Heat(*(np.where(where, *pair) for where, *pair in zip(shapes, self, other, strict=True)))


@dataclass(frozen=True)
class _Balls:
    """The balls that still move, in unknowns that no rounding spoils: slip on their stronger diagonal.

    The unknowns are both centre slips there and the spin, as differences from rolling on that diagonal.
    """

    base: NDArray  # (n, G, 2, 3) slip when rolling on the stronger diagonal
    by_unknown: NDArray  # (n, G, 2, 3, 3) slip by the unknowns
    ellipse: Ellipse
    scale: NDArray  # (n, 3, 3) unknowns by the components of the motion, each in parts of its speed

    def taken(self, keep: NDArray) -> "_Balls":
        """Return some of the balls."""
        return _Balls(self.base[keep], self.by_unknown[keep], self.ellipse.taken(keep), self.scale[keep])

    def slip(self, unknowns: NDArray) -> NDArray:
        """Slip (n, G, 2, 3) at unknowns (n, 3)."""
        return self.base + np.einsum("ngsij,nj->ngsi", self.by_unknown, unknowns)

    def imbalance(self, heat: _Heat) -> NDArray:
        """Unbalanced power of each component of the motion over the power of friction, the largest (n)."""
        return np.abs(np.einsum("nij,ni->nj", self.scale, heat.slope)).max(axis=1) / heat.power

    def at(self, unknowns: NDArray) -> _Heat:
        """Heat at unknowns (n, 3)."""
        found = sliding_friction(self.slip(unknowns), self.ellipse)
        slope = np.einsum("ngsij,ngsi->nj", self.by_unknown, found.by_slip)
        turned = np.swapaxes(self.by_unknown, -1, -2)
        curved, above = ((turned @ matrix @ self.by_unknown).sum((1, 2)) for matrix in found.curvatures())
        return _Heat(found.power.sum((1, 2)), slope, curved, above)


def attitude(contacts: BallContacts, ellipse: Ellipse) -> Attitude:
    r"""Motion in which the friction of slow balls is in balance, without inertia.

    .. math:: \min_{\Omega_o, \omega_x, \omega_r} \Phi,\quad
              \Phi = \sum_{contacts} \int \mu p\, |v|\, dA,\quad \Omega_i - \Omega_o = 1

    The heat Phi is convex in the motion: its stationarity is the balance of forces along the orbit and of
    both moments, its minimum is the torque, and there is no other balance. Newton's method for all balls
    side by side from the best of these motions: rolling on either diagonal, spinning on both, or rolling on
    two lines of each contact of the stronger diagonal, without spin on one race or with as much on both.

    Parameters
    ----------
    contacts : BallContacts
        N balls, G diagonals
    ellipse : Ellipse
        (N, G, 2) semi-axes and friction forces

    Returns
    -------
    Attitude

    Raises
    ------
    NotSolved
        when a ball is not in balance; the message names the first one

    Source
    ------
    Joshi et al. (2015), Lubricants 3, 181-196, Eqs (1) to (3); their last terms must read -M_ril sin(a_il)
    and +M_ril cos(a_il). Starts: Heras et al. (2017), Eqs (1) to (3).

    Valid
    -----
    Slow: no inertia, no oil film, no cage; sliding everywhere in the contacts.
    """
    driven = np.all(ellipse.traction.max(axis=1) > 0.0, axis=1)
    rolling, balls, starts = _prepared(contacts, ellipse)
    unknowns = np.full_like(rolling, np.nan)
    (power, imbalance), evaluations = np.zeros((2, len(rolling))), 0
    if driven.any():
        moving = balls.taken(driven)
        found = _least_power(moving, _best(moving, starts[:, driven]))
        unknowns[driven], power[driven], imbalance[driven], evaluations = found
    _check(imbalance, evaluations)
    change = np.linalg.solve(balls.scale, unknowns[..., None])[..., 0]
    motion = rolling + _speed(rolling) * change
    return Attitude(motion, balls.slip(unknowns), power, driven, imbalance, evaluations)


def _check(imbalance: NDArray, evaluations: int) -> None:
    bad = np.flatnonzero(~(imbalance <= ENOUGH))
    if len(bad):
        raise NotSolved(
            f"{len(bad)} of {len(imbalance)} balls found no balance of friction in {evaluations} "
            f"evaluations, the first is ball {bad[0]}: {imbalance[bad[0]]:.1e} of its power is unbalanced, "
            f"allowed {ENOUGH:.0e}",
            "iteration limit" if evaluations >= LIMIT else "stalled",
        )


def _prepared(contacts: BallContacts, ellipse: Ellipse) -> tuple[NDArray, _Balls, NDArray]:
    """Rolling on the stronger diagonal (N, 3), balls about it, and unknowns (S, N, 3) of all starts."""
    by_motion = slip_by_motion(contacts)
    diagonals = contacts.angle.shape[1]
    motions = [rolling_motion(contacts, i) for i in range(diagonals)]
    if diagonals == 2:
        motions.append(spinning_motion(contacts))
    every, ball = np.array(motions), np.arange(len(by_motion))
    strong = ellipse.traction.sum(axis=2).argmax(axis=1)
    rolling = every[strong, ball]
    own = by_motion[ball, strong]
    unknowns = np.concatenate([own[:, :, CENTRE], own[:, [OUTER], SPIN] - own[:, [INNER], SPIN]], axis=1)
    base = slip_of(rolling, by_motion)
    by_unknown = by_motion @ np.linalg.inv(unknowns)[:, None, None]
    base[ball, strong, :, CENTRE] = 0.0  # as rolling is made and the unknowns are chosen: exactly so
    by_unknown[ball, strong, :, CENTRE] = np.eye(3)[:2]
    balls = _Balls(base, by_unknown, ellipse, unknowns * _speed(rolling)[:, None])
    starts = np.einsum("nij,snj->sni", unknowns, every - rolling)
    control = np.zeros((3, len(rolling), 3))  # no spin on the inner, on the outer race, as much on both
    control[:2, :, 2] = (-base[ball, strong, :, SPIN] / by_unknown[ball, strong, :, SPIN, 2]).T
    control[2, :, 2] = control[:2, :, 2].mean(0)
    control[:, :, :2] = (LINES * base[..., ROLL] * ellipse.across**2 / ellipse.radius)[ball, strong]
    return rolling, balls, np.concatenate([starts, control])


def _speed(motion: NDArray) -> NDArray:
    """Speeds (N, 3) that changes of a motion are measured with."""
    ball = np.hypot(motion[:, 1], motion[:, 2])
    return np.stack([np.ones_like(ball), ball, ball], -1)


def _best(balls: _Balls, starts: NDArray) -> NDArray:
    """Unknowns (n, 3) of the start (S, n, 3) with the least power."""
    slip = balls.base + np.einsum("ngsij,tnj->tngsi", balls.by_unknown, starts)
    powers = sliding_friction(slip, balls.ellipse).power.sum((2, 3))
    return starts[np.argmin(powers, axis=0), np.arange(len(balls.base))]


def _least_power(balls: _Balls, start: NDArray) -> tuple[NDArray, NDArray, NDArray, int]:
    """Unknowns (n, 3) with the least power, that power, what is unbalanced there (n), and evaluations.

    Newton steps, shortened when they go too far; where that does not help, steps towards the minimum of the
    majorant, which always lower the power but creep along its valleys.
    """
    found, least, left = start.copy(), np.empty(len(start)), np.empty(len(start))
    running, here, heat = np.arange(len(start)), balls, balls.at(start)
    tries, part = np.zeros(len(start), int), np.ones(len(start))
    evaluations = 1
    while True:
        least[running], left[running] = heat.power, here.imbalance(heat)
        going = (left[running] > TOLERANCE) & (tries < len(CAUTION))
        if not going.any() or evaluations >= LIMIT:
            return found, least, left, evaluations
        if not going.all():
            running, here, heat = running[going], here.taken(going), heat.taken(going)
            tries, part = tries[going], part[going]
        step = part[:, None] * _step(heat, CAUTION[tries])
        trial = found[running] + step
        there, evaluations = here.at(trial), evaluations + 1
        before, after = (heat.slope * step).sum(axis=1), (there.slope * step).sum(axis=1)
        better = (after <= -ENOUGH_SLOPE * before) | (CAUTION[tries] == 1.0)
        better &= there.power <= heat.power * (1 + ROUNDING)
        found[running[better]] = trial[better]
        if better.all():  # all that follows would change nothing
            heat, tries, part = there, np.zeros_like(tries), np.ones_like(part)
            continue
        heat = there.or_else(heat, better)
        tries = np.where(better, 0, tries + 1)
        whole = better | (CAUTION.take(tries, mode="clip") > 0.0)
        part = np.where(whole, 1.0, part * _shorter(before, after))


def _step(heat: _Heat, caution: NDArray) -> NDArray:
    """Step (n, 3) to the minimum of a parabola between the tangent one and the majorant."""
    share = caution[:, None, None]
    matrix = (1 - share) * heat.curved + share * heat.above
    size = np.sqrt(np.einsum("nii->ni", heat.above))
    scaled = matrix / (size[:, :, None] * size[:, None, :]) + _RIDGE
    return -np.linalg.solve(scaled, (heat.slope / size)[..., None])[..., 0] / size


def _shorter(before: NDArray, after: NDArray) -> NDArray:
    """Part of a step that went too far to try next: where the slope along it would vanish if straight."""
    straight = before / np.where(after > before, before - after, -1.0)
    return np.clip(np.where(after > 0.0, straight, 0.5), 0.1, 0.7)
