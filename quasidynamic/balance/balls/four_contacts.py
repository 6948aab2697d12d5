"""Balance of balls between two grooves of one or two arches each, with inertia."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.arch_motion import arch_motion
from quasidynamic.balance.balls.ending_races import BEHIND, EndingRaces
from quasidynamic.balance.balls.light_ball import held_traction
from quasidynamic.contact.ellipse.point_contact import point_contact, race_curvatures
from quasidynamic.motion.ball_slip import OUTER, SIDE
from quasidynamic.motion.roller_speeds import rolling_cage_speed
from quasidynamic.parts.ball import FourPointBearing

SIDE_OF_DIAGONAL = np.array([1.0, -1.0])  # sign of the axial direction in which it points outwards
OWN_SIDE = np.stack([SIDE_OF_DIAGONAL, np.ones(2)], -1)  # (2, 2) of components, there and back
FLOATING = 1e-12  # of its stiffness, given to every ball
LEAST_STIFFNESS = 1e-9  # [N/m] the same where nothing touches: a long step, not an infinite one


class ContactForces(NamedTuple):
    """Forces of balls on races; vectors are axial, to the side of the diagonal, and radial."""

    approach: NDArray  # (Z, 2, 2) [m] of ball and race, negative in a gap
    loads: NDArray  # (Z, 2, 2) [N] normal, >= 0
    whole: NDArray  # (Z, 2, 2) [N] the same of contacts that no shoulder cuts off
    on_races: NDArray  # (Z, 2, 2, 2) [N] force of the ball on each race
    orbit: NDArray  # (Z) [rad/s]
    centrifugal: NDArray  # (Z) [N]
    gyroscopic: NDArray  # (Z) [N m]


class _Pressed(NamedTuple):
    """Contacts without friction, with slopes by their own arms."""

    whole: NDArray  # (Z, 2, 2) [N] loads of contacts that no shoulder cuts off
    loads: NDArray  # (Z, 2, 2) [N]
    pushes: NDArray  # (Z, 2, 2, 2) [N] forces along the arms
    stiffness: NDArray  # (Z, 2, 2, 2) [N/m] of the loads
    springs: NDArray  # (Z, 2, 2, 2, 2) [N/m] of the pushes


class BallsOnArches(NamedTuple):
    """Balls at places, and slopes by the arms (8) of their contacts: diagonal, race, component."""

    arms: NDArray  # (Z, 2, 2, 2) [m] from the outer grooves to the ball, from the ball to the inner ones
    forces: ContactForces
    turn: NDArray  # (Z, 2, 2, 2) [rad/m] of the contact angles by their arms
    force_slopes: NDArray  # (Z, 8, 8) [N/m] of the forces on the races
    excess: NDArray  # (Z, 2) [N] force on each ball that is not balanced, axial and radial
    excess_slopes: NDArray  # (Z, 2, 8) [N/m]

    @property
    def angles(self) -> NDArray:
        """Contact angles (Z, 2, 2) [rad]."""
        return np.arctan2(self.arms[..., 0], self.arms[..., 1])

    @property
    def by_ball(self) -> NDArray:
        """Slopes of the unbalanced force by the place of the ball (Z, 2, 2) [N/m]."""
        return self.excess_slopes @ ARMS_BY_BALL

    @property
    def held_lightly(self) -> NDArray:
        """Stiffness (Z) [N/m] that is given to every ball, as some are held by nothing."""
        return FLOATING * np.abs(self.by_ball).sum((1, 2)) + LEAST_STIFFNESS

    def after(self, moves: NDArray) -> NDArray:
        """Forces on the races (Z, 8) [N] after small moves of the balls (Z, 2) [m]."""
        change = self.force_slopes @ (ARMS_BY_BALL @ moves[..., None])
        return self.forces.on_races.reshape(-1, 8) + change[..., 0]

    @property
    def following(self) -> NDArray:
        """Move of the balls as the grooves move the arms, in balance (Z, 2, 8) [-]."""
        held = self.by_ball - self.held_lightly[:, None, None] * np.eye(2)
        return -np.linalg.solve(held, self.excess_slopes)

    @property
    def arms_by_grooves(self) -> NDArray:
        """Change of the arms as the grooves move them, balls in balance (Z, 8, 8) [-]."""
        return np.eye(8) + ARMS_BY_BALL @ self.following


def _arms_by_ball() -> NDArray:
    """Change of the arms (8) by the place of the ball, axial and radial (8, 2) [-]."""
    towards = np.array([-1.0, 1.0])  # of the inner and the outer arm
    return (towards[None, :, None, None] * OWN_SIDE[:, None, :, None] * np.eye(2)).reshape(8, 2)


ARMS_BY_BALL = _arms_by_ball()
ARMS_OWN = np.abs(ARMS_BY_BALL) * np.tile(OWN_SIDE[:, None, :, None], (1, 2, 1, 1)).reshape(
    8, 1
)  # (8, 2) components
ARMS_BY_RING = np.where(
    np.tile([[1.0], [1.0], [0.0], [0.0]], (2, 1)) > 0, -ARMS_BY_BALL, 0.0
)  # (8, 2) of inner
ARMS_BY_SHAPE = np.where(np.tile([1.0, 1.0, 0.0, 0.0], 2) > 0, 1.0, -1.0)  # (8) by the shape of each groove


@dataclass(frozen=True)
class FourContacts:
    r"""Balls between two grooves, each with two arches or one.

    .. math:: \sum_k (-Q_k + \mathrm i P_k)\, n_k + \mathrm i F_c = 0,\quad
              Q_k = K [L_k - \rho]_+^{3/2},\quad
              P_k = \frac{2 M_g}{D} \frac{Q_k}{\sum_{outer} Q}\ \text{(outer)},\quad P_k = 0\ \text{(inner)}

    in complex numbers, axial + i radial, with the normals n_k from the ball to its contacts, the distance L_k
    of ball and groove centre and rho = r - D/2. Tractions hold the gyroscopic moment on the outer race alone,
    as with outer race control, shared by its contacts as they are loaded; up to what `held_traction` allows.
    Where arches end on shoulders Q is that of `EndingRaces`, whose S is added to P.
    Orbit and spin are those of `arch_motion`. Moments and tilts of the ring are taken over the pitch radius.

    Source
    ------
    Jones, J. Basic Eng. 81 (1959); Harris, Rolling Bearing Analysis, 4th ed. (2001), ch. 8 and 9, for one
    diagonal; the share of three and four contacts is an assumption.
    """

    bearing: FourPointBearing
    speed: float  # [rad/s] of the inner ring, the outer one at rest
    coefficient: NDArray  # (2) [N/m^1.5] of the contacts with the inner, the outer race
    reach: NDArray  # (2) [m] from the centre of a groove to that of a ball that just touches
    start: NDArray  # (2, 2, 2) [m] arms of balls in the middle, rings concentric
    moves: NDArray  # (Z, 2, 5) [-] displacement of the inner ring at each ball by its place, axial and radial
    races: EndingRaces | None = None  # whose shoulders cut contacts off; None: all are whole

    @classmethod
    def of(cls, bearing: FourPointBearing, speed: float = 0.0) -> "FourContacts":
        """Build from a bearing and a speed [rad/s]."""
        cosine, sine = np.cos(bearing.azimuths), np.sin(bearing.azimuths)
        none, one = np.zeros_like(cosine), np.ones_like(cosine)
        reach = bearing.groove_radii - bearing.ball.diameter / 2
        apart = bearing.centre_distance - bearing.clearance
        both = apart * np.array([np.sin(bearing.contact_angle), np.cos(bearing.contact_angle)])
        aside = bearing.outer_offset  # balls begin where they touch the outer groove in its middle
        outer = np.array([aside, np.sqrt(max(reach[OUTER] ** 2 - aside**2, 0.0))])
        curvatures = race_curvatures(
            bearing.ball.diameter, bearing.groove_radii, bearing.pitch_diameter, bearing.contact_angle, SIDE
        )
        contacts, races = point_contact(curvatures, bearing.moduli), None
        if np.isfinite(bearing.groove_ends).any():
            ends = np.minimum([bearing.groove_ends, (BEHIND, BEHIND)], BEHIND)
            spread = contacts.across * np.cbrt(contacts.coefficient)
            ratio = contacts.across / contacts.along
            races = EndingRaces(ends.reshape(2, 1, 1, 2), bearing.groove_radii, spread, ratio)
        return cls(
            bearing=bearing,
            speed=speed,
            coefficient=contacts.coefficient,
            reach=reach,
            start=np.stack([both - outer, outer]) + np.zeros((2, 1, 1)),
            moves=np.stack(
                [
                    np.stack([one, none, none, cosine, -sine], 1),
                    np.stack([none, sine, cosine, none, none], 1),
                ],
                1,
            ),
            races=races,
        )

    @property
    def of_whole_contacts(self) -> "FourContacts":
        """The same without shoulders."""
        return self if self.races is None else replace(self, races=None)

    def withdrawn(self, angle: float) -> "FourContacts":
        """The same with arches that end further out by an angle [rad]."""
        return self if self.races is None else replace(self, races=self.races.withdrawn(angle))

    def over_shoulders(self, balls: BallsOnArches) -> float:
        """Angle [rad] by which whole contacts of balls reach over shoulders, none where <= 0."""
        if self.races is None:
            return -np.inf
        return float(self.races.beyond(balls.forces.approach, balls.angles).max())

    @cached_property
    def free_centrifugal(self) -> float:
        """F_c of balls that lie on the outer race alone, in the middle [N]."""
        bearing = self.bearing
        orbit = rolling_cage_speed(self.speed, 0.0, bearing.ball.diameter / bearing.pitch_diameter)
        return float(0.5 * bearing.ball.mass * bearing.pitch_diameter * orbit**2)

    @cached_property
    def in_series(self) -> float:
        """Coefficient of a diagonal, both contacts in series [N/m^1.5]."""
        return float((self.coefficient ** (-2 / 3)).sum() ** -1.5)

    @property
    def distances(self) -> NDArray:
        """Distances of opposite groove centres, rings concentric (2, 2) [m], axial and radial."""
        return self.start.sum(1)

    def arms(self, place: NDArray, centres: NDArray, shape: NDArray | float = 0.0) -> NDArray:
        """Arms (Z, 2, 2, 2) [m] at places of the ring (5) and of balls (Z, 2), grooves moved by a shape."""
        moved = (self.moves @ place) @ ARMS_BY_RING.T + centres @ ARMS_BY_BALL.T
        shapes = ARMS_BY_SHAPE.reshape(2, 2, 2) * shape
        return self.start + moved.reshape(-1, 2, 2, 2) + shapes

    def at(self, arms: NDArray) -> BallsOnArches:
        """Forces and their slopes at the arms (Z, 2, 2, 2) [m] of balls."""
        walled = np.stack([arms[..., 0], np.maximum(arms[..., 1], 0.0)], -1)
        length = np.hypot(walled[..., 0], walled[..., 1])
        approach = self._on_arch(length - self.reach, arms[..., 0])
        normals = walled / length[..., None]  # along the arms
        turned = np.stack([normals[..., 1], -normals[..., 0]], -1)  # change of the normals by the angle
        turn = np.where(arms[..., 1:] > 0.0, turned / length[..., None], 0.0)  # of the angle by the arm
        pressed = self._pressed(approach, length, (normals, turned, turn))
        loads, stiffness, springs = pressed.loads, pressed.stiffness, pressed.springs
        on_races, slopes = SIDE[:, None] * pressed.pushes, np.zeros((len(arms), 4, 2, 4, 2))
        each = np.arange(4)
        slopes[:, each, :, each] = (SIDE[:, None, None] * springs).reshape(-1, 4, 2, 2).swapaxes(0, 1)
        slopes = slopes.reshape(-1, 8, 8)
        inertia, inertia_slopes, traction, traction_slopes = self._inertia(
            loads, normals, turned, stiffness, turn
        )
        along = turned[..., OUTER, :]
        on_races[..., OUTER, :] += traction[..., None] * along
        held = along[..., None] * traction_slopes[:, :, None]
        held.reshape(-1, 2, 2, 2, 2, 2)[:, [0, 1], :, [0, 1], OUTER] -= np.moveaxis(
            (traction[..., None] * normals[..., OUTER, :])[..., None] * turn[..., OUTER, None, :], 1, 0
        )
        slopes.reshape(-1, 2, 2, 2, 8)[:, :, OUTER] += held
        excess = -on_races.reshape(-1, 8) @ ARMS_OWN
        excess[:, 1] += inertia[1]
        by_arms = -ARMS_OWN.T @ slopes
        by_arms[:, 1] += inertia_slopes
        forces = ContactForces(approach, loads, pressed.whole, on_races, *inertia)
        return BallsOnArches(walled, forces, turn, slopes, excess, by_arms)

    def _pressed(
        self, approach: NDArray, length: NDArray, along: tuple[NDArray, NDArray, NDArray]
    ) -> "_Pressed":
        """Contacts without friction; `along` are normals, their turn, and that of angles by arms."""
        normals, turned, turn = along
        closer = np.maximum(approach, 0.0)
        grown = self.coefficient * np.sqrt(closer)
        loads, stiff = grown * closer, 1.5 * grown
        if self.races is None:
            pushes, slopes = loads[..., None] * normals, stiff[..., None] * normals
            springs = normals[..., :, None] * slopes[..., None, :]
            springs += loads[..., None, None] * turned[..., :, None] * turn[..., None, :]
            return _Pressed(loads, loads, pushes, slopes, springs)
        angles = np.arctan2(normals[..., 0], normals[..., 1])
        cut = self.races.forces((loads, stiff), closer, angles, length)
        pushes = cut.loads[..., None] * normals + cut.aside[..., None] * turned
        slopes = cut.stiffness[..., None] * normals + cut.by_angle[..., None] * turn
        aside = cut.aside_stiffness[..., None] * normals + cut.aside_by_angle[..., None] * turn
        turning = cut.loads[..., None] * turned - cut.aside[..., None] * normals
        springs = normals[..., :, None] * slopes[..., None, :] + turned[..., :, None] * aside[..., None, :]
        springs += turning[..., :, None] * turn[..., None, :]
        return _Pressed(cut.whole, cut.loads, pushes, slopes, springs)

    def _inertia(
        self, loads: NDArray, normals: NDArray, turned: NDArray, stiffness: NDArray, turn: NDArray
    ) -> tuple[NDArray, NDArray, NDArray, NDArray]:
        """Orbit, F_c and M_g (3, Z), slopes of F_c (Z, 8), outer tractions (Z, 2) and their slopes."""
        count, ball = len(loads), self.bearing.ball
        if not self.speed:
            return np.zeros((3, count)), np.zeros((count, 8)), np.zeros((count, 2)), np.zeros((count, 2, 8))
        to_contact = SIDE[:, None] * OWN_SIDE[:, None]
        motion = arch_motion(
            loads,
            to_contact * normals,
            to_contact * turned,
            self.bearing.pitch_diameter / ball.diameter,
            self.speed,
            self.free_centrifugal,
        )
        by_arm = np.zeros((count, 2, 4, 4, 2))  # of the loads and the angles of contacts
        each = np.arange(4)
        by_arm[:, 0, each, each] = stiffness.reshape(-1, 4, 2)
        by_arm[:, 1, each, each] = turn.reshape(-1, 4, 2)
        by_arms = by_arm.reshape(count, 8, 8)
        outer, _, radial = motion.motion.T
        outer_slopes, _, radial_slopes = np.moveaxis(motion.slopes @ by_arms, 1, 0)
        size = ball.mass * self.bearing.pitch_diameter
        moment_slopes = -ball.inertia * (outer_slopes * radial[:, None] + outer[:, None] * radial_slopes)
        inertia = np.stack([-outer, 0.5 * size * outer**2, -ball.inertia * outer * radial])
        outside = loads[..., OUTER]
        load = outside.sum(1)
        total, by_needed, by_load = held_traction(2.0 / ball.diameter * inertia[2], load)
        outside_slopes = by_arm[:, 0, OUTER::2].reshape(count, 2, 8)
        load_slopes = outside_slopes.sum(1)
        total_slopes = np.reshape(by_needed, (-1, 1)) * (2.0 / ball.diameter) * moment_slopes
        total_slopes += np.reshape(by_load, (-1, 1)) * load_slopes
        divisor = np.where(load > 0.0, load, 1.0)
        share = outside / divisor[:, None]
        share_slopes = (outside_slopes - share[..., None] * load_slopes[:, None]) / divisor[:, None, None]
        traction = SIDE_OF_DIAGONAL * share * total[:, None]
        slopes = share[..., None] * total_slopes[:, None] + total[:, None, None] * share_slopes
        return inertia, size * outer[:, None] * outer_slopes, traction, SIDE_OF_DIAGONAL[:, None] * slopes

    def _on_arch(self, approach: NDArray, axial: NDArray) -> NDArray:
        """Approach (Z, 2, 2) [m], negative for the half of one outer arc that a ball is not on."""
        if self.bearing.outer_arches == 2:
            return approach
        beside = axial[..., OUTER] <= np.array(
            [-np.finfo(float).tiny, 0.0]
        )  # in the middle it is on the first
        approach[..., OUTER] = np.where(beside, -np.abs(axial[..., OUTER]), approach[..., OUTER])
        return approach

    def carried(self, on_races: NDArray) -> NDArray:
        """Load (5, ...) [N] on the inner ring that forces on the races (Z, 8, ...) carry."""
        return -np.einsum("jkp,jk...->p...", self.arms_by_place, on_races)

    @cached_property
    def arms_by_place(self) -> NDArray:
        """Change of the arms by the place of the inner ring (Z, 8, 5) [-]."""
        return ARMS_BY_RING @ self.moves
