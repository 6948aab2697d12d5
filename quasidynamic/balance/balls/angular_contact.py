"""Balance of balls between an outer ring at rest in space and an inner ring that moves in five directions."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.ball_position import BallPlaces, Vectors, groove_arm, turning
from quasidynamic.balance.balls.ending_races import CutContacts, EndingRaces
from quasidynamic.balance.balls.race_control import BallKinematics, LoadedContacts, RaceControl
from quasidynamic.contact.ellipse.point_contact import (
    INNER,
    OUTER,
    Curvatures,
    PointContact,
    point_contact,
    race_curvatures,
)
from quasidynamic.contact.lubricated_ellipse import LubricatedRaces
from quasidynamic.contact.lubrication import BallLubrication
from quasidynamic.motion.roller_speeds import rolling_cage_speed
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing
from quasidynamic.parts.material import contact_modulus


class BallBalance(NamedTuple):
    """Balls at given places; C cases, Z balls; vectors are complex numbers, axial + i radial.

    Derivatives are by a move in the axial and by one in the radial direction. Three quantities stand
    together: the force on a ball that is not balanced, the force of the inner ring on it, T_i.
    """

    forces: Vectors  # (3, C, Z) [N]
    by_ball: Vectors  # (2, 3, C, Z) [N/m] by the place of the ball
    by_groove: Vectors  # (2, 3, C, Z) [N/m] by the place of the inner groove
    contacts: LoadedContacts
    kinematics: BallKinematics
    cut: CutContacts | None = None  # None: contacts are whole

    @property
    def excess(self) -> Vectors:
        """Force on each ball that is not balanced (C, Z) [N]."""
        return self.forces[0]

    @property
    def pull(self) -> Vectors:
        """Centrifugal force and tractions on each ball (C, Z) [N]."""
        inner, outer = self.kinematics.tractions * np.exp(-1j * self.contacts.angles)
        return inner - outer + 1j * self.kinematics.centrifugal

    @property
    def loads(self) -> NDArray:
        """Normal loads (2, C, Z) [N], inner then outer."""
        return self.contacts.loads


class RingBalance(NamedTuple):
    """Forces on the inner ring, rotations and moments scaled by R_i."""

    excess: NDArray  # (C, 5) [N] what the balls do not carry; zero where the ring is held
    stiffness: NDArray  # (C, 5, 5) [N/m] force that the balls take up per displacement, balls in balance
    carried: NDArray  # (C, 5) [N] force that the balls take up


@dataclass(frozen=True)
class AngularBalance:
    r"""Equations of an angular-contact bearing under quasi-static loads.

    .. math:: Q_i \sin\alpha_i - Q_o \sin\alpha_o + T_i \cos\alpha_i - T_o \cos\alpha_o &= 0 \\
              Q_i \cos\alpha_i - Q_o \cos\alpha_o - T_i \sin\alpha_i + T_o \sin\alpha_o + F_c &= 0

    in complex numbers, axial + i radial, with n = sin(alpha) + i cos(alpha):
    (Q_i - i T_i) n_i - (Q_o - i T_o) n_o + i F_c = 0. The race control says what F_c, T_i and T_o are.

    Grooves are half circles that go on as straight walls, see `groove_arm`; where races end on shoulders,
    S of `EndingRaces` is added to T in the forces, but not to its lever.
    The ring carries T_i with its lever to the groove centre.

    Source
    ------
    Harris, Rolling Bearing Analysis, 4th ed. (2001), ch. 9, with the signs of a positive ball speed;
    de Mul, Vree and Maas, J. Tribol. 111 (1989) for the five directions.
    """

    bearing: AngularContactBearing
    contacts: tuple[PointContact, PointContact]  # with the inner and with the outer race
    control: RaceControl
    load: NDArray  # (C, 5) [N] moments over R_i
    held: NDArray  # (C, 5) bool, where the displacement is given
    place: NDArray  # (C, 5) [m] the given displacements, rotations times R_i
    speeds: NDArray  # (2, C, 1) [rad/s] inner, outer ring
    races: EndingRaces | None = None  # whose shoulders cut contacts off; None: all are whole

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
        """Place of the inner groove centre, axial + i radial, at each ball per ring displacement (Z, 5).

        Axial is towards the shoulder of the row: along -x where it is mirrored. A tilt moves rows beside its
        centre radially.
        """
        bearing = self.bearing
        sine, cosine = np.sin(bearing.azimuths), np.cos(bearing.azimuths)
        axial = bearing.along_x
        tilt = axial - 1j * bearing.of_balls("axial") / bearing.inner_groove_radius
        return np.array([axial, 1j * sine, 1j * cosine, tilt * cosine, -tilt * sine], dtype=complex).T.copy()

    def grooves(self, ring: NDArray) -> Vectors:
        """Inner groove centres from the outer ones (C, Z) [m] at ring displacements (C, 5)."""
        return self.unloaded_groove + ring @ self.ring_to_groove.T

    @cached_property
    def unloaded_groove(self) -> Vectors:
        """Inner groove centres from the outer ones where the ring is not displaced (Z)."""
        approaches = np.array(self.bearing.approaches or 0.0)
        return complex(*self.bearing.groove_offset) + self.bearing.of_balls("closer") + 1j * approaches

    def out_of_round(self, part: float) -> "AngularBalance":
        """The same with a part of what makes raceways approach the balls."""
        approaches = tuple(part * each for each in self.bearing.approaches) if part else ()
        return replace(self, bearing=replace(self.bearing, approaches=approaches))

    @cached_property
    def free_centrifugal(self) -> NDArray:
        """F_c of balls that lie on the outer race alone, at its bottom (C, 1) [N]."""
        bearing = self.bearing
        orbit = rolling_cage_speed(self.speeds[0], self.speeds[1], bearing.diameter_ratio)
        return 0.5 * bearing.ball.mass * bearing.pitch_diameter * orbit**2

    @cached_property
    def pulled(self) -> NDArray:
        """Whether centrifugal forces act (C, 1)."""
        return self.free_centrifugal > 0

    @cached_property
    def both_free(self) -> NDArray:
        """Pairs of directions in which the ring is free (C, 5, 5)."""
        return ~(self.held[:, :, None] | self.held[:, None, :])

    @cached_property
    def largest_load(self) -> NDArray:
        """Largest load on the ring (C) [N]."""
        return np.abs(self.load).max(1)

    @cached_property
    def places(self) -> BallPlaces:
        """Where balls lie, wedge or are pressed."""
        bearing = self.bearing
        return BallPlaces(bearing.inner_reach, bearing.outer_reach, *self.contacts, self.free_centrifugal)

    # -- balance -------------------------------------------------------------------------------

    def balls(self, grooves: Vectors, centres: Vectors, near: NDArray | None = None) -> BallBalance:
        """Forces on balls at `centres`, the inner groove at `grooves`, both (C, Z) [m].

        For `near` see `RaceControl`.
        """
        arms = groove_arm(np.array([grooves - centres, centres]))
        lengths = np.abs(arms)
        normals = arms / lengths
        angles, pressed = np.arctan2(normals.real, normals.imag), self.pressed(lengths)
        cut = (
            None
            if self.races is None
            else self.races.forces(pressed, self._approach(lengths), angles, lengths)
        )
        contacts = LoadedContacts(angles, *(pressed if cut is None else (cut.loads, cut.stiffness)))
        kinematics = self.control.kinematics(contacts, self.speeds, self.free_centrifugal, near)
        if cut is not None:
            kinematics = _by_all_angles(kinematics, contacts, cut)
        tractions, held = kinematics.tractions, kinematics.traction_slopes
        turns = -1j * normals  # along the groove sections
        pushes = contacts.loads - 1j * (tractions if cut is None else tractions + cut.aside)
        forces = np.empty((3, *grooves.shape), complex)
        on_inner, on_outer = pushes * normals
        forces[0] = on_inner - on_outer + 1j * kinematics.centrifugal
        forces[1], forces[2] = on_inner, tractions[0]
        slopes = np.empty((4, *forces.shape), complex)  # by L_i, alpha_i, L_o, alpha_o
        stiffer, turned = contacts.stiffness * normals, pushes * turns
        if cut is not None:
            stiffer += cut.aside_stiffness * turns
            turned += cut.by_angle * normals + cut.aside_by_angle * turns
        inner, outer = held * turns[:, None]
        inner[0] += stiffer[0]
        inner[1] += turned[0]
        outer[2] += stiffer[1]
        outer[3] += turned[1]
        slopes[:, 0] = inner - outer + 1j * kinematics.centrifugal_slopes
        slopes[:, 1], slopes[:, 2] = inner, held[0]
        by_inner, by_outer = _by_place(slopes.reshape(2, 2, *forces.shape), normals, turning(arms) / lengths)
        return BallBalance(forces, by_outer - by_inner, by_inner, contacts, kinematics, cut)

    def centrifugal_by_place(self, balls: BallBalance, grooves: Vectors, centres: Vectors) -> NDArray:
        """Derivatives of F_c by the places of the inner groove and of the ball (2, 2, C, Z) [N/m]."""
        arms = groove_arm(np.array([grooves - centres, centres]))
        lengths = np.abs(arms)
        slopes = balls.kinematics.centrifugal_slopes.reshape(2, 2, 1, *grooves.shape)
        by_inner, by_outer = _by_place(slopes, arms / lengths, turning(arms) / lengths)[:, :, 0]
        return np.array([by_inner, by_outer - by_inner])

    def pressed(self, lengths: NDArray) -> tuple[NDArray, NDArray]:
        """Loads and stiffnesses (2, C, Z) of whole contacts from the lengths between the centres."""
        approach = self._approach(lengths)
        grown = self._reach_and_coefficient[1] * np.sqrt(approach)
        return grown * approach, 1.5 * grown

    def touching(self, grooves: Vectors, centres: Vectors) -> NDArray:
        """Balls (C, Z) that both races press."""
        return (
            np.abs(groove_arm(np.array([grooves - centres, centres]))) > self._reach_and_coefficient[0]
        ).all(0)

    def over_shoulders(self, balls: BallBalance) -> NDArray:
        """Angle (C) [rad] by which whole contacts of balls reach over shoulders, none where <= 0."""
        if self.races is None:
            return np.full(len(self.load), -np.inf)
        approach = (balls.loads / self._reach_and_coefficient[1]) ** (2 / 3)
        return self.races.beyond(approach, balls.contacts.angles).max((0, 2))

    def withdrawn(self, angle: float) -> "AngularBalance":
        """The same with races that end further out by an angle [rad]."""
        return self if self.races is None else replace(self, races=self.races.withdrawn(angle))

    @property
    def of_whole_contacts(self) -> "AngularBalance":
        """The same without shoulders."""
        return self if self.races is None else replace(self, races=None)

    def _approach(self, lengths: NDArray) -> NDArray:
        return np.maximum(lengths - self._reach_and_coefficient[0], 0.0)

    @cached_property
    def _reach_and_coefficient(self) -> NDArray:
        """Lengths [m] from which contacts carry, and their K [N/m^1.5]; (2, 2, 1, 1)."""
        bearing, (inner, outer) = self.bearing, self.contacts
        reach = bearing.inner_reach, bearing.outer_reach
        return np.array([*reach, inner.coefficient, outer.coefficient]).reshape(2, 2, 1, 1)

    def ring(self, balls: BallBalance, follow: Vectors) -> RingBalance:
        """Balance of the inner ring; `follow` (2, C, Z) is the move of a ball per move of its groove."""
        _, force, traction = balls.forces
        carried = self.on_ring(force, traction)
        along, aside = balls.by_groove + moved(balls.by_ball[:, None], follow[:, None])
        by_ring = along[1:, ..., None] * self.ring_to_groove.real
        by_ring += aside[1:, ..., None] * self.ring_to_groove.imag
        stiffness = (self.groove_to_ring.T @ by_ring[0] - self.ring_to_lever.T @ by_ring[1]).real
        return RingBalance(np.where(self.held, 0.0, self.load - carried), stiffness, carried)

    def on_ring(self, force: Vectors, traction: NDArray) -> NDArray:
        """Load (C, 5) [N] that forces and tractions of the inner ring on the balls (C, Z) take up."""
        return (force @ self.groove_to_ring - traction @ self.ring_to_lever).real

    def dragged(self, balls: BallBalance) -> NDArray:
        """Load (C, 5) [N] that the tractions of the inner race take up."""
        traction = balls.kinematics.tractions[0]
        return self.on_ring(traction * np.exp(-1j * balls.contacts.angles[0]), traction)

    @cached_property
    def groove_to_ring(self) -> Vectors:
        """Load on the ring per force on a ball, conjugate complex (Z, 5)."""
        return self.ring_to_groove.conj()

    @cached_property
    def ring_to_lever(self) -> NDArray:
        """Move of the inner contacts against the balls by the tilt of the section (Z, 5)."""
        bearing = self.bearing
        lever = bearing.inner.conformity * bearing.ball.diameter / bearing.inner_groove_radius
        return lever * self.ring_to_groove.real * [0.0, 0.0, 0.0, 1.0, 1.0]


def _by_all_angles(kinematics: BallKinematics, contacts: LoadedContacts, cut: CutContacts) -> BallKinematics:
    """Slopes by contact angles with what comes through loads, which follow the angles of cut contacts."""
    through = cut.by_angle / np.where(contacts.stiffness > 0, contacts.stiffness, np.inf)

    def turned(slopes: NDArray) -> NDArray:
        by_length, by_angle = slopes[..., ::2, :, :], slopes[..., 1::2, :, :]
        changed = slopes.copy()
        changed[..., 1::2, :, :] = by_angle + by_length * through
        return changed

    return kinematics._replace(
        centrifugal_slopes=turned(kinematics.centrifugal_slopes),
        traction_slopes=turned(kinematics.traction_slopes),
    )


def race_contacts(
    bearing: AngularContactBearing, angles: NDArray | None = None
) -> tuple[PointContact, PointContact]:
    """Hertz contacts with the inner and with the outer race, at angles (2, ...) or the unloaded one."""
    inner, outer = (
        point_contact(curvatures, modulus)
        for curvatures, modulus in zip(_curvatures(bearing, angles), _moduli(bearing), strict=True)
    )
    return inner, outer


def lubricated_races(
    bearing: AngularContactBearing, contacts: tuple[PointContact, PointContact], lubrication: BallLubrication
) -> LubricatedRaces:
    """Contacts with oil, at the unloaded angle."""
    return LubricatedRaces(
        lubrication=lubrication,
        contacts=contacts,
        radius=np.array([1.0 / float(each.along) for each in _curvatures(bearing, None)]),
        modulus=np.array(_moduli(bearing)),
    )


def _curvatures(bearing: AngularContactBearing, angles: NDArray | None) -> list[Curvatures]:
    """Curvatures of the inner and of the outer contact, at angles (2, ...) or the unloaded one."""
    return [
        race_curvatures(
            bearing.ball.diameter,
            groove.conformity * bearing.ball.diameter,
            bearing.pitch_diameter,
            bearing.contact_angle if angles is None else angles[race],
            side,
        )
        for race, (groove, side) in enumerate(((bearing.inner, INNER), (bearing.outer, OUTER)))
    ]


def _moduli(bearing: AngularContactBearing) -> list[float]:
    """E' of the inner and of the outer contact [Pa]."""
    return [contact_modulus(bearing.ball.material, each.material) for each in (bearing.inner, bearing.outer)]


def moved(by_place: Vectors, move: Vectors) -> Vectors:
    """Change of quantities with derivatives (2, ...) under a complex move."""
    return by_place[0] * move.real + by_place[1] * move.imag


def _by_place(slopes: Vectors, normals: Vectors, turning: NDArray) -> Vectors:
    """Derivatives by an axial and by a radial move at both ends (2, 2, ...).

    From slopes (2, 2, ...) by length and contact angle at each end, and the turn of normals (2, C, Z) [1/m].
    """
    along = slopes[:, 0, None]
    across = slopes[:, 1, None] * turning[:, None, None]
    sine, cosine = normals.real[:, None], normals.imag[:, None]
    by_place = np.empty_like(slopes)
    by_place[:, 0] = along[:, 0] * sine + across[:, 0] * cosine
    by_place[:, 1] = along[:, 0] * cosine - across[:, 0] * sine
    return by_place
