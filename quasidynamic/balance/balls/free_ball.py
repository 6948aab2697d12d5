"""Balance of friction and gyroscopic moments of a ball that two races drive."""

from dataclasses import dataclass, fields
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.ellipse.full_sliding import Ellipse
from quasidynamic.contact.ellipse.general_sliding import (
    FINE,
    EllipsePoints,
    GeneralSliding,
    sliding_ellipse,
)
from quasidynamic.contact.ellipse.rigid_slip import CENTRE
from quasidynamic.motion.ball_slip import (
    INNER,
    ORBIT,
    OUTER,
    RADIAL,
    TURN,
    BallContacts,
    rolling_motion,
    turning_slip_by_motion,
)

_RIDGE = 1e-12  # of `above`: keeps slopes of saturated friction regular


class FreeBallBalance(NamedTuple):
    """Balance of balls near one motion."""

    left: NDArray  # (n, 4) moments that are not balanced, by unknown
    slopes: NDArray  # (n, 4, 4) of these by the unknowns
    above: NDArray  # (n, 4) roughly what the slopes of friction nowhere exceed

    def taken(self, keep: NDArray) -> "FreeBallBalance":
        """Return that of some of the balls."""
        return FreeBallBalance(*(array[keep] for array in self))

    def resolved(self, moments: NDArray, caution: NDArray | float = 0.0) -> NDArray:
        """Changes (n, 4, k) of the unknowns that make moments (n, 4, k); a share of `above` resists."""
        size = np.sqrt(self.above)[..., None]
        ridge = (_RIDGE + np.reshape(caution, (-1, 1, 1))) * np.eye(4)
        scaled = self.slopes / (size * np.swapaxes(size, -1, -2)) + ridge
        return np.linalg.solve(scaled, moments / size) / size

    def or_else(self, other: "FreeBallBalance", better: NDArray) -> "FreeBallBalance":
        """Return this one where it is better (n), else the other one."""
        shapes = (better.reshape(-1, *[1] * (array.ndim - 1)) for array in self)
        return FreeBallBalance(
            *(np.where(where, *pair) for where, *pair in zip(shapes, self, other, strict=True))
        )


@dataclass(frozen=True)
class FreeBalls:
    r"""N balls that slide on both races; speeds are over that of the inner against the outer ring.

    .. math:: \frac{\partial \Phi}{\partial \Omega_o} = 0,\quad
              \frac{\partial \Phi}{\partial \omega_x} = 0,\quad
              \frac{\partial \Phi}{\partial \omega_r} = J \omega_m \omega_t,\quad
              \frac{\partial \Phi}{\partial \omega_t} = -J \omega_m \omega_r

    Phi is the heat of friction. No force acts along the orbit; friction provides the moment
    J omega_m e_x x omega that turns the spin with the orbit, and that does no work: the heat is the power of
    the rings. For a given orbit Phi is convex and the gyroscopic part skew: there is one balance.

    The unknowns that no rounding spoils: slip in the centres of both contacts, the spin with neither, the
    speed of the surface by the turn about the rolling direction; from rolling without turning.

    Source
    ------
    Jones, J. Basic Eng. 81 (1959); Harris, Rolling Bearing Analysis, 4th ed. (2001), ch. 8, for the speeds;
    the heat as a function of the motion is convex as that of slow balls, `sliding_balls`.
    """

    contacts: BallContacts  # N balls, one diagonal
    ellipse: Ellipse  # (N, 2)
    gyration: NDArray  # (N) [N m] J over the square of the reference speed
    outer_speed: NDArray  # (N) [-] of the outer ring in space
    by_motion: NDArray  # (N, 2, 5, 4) slip by the motion
    rolling: NDArray  # (N, 4) [-] motion without slip in the middle of both contacts
    base: NDArray  # (N, 2, 5) slip there
    unknowns: NDArray  # (N, 4, 4) motion by the unknowns
    by_unknown: NDArray  # (N, 2, 5, 4) slip by the unknowns
    scale: NDArray  # (N, 4) largest friction by unknown

    def taken(self, keep: NDArray) -> "FreeBalls":
        """Return some of the balls."""
        names = [field.name for field in fields(self)[2:]]
        arrays = {name: getattr(self, name)[keep] for name in names}
        return FreeBalls(contacts=self.contacts.taken(keep), ellipse=self.ellipse.taken(keep), **arrays)

    def slip(self, unknowns: NDArray) -> NDArray:
        """Slip (N, 2, 5) at unknowns (N, 4)."""
        return self.base + np.einsum("ngij,nj->ngi", self.by_unknown, unknowns)

    def motion(self, unknowns: NDArray) -> NDArray:
        """Outer ring seen from the orbit, spin in axial, radial and rolling direction (N, 4) [-]."""
        return self.rolling + np.einsum("nij,nj->ni", self.unknowns, unknowns)

    def friction(self, unknowns: NDArray, points: EllipsePoints = FINE) -> GeneralSliding:
        """Friction (N, 2) at unknowns (N, 4)."""
        return sliding_ellipse(self.slip(unknowns), self.ellipse, points)

    def balance(self, unknowns: NDArray, friction: GeneralSliding, part: float = 1.0) -> FreeBallBalance:
        """Balance at unknowns (N, 4), of the friction there with a part of the gyroscopic moments."""
        by_motion, slopes = gyroscopic(self.motion(unknowns), part * self.gyration, self.outer_speed)
        back = np.swapaxes(self.unknowns, -1, -2)
        turned = np.swapaxes(self.by_unknown, -1, -2)
        return FreeBallBalance(
            left=np.einsum("ngij,ngi->nj", self.by_unknown, friction.by_slip)
            - (back @ by_motion[..., None])[..., 0],
            slopes=(turned @ friction.curvature @ self.by_unknown).sum(1) - back @ slopes @ self.unknowns,
            above=np.einsum("ngij,ngi->nj", self.by_unknown**2, friction.majorant),
        )


