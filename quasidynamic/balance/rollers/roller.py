"""Balance of one roller between its raceways and in its pocket, for all rollers of all cases at once."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.operating_points import OperatingPoints
from quasidynamic.columns import stacked, taken
from quasidynamic.contact.drag import churning_torque, orbit_drag_force
from quasidynamic.contact.line.load_law import smooth_positive
from quasidynamic.contact.lubrication import Lubrication
from quasidynamic.contact.raceways import Raceways, RacewayState
from quasidynamic.contact.rib import EXPONENT, in_series, rib_stiffness
from quasidynamic.parts.material import contact_modulus
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing

POCKET_ROUNDING = 1e-3  # of the smallest load of a roller: width over which the pocket force changes side
STANDSTILL = 1e-5  # of nominal speeds: below it surfaces are at rest
POCKET_STANDSTILL = 1e-3  # of the spin in pure rolling: below it friction in the pocket has no full sense

RIB_CREEP = 0.1  # of its sliding in pure rolling: below it friction of a rib has no full sense; assumed

# Places among a roller's inputs and its value, and among its forces, counted from the end.
RIB, SPIN, CAGE_SPEED, FILM_I, FILM_O, VALUE = range(-6, 0)  # the first one of rollers on ribs alone
OUTWARD, BACKWARD, CHURNING, POCKET_UP, POCKET_BRAKE = range(-5, 0)


class Motion(NamedTuple):
    """How the rollers of C cases move."""

    spin_drift: NDArray  # (C, Z) spin less that of pure rolling [rad/s]
    cage_drift: NDArray  # (C, 1) cage speed less that of pure rolling [rad/s]
    spin: NDArray  # (C, Z) relative to the cage [rad/s]
    cage_speed: NDArray  # (C, 1) [rad/s]
    standstill_spin: NDArray  # (C, 1) below it a roller is at rest [rad/s]


class RibState(NamedTuple):
    """Ends of the rollers on ribs; those of the inner ring first."""

    thrust: NDArray  # (C, Z) force of the inner ring's rib on the roller along x, through it on the other [N]
    sliding: NDArray  # (2, C, Z) rib over the roller's end, along the motion [m/s]
    friction: NDArray  # (2, C, Z) of the rib on the roller, along the motion [N]


class RollerInputs(NamedTuple):
    """Approaches, films and motion of the rollers of C cases; M axial modes."""

    approach: NDArray  # (2, M, C, Z) by axial modes, at inner and outer raceway [m]
    film: NDArray  # (2, C, Z) [m]
    motion: Motion
    weight: NDArray  # (2, C, Z) of the rollers, outwards and along the motion [N]
    closing: NDArray | None = None  # (C, Z) of both ribs on the rollers [m]; None without


class RollerState(NamedTuple):
    """Everything that happens at the rollers in one state; inner raceway first."""

    contact: RacewayState
    sliding: NDArray  # (2, C, Z) raceway over roller surface [m/s]
    entrainment: NDArray  # (2, C, Z) [m/s] >= 0
    film: NDArray  # (2, C, Z) [m]
    centrifugal: NDArray  # (C, 1) of one roller, outwards [N]
    drag: NDArray  # (C, 1) oil-air mixture on one roller, against +t [N]
    weight: NDArray  # (2, C, Z) outwards and along the motion [N]
    churning: NDArray  # (C, Z) torque of the mixture between roller and cage against the spin [N m]
    sense: NDArray  # (2, C, Z) sign of the mean surface speed, smooth through zero [-]
    pocket_brake: NDArray  # (C, Z) friction of the pocket against the spin, signed like it [N]
    pocket: NDArray  # (2, C, Z) force of the pocket on the roller along the motion and outwards [N]
    ribs: RibState | None = None  # of rollers that thrust presses on ribs


class Response(NamedTuple):
    """Rows of the roller's table: derivatives by its 2 M + 4 inputs, then the value itself.

    The inputs are the M approaches at the inner and at the outer raceway, how far ribs close, spin, cage
    speed, inner and outer film. Keeping value and derivatives side by side lets every equation be written
    once: what is a sum of forces is also the sum of their derivatives.

    Rows: radial force [N], tilt moment [N m] (with two axial modes or more), film at the inner and the
    outer raceway [m], spin [N m]: these must vanish. Then what acts on the rest of the bearing:
    torque on the cage [N m], tangential force of the inner ring [N], force of the pocket on the roller
    along the motion and outwards [N] (with a free cage), thrust [N] (on ribs), the M forces conjugate to the
    axial modes at the inner and at the outer raceway [N].
    """

    table: NDArray  # (rows, inputs + 1, C, Z)
    state: RollerState


@dataclass(frozen=True, kw_only=True)
class RollerBalance:
    """Equations of one roller.

    Every row is a sum of forces with constant levers: `levers` is the page of equations, `_forces`
    fills in the forces and their derivatives.
    """

    bearing: CylindricalRollerBearing
    raceways: Raceways
    lubrication: Lubrication
    on_ribs: bool = False  # whether thrust presses the rollers on the ribs of the bearing

    def take(self, cases: NDArray) -> "RollerBalance":
        """Equations of some of the cases."""
        return self if self._alike else taken(self, cases)

    @cached_property
    def _alike(self) -> bool:
        """Whether no number differs between cases."""
        return taken(self, np.zeros(1, int)) is self

    @cached_property
    def axial_modes(self) -> int:
        """Number M of axial modes; with one the roller has no tilt."""
        return self.raceways.slices.axial_modes

    @cached_property
    def forces(self) -> list[str]:
        """Names of the forces, in the order of the columns of `levers`; films stand among them."""
        return (
            [f"inner {m}" for m in range(self.axial_modes)]
            + [f"outer {m}" for m in range(self.axial_modes)]
            + ["T_i", "T_o", "R_i", "R_o", "film_i", "film_o"]
            + (["thrust", "rib_i", "rib_o"] if self.on_ribs else [])
            + ["outward", "backward", "churning", "pocket up", "pocket brake"]
        )

    @cached_property
    def cage_force(self) -> NDArray:
        """Force of the pocket on the roller (forces) or (forces, C, 1) from the tangential balance [-]."""
        g = self.bearing.diameter_ratio
        ribs = dict.fromkeys(("rib_i", "rib_o"), -1) if self.on_ribs else {}
        return self._row(backward=1, T_i=-1, T_o=-1, R_i=-(1 - 2 * g), R_o=1 + 2 * g, **ribs)

    @cached_property
    def levers(self) -> NDArray:
        """Equations (rows, forces) or (rows, forces, C, 1), the rows of `Response` [-] or [m]."""
        r_w, r_m = self.bearing.roller.diameter / 2, self.bearing.pitch_diameter / 2
        half, g = self.raceways.slices.length / 2, self.bearing.diameter_ratio
        radial = self._row(**{"inner 0": 1, "outer 0": -1, "outward": 1, "pocket up": 1})
        tilt = [self._row(**{"outer 1": half, "inner 1": -half})] if self.axial_modes > 1 else []
        alone, m = np.multiply.outer(np.eye(len(self.forces)), np.ones(self._lever_shape)), self.axial_modes
        films, contact_forces = alone[2 * m + 4 : 2 * m + 6], alone[: 2 * m]
        spin = r_w * self._row(**{"T_i": 1, "T_o": -1, "R_i": -1, "R_o": -1, "pocket brake": -1})
        spin += self._row(churning=-1)
        cage = -r_m * self.cage_force + self._row(**{"pocket brake": -r_w, "churning": -1})
        tangential = self._row(T_i=1, R_i=1 - 2 * g)
        thrust = []
        if self.on_ribs:
            inner, outer = self.bearing.rib_levels
            thrust = [self._row(thrust=1)]
            tilt[0] += self._row(thrust=inner - outer)
            spin += self._row(rib_i=-inner, rib_o=-outer)
            tangential += self._row(rib_i=1)
        pocket = [self.cage_force, self._row(**{"pocket up": 1})] if self.bearing.cage.free else []
        return np.array([radial, *tilt, *films, spin, cage, tangential, *pocket, *thrust, *contact_forces])

    def _row(self, **weights: NDArray | float) -> NDArray:
        row = np.zeros((len(self.forces), *self._lever_shape))
        for name, weight in weights.items():
            row[self.forces.index(name)] = weight
        return row

    @cached_property
    def _lever_shape(self) -> tuple[int, ...]:
        """Shape of a lever: that of a number, or (C, 1) where dimensions differ between cases."""
        return np.shape(self.bearing.inner_radius + self.bearing.roller.diameter + self.bearing.roller.length)

    def respond(self, inputs: RollerInputs, points: OperatingPoints) -> Response:
        """Evaluate the equations of all rollers."""
        sliding, entrainment, sense = self.surfaces(inputs.motion, points)
        contact = self.raceways.state(inputs.approach, sliding, entrainment, inputs.film)
        forces, centrifugal, drag = self._forces(contact, inputs)
        m, ribs = self.axial_modes, self._add_ribs(forces, inputs, points) if self.on_ribs else None
        friction = forces[2 * m : 2 * m + 6].reshape(3, 2, *forces.shape[1:])
        self._fill_friction(friction, contact, entrainment, sense)
        films = friction[2]  # what the speeds require, less what was assumed
        films[0, FILM_I] = films[1, FILM_O] = -1.0
        films[:, VALUE] -= inputs.film
        cage_force = self._add_pocket(forces, inputs.motion)
        return Response(
            _combined(self.levers, forces),
            RollerState(
                contact,
                sliding,
                entrainment,
                inputs.film,
                centrifugal=centrifugal,
                drag=drag,
                weight=inputs.weight,
                churning=forces[CHURNING, VALUE],
                sense=sense,
                pocket_brake=forces[POCKET_BRAKE, VALUE],
                pocket=np.array([cage_force, forces[POCKET_UP, VALUE]]),
                ribs=ribs,
            ),
        )

    # -- surfaces ------------------------------------------------------------------------------

    def surfaces(self, motion: Motion, points: OperatingPoints) -> tuple[NDArray, NDArray, NDArray]:
        """Sliding and entrainment speed (2, C, Z) [m/s], sense of rolling [-].

        The sliding of raceway over roller is that of the drifts from pure rolling: nothing large cancels.
        """
        (slide_by_spin, slide_by_cage), (roll_by_spin, roll_by_cage) = self.speed_slopes
        sliding = slide_by_spin * motion.spin_drift + slide_by_cage * motion.cage_drift
        rolling = roll_by_spin * motion.spin + roll_by_cage * (motion.cage_speed - points.ring_speeds)
        # The size of the mean surface speed, kept above zero.
        entrainment = np.sqrt(
            rolling * rolling + (STANDSTILL * self.bearing.inner_radius * points.relative_speed) ** 2
        )
        return sliding, entrainment, rolling / entrainment

    @cached_property
    def speed_slopes(self) -> tuple[NDArray, NDArray]:
        """Sliding and mean surface speed by spin and by cage speed, (2, 2 raceways, 1 or C, 1) [m]."""
        r_w, r_i, r_o = self.bearing.roller.diameter / 2, self.bearing.inner_radius, self.bearing.outer_radius
        sliding = stacked(-r_w, r_w, -r_i, -r_o)
        rolling = 0.5 * stacked(r_w, r_w, -r_i, r_o)
        return sliding.reshape(2, 2, -1, 1), rolling.reshape(2, 2, -1, 1)

    def _fill_friction(
        self, friction: NDArray, contact: RacewayState, entrainment: NDArray, sense: NDArray
    ) -> None:
        """Traction, rolling shear along the rolling, and film of both raceways (3, 2, inputs + 1, C, Z)."""
        m, (rolling, film) = self.axial_modes, (contact.rolling, contact.film)
        by_load = np.array([sense * rolling.by_load, film.by_line_load])
        by_approach = by_load[:, :, None] * contact.force_by_approach[:, 0]
        friction[0, 0, :m], friction[0, 1, m : 2 * m] = contact.traction_by_approach
        friction[1:, 0, :m], friction[1:, 1, m : 2 * m] = by_approach[:, 0], by_approach[:, 1]
        by_sliding, by_speed = (slopes.swapaxes(0, 1) for slopes in self.speed_slopes)
        by_rolling = sense * np.array(
            [contact.traction_by_entrainment, sense * rolling.by_entrainment, film.by_entrainment]
        )
        by_rolling[1] += (1 - sense * sense) / entrainment * rolling.force  # the sense changes with the speed
        by_speeds = friction[:, :, SPIN:FILM_I]
        np.multiply(by_rolling[:, :, None], by_speed, out=by_speeds)
        sliders = by_speeds[::2]  # traction and film
        sliders += np.array([contact.traction_by_sliding, film.by_sliding])[:, :, None] * by_sliding
        friction[0, 0, FILM_I], friction[0, 1, FILM_O] = contact.traction_by_film
        friction[:, :, VALUE] = contact.traction, sense * rolling.force, film.thickness

    # -- forces --------------------------------------------------------------------------------

    def _forces(self, contact: RacewayState, inputs: RollerInputs) -> tuple[NDArray, NDArray, NDArray]:
        """Begin `forces` (forces, inputs + 1, C, Z): all but raceway friction, films and the pocket's.

        Returned with centrifugal force and drag of a roller (C, 1) [N].
        """
        motion = inputs.motion
        m, shape = self.axial_modes, motion.spin.shape
        forces = np.zeros((len(self.forces), 2 * m + 5 + self.on_ribs, *shape))
        forces[: 2 * m, VALUE] = contact.force.reshape(2 * m, *shape)
        forces[:m, :m], forces[m : 2 * m, m : 2 * m] = contact.force_by_approach
        outward, along = inputs.weight
        centrifugal, forces[OUTWARD, CAGE_SPEED] = self.centrifugal(motion.cage_speed)
        drag, forces[BACKWARD, CAGE_SPEED] = self.drag(motion.cage_speed)
        forces[OUTWARD, VALUE], forces[BACKWARD, VALUE] = centrifugal + outward, drag - along
        if self.lubrication.churning_gap is not None:
            forces[CHURNING, VALUE], forces[CHURNING, SPIN] = churning_torque(
                motion.spin,
                self.bearing.roller,
                self.lubrication.oil,
                oil_fraction=self.lubrication.oil_fraction,
                gap=self.lubrication.churning_gap,
            )
        return forces, centrifugal, drag

    def _add_ribs(self, forces: NDArray, inputs: RollerInputs, points: OperatingPoints) -> RibState:
        """Fill in thrust and friction of the ends on the ribs of both rings, which it presses alike."""
        ribs, side = self.bearing.ribs, np.sign(points.axial_load)
        assert ribs is not None  # or nothing would be pressed on them
        assert inputs.closing is not None
        closed, root = smooth_positive(side * inputs.closing, self.raceways.law.rounding)
        load = self.rib_stiffness * closed**EXPONENT
        by_closing = EXPONENT * load / root
        thrust, rib_i, rib_o = forces[2 * self.axial_modes + 6 : OUTWARD]
        thrust[VALUE], thrust[RIB] = side * load, by_closing
        motion, slidings, frictions = inputs.motion, [], []
        for force, level, ring_speed in zip(
            (rib_i, rib_o), self.bearing.rib_levels, points.ring_speeds, strict=True
        ):
            radius = self.bearing.pitch_diameter / 2 + level
            drift = motion.spin_drift * level - motion.cage_drift * radius
            sliding = (ring_speed - motion.cage_speed) * radius + motion.spin * level
            creep = RIB_CREEP * (sliding - drift)
            size = np.hypot(sliding, creep)
            share = ribs.friction * sliding / size
            by_sliding = ribs.friction * load * (creep / size) ** 2 / size
            force[VALUE], force[RIB] = share * load, side * share * by_closing
            force[SPIN], force[CAGE_SPEED] = level * by_sliding, -radius * by_sliding
            slidings.append(sliding)
            frictions.append(force[VALUE])
        return RibState(thrust[VALUE], np.array(slidings), np.array(frictions))

    @cached_property
    def rib_moduli(self) -> tuple[float, float]:
        """E* of the contacts on the ribs of inner and outer ring [Pa]."""
        rings = (self.bearing.inner_ring, self.bearing.outer_ring)
        inner, outer = (contact_modulus(self.bearing.roller.material, ring) / 2 for ring in rings)
        return inner, outer

    @cached_property
    def rib_stiffnesses(self) -> tuple[float, float]:
        """Of these contacts [N/m^1.5]."""
        assert self.bearing.ribs is not None  # or nothing would be pressed on them
        radius, (inner, outer) = self.bearing.ribs.end_radius, self.rib_moduli
        return rib_stiffness(radius, inner), rib_stiffness(radius, outer)

    @cached_property
    def rib_stiffness(self) -> float:
        """Of both in series [N/m^1.5]."""
        return in_series(*self.rib_stiffnesses)

    def centrifugal(self, cage_speed: NDArray) -> tuple[NDArray, NDArray]:
        """Centrifugal force of a roller [N], its derivative by the cage speed [N s]."""
        unit = self.bearing.roller.mass * self.bearing.pitch_diameter / 2
        return unit * cage_speed**2, 2 * unit * cage_speed

    def weight(self, points: OperatingPoints) -> NDArray:
        """Weight of the rollers (2, C, Z), outwards and along the motion [N]."""
        sin, cos = np.sin(self.bearing.azimuths), np.cos(self.bearing.azimuths)
        outward = points.gravity_y * sin + points.gravity_z * cos
        along = points.gravity_y * cos - points.gravity_z * sin
        return self.bearing.roller.mass * np.array([outward, along])

    def drag(self, cage_speed: NDArray) -> tuple[NDArray, NDArray]:
        """Force of the mixture on an orbiting roller [N], its derivative by the cage speed [N s]."""
        lubrication = self.lubrication
        return orbit_drag_force(
            cage_speed, self.bearing, lubrication.oil, lubrication.oil_fraction, lubrication.drag_coefficient
        )

    def _add_pocket(self, forces: NDArray, motion: Motion) -> NDArray:
        """Fill in the pocket's friction: lifts or presses the roller, brakes its spin; returns F_c (C, Z)."""
        coefficient = self.bearing.cage.pocket_friction
        speed = np.sqrt(motion.spin**2 + motion.standstill_spin**2)
        sense = motion.spin / speed
        cage_force = _combined(self.cage_force[None], forces)[0]
        force = cage_force[VALUE]
        rounded = np.sqrt(force * force + self._pocket_rounding**2)
        share = force / rounded
        size, slope = force * share, share * (2 - share * share)  # of the force, smooth through zero
        friction = coefficient * sense
        by_spin = (coefficient - friction * sense) / speed
        up, brake = forces[POCKET_UP], forces[POCKET_BRAKE]
        np.multiply(friction, cage_force, out=up)
        np.multiply(slope, up, out=brake)
        np.multiply(friction, size, out=brake[VALUE])
        up[SPIN] += by_spin * force
        brake[SPIN] += by_spin * size
        return force

    @cached_property
    def _pocket_rounding(self) -> NDArray:
        """Width (1 or C, 1) over which the pocket force changes side [N]."""
        return POCKET_ROUNDING * self.raceways.smallest_load[0]


def _combined(weights: NDArray, forces: NDArray) -> NDArray:
    """Sums (rows, ..., C, Z) of forces (forces, ..., C, Z), by weights (rows, forces) or of every case."""
    if weights.ndim > 2:
        summed = np.zeros((len(weights), *forces.shape[1:]))
        for row, force in zip(*np.nonzero(weights.any((-2, -1))), strict=True):  # most are zero
            summed[row] += weights[row, force] * forces[force]
        return summed
    summed = weights.dot(forces.reshape(len(forces), -1))  # quicker than `@` where it is small
    return summed.reshape(-1, *forces.shape[1:])
