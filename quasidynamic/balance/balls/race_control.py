"""What races make balls do, by an assumption on which race controls their spin."""

from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.light_ball import grip, held_traction, limited_angle
from quasidynamic.motion.ball_speeds import Control, ball_motion, centrifugal_force, gyroscopic_moment
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing

INNER_SHARE = {"outer": 0.0, "inner": 2.0, "equal": 1.0}  # lambda_i, part of 2 M_g/D held by the inner race


class LoadedContacts(NamedTuple):
    """Contacts of balls with the inner and with the outer race (2, C, Z); C cases, Z balls."""

    angles: NDArray  # [rad] contact angles
    loads: NDArray  # [N] normal, >= 0
    stiffness: NDArray  # [N/m] of the loads by the distances L_i, L_o of ball and groove centres


class BallKinematics(NamedTuple):
    """Motion of balls and what it asks of the races; slopes (4, C, Z) by L_i, alpha_i, L_o, alpha_o."""

    orbit: NDArray  # (C, Z) [rad/s]
    spin: NDArray  # (C, Z) [rad/s] in the orbiting frame
    attitude: NDArray  # (C, Z) [rad] of the spin axis to the shaft, in the plane of the section
    yaw: NDArray  # (C, Z) [rad] of the spin axis out of that plane
    centrifugal: NDArray  # (C, Z) [N]
    centrifugal_slopes: NDArray  # (4, C, Z)
    gyroscopic: NDArray  # (C, Z) [N m] about the rolling direction
    tractions: NDArray  # (2, C, Z) [N] along the groove sections
    traction_slopes: NDArray  # (2, 4, C, Z)
    near: NDArray  # (C, Z, k) where a search nearby begins; k = 0 where motion has a closed form, else 5


class RaceControl(Protocol):
    """How motion and tractions of balls follow from their contacts."""

    @property
    def simpler(self) -> "RaceControl | None":
        """A race control that costs less and balances ring and balls near the same place, to begin there."""
        ...

    @property
    def noise(self) -> float:
        """Part of the largest force by which its forces are uncertain, beyond rounding of places [-]."""
        ...

    @property
    def cost(self) -> int:
        """Time of an evaluation over that of closed forms, roughly."""
        ...

    @property
    def rolling_alone(self) -> bool:
        """Whether a ball on the outer race alone lies where its rolling has a closed form, or nearly."""
        ...

    def kinematics(
        self, contacts: LoadedContacts, speeds: NDArray, centrifugal: NDArray, near: NDArray | None = None
    ) -> BallKinematics:
        """Motion of balls and what it asks of the races; of several motions that are balanced one `near`."""
        ...


@dataclass(frozen=True)
class PrescribedControl:
    r"""Balls roll on both races; one of these, or both alike, control the attitude of their spin.

    .. math:: T_i = \lambda_i M_g / D,\quad T_o = \lambda_o M_g / D,\quad \lambda_i + \lambda_o = 2

    A ball that leaves the inner race rests on the outer one: as its load Q_i falls below a small
    multiple of `light_ball.RELEASE` F_c, the inner contact angle in the kinematics fades out by
    h = tanh(Q_i/(RELEASE F_c)). No traction comes near its load, see `held_traction`; what the inner race
    cannot hold the outer one takes. A ball that its centrifugal force wedges between grooves far apart
    touches the inner race near its pole, where rolling alone would whirl it away: in the kinematics
    the angle between the contacts grows less from `FULL_ANGLE` on and stays below `LARGEST_ANGLE`.

    Source
    ------
    Jones, J. Basic Eng. 81 (1959); Harris, Rolling Bearing Analysis, 4th ed. (2001), ch. 8 and 9, with the
    signs of a positive ball speed.
    """

    bearing: AngularContactBearing
    control: Control

    @property
    def simpler(self) -> None:
        """None: nothing costs less."""
        return None

    @property
    def noise(self) -> float:
        """Zero: closed forms."""
        return 0.0

    @property
    def cost(self) -> int:
        """One: closed forms."""
        return 1

    @property
    def rolling_alone(self) -> bool:
        """True: it rolls."""
        return True

    def kinematics(
        self, contacts: LoadedContacts, speeds: NDArray, centrifugal: NDArray, near: NDArray | None = None
    ) -> BallKinematics:
        """Motion of balls and what it asks of the races, see `RaceControl`."""
        bearing, (inner, outer) = self.bearing, contacts.angles
        hold, hold_slope = grip(contacts.loads[0], contacts.stiffness[0], centrifugal)
        apart, slope = limited_angle(inner - outer)
        seen = np.array([outer + hold * apart, outer])
        motion = ball_motion(seen, bearing.diameter_ratio, tuple(speeds), self.control)
        force = centrifugal_force(motion.orbit, bearing.ball.mass, bearing.pitch_diameter)
        moment = gyroscopic_moment(motion, bearing.ball.inertia)
        by_seen = np.array([force.slopes, moment.slopes])  # (2, 2, C, Z)
        slopes = np.zeros((2, 4, *inner.shape))
        slopes[:, 0] = by_seen[:, 0] * (hold_slope * apart)
        slopes[:, 1] = by_seen[:, 0] * (hold * slope)
        slopes[:, 3] = by_seen[:, 0] + by_seen[:, 1] - slopes[:, 1]
        tractions, held = self._tractions(moment.value, slopes[1], contacts)
        return BallKinematics(
            orbit=motion.orbit.value,
            spin=motion.spin.value,
            attitude=motion.attitude.value,
            yaw=np.zeros_like(inner),
            centrifugal=force.value,
            centrifugal_slopes=slopes[0],
            gyroscopic=moment.value,
            tractions=tractions,
            traction_slopes=held,
            near=np.zeros((*inner.shape, 0)),
        )

    def _tractions(
        self, moment: NDArray, slopes: NDArray, contacts: LoadedContacts
    ) -> tuple[NDArray, NDArray]:
        """T_i, T_o (2, C, Z) [N] and their slopes (2, 4, C, Z)."""
        needed, slopes = (2 / self.bearing.ball.diameter) * moment, (2 / self.bearing.ball.diameter) * slopes
        share, (loads, stiffness) = 0.5 * INNER_SHARE[self.control], contacts[1:]
        tractions, held = np.zeros((2, *moment.shape)), np.zeros((2, *slopes.shape))
        if share:
            tractions[0], by_needed, by_load = held_traction(share * needed, loads[0])
            held[0] = by_needed * share * slopes
            held[0, 0] += by_load * stiffness[0]
        tractions[1], by_needed, by_load = held_traction(needed - tractions[0], loads[1])
        held[1] = by_needed * (slopes - held[0])
        held[1, 2] += by_load * stiffness[1]
        return tractions, held
