"""What Coulomb friction on both races makes balls do."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.driving_load import driving_load
from quasidynamic.balance.balls.free_ball import free_balls
from quasidynamic.balance.balls.light_ball import RELEASE
from quasidynamic.balance.balls.race_control import BallKinematics, LoadedContacts, PrescribedControl
from quasidynamic.contact.ellipse.full_sliding import Ellipse
from quasidynamic.contact.ellipse.point_contact import PointContact
from quasidynamic.contact.ellipse.rigid_slip import Spin
from quasidynamic.motion.ball_slip import (
    AXIAL,
    INNER,
    ORBIT,
    OUTER,
    RADIAL,
    TURN,
    BallContacts,
    pressed_height,
    pressed_radius,
)
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing
from quasidynamic.solve.balls.free_ball_motion import FreeBallMotion, free_ball_motion

RELEASED = (RELEASE, RELEASE / 8)  # of F_c: least driving load of the inner, of the outer race
UNEVEN = 0.05  # of the load on the other race: the same, away from balance
NOISE = 1e-9  # of the largest force: what is left of the balance of balls that friction moves
WIDEST = 0.9  # of the ball radius: semi-axis up to which a contact has a friction


class DrivenContacts(NamedTuple):
    """Contacts as friction sees them, N balls in a row, inner and outer race."""

    angles: NDArray  # (2, N) [rad]
    loads: NDArray  # (2, N) [N] that drive
    hold: NDArray  # (2, N) [-] part of these that is there
    hold_slopes: NDArray  # (2, 2, N) [1/m] by L of the same, of the other race
    chain: NDArray  # (N, 4, 4) slopes of ln N_i, alpha_i, ln N_o, alpha_o by L_i, alpha_i, L_o, alpha_o


@dataclass(frozen=True)
class CoulombControl:
    r"""Balls move as Coulomb friction balances their inertia, with no assumption on which race controls them.

    .. math:: T = -\int \mu p\, \frac{v_1}{|v|}\, dA

    All three components of the spin and the orbit follow from the balance of `FreeBalls`, for each ball alone
    and for its contacts as they are: no film, no cage, no drag. Where friction cannot hold the gyroscopic
    moment the ball turns about the rolling direction, and the tractions stay below mu Q.

    A ball that the inner race presses lightly would slow down to where friction can drive it; in a bearing a
    cage carries it on. So no race drives with less than a share of F_c, see `driving_load`, the tractions
    being those of the true load, and the inner contact angle fades to the outer one with the inner load.

    Source
    ------
    Jones, J. Basic Eng. 81 (1959), for the slip; Harris and Kotzalas, Essential Concepts (2006), ch. 5, for
    balls that slide on both races.
    """

    bearing: AngularContactBearing
    contacts: tuple[PointContact, PointContact]  # with the inner and with the outer race
    friction: float  # [-] Coulomb coefficient
    spin: Spin = "centre"  # that makes slip across

    @property
    def simpler(self) -> PrescribedControl:
        """Outer control: what friction comes to at high speed, a hundred times as quick."""
        return PrescribedControl(self.bearing, "outer")

    @property
    def noise(self) -> float:
        """What the search for the motion of balls leaves of their friction."""
        return NOISE

    @property
    def cost(self) -> int:
        """A search for the motion of every ball, and less of all else."""
        return 20

    def kinematics(self, contacts: LoadedContacts, speeds: NDArray, centrifugal: NDArray) -> BallKinematics:
        """Motion of balls and what it asks of the races, see `RaceControl`."""
        bearing, shape = self.bearing, contacts.angles.shape[1:]
        driven, balls, ahead, outer = self._in_a_row(contacts, speeds, centrifugal)
        orbit = outer - ahead * balls.motion[:, ORBIT]
        turn = np.sign(ahead) * balls.motion[:, TURN]
        size = np.linalg.norm(balls.motion[:, AXIAL:], axis=1)
        slopes = np.einsum("nij,njk->ikn", balls.motion_slopes, driven.chain)
        across = np.einsum("ncj,njk->ckn", balls.across_slopes, driven.chain) * driven.hold[:, None]
        for race in (INNER, OUTER):
            across[race, [2 * race, 2 - 2 * race]] += driven.hold_slopes[:, race] * balls.across[:, race]
        mass = bearing.ball.mass * bearing.pitch_diameter
        kinematics = BallKinematics(
            orbit=orbit,
            spin=ahead * size,
            attitude=np.arctan2(balls.motion[:, RADIAL], 0.0 - balls.motion[:, AXIAL]),
            yaw=np.arcsin(turn / np.where(size > 0, size, 1.0)),
            centrifugal=0.5 * mass * orbit**2,
            centrifugal_slopes=-mass * orbit * ahead * slopes[ORBIT],
            gyroscopic=bearing.ball.inertia * orbit * ahead * balls.motion[:, RADIAL],
            tractions=driven.hold * balls.across.T,
            traction_slopes=across,
        )
        return BallKinematics(*(array.reshape(*array.shape[:-1], *shape) for array in kinematics))

    def heat(self, contacts: LoadedContacts, speeds: NDArray, centrifugal: NDArray) -> NDArray:
        """Heat of friction on both races (C, Z) [W]; for what is given see `RaceControl`."""
        driven, balls, ahead, _ = self._in_a_row(contacts, speeds, centrifugal)
        heat = np.abs(ahead) * (driven.hold * balls.power.T).sum(0)
        return heat.reshape(contacts.angles.shape[1:])

    def _in_a_row(
        self, contacts: LoadedContacts, speeds: NDArray, centrifugal: NDArray
    ) -> tuple[DrivenContacts, FreeBallMotion, NDArray, NDArray]:
        """Balls (N) of all cases, speed of the inner against the outer ring, speed of the outer one."""
        shape = contacts.angles.shape[1:]
        flat = LoadedContacts(*(array.reshape(2, -1) for array in contacts))
        ahead, outer, free = (
            (array + np.zeros(shape)).ravel() for array in (speeds[0] - speeds[1], speeds[1], centrifugal)
        )
        driven = self.driven(flat, free)
        return driven, self.motion(driven, ahead, outer), ahead, outer

    def driven(self, contacts: LoadedContacts, centrifugal: NDArray) -> DrivenContacts:
        """Contacts as friction sees them; `contacts` (2, N), F_c (N) [N]."""
        (inner, outer), loads, stiffness = contacts
        apart, other = inner - outer, loads[::-1]
        driving = driving_load(loads, np.reshape(RELEASED, (2, 1)) * centrifugal + UNEVEN * other)
        safe = np.where(driving.value > 0, driving.value, 1.0)
        by_own = stiffness * driving.by_load / safe
        by_other = stiffness[::-1] * UNEVEN * driving.by_width / safe
        hold_slopes = np.array([stiffness / safe - driving.hold * by_own, -driving.hold * by_other])
        chain = np.zeros((len(inner), 4, 4))
        chain[:, 0, 0], chain[:, 2, 2] = by_own
        chain[:, 0, 2], chain[:, 2, 0] = by_other
        chain[:, 1, 0], chain[:, 1, 2] = hold_slopes[:, 0] * apart
        chain[:, 1, 1], chain[:, 1, 3] = driving.hold[0], 1 - driving.hold[0]
        chain[:, 3, 3] = 1.0
        seen = np.array([outer + driving.hold[0] * apart, outer])
        return DrivenContacts(seen, driving.value, driving.hold, hold_slopes, chain)

    def motion(self, driven: DrivenContacts, ahead: NDArray, outer_speed: NDArray) -> FreeBallMotion:
        """Balance of balls (N) between rings of these speeds (N) [rad/s]; not a number where none is found.

        Balls that nothing drives roll at no slope.
        """
        count = len(ahead)
        axes = np.array([c.semi_axes(n) for c, n in zip(self.contacts, driven.loads, strict=True)])
        axes[:, 0] = np.minimum(axes[:, 0], self.widest)
        moving = (ahead != 0) & (driven.loads > 0).all(0)
        motion = FreeBallMotion(*(np.zeros((count, *size)) for size in ((4,), (4, 4), (2,), (2, 4), (2,))))
        motion.motion[:, ORBIT] = -(1 - self.bearing.diameter_ratio) / 2
        if moving.any():
            balls = free_balls(
                self._places(driven.angles[:, moving].T, axes[:, 0, moving].T),
                self._ellipses(axes[:, :, moving], driven.loads[:, moving]),
                self.bearing.ball.inertia * ahead[moving] ** 2,
                outer_speed[moving] / ahead[moving],
            )
            for array, part in zip(motion, free_ball_motion(balls), strict=True):
                array[moving] = part
        return motion

    @property
    def widest(self) -> float:
        """Semi-axis across the rolling direction that contacts do not pass on the way to a balance [m].

        In balance a wider one has no friction that this model knows.
        """
        return WIDEST * self.bearing.ball.diameter / 2

    def _ellipses(self, axes: NDArray, loads: NDArray) -> Ellipse:
        """Contacts (N, 2) of semi-axes (2, 2, N) and loads (2, N)."""
        across, along = axes[:, 0].T, axes[:, 1].T
        surfaces = self._surfaces + np.zeros_like(across)
        return Ellipse(across, along, surfaces, self.friction * loads.T, self.spin)

    def _places(self, angles: NDArray, across: NDArray) -> BallContacts:
        """Contacts at angles (N, 2) of semi-axes (N, 2)."""
        ones = np.ones(len(angles))
        radius = self.bearing.ball.diameter / 2 * ones
        height = pressed_height(radius[:, None], self._surfaces, across)
        return BallContacts(radius, self.bearing.pitch_diameter / 2 * ones, angles[:, None], height[:, None])

    @property
    def _surfaces(self) -> NDArray:
        """R of the pressed surfaces (2) [m]."""
        bearing, diameter = self.bearing, self.bearing.ball.diameter
        grooves = diameter * np.array([bearing.inner.conformity, bearing.outer.conformity])
        return pressed_radius(np.array(diameter / 2), grooves)
