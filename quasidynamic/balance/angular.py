"""Balance of balls between an outer ring at rest in space and an inner ring that moves in five directions."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.ball_place import BallPlaces, Vectors, groove_arm, turning
from quasidynamic.balance.light_ball import grip, held_traction, led_angle
from quasidynamic.contact.point import INNER, OUTER, PointContact, point_contact, race_curvatures
from quasidynamic.motion.ball_speeds import (
    BallMotion,
    Control,
    ball_motion,
    centrifugal_force,
    gyroscopic_moment,
)
from quasidynamic.parts.angular import AngularContactBearing
from quasidynamic.parts.material import contact_modulus

INNER_SHARE = {"outer": 0.0, "inner": 2.0, "equal": 1.0}  # lambda_i, part of 2 M_g/D held by the inner race


class BallBalance(NamedTuple):
    """Balls at given places; C cases, Z balls; vectors are complex numbers, axial + i radial.

    Derivatives are by a move in the axial and by one in the radial direction. Three quantities stand
    together: the force on a ball that is not balanced, the force of the inner ring on it, T_i.
    """

    forces: Vectors  # (3, C, Z) [N]
    by_ball: Vectors  # (2, 3, C, Z) [N/m] by the place of the ball
    by_groove: Vectors  # (2, 3, C, Z) [N/m] by the place of the inner groove
    angles: NDArray  # (2, C, Z) [rad] contact angles, inner then outer
    loads: NDArray  # (2, C, Z) [N] normal, inner then outer
    tractions: NDArray  # (2, C, Z) [N] along the groove sections, holding the gyroscopic moment
    motion: BallMotion
    centrifugal: NDArray  # (C, Z) [N]
    gyroscopic: NDArray  # (C, Z) [N m]

    @property
    def excess(self) -> Vectors:
        """Force on each ball that is not balanced (C, Z) [N]."""
        return self.forces[0]

    @property
    def pull(self) -> Vectors:
        """Centrifugal force and tractions on each ball (C, Z) [N]."""
        inner, outer = self.tractions * np.exp(-1j * self.angles)
        return inner - outer + 1j * self.centrifugal


class _Inertia(NamedTuple):
    """What the motion of balls asks of the races; slopes (4, C, Z) by L_i, alpha_i, L_o, alpha_o."""

    motion: BallMotion
    centrifugal: NDArray  # (C, Z) [N]
    centrifugal_slopes: NDArray
    gyroscopic: NDArray  # (C, Z) [N m]
    gyroscopic_slopes: NDArray


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

    in complex numbers, axial + i radial, with n = sin(alpha) + i cos(alpha):
    (Q_i - i T_i) n_i - (Q_o - i T_o) n_o + i F_c = 0.

    A ball that leaves the inner race rests on the outer one: as its load Q_i falls below a small
    multiple of `RELEASE` F_c, the inner contact angle in the kinematics fades out by
    h = tanh(Q_i/(RELEASE F_c)). No traction comes near its load, see `held_traction`; what the inner race
    cannot hold the outer one takes. A ball that its centrifugal force wedges between grooves far apart
    touches the inner race near its pole, where rolling alone would whirl it away: in the kinematics
    the angle between the contacts grows no more from `LED` on, smoothly, and stays below `WIDEST`.
    Grooves are half circles that go on as straight walls, see `groove_arm`.
    The ring carries T_i with its lever to the groove centre.

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
    def ring_to_groove(self) -> Vectors:
        """Place of the inner groove centre, axial + i radial, at each ball per ring displacement (Z, 5)."""
        azimuth = self.bearing.azimuths
        sine, cosine = np.sin(azimuth), np.cos(azimuth)
        return np.array([1j * cosine, 1j * sine, 1 + 0 * sine, sine, -cosine], dtype=complex).T.copy()

    def grooves(self, ring: NDArray) -> Vectors:
        """Inner groove centres from the outer ones (C, Z) [m] at ring displacements (C, 5)."""
        return self.unloaded_groove + ring @ self.ring_to_groove.T

    @cached_property
    def unloaded_groove(self) -> complex:
        """Inner groove centre from the outer one where a ball just touches both races [m]."""
        own, angle = self.bearing, self.bearing.contact_angle
        return (own.inner_reach + own.outer_reach) * complex(np.sin(angle), np.cos(angle))

    @cached_property
    def free_centrifugal(self) -> NDArray:
        """F_c of balls that lie on the outer race alone, at its bottom (C, 1) [N]."""
        own, none = self.bearing, np.zeros(())
        motion = ball_motion(none, none, own.diameter_ratio, tuple(self.speeds), self.control)
        return centrifugal_force(motion.orbit, own.ball.mass, own.pitch_diameter).value

    @cached_property
    def places(self) -> BallPlaces:
        """Where balls lie, wedge or are pressed."""
        own = self.bearing
        return BallPlaces(own.inner_reach, own.outer_reach, *self.contacts, self.free_centrifugal)

    # -- balance -------------------------------------------------------------------------------

    def balls(self, grooves: Vectors, centres: Vectors) -> BallBalance:
        """Forces on balls at `centres`, the inner groove at `grooves`, both (C, Z) [m]."""
        arms = groove_arm(np.array([grooves - centres, centres]))
        lengths = np.abs(arms)
        normals = arms / lengths
        angles = np.arctan2(normals.real, normals.imag)
        loads, stiffness = self.pressed(lengths)
        inertia = self._inertia(angles, loads, stiffness[0])
        tractions, held = self._tractions(inertia, loads, stiffness)
        turns = -1j * normals  # along the groove sections
        pushes = loads - 1j * tractions
        on_inner = pushes[0] * normals[0]
        excess = on_inner - pushes[1] * normals[1] + 1j * inertia.centrifugal
        slopes = np.empty((4, 3, *excess.shape), complex)  # by L_i, alpha_i, L_o, alpha_o
        slopes[:, 1] = held[0] * turns[0]
        slopes[0, 1] += stiffness[0] * normals[0]
        slopes[1, 1] += pushes[0] * turns[0]
        slopes[:, 2] = held[0]
        slopes[:, 0] = slopes[:, 1] - held[1] * turns[1] + 1j * inertia.centrifugal_slopes
        slopes[2, 0] -= stiffness[1] * normals[1]
        slopes[3, 0] -= pushes[1] * turns[1]
        by_groove = _by_place(slopes[:2], arms[0], lengths[0])
        return BallBalance(
            forces=np.array([excess, on_inner, tractions[0]]),
            by_ball=_by_place(slopes[2:], arms[1], lengths[1]) - by_groove,
            by_groove=by_groove,
            angles=angles,
            loads=loads,
            tractions=tractions,
            motion=inertia.motion,
            centrifugal=inertia.centrifugal,
            gyroscopic=inertia.gyroscopic,
        )

    def _inertia(self, angles: NDArray, loads: NDArray, stiffness: NDArray) -> "_Inertia":
        """Motion of the balls and what it asks of the races."""
        own = self.bearing
        hold, hold_slope = grip(loads[0], stiffness, self.free_centrifugal)
        apart, slope = led_angle(angles[0] - angles[1])
        rolling, by_length, by_angle = angles[1] + hold * apart, hold_slope * apart, hold * slope
        motion = ball_motion(rolling, angles[1], own.diameter_ratio, tuple(self.speeds), self.control)
        force = centrifugal_force(motion.orbit, own.ball.mass, own.pitch_diameter)
        moment = gyroscopic_moment(motion, own.ball.inertia)
        both = np.array([force.slopes, moment.slopes]).swapaxes(0, 1)
        by_inner = both[0] * by_angle
        slopes = np.array([both[0] * by_length, by_inner, 0.0 * by_inner, both[1] + both[0] - by_inner])
        return _Inertia(motion, force.value, slopes[:, 0], moment.value, slopes[:, 1])

    def _tractions(self, inertia: "_Inertia", loads: NDArray, stiffness: NDArray) -> tuple[NDArray, NDArray]:
        """T_i, T_o (2, C, Z) [N] and their slopes (2, 4, C, Z) by L_i, alpha_i, L_o, alpha_o."""
        diameter, share = self.bearing.ball.diameter, INNER_SHARE[self.control]
        wanted, slopes = inertia.gyroscopic / diameter, inertia.gyroscopic_slopes / diameter
        inner, held = 0.0 * wanted, 0.0 * slopes
        if share:
            inner, by_wanted, by_load = held_traction(share * wanted, loads[0])
            held = by_wanted * share * slopes
            held[0] += by_load * stiffness[0]
        outer, by_wanted, by_load = held_traction(2 * wanted - inner, loads[1])
        rest = by_wanted * (2 * slopes - held)
        rest[2] += by_load * stiffness[1]
        return np.array([inner, outer]), np.array([held, rest])

    def pressed(self, lengths: NDArray) -> tuple[NDArray, NDArray]:
        """Loads and stiffnesses (2, C, Z) of the contacts from the lengths between the centres."""
        own, (inner, outer) = self.bearing, self.contacts
        reach = np.array([own.inner_reach, own.outer_reach])[:, None, None]
        both = np.array([inner.coefficient, outer.coefficient])[:, None, None]
        approach = np.maximum(lengths - reach, 0.0)
        grown = both * np.sqrt(approach)
        return grown * approach, 1.5 * grown

    def ring(self, balls: BallBalance, follow: Vectors) -> RingBalance:
        """Balance of the inner ring; `follow` (2, C, Z) is the move of a ball per move of its groove."""
        _, force, traction = balls.forces
        carried = self.on_ring(force, traction)
        along, aside = balls.by_groove + moved(balls.by_ball[:, None], follow[:, None])
        by_ring = along[1:, ..., None] * self.ring_to_groove.real
        by_ring += aside[1:, ..., None] * self.ring_to_groove.imag
        stiffness = (self.ring_to_groove.conj().T @ by_ring[0] - self.ring_to_lever.T @ by_ring[1]).real
        return RingBalance(np.where(self.held, 0.0, self.load - carried), stiffness, carried)

    def on_ring(self, force: Vectors, traction: NDArray) -> NDArray:
        """Load (C, 5) [N] that forces and tractions of the inner ring on the balls (C, Z) take up."""
        return (force @ self.ring_to_groove.conj() - traction @ self.ring_to_lever).real

    def dragged(self, balls: BallBalance) -> NDArray:
        """Load (C, 5) [N] that the tractions of the inner race take up."""
        traction = balls.tractions[0]
        return self.on_ring(traction * np.exp(-1j * balls.angles[0]), traction)

    @cached_property
    def ring_to_lever(self) -> NDArray:
        """Move of the inner contacts against the balls by the tilt of the section (Z, 5)."""
        own = self.bearing
        lever = own.inner.conformity * own.ball.diameter / own.inner_groove_radius
        return lever * self.ring_to_groove.real * [0.0, 0.0, 0.0, 1.0, 1.0]


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


def moved(by_place: Vectors, move: Vectors) -> Vectors:
    """Change of quantities with derivatives (2, ...) under a complex move."""
    return by_place[0] * move.real + by_place[1] * move.imag


def _by_place(slopes: Vectors, arm: Vectors, length: NDArray) -> Vectors:
    """Derivatives by an axial and by a radial move from slopes by the length and by the contact angle."""
    (by_length, by_angle), sine, cosine = slopes, arm.real / length, arm.imag / length
    turned = by_angle * (turning(arm) / length)
    return np.array([by_length * sine + turned * cosine, by_length * cosine - turned * sine])
