"""Heat of friction of slow balls by their motion: where it is least, forces and moments are in balance."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.ellipse.full_sliding import Ellipse, sliding_friction
from quasidynamic.contact.ellipse.rigid_slip import CENTRE, SPIN
from quasidynamic.motion.ball_slip import (
    AXIAL,
    INNER,
    ORBIT,
    OUTER,
    RADIAL,
    BallContacts,
    slip_by_motion,
    slip_of,
)

SERIES, EXACT = 1e-3, 20.0  # of the width: load below which N is taken from its series, above which it is Q


class DrivingLoad(NamedTuple):
    """Load that the friction balance of a ball sees."""

    value: NDArray  # (...) [N] N
    by_load: NDArray  # (...) [-] dN/dQ
    by_width: NDArray  # (...) [-] dN/dw
    hold: NDArray  # (...) [-] h = Q/N, the part of the friction that is there


def driving_load(load: NDArray, width: NDArray) -> DrivingLoad:
    r"""Load with which a race drives a ball, never below w.

    .. math:: N = Q / h,\qquad h = \tanh (Q/w)

    A cage carries a ball along that races press too lightly; there is none here, so these press with w.

    Parameters
    ----------
    load : array (...)
        Q [N], >= 0
    width : array (...)
        w [N], >= 0

    Returns
    -------
    DrivingLoad
        of both kinds of balls without a kink

    Source
    ------
    An assumption, with the h of `grip`.

    Valid
    -----
    N = Q to rounding from Q = 19 w on, to a hundredth from 2.5 w on; below, the motion is an estimate.

    >>> light = driving_load(np.array([0.0, 50.0]), np.array([2.0, 2.0]))
    >>> light.value.tolist(), light.hold.tolist()
    ([2.0, 50.0], [0.0, 1.0])
    """
    part = load / np.maximum(width, np.finfo(float).tiny)
    heavy, light = part > EXACT, part < SERIES
    safe = np.where(heavy | light, 1.0, part)
    hold = np.tanh(safe)
    share = (1 - hold**2) * safe / hold
    return DrivingLoad(
        value=np.where(heavy, load, np.where(light, width * (1 + part**2 / 3), load / hold)),
        by_load=np.where(heavy, 1.0, np.where(light, 2 * part / 3, (1 - share) / hold)),
        by_width=np.where(heavy, 0.0, np.where(light, 1 - part**2 / 3, safe * share / hold)),
        hold=np.where(heavy, 1.0, np.where(light, part, hold)),
    )


class FrictionHeat(NamedTuple):
    """Heat of friction of balls near one motion."""

    power: NDArray  # (n)
    slope: NDArray  # (n, k) by the unknowns
    curvature: NDArray  # (n, k, k)
    majorant: NDArray  # (n, k, k) curvature of the parabola that touches the heat and lies above everywhere

    def taken(self, keep: NDArray) -> "FrictionHeat":
        """Return that of some of the balls."""
        return FrictionHeat(*(array[keep] for array in self))

    def or_else(self, other: "FrictionHeat", better: NDArray) -> "FrictionHeat":
        """Return that of this motion where it is better (n), else of the other."""
        shapes = (better.reshape(-1, *[1] * (array.ndim - 1)) for array in self)
        return FrictionHeat(
            *(np.where(where, *pair) for where, *pair in zip(shapes, self, other, strict=True))
        )


@dataclass(frozen=True)
class SlidingBallBalance:
    """Balls in k unknowns that no rounding spoils: slip on their stronger diagonal.

    The unknowns are both centre slips there and, where the axis is free, the spin, as differences from
    rolling on that diagonal.
    """

    base: NDArray  # (n, G, 2, 3) slip when rolling on the stronger diagonal
    by_unknown: NDArray  # (n, G, 2, 3, k) slip by the unknowns
    ellipse: Ellipse
    by_motion: NDArray  # (n, k, k) unknowns by the components of the motion
    scale: NDArray  # (n, k, k) the same, each component in parts of its speed

    def taken(self, keep: NDArray) -> "SlidingBallBalance":
        """Return some of the balls."""
        return SlidingBallBalance(
            self.base[keep],
            self.by_unknown[keep],
            self.ellipse.taken(keep),
            self.by_motion[keep],
            self.scale[keep],
        )

    def slip(self, unknowns: NDArray) -> NDArray:
        """Slip (n, G, 2, 3) at unknowns (n, k)."""
        return self.base + np.einsum("ngsij,nj->ngsi", self.by_unknown, unknowns)

    def imbalance(self, heat: FrictionHeat) -> NDArray:
        """Unbalanced power of each component of the motion over the power of friction, the largest (n)."""
        return np.abs(np.einsum("nij,ni->nj", self.scale, heat.slope)).max(axis=1) / heat.power

    def at(self, unknowns: NDArray) -> FrictionHeat:
        """Heat at unknowns (n, k)."""
        friction = sliding_friction(self.slip(unknowns), self.ellipse)
        slope = np.einsum("ngsij,ngsi->nj", self.by_unknown, friction.by_slip)
        turned = np.swapaxes(self.by_unknown, -1, -2)
        curvature, majorant = (
            (turned @ matrix @ self.by_unknown).sum((1, 2)) for matrix in friction.curvatures()
        )
        return FrictionHeat(friction.power.sum((1, 2)), slope, curvature, majorant)


def sliding_ball_balance(contacts: BallContacts, ellipse: Ellipse, rolling: NDArray) -> SlidingBallBalance:
    """Balance of balls about rolling (N, 3) on their stronger diagonal."""
    by_motion = slip_by_motion(contacts)
    ball, strong = np.arange(len(by_motion)), stronger_diagonal(ellipse)
    on_strong = by_motion[ball, strong]
    unknowns = np.concatenate(
        [on_strong[:, :, CENTRE], on_strong[:, [OUTER], SPIN] - on_strong[:, [INNER], SPIN]], axis=1
    )
    base = slip_of(rolling, by_motion)
    by_unknown = by_motion @ np.linalg.inv(unknowns)[:, None, None]
    base[ball, strong, :, CENTRE] = 0.0  # as rolling is made and the unknowns are chosen: exactly so
    by_unknown[ball, strong, :, CENTRE] = np.eye(3)[:2]
    return SlidingBallBalance(base, by_unknown, ellipse, unknowns, unknowns * motion_scale(rolling)[:, None])


def guided_ball_balance(contacts: BallContacts, ellipse: Ellipse, attitude: NDArray) -> SlidingBallBalance:
    """Balance of balls (N) of one diagonal whose axis stands at an attitude [rad], see `AngularContactState`.

    The motion is that of the outer ring and the speed about this axis; two forces, along the orbit and about
    the axis, balance.
    """
    by_motion = slip_by_motion(contacts)
    axis = np.zeros((len(attitude), 3, 2))
    axis[:, ORBIT, 0], axis[:, AXIAL, 1], axis[:, RADIAL, 1] = 1.0, -np.cos(attitude), np.sin(attitude)
    guided = by_motion @ axis[:, None, None]  # (N, 1, 2, 3, 2)
    unknowns, driven = guided[:, 0, :, CENTRE], by_motion[:, 0, INNER, :, ORBIT]
    by_unknown = guided @ np.linalg.inv(unknowns)[:, None, None]
    rolling = np.linalg.solve(unknowns, np.stack([-driven[:, CENTRE], 0.0 * attitude], -1)[..., None])
    base = (guided @ rolling[:, None, None])[..., 0]
    base[:, 0, INNER] += driven
    base[:, 0, :, CENTRE], by_unknown[:, 0, :, CENTRE] = 0.0, np.eye(2)  # as they are chosen: exactly so
    scale = unknowns * np.stack([np.ones_like(attitude), np.abs(rolling[:, 1, 0])], -1)[:, None]
    return SlidingBallBalance(base, by_unknown, ellipse, unknowns, scale)


def stronger_diagonal(ellipse: Ellipse) -> NDArray:
    """Diagonal (N) with more friction."""
    return ellipse.traction.sum(axis=2).argmax(axis=1)


def motion_scale(motion: NDArray) -> NDArray:
    """Speeds (N, 3) that changes of a motion are measured with."""
    ball = np.hypot(motion[:, 1], motion[:, 2])
    return np.stack([np.ones_like(ball), ball, ball], -1)
