"""How an angular-contact ball bearing carries its load."""

from dataclasses import dataclass, fields
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.angular_contact import race_contacts
from quasidynamic.balance.balls.free_ball import OiledBalls
from quasidynamic.balance.balls.light_ball import FULL_ANGLE, FULL_CAGED, FULL_GRIP
from quasidynamic.contact.ellipse.full_sliding import Ellipse
from quasidynamic.contact.ellipse.point_contact import INNER, OUTER, PointContact
from quasidynamic.contact.ellipse.rigid_slip import Spin
from quasidynamic.motion.ball_slip import BallContacts, pressed_height
from quasidynamic.motion.ball_speeds import Control, ball_attitude, spin_to_roll
from quasidynamic.motion.rolling_lines import (
    RollingLines,
    ball_friction,
    hertz_section_radius,
    rolling_lines,
    slip_velocity,
    spin_parameter,
    spin_torque_factor,
    spin_torque_integral,
)
from quasidynamic.outcome.truncation import edge_angle, height_above_bottom
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing, RingOperation
from quasidynamic.solve.balls.sliding_motion import guided_motion

CONTROLS: tuple[Control, ...] = ("outer", "inner")
UPRIGHT = 0.9  # of the attitude under race control: what is left of it where friction holds


@dataclass(frozen=True)
class RollingContact:
    """Where balls roll without slip; index 0 the inner and 1 the outer race.

    Only balls that touch both, by contacts that are narrower than what they press, and slide on neither race.
    """

    balls: NDArray  # (B) numbers of these balls
    wide: NDArray  # numbers of balls with a contact as wide as the surface it presses
    sliding: NDArray  # numbers of balls whose friction moments do not balance in rolling, see `ball_friction`
    parameter: NDArray  # (2, B) E [-]
    net_force: NDArray  # (2, B) e, friction in the rolling direction over mu Q [-]
    lines: RollingLines  # (2, B)
    semi_axes: tuple[NDArray, NDArray]  # a, b (2, B) [m]
    loads: NDArray  # (2, B) [N]
    section_radius: NDArray  # (2, 1) R [m]
    rolling: NDArray  # (2, B) omega_roll of `slip_velocity` [rad/s]
    spin_to_roll: NDArray  # (2, B) S [-]

    def slip_velocity(self, position: NDArray) -> NDArray:
        """Slip (2, B, P) [m/s] at x/a (P), ball minus race; see `rolling_lines.slip_velocity`."""
        lines = RollingLines(*(value[..., None] for value in self.lines))
        per_contact = self.semi_axes[0], self.section_radius, self.rolling, self.spin_to_roll
        return slip_velocity(position, lines, *(value[..., None] for value in per_contact))

    def spin_torques(self, friction: float, method: Literal["lines", "integral"] = "integral") -> NDArray:
        """Friction torque about each contact normal (2, B) [N m] for a coefficient of friction."""
        across, along = self.semi_axes
        if method == "lines":
            factor = spin_torque_factor(self.lines)
        else:
            factor = spin_torque_integral(self.lines, along / across)
        return friction * self.loads * across * factor


