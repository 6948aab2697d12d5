"""Balance of friction and gyroscopic moments of a ball that two races drive, dry or in oil."""

from dataclasses import dataclass, fields, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.caged_ball import Cages, PocketForces, Pockets
from quasidynamic.balance.balls.oiled_ball import OiledContacts, OiledFriction, mean_by_motion
from quasidynamic.contact.ellipse.full_sliding import Ellipse
from quasidynamic.contact.ellipse.general_sliding import (
    FINE,
    EllipsePoints,
    GeneralSliding,
    sliding_ellipse,
)
from quasidynamic.contact.ellipse.rigid_slip import ACROSS, CENTRE, ROLL, SPIN
from quasidynamic.contact.lubricated_ellipse import LubricatedRaces
from quasidynamic.motion.ball_slip import (
    AXIAL,
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
POCKET_NOISE = 1e-9  # of the stiffness of pockets: the same, which keeps above rounding what is left
OILED = 2e-3  # of the load: friction that moments of lubricated contacts are measured with


class ContactPowers(NamedTuple):
    """Power of both contacts of balls, as far as races do it."""

    by_motion: NDArray  # (N, 2, 4) [N m] on a unit of each component of the motion
    across: NDArray  # (N, 2) [N] friction on the ball along the groove sections
    sliding: NDArray  # (N, 2) [N m] heat of the slip
    friction: OiledFriction | None  # what the oil does there


class OiledBalls(NamedTuple):
    """What the oil does to balls, arrays (N, ...) of balls or (..., C, Z) of cases; two races inner first."""

    film: NDArray  # (2) [m]
    entrainment: NDArray  # (2) [m/s] mean surface speed, >= 0
    sliding_heat: NDArray  # (2) [W]
    rolling_heat: NDArray  # (2) [W]
    drag_heat: NDArray  # [W]
    churning_heat: NDArray  # [W]
    ring_torque: NDArray  # (2) [N m] that turns each ring, signed like speeds
    slip: NDArray  # [-] of the orbit against rolling with the same axis, both against the outer ring
    spin_to_roll: NDArray  # (2) [-]
    sliding_power: NDArray  # (2) [W/m2] pressure times slip, mean over the contact
    friction_intensity: NDArray  # (2) [W/m2] heat of the slip per area
    pocket_force: NDArray  # [N] of the cage on the ball, signed like speeds
    pocket_torque: NDArray  # [N m] of the pocket on the ball about the shaft, with its friction, signed alike
    pocket_displacement: NDArray  # [m] of the ball from the centre of its pocket, signed alike
    pocket_heat: NDArray  # [W]
    cage_speed: NDArray  # [rad/s]
    land_torque: NDArray  # [N m] of the land on the cage, part of one ball
    land_heat: NDArray  # [W] part of one ball

    def of_case(self, case: int) -> "OiledBalls":
        """Return that of one of the cases."""
        return OiledBalls(*(array[..., case, :] for array in self))

    def on_land(self, cages: Cages, sense: NDArray) -> "OiledBalls":
        """Return that of balls (N) whose cages a land may guide; `sense` (N) is that of the rings."""
        of_ball, torque = cages.of_ball, self.ring_torque
        speed = (sense * self.cage_speed)[np.unique(of_ball, return_index=True)[1]] / cages.speed
        land = cages.land(speed)
        each = 1 / np.bincount(of_ball)[of_ball]
        share = sense * each * land.torque[of_ball]
        if cages.cage.guidance != "balls":
            torque = torque.copy()
            torque[:, 0 if cages.cage.guidance == "inner" else 1] += share
        return self._replace(
            ring_torque=torque, land_torque=share, land_heat=each * (cages.speed * land.heat)[of_ball]
        )

    @property
    def heat(self) -> NDArray:
        """Heat by all causes [W]."""
        contacts = self.sliding_heat + self.rolling_heat
        return contacts.sum(0) + self.drag_heat + self.churning_heat + self.pocket_heat + self.land_heat


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

    In oil tractions are those of a law of the slip, and rolling friction, drag and churning join. Phi is then
    the potential of `sliding_ellipse` instead of the heat, for the films and the speeds through the contacts
    as they are; these change a little with the motion, which no potential has.

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
    oil: OiledContacts | None = (
        None  # None: dry contacts, whose friction the ellipse has; else it has the load
    )

    def taken(self, keep: NDArray) -> "FreeBalls":
        """Return some of the balls."""
        names = [field.name for field in fields(self)[2:-1]]
        arrays = {name: getattr(self, name)[keep] for name in names}
        oil = self.oil and self.oil.taken(keep)
        return FreeBalls(
            contacts=self.contacts.taken(keep), ellipse=self.ellipse.taken(keep), oil=oil, **arrays
        )

    def slip(self, unknowns: NDArray) -> NDArray:
        """Slip (N, 2, 5) at unknowns (N, 4)."""
        return self.base + np.einsum("ngij,nj->ngi", self.by_unknown, unknowns)

    def motion(self, unknowns: NDArray) -> NDArray:
        """Outer ring seen from the orbit, spin in axial, radial and rolling direction (N, 4) [-]."""
        return self.rolling + np.einsum("nij,nj->ni", self.unknowns, unknowns)

    def friction(self, unknowns: NDArray, points: EllipsePoints = FINE) -> GeneralSliding | OiledFriction:
        """Friction (N, 2) at unknowns (N, 4)."""
        return self._friction(self.slip(unknowns), self.motion(unknowns), points)

    def _friction(
        self, slip: NDArray, motion: NDArray, points: EllipsePoints
    ) -> GeneralSliding | OiledFriction:
        if self.oil is None:
            return sliding_ellipse(slip, self.ellipse, points)
        mean = _of_rings(self.oil.mean_by_motion, motion)
        return self.oil.friction(slip, mean, (self.contacts, self.ellipse), points)

    def powers(self, motion: NDArray, points: EllipsePoints = FINE) -> ContactPowers:
        """Power of both contacts at a motion (N, 4)."""
        friction = self._friction(_of_rings(self.by_motion, motion), motion, points)
        sliding = sliding_of(friction)
        by_motion = np.einsum("ngij,ngi->ngj", self.by_motion, sliding.by_slip)
        across = -sliding.by_slip[..., ACROSS]
        if isinstance(friction, GeneralSliding) or self.oil is None:
            return ContactPowers(by_motion, across, sliding.power, None)
        return ContactPowers(
            by_motion + self.oil.rolling_by_motion(friction), across, sliding.power, friction
        )

    def oiled(self, motion: NDArray, unknowns: NDArray, sense: NDArray) -> OiledBalls:
        """What the oil does at motions and unknowns (N, 4); `sense` (N) is the sign of the speeds."""
        oil, powers = self.oil, self.powers(motion)
        assert oil is not None  # of lubricated balls
        assert powers.friction is not None
        slip, friction, speed = _of_rings(self.by_motion, motion), powers.friction, oil.speed[:, None]
        mixture, pocket = oil.mixture(motion, self.contacts, self.outer_speed), self.pocket(unknowns)
        none = np.zeros(len(motion))
        alone = sliding_ellipse(slip, self.ellipse).power  # of a coefficient of one
        area = np.pi * self.ellipse.across * self.ellipse.along
        heat = speed * friction.sliding.power
        rolled = 2 * friction.rolling.force * friction.sense**2 * friction.entrainment
        return OiledBalls(
            film=friction.film.thickness,
            entrainment=speed * friction.entrainment,
            sliding_heat=heat,
            rolling_heat=speed * rolled,
            drag_heat=oil.speed * mixture.drag * self.contacts.pitch_radius * np.abs(mixture.orbit),
            churning_heat=oil.speed * mixture.churning * mixture.spin,
            ring_torque=sense[:, None] * powers.by_motion[..., ORBIT],
            slip=1.0 - motion[:, ORBIT] / _rolling_orbit(self.by_motion[:, :, CENTRE], motion),
            spin_to_roll=slip[..., SPIN] / slip[..., ROLL],
            sliding_power=speed * alone / area,
            friction_intensity=heat / area,
            pocket_force=none if pocket is None else -sense * pocket.force,
            pocket_torque=none if pocket is None else -sense * pocket.torque,
            pocket_displacement=none if pocket is None else sense * pocket.displacement,
            pocket_heat=none if pocket is None else oil.speed * pocket.heat,
            cage_speed=none
            if oil.pockets is None
            else sense * oil.speed * (oil.pockets.base + oil.pockets.speed),
            land_torque=none,
            land_heat=none,
        )

    def in_cage(self, speed: NDArray) -> "FreeBalls":
        """Return the same balls in cages of this speed (N) [-]."""
        oil = self.oil
        assert oil is not None  # of lubricated balls
        assert oil.pockets is not None
        return replace(self, oil=replace(oil, pockets=oil.pockets.at_speed(speed)))

    def from_base(self, base: NDArray) -> "FreeBalls":
        """Return the same balls with speeds of their cages counted from a base (N) [-]."""
        oil = self.oil
        assert oil is not None  # of lubricated balls
        assert oil.pockets is not None
        return replace(self, oil=replace(oil, pockets=replace(oil.pockets, base=base)))

    def pocket(self, unknowns: NDArray, part: NDArray | float = 1.0) -> PocketForces | None:
        """Forces of pockets at unknowns (N, 4), with a part (N) of their friction; None without a cage."""
        pockets = self.oil and self.oil.pockets
        if pockets is None:
            return None
        change = np.einsum("nj,nj->n", self.unknowns[:, ORBIT], unknowns)
        lead = pockets.lead(self.rolling[:, ORBIT], change)
        return pockets.forces(self.motion(unknowns), lead, part)

    def balance(
        self, unknowns: NDArray, friction: GeneralSliding | OiledFriction, part: NDArray | float = 1.0
    ) -> FreeBallBalance:
        """Balance at unknowns (N, 4), of sliding and pocket films with a part (N) of all other moments."""
        motion, sliding = self.motion(unknowns), sliding_of(friction)
        by_motion, by_motions = gyroscopic(motion, self.gyration, self.outer_speed)
        above = np.einsum("ngij,ngi->nj", self.by_unknown**2, sliding.majorant)
        turned, back = np.swapaxes(self.by_unknown, -1, -2), np.swapaxes(self.unknowns, -1, -2)
        slopes, share = (turned @ self.force_slopes(friction)).sum(1), np.reshape(part, (-1, 1))
        if self.oil is not None and isinstance(friction, OiledFriction):
            mixture = self.oil.mixture(motion, self.contacts, self.outer_speed)
            by_motion = by_motion - mixture.left - self.oil.rolling_by_motion(friction).sum(1)
            by_motions = by_motions - mixture.slopes
            rolling, most = self.oil.rolling_slopes(friction, self._mean_by_unknown)
            slopes, above = slopes + share[..., None] * rolling, above + share * most
        by_motion, by_motions = share * by_motion, share[..., None] * by_motions
        if (pocket := self.pocket(unknowns, part)) is not None:
            by_motion, by_motions = by_motion - pocket.left, by_motions - pocket.slopes
            above = above + pocket.slopes[:, [ORBIT], ORBIT] * self.unknowns[:, ORBIT] ** 2
        return FreeBallBalance(
            left=np.einsum("ngij,ngi->nj", self.by_unknown, sliding.by_slip)
            - (back @ by_motion[..., None])[..., 0],
            slopes=slopes - back @ by_motions @ self.unknowns,
            above=above,
        )

    def force_slopes(self, friction: GeneralSliding | OiledFriction) -> NDArray:
        """Derivatives (N, 2, 5, 4) of the power by slip, by the unknowns."""
        slopes = sliding_of(friction).curvature @ self.by_unknown
        if self.oil is not None and isinstance(friction, OiledFriction):
            slopes += self.oil.by_speed(friction, self.by_unknown, self._mean_by_unknown)
        return slopes

    @property
    def _mean_by_unknown(self) -> NDArray:
        """Mean surface speed (N, 2, 4) [m] by the unknowns, of balls in oil."""
        assert self.oil is not None
        return self.oil.mean_by_motion @ self.unknowns


def sliding_of(friction: GeneralSliding | OiledFriction) -> GeneralSliding:
    """The part of the friction that works on the slip."""
    return friction if isinstance(friction, GeneralSliding) else friction.sliding


def _of_rings(by_motion: NDArray, motion: NDArray) -> NDArray:
    """What both contacts have (N, 2, ...) at motions (N, 4); the inner ring is one faster than the outer."""
    each = np.repeat(motion[:, None], 2, axis=1)
    each[:, INNER, ORBIT] += 1.0
    return np.einsum("ng...j,ngj->ng...", by_motion, each)


def _rolling_orbit(centre: NDArray, motion: NDArray) -> NDArray:
    """Outer ring seen from the orbit (N) of balls that do not slip in the middle of both contacts.

    Their axes are those of a motion (N, 4); `centre` (N, 2, 4) is the slip there by the motion.
    """
    turning = np.einsum("ngj,nj->ng", centre[..., AXIAL:], motion[:, AXIAL:])
    driven, outer = centre[..., ORBIT].T
    return driven * turning[:, OUTER] / (outer * turning[:, INNER] - driven * turning[:, OUTER])


def free_balls(
    contacts: BallContacts,
    ellipse: Ellipse,
    gyration: NDArray,
    outer_speed: NDArray,
    oil: tuple[LubricatedRaces, NDArray, NDArray] | None = None,
    pockets: Pockets | None = None,
) -> FreeBalls:
    """Balls at these contacts, see the fields of `FreeBalls`.

    Oil is what both races are lubricated with, the speed (N) [rad/s] of the rings against each other, and the
    part of the driving loads that is there (N, 2) [-]. Only balls in oil have pockets.
    """
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
    balls = FreeBalls(
        contacts, ellipse, gyration, outer_speed, by_motion, rolling, base, unknowns, by_unknown, scale
    )
    if oil is None:
        return balls
    oiled = OiledContacts(*oil, mean_by_motion(by_motion[..., CENTRE, :]), pockets)
    if pockets is not None:  # which hold a ball that one race hardly presses
        scale[:, :2] = scale[:, :2].max(1, keepdims=True)
        rounding = POCKET_NOISE * pockets.film_stiffness / OILED
        scale += rounding[:, None] * np.abs(unknowns[:, ORBIT])
    return replace(balls, scale=OILED * scale, oil=oiled)


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
