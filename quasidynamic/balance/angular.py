"""Balance of balls between an outer ring at rest in space and an inner ring that moves in five directions."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.point import INNER, OUTER, PointContact, in_series, point_contact, race_curvatures
from quasidynamic.motion.ball_speeds import (
    BallMotion,
    Control,
    Rated,
    ball_motion,
    centrifugal_force,
    gyroscopic_moment,
)
from quasidynamic.parts.angular import AngularContactBearing
from quasidynamic.parts.material import contact_modulus

RELEASE = 0.2  # of the nominal centrifugal force: inner load over which a ball is let go by the inner race
FLATTEST_WEDGE = 0.1  # [-] sine of the angle between the contacts in a first guess of their loads
LEAST_RELEASE = 1e-100  # [N] the same at rest, where it no longer matters
INNER_SHARE = {"outer": 0.0, "inner": 2.0, "equal": 1.0}  # lambda_i, part of 2 M_g/D held by the inner race


class BallBalance(NamedTuple):
    """Balls at given places; C cases, Z balls, components axial and radial."""

    excess: NDArray  # (C, Z, 2) [N] force on each ball that is not balanced
    by_ball: NDArray  # (C, Z, 2, 2) [N/m] its derivative by the place of the ball
    by_groove: NDArray  # (C, Z, 2, 2) [N/m] its derivative by the place of the inner groove
    ring_on_ball: NDArray  # (C, Z, 3) [N] axial, radial, moment about the ring centre over R_i
    ring_by_ball: NDArray  # (C, Z, 3, 2) [N/m]
    ring_by_groove: NDArray  # (C, Z, 3, 2) [N/m]
    angles: NDArray  # (2, C, Z) [rad] contact angles, inner then outer
    loads: NDArray  # (2, C, Z) [N] normal, inner then outer
    tractions: NDArray  # (2, C, Z) [N] along the groove sections, holding the gyroscopic moment
    motion: BallMotion
    centrifugal: NDArray  # (C, Z) [N]
    gyroscopic: NDArray  # (C, Z) [N m]


class RingBalance(NamedTuple):
    """Forces on the inner ring, rotations and moments scaled by R_i."""

    excess: NDArray  # (C, 5) [N] what the balls do not carry; zero where the ring is held
    stiffness: NDArray  # (C, 5, 5) [N/m] force that the balls take up per displacement, balls in balance
    carried: NDArray  # (C, 5) [N] force that the balls take up


@dataclass(frozen=True)
class AngularBalance:
    r"""Equations of an angular-contact bearing under quasi-static loads.

    .. math:: Q_i \sin\alpha_i - Q_o \sin\alpha_o + T_i \cos\alpha_i - T_o \cos\alpha_o &= 0 \\
              Q_i \cos\alpha_i - Q_o \cos\alpha_o - T_i \sin\alpha_i + T_o \sin\alpha_o + F_c &= 0 \\
              T_i = \lambda_i M_g / D,\quad T_o = \lambda_o M_g / D,\quad \lambda_i + \lambda_o &= 2

    A ball that leaves the inner race rests on the outer one: as its load Q_i falls below a small
    multiple of `RELEASE` F_c, the traction T_i and the inner contact angle in the kinematics fade out
    by h = tanh(Q_i/(RELEASE F_c)). The ring carries T_i with its lever to the groove centre.

    Source
    ------
    Harris, Rolling Bearing Analysis, 4th ed. (2001), ch. 9, with the signs of a positive ball speed;
    de Mul, Vree and Maas, J. Tribol. 111 (1989) for the five directions.
    """

    bearing: AngularContactBearing
    contacts: tuple[PointContact, PointContact]  # with the inner and with the outer race
    control: Control
    load: NDArray  # (C, 5) [N] moments over R_i
    held: NDArray  # (C, 5) bool, where the displacement is given
    place: NDArray  # (C, 5) [m] the given displacements, rotations times R_i
    speeds: NDArray  # (2, C, 1) [rad/s] inner, outer ring
    inertia: float = 1.0  # part of the centrifugal force and the gyroscopic moment that acts

    def take(self, cases: NDArray) -> "AngularBalance":
        """Return the same equations for some of the cases."""
        return replace(
            self,
            load=self.load[cases],
            held=self.held[cases],
            place=self.place[cases],
            speeds=self.speeds[:, cases],
        )

    # -- geometry ------------------------------------------------------------------------------

    @cached_property
    def ring_to_groove(self) -> NDArray:
        """Place of the inner groove centre (axial, radial) at each ball per ring displacement (Z, 2, 5)."""
        azimuth = self.bearing.azimuths
        sine, cosine, none = np.sin(azimuth), np.cos(azimuth), np.zeros_like(azimuth)
        axial = [none, none, none + 1, sine, -cosine]
        return np.array([axial, [cosine, sine, none, none, none]]).transpose(2, 0, 1)

    @cached_property
    def ball_to_ring(self) -> NDArray:
        """Force on the ring in its five directions per (axial, radial, moment over R_i) (Z, 5, 3)."""
        matrix = np.zeros((self.bearing.balls, 5, 3))
        matrix[:, :3, :2] = self.ring_to_groove[:, :, :3].transpose(0, 2, 1)
        matrix[:, 3:, 2] = self.ring_to_groove[:, 0, 3:]
        return matrix

    def grooves(self, ring: NDArray) -> NDArray:
        """Inner groove centres from the outer ones (C, Z, 2) [m] at ring displacements (C, 5)."""
        own = self.bearing
        distance = own.inner_reach + own.outer_reach
        unloaded = distance * np.array([np.sin(own.contact_angle), np.cos(own.contact_angle)])
        return unloaded + (self.ring_to_groove @ ring[:, None, :, None])[..., 0]

    @cached_property
    def free_centrifugal(self) -> NDArray:
        """F_c of balls that lie on the outer race alone, at its bottom (C, 1) [N]."""
        own, none = self.bearing, np.zeros(())
        motion = ball_motion(none, none, own.diameter_ratio, tuple(self.speeds), self.control)
        return self.inertia * centrifugal_force(motion.orbit, own.ball.mass, own.pitch_diameter).value

    def lying(self, grooves: NDArray) -> tuple[NDArray, NDArray]:
        """Centres (C, Z, 2) [m] of balls at the bottom of the outer race, and which ones (C, Z) stay there.

        They stay, in balance, where the inner race leaves them alone.
        """
        centres = np.zeros_like(grooves)
        centres[..., 1] = self.bearing.outer_reach + self.contacts[1].approach(self.free_centrifugal)
        off = ((grooves - centres) ** 2).sum(-1) <= self.bearing.inner_reach**2
        return centres, off & (self.free_centrifugal > 0)

    def resting(self, grooves: NDArray) -> NDArray:
        """Ball centres (C, Z, 2) [m] in balance but for the gyroscopic moment or for the centrifugal force.

        A ball lies on the outer race, is wedged between the races by the centrifugal force, or pressed on
        the line of the groove centres where that prevails.
        """
        lying, free = self.lying(grooves)
        apart = np.sqrt((grooves**2).sum(-1))
        approach = np.maximum(apart - self.bearing.inner_reach - self.bearing.outer_reach, 0.0)
        pressed = in_series(*self.contacts) * approach**1.5 >= self.free_centrifugal
        centres = self._pressed(grooves, apart)
        if not pressed.all():
            centres = np.where(pressed[..., None], centres, self._wedged(grooves, apart))
        return np.where(free[..., None], lying, centres)

    def _pressed(self, grooves: NDArray, apart: NDArray) -> NDArray:
        """Centres on the line of the groove centres, the approach shared as equal loads ask."""
        own, (inner, outer) = self.bearing, self.contacts
        gap = apart - own.inner_reach - own.outer_reach
        soft = (inner.coefficient / outer.coefficient) ** (2 / 3)
        share = np.where(gap > 0, soft / (1 + soft), own.outer_reach / (own.inner_reach + own.outer_reach))
        return grooves * ((own.outer_reach + share * gap) / apart)[..., None]

    def _wedged(self, grooves: NDArray, apart: NDArray) -> NDArray:
        """Centres where both races touch the ball and hold its centrifugal force without friction."""
        own, (inner, outer) = self.bearing, self.contacts
        to_inner = np.full(apart.shape, own.inner_reach)
        to_outer = np.full(apart.shape, own.outer_reach)
        along = grooves / apart[..., None]
        side = np.where(along[..., 0] < 0, -1.0, 1.0)
        across = np.stack([-along[..., 1] * side, np.abs(along[..., 0])], axis=-1)
        for _ in range(2):  # touching, then pressed by the loads of that place
            foot = (apart**2 + to_outer**2 - to_inner**2) / (2 * apart)
            height = np.sqrt(np.maximum(to_outer**2 - foot**2, 0.0))
            centres = foot[..., None] * along + height[..., None] * across
            angle_o = np.arctan2(centres[..., 0], centres[..., 1])
            angle_i = np.arctan2(*np.moveaxis(grooves - centres, -1, 0))
            wedge = np.maximum(np.abs(np.sin(angle_i - angle_o)), FLATTEST_WEDGE)
            force = self.free_centrifugal / wedge
            to_inner = own.inner_reach + inner.approach(force * np.abs(np.sin(angle_o)))
            to_outer = own.outer_reach + outer.approach(force * np.abs(np.sin(angle_i)))
        return centres

    # -- balance -------------------------------------------------------------------------------

    def balls(self, grooves: NDArray, centres: NDArray) -> BallBalance:
        """Forces on balls at `centres`, the inner groove at `grooves`, both (C, Z, 2) [m]."""
        own, (inner, outer) = self.bearing, self.contacts
        arm_i, length_i, angle_i, frame_i = _direction(grooves - centres)
        arm_o, length_o, angle_o, frame_o = _direction(centres)
        load_i, load_o = inner.load(length_i - own.inner_reach), outer.load(length_o - own.outer_reach)
        stiff_i = inner.stiffness(length_i - own.inner_reach)
        stiff_o = outer.stiffness(length_o - own.outer_reach)

        width = np.maximum(RELEASE * self.free_centrifugal, LEAST_RELEASE)
        gripped = np.tanh(load_i / width)  # h
        grip_slope = (1 - gripped**2) / width * stiff_i
        rolling = angle_o + gripped * (angle_i - angle_o)
        motion = ball_motion(rolling, angle_o, own.diameter_ratio, tuple(self.speeds), self.control)
        rolling_slopes = grip_slope * (angle_i - angle_o), gripped  # by L_i, alpha_i
        centrifugal, centrifugal_slopes = _chained(
            centrifugal_force(motion.orbit, own.ball.mass, own.pitch_diameter), rolling_slopes, self.inertia
        )
        gyroscopic, gyroscopic_slopes = _chained(
            gyroscopic_moment(motion, own.ball.inertia), rolling_slopes, self.inertia
        )

        whole, whole_slopes = gyroscopic / own.ball.diameter, gyroscopic_slopes / own.ball.diameter
        share = INNER_SHARE[self.control]
        traction_i, slopes_i = _held_back(share * whole, share * whole_slopes, load_i, stiff_i)
        traction_o, slopes_o = 2 * whole - traction_i, 2 * whole_slopes - slopes_i

        on_i, on_i_slopes = _contact_force(frame_i, (load_i, stiff_i, traction_i, slopes_i), 0)
        on_o, on_o_slopes = _contact_force(frame_o, (load_o, stiff_o, traction_o, slopes_o), 2)
        excess, excess_slopes = on_i - on_o, on_i_slopes - on_o_slopes
        excess[..., 1] += centrifugal
        excess_slopes[..., 1, :] += centrifugal_slopes
        lever = own.inner.conformity * own.ball.diameter / own.inner_groove_radius
        moment = on_i[..., :1] - lever * traction_i[..., None]
        moment_slopes = on_i_slopes[..., :1, :] - lever * slopes_i[..., None, :]
        ring, ring_slopes = (
            np.concatenate([on_i, moment], axis=-1),
            np.concatenate([on_i_slopes, moment_slopes], axis=-2),
        )
        by_groove, by_outer = arm_i, arm_o  # of lengths and angles
        return BallBalance(
            excess=excess,
            by_ball=excess_slopes[..., 2:] @ by_outer - excess_slopes[..., :2] @ by_groove,
            by_groove=excess_slopes[..., :2] @ by_groove,
            ring_on_ball=ring,
            ring_by_ball=ring_slopes[..., 2:] @ by_outer - ring_slopes[..., :2] @ by_groove,
            ring_by_groove=ring_slopes[..., :2] @ by_groove,
            angles=np.stack([angle_i, angle_o]),
            loads=np.stack([load_i, load_o]),
            tractions=np.stack([traction_i, traction_o]),
            motion=motion,
            centrifugal=centrifugal,
            gyroscopic=gyroscopic,
        )

    def ring(self, balls: BallBalance, follow: NDArray) -> RingBalance:
        """Balance of the inner ring; `follow` is the place of a ball per place of its groove (C, Z, 2, 2)."""
        carried = (self.ball_to_ring @ balls.ring_on_ball[..., None])[..., 0].sum(1)
        per_ball = balls.ring_by_groove + balls.ring_by_ball @ follow
        stiffness = (self.ball_to_ring @ per_ball @ self.ring_to_groove).sum(1)
        return RingBalance(np.where(self.held, 0.0, self.load - carried), stiffness, carried)


def race_contacts(bearing: AngularContactBearing) -> tuple[PointContact, PointContact]:
    """Hertz contacts with the inner and with the outer race, at the unloaded contact angle."""
    own = bearing
    inner, outer = (
        point_contact(
            race_curvatures(
                own.ball.diameter,
                groove.conformity * own.ball.diameter,
                own.pitch_diameter,
                own.contact_angle,
                side,
            ),
            contact_modulus(own.ball.material, groove.material),
        )
        for groove, side in ((own.inner, INNER), (own.outer, OUTER))
    )
    return inner, outer


def _direction(arm: NDArray) -> tuple[NDArray, NDArray, NDArray, NDArray]:
    """Derivatives of length and angle, length, angle, and frame with columns n, t; matrices (..., 2, 2)."""
    axial, radial = arm[..., 0], arm[..., 1]
    length = np.sqrt(axial * axial + radial * radial)
    frame = np.empty((*length.shape, 2, 2))  # symmetric
    frame[..., 0, 0], frame[..., 0, 1] = axial / length, radial / length
    frame[..., 1, 0], frame[..., 1, 1] = frame[..., 0, 1], -frame[..., 0, 0]
    slopes = frame.copy()
    slopes[..., 1, :] /= length[..., None]
    return slopes, length, np.arctan2(axial, radial), frame


def _chained(rated: Rated, rolling: tuple[NDArray, NDArray], factor: float) -> tuple[NDArray, NDArray]:
    """Value (...) and slopes (..., 4) by L_i, alpha_i, L_o, alpha_o of a quantity of the kinematic angles."""
    by_length, by_angle = rolling
    by_rolling, by_outer = factor * rated.slopes
    slopes = np.zeros((*np.shape(rated.value), 4))
    slopes[..., 0], slopes[..., 1] = by_rolling * by_length, by_rolling * by_angle
    slopes[..., 3] = by_outer + by_rolling * (1 - by_angle)
    return factor * rated.value, slopes


def _held_back(
    wanted: NDArray, slopes: NDArray, load: NDArray, stiffness: NDArray
) -> tuple[NDArray, NDArray]:
    """Traction P tanh(Q/|P|), which never exceeds the load Q, for a wanted P; and its slopes."""
    ratio = load / np.maximum(np.abs(wanted), LEAST_RELEASE)
    part = np.tanh(ratio)
    growth = 1 - part**2
    held = (part - np.where(growth > 0, ratio, 0.0) * growth)[..., None] * slopes
    held[..., 0] += np.sign(wanted) * growth * stiffness
    return wanted * part, held


def _contact_force(
    frame: NDArray, local: tuple[NDArray, NDArray, NDArray, NDArray], place: int
) -> tuple[NDArray, NDArray]:
    """Q n + T t and its slopes by L_i, alpha_i, L_o, alpha_o; `place` is that of the contact's own length."""
    load, stiffness, traction, slopes = local
    rows = np.zeros((*load.shape, 2, 4))
    rows[..., 0, place], rows[..., 0, place + 1] = stiffness, -traction
    rows[..., 1, :] = slopes
    rows[..., 1, place + 1] += load
    force = load[..., None] * frame[..., 0] + traction[..., None] * frame[..., 1]
    return force, frame @ rows