def free_balls(
    contacts: BallContacts, ellipse: Ellipse, gyration: NDArray, outer_speed: NDArray
) -> FreeBalls:
    """Balls at these contacts, see the fields of `FreeBalls`."""
    by_motion = turning_slip_by_motion(contacts)[:, 0]
    rolling = np.pad(rolling_motion(contacts, 0), [(0, 0), (0, 1)])
    base = np.einsum("ngij,nj->ngi", by_motion, rolling)
    base[:, INNER] += by_motion[:, INNER, :, ORBIT]  # the inner ring is one faster than the outer one
    base[..., CENTRE] = 0.0  # as rolling is made: exactly so
    unknowns = motion_by_slip(by_motion[:, :, CENTRE, :TURN], contacts.ball_radius)
    by_unknown = by_motion @ unknowns[:, None]
    by_unknown[..., CENTRE, :] = np.eye(4)[:2]  # as the unknowns are chosen: exactly so
    fall = ellipse.across**2 / (2 * ellipse.radius)
    ones = np.ones_like(fall)
    most = ellipse.traction[..., None] * np.stack([ones, fall, ellipse.across, ones, fall], -1)
    scale = np.einsum("ngi,ngij->nj", most, np.abs(by_unknown))
    return FreeBalls(
        contacts, ellipse, gyration, outer_speed, by_motion, rolling, base, unknowns, by_unknown, scale
    )


def motion_by_slip(centre: NDArray, ball_radius: NDArray) -> NDArray:
    """Motion by unknowns that no rounding spoils."""
    turned = np.swapaxes(centre, -1, -2)
    spinning = np.cross(centre[:, INNER], centre[:, OUTER])
    motion = np.zeros((len(centre), 4, 4))
    motion[:, :TURN, :2] = turned @ np.linalg.inv(centre @ turned)
    motion[:, :TURN, 2] = spinning / np.linalg.norm(spinning, axis=-1, keepdims=True)
    motion[:, TURN, 3] = 1 / ball_radius
    return motion


def gyroscopic(motion: NDArray, gyration: NDArray, outer_speed: NDArray) -> tuple[NDArray, NDArray]:
    r"""Moments that turn the spin of balls with their orbit.

    .. math:: M = J \omega_m (0, 0, \omega_t, -\omega_r),\quad \omega_m = \omega_o - \Omega_o

    as derivatives of a heat by Omega_o, omega_x, omega_r and omega_t: minus the moments of friction.

    The motion (N, 4) is that of the outer ring seen from the orbit and the spin of the ball in axial, radial
    and rolling direction [-], `outer_speed` (N) is omega_o in space [-], `gyration` (N) J over the square of
    the reference speed [N m]. M (N, 4) has slopes by the motion (N, 4, 4) [N m].

    Source
    ------
    Euler's equations of a sphere in a frame that turns with the orbit.
    """
    moments, slopes = np.zeros_like(motion), np.zeros((*motion.shape, 4))
    orbit = gyration * (outer_speed - motion[:, ORBIT])
    radial, turn = motion[:, RADIAL], motion[:, TURN]
    moments[:, RADIAL], moments[:, TURN] = orbit * turn, -orbit * radial
    slopes[:, RADIAL, TURN], slopes[:, TURN, RADIAL] = orbit, -orbit
    slopes[:, RADIAL, ORBIT], slopes[:, TURN, ORBIT] = -gyration * turn, gyration * radial
    return moments, slopes