@dataclass(frozen=True)
class AngularContactState:
    """How an angular-contact bearing carries its load; Z balls, index 0 the inner and 1 the outer race."""

    bearing: AngularContactBearing
    operation: RingOperation
    ring_displacement: NDArray  # (5) [m, m, m, rad, rad] of the inner ring: x, y, z, about y, about z
    ring_load: NDArray  # (5) [N, N, N, N m, N m] that the balls take up
    stiffness: NDArray  # (5, 5) load per displacement, balls in balance [N/m, N, N m]
    contact_angles: NDArray  # (2, Z) [rad]
    loads: NDArray  # (2, Z) [N] normal
    tractions: NDArray  # (2, Z) [N] along the groove sections, holding the gyroscopic moment
    orbital_speed: NDArray  # (Z) [rad/s]
    ball_speed: NDArray  # (Z) [rad/s] in the orbiting frame
    attitude: NDArray  # (Z) [rad] beta, of the spin axis to the shaft
    yaw: NDArray  # (Z) [rad] of the spin axis out of the plane of the section
    centrifugal_force: NDArray  # (Z) [N]
    gyroscopic_moment: NDArray  # (Z) [N m]
    evaluations: int  # of all balls
    friction: float | None = None  # [-] Coulomb coefficient of the contacts
    spin: Spin = "centre"  # that makes slip across in contacts, see `strip_slip`
    sliding_heat: NDArray | None = None  # (Z) [W] by all causes, where friction decides what balls do
    oil: OiledBalls | None = None  # what it does to the balls; None: dry contacts
    sticking: bool = False  # whether these contacts stick and slip as by FASTSIM
    imbalance: float = 0.0  # [-] largest unbalanced force over the largest force
    whole_displacement: NDArray | None = None  # (5) as of the inner ring with whole contacts; None as below
    whole_loads: NDArray | None = None  # (2, Z) [N] of whole contacts, same approach; None: none is cut off
    shoulder_forces: NDArray | None = None  # (2, Z) [N] of cut contacts along the sections; None as above
    groove_displacement: NDArray | None = None  # (2, Z, 2) [m] axial, outward; None: rigid

    @cached_property
    def friction_heat(self) -> NDArray | None:
        """Heat of friction of both contacts (Z) [W]; zero for balls that do not touch both races.

        Where a race control sets the axes, forces along the orbit and about the axis balance for each ball,
        see `guided_motion`. None without a coefficient of friction, or where a contact is as wide as the
        ball.
        """
        if self.sliding_heat is not None or self.friction is None:
            return self.sliding_heat
        if self._wide.any():
            return None
        heat, balls = np.zeros(self.loads.shape[1]), np.flatnonzero((self.loads > 0).all(0))
        speed = abs(self.operation.inner_speed - self.operation.outer_speed)
        if speed:
            heat[balls] = speed * guided_motion(*self.touching(balls), self.attitude[balls]).power
        return heat

    def touching(self, balls: NDArray) -> tuple[BallContacts, Ellipse]:
        """Contacts of some balls (n), by their numbers, that touch both races, as friction takes them.

        One diagonal, (n, 1, 2); a coefficient of friction is known.
        """
        across, along = (axis[:, balls].T[:, None] for axis in self.semi_axes)
        radius, surface = np.full(len(balls), self.bearing.ball.diameter / 2), self._surfaces.T[:, None]
        places = BallContacts(
            ball_radius=radius,
            pitch_radius=np.full(len(balls), self.bearing.pitch_diameter / 2),
            angle=self.contact_angles[:, balls].T[:, None],
            height=pressed_height(radius[:, None, None], surface, across),
        )
        traction = np.asarray(self.friction) * self.loads[:, balls].T[:, None]
        return places, Ellipse(across, along, surface + np.zeros_like(across), traction, self.spin)

    def motion(self, balls: NDArray) -> NDArray:
        """Motion of some balls (n, 4) that touch both races, over the speed of the rings [-].

        Outer ring, ball axial, radial, about the rolling direction, from the orbiting ball centre; the
        speed is that of the inner against the outer ring, not zero. Where a race control sets the axes, see
        `guided_motion`.
        """
        if self.sliding_heat is None:
            guided = guided_motion(*self.touching(balls), self.attitude[balls]).motion
            return np.concatenate([guided, np.zeros((len(balls), 1))], 1)
        ahead = self.operation.inner_speed - self.operation.outer_speed
        outer = (self.operation.outer_speed - self.orbital_speed[balls]) / ahead
        attitude, yaw, size = self.attitude[balls], self.yaw[balls], self.ball_speed[balls] / ahead
        axial, radial = -size * np.cos(yaw) * np.cos(attitude), size * np.cos(yaw) * np.sin(attitude)
        return np.stack([outer, axial, radial, np.sign(ahead) * size * np.sin(yaw)], -1)

    @property
    def friction_torque(self) -> float | None:
        """Torque of friction, heat over the speed of the rings against each other [N m]; None as above."""
        if self.friction_heat is None:
            return None
        speed = abs(self.operation.inner_speed - self.operation.outer_speed)
        return float(self.friction_heat.sum() / speed) if speed else 0.0

    @cached_property
    def contacts(self) -> PointContact:
        """Hertz contacts (2, Z) at the loaded contact angles."""
        inner, outer = race_contacts(self.bearing, self.contact_angles)
        names = [field.name for field in fields(PointContact)]
        return PointContact(*(np.stack([getattr(inner, name), getattr(outer, name)]) for name in names))

    @property
    def semi_axes(self) -> tuple[NDArray, NDArray]:
        """Semi-axes a across and b along the rolling direction (2, Z) [m], at the loaded contact angles.

        Of whole ellipses: a contact that a shoulder cuts off has those of its approach.
        """
        return self.contacts.semi_axes(self._as_whole)

    @property
    def _as_whole(self) -> NDArray:
        """Loads of whole contacts at the same approach (2, Z) [N]."""
        return self.loads if self.whole_loads is None else self.whole_loads

    @property
    def carried_shares(self) -> NDArray:
        """Load of contacts over that of whole ones, same approach (2, Z) [-]."""
        return np.where(self._as_whole > 0, self.loads / np.where(self._as_whole > 0, self._as_whole, 1), 1.0)

    @property
    def section_forces(self) -> NDArray:
        """Forces along the groove sections, of friction and of cut contacts (2, Z) [N]."""
        return self.tractions if self.shoulder_forces is None else self.tractions + self.shoulder_forces

    @property
    def _surfaces(self) -> NDArray:
        """R of the pressed surfaces (2, 1) [m]."""
        grooves = [[self.bearing.inner.conformity], [self.bearing.outer.conformity]]
        return hertz_section_radius(self.bearing.ball.diameter, grooves)

    @property
    def _wide(self) -> NDArray:
        """Balls (Z) with a contact as wide as the surface it presses, or as the ball."""
        across = self.semi_axes[0]
        return np.any(across >= np.minimum(self._surfaces, self.bearing.ball.diameter / 2), axis=0)

    @property
    def needed_shoulders(self) -> NDArray:
        """Height of the races above the bottoms of their grooves up to which contacts reach (2, Z) [m].

        Zero without a load. On a lower shoulder contacts are cut off, see `EndingRaces`. See `truncation`.
        """
        diameter = self.bearing.ball.diameter
        radii = diameter * np.array([[self.bearing.inner.conformity], [self.bearing.outer.conformity]])
        edge = edge_angle(np.abs(self.contact_angles), self.semi_axes[0], diameter / 2, "chord")
        return np.where(self.loads > 0, height_above_bottom(edge, radii), 0.0)

    @property
    def peak_pressures(self) -> NDArray:
        """p0 (2, Z) [Pa]; of a cut contact that of the whole one, without the edge."""
        return self.contacts.peak_pressure(self._as_whole)

    @property
    def needed_friction(self) -> NDArray:
        """Traction over load that keeps a ball from turning about the rolling direction (2, Z) [-]."""
        loaded = self.loads > 0
        return np.where(loaded, np.abs(self.tractions) / np.where(loaded, self.loads, 1.0), 0.0)

    def rolling_contact(
        self,
        spin: Literal["slip field", "contact angle"] = "slip field",
        friction: Literal["none", "balanced"] = "none",
    ) -> RollingContact:
        """Pure rolling lines of the balls that touch both races, each for itself.

        It says which balls have no lines. S [-] is that of the ball's motion, or, with "contact angle", gamma
        sin(alpha) alone as in Rivera, Tong and Hong (2021), Eq. (15). Net friction in the rolling direction
        is none (e = 0), or, "balanced", as much as balances the friction moments about the spin axis, see
        `ball_friction`.

        Source
        ------
        Rivera, Tong and Hong (2021); see `quasidynamic.motion.rolling_lines`.
        """
        bearing, (across, along), side = self.bearing, self.semi_axes, np.array([[INNER], [OUTER]])
        ratio, diameter = bearing.diameter_ratio, bearing.ball.diameter
        radius, touching = self._surfaces, (self.loads > 0).all(0)
        wide = touching & self._wide
        keep = np.flatnonzero(touching & ~wide)
        spin_axis = self.contact_angles if spin == "contact angle" else self.attitude
        ratios = spin_to_roll(self.contact_angles, spin_axis, ratio, side)
        parameter = spin_parameter(ratios[:, keep], radius, across[:, keep])
        net, slides = np.zeros_like(parameter), np.zeros(len(keep), bool)
        if friction == "balanced":
            ahead = (self.contact_angles - self.attitude)[:, keep]
            net = ball_friction(parameter, self.loads[:, keep], across[:, keep], ahead, diameter)
            slides = np.isnan(net[0])
        parameter, net, balls = parameter[:, ~slides], net[:, ~slides], keep[~slides]
        rings = np.array([[self.operation.inner_speed], [self.operation.outer_speed]])
        return RollingContact(
            balls=balls,
            wide=np.flatnonzero(wide),
            sliding=keep[slides],
            parameter=parameter,
            net_force=net,
            lines=rolling_lines(parameter, net),
            semi_axes=(across[:, balls], along[:, balls]),
            loads=self.loads[:, balls],
            section_radius=radius,
            rolling=(rings - self.orbital_speed[balls]) / ratio,
            spin_to_roll=ratios[:, balls],
        )

    @property
    def groove_axial(self) -> NDArray | None:
        """Displacement of elastic grooves along x (2, Z) [m]; None between rigid rings."""
        if self.groove_displacement is None:
            return None
        return self.bearing.along_x * self.groove_displacement[..., 0]

    @property
    def groove_radial(self) -> NDArray | None:
        """Outward displacement of elastic grooves (2, Z) [m]; None between rigid rings."""
        return None if self.groove_displacement is None else self.groove_displacement[..., 1]

    @property
    def ball_row(self) -> NDArray | None:
        """Number of the row of each ball (Z), from 0; None of one row."""
        return self.bearing.ball_rows if len(self.bearing.rows) > 1 else None

    @property
    def row_load(self) -> NDArray | None:
        """Force along x, y, z that each row takes for the inner ring (R, 3) [N]; None of one row."""
        bearing = self.bearing
        if len(bearing.rows) == 1:
            return None
        forces = (self.loads[0] - 1j * self.section_forces[0]) * 1j * np.exp(-1j * self.contact_angles[0])
        axial = bearing.along_x * forces.real
        around = np.exp(1j * bearing.azimuths) * forces.imag  # z + i y
        return np.array([axial, around.imag, around.real]).T.reshape(len(bearing.rows), -1, 3).sum(1)

    @property
    def on_inner(self) -> NDArray:
        """Balls that the inner race touches (Z), bool."""
        return self.loads[0] > 0

    @property
    def guided(self) -> NDArray:
        """Balls whose motion both races set (Z), bool.

        The others are pressed too lightly, stand too far round a race or lack friction for their gyroscopic
        moment, see `PrescribedControl`: orbit, spin and tractions of these are estimates. Where friction
        decides, see `CoulombControl`, they are pressed too lightly, in a cage hardly at all.
        """
        if self.oil is not None and self.oil.cage_speed.any():
            return self.loads[0] > FULL_CAGED * self.loads[1]
        apart = np.abs(self.contact_angles[0] - self.contact_angles[1])
        pressed = self.loads[0] > FULL_GRIP * self.centrifugal_force
        if self.sliding_heat is not None:
            return pressed
        needed = 2 * np.abs(self.gyroscopic_moment) / self.bearing.ball.diameter
        held = np.abs(self.tractions.sum(0)) >= (1 - 1e-9) * needed
        return (apart <= FULL_ANGLE) & pressed & held

    @property
    def upright(self) -> NDArray:
        """Balls whose axes friction holds up against the gyroscopic moment (Z), bool.

        Their attitude is not far below those of outer and of inner control; where friction is missing the
        axis turns towards the shaft, and the moment becomes less.
        """
        ratio = self.bearing.diameter_ratio
        known = [ball_attitude(self.contact_angles, ratio, control).value for control in CONTROLS]
        return (self.ball_speed == 0) | (np.abs(self.attitude) >= UPRIGHT * np.abs(known).min(axis=0))
