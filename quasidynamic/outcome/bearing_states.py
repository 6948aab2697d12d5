"""What bearings do in many states side by side, in physical units."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.floating_cage import FloatingCage
from quasidynamic.balance.rollers.roller import RollerState
from quasidynamic.balance.rollers.unknowns import CAGE, INNER, OUTER, SHIFT, TILT_Z, Unknowns
from quasidynamic.contact.cage import displacement_in_pocket, land_torque
from quasidynamic.contact.line import Slices, palmgren, peak_pressure
from quasidynamic.contact.rib import rib_pressure
from quasidynamic.contact.traction.film_strip import friction_intensity
from quasidynamic.outcome.acting_forces import ActingForces, Losses
from quasidynamic.outcome.life import basic_life, raceway_lives, turning_share
from quasidynamic.outcome.ring_stiffness import (
    LoadChange,
    Tangent,
    change_by_load,
    change_by_load_near,
    free_to_tilt,
    raceway_forces_by_load,
)
from quasidynamic.solve.rollers import bordered_system

LOADED = 3e-4  # of the largest load of a raceway: contacts above it carry load and have a film worth telling


@dataclass(frozen=True)
class BearingStates:
    """What bearings do in C states. Z rollers, M axial modes, K slices; inner raceway first, outer second.

    Cases are the first axis of every quantity but `rollers` and `unknowns`, where fields keep theirs.
    """

    balance: BearingBalance  # of C cases
    scaled: NDArray  # (C, N) unknowns
    axial_modes: int  # M, axial modes that loads are handed on with
    near: "BearingStates | None" = None  # a state that these hardly differ from: tangents are of first order

    def take(self, cases: NDArray) -> "BearingStates":
        """Some of the cases."""
        return BearingStates(self.balance.take(cases), self.scaled[cases], self.axial_modes)

    @cached_property
    def system(self) -> Linearisation:
        """Residual and derivatives."""
        return self.balance.evaluate(self.scaled)

    def know(self, system: Linearisation) -> None:
        """Take residual and derivatives that were evaluated at these unknowns before."""
        self.__dict__["system"] = system

    @cached_property
    def unknowns(self) -> Unknowns:
        """Unknowns in SI units."""
        return self.balance.unpack(self.scaled)

    @property
    def residual(self) -> NDArray:
        """Largest unbalanced force over the reference force (C) [-]."""
        return np.abs(self.system.residual).max(axis=1)

    @property
    def rollers(self) -> RollerState:
        """Forces and speeds at the rollers; the axis of cases stands before that of the rollers."""
        return self.system.state

    @cached_property
    def slice_loads(self) -> NDArray:
        """Load per length (C, 2, Z, K) [N/m]."""
        slice_load = self.rollers.contact.slice_load
        return self.balance.roller.raceways.slices.unfolded(slice_load).swapaxes(0, 1)

    @property
    def loads(self) -> NDArray:
        """Roller loads (C, 2, Z) [N]."""
        return self.rollers.contact.force[:, 0].swapaxes(0, 1)

    @cached_property
    def forces(self) -> NDArray:
        """Forces (C, 2, Z, M) [N] of the rollers on the raceways; [..., 0] is the load."""
        load = self.slice_loads.transpose(3, 1, 0, 2)  # (K, 2, C, Z)
        return self._whole_slices.summed(load).transpose(2, 1, 3, 0)

    @cached_property
    def _whole_slices(self) -> Slices:
        """Slices along whole rollers."""
        return self.balance.roller.raceways.slices.with_axial_modes(max(self.axial_modes, 2))

    @cached_property
    def deviation(self) -> NDArray:
        """Outward raceway deviations (C, 2, Z, M) by axial modes [m]."""
        deviation = self.unknowns.deviation.transpose(2, 0, 3, 1)
        if self.balance.deviation is not None:
            deviation = deviation + self.balance.deviation
        missing = self.axial_modes - deviation.shape[-1]
        return np.concatenate([deviation, np.zeros((*deviation.shape[:-1], missing))], axis=-1)

    @cached_property
    def deviation_along_rollers(self) -> NDArray:
        """Outward raceway deviations (C, 2, Z, K) [m]."""
        deviation = self.deviation
        return deviation @ self._whole_slices.modes[:, : deviation.shape[-1]].T

    @cached_property
    def loaded(self) -> NDArray:
        """Which contacts carry load (C, 2, Z)."""
        return self.loads > LOADED * self.loads.max(axis=-1, keepdims=True)

    @property
    def film(self) -> NDArray:
        """Film (C, 2, Z) [m]."""
        return self.unknowns.film.swapaxes(0, 1)

    @cached_property
    def loaded_film(self) -> NDArray:
        """Film (C, 2, Z) [m] of the contacts that carry load, 0 elsewhere."""
        return np.where(self.loaded, self.film, 0.0)

    @property
    def minimum_film(self) -> NDArray:
        """Smallest film (C, 2) of the loaded contacts of each raceway [m]; 0 where none is loaded."""
        smallest = np.where(self.loaded, self.film, np.inf).min(axis=-1)
        return np.where(np.isfinite(smallest), smallest, 0.0)

    # -- motion --------------------------------------------------------------------------------

    @property
    def cage_speed(self) -> NDArray:
        """Cage speed (C) [rad/s]."""
        return self._cage_speed[:, 0]

    @property
    def _cage_speed(self) -> NDArray:
        """The same as a column (C, 1)."""
        return self._speeds[1]

    @cached_property
    def _speeds(self) -> tuple[NDArray, NDArray]:
        """Spins (C, Z) and cage speed (C, 1) [rad/s]."""
        return self.balance.speeds(self.unknowns)

    @property
    def cage_slip(self) -> NDArray:
        """Lag of the cage behind pure rolling (C), as a fraction [-]; not a number when that is at rest."""
        return _lag(self.unknowns.cage_drift, self.balance.rolling_cage)[:, 0]

    @property
    def roller_speed(self) -> NDArray:
        """Spin (C, Z) relative to the cage [rad/s]."""
        return self._speeds[0]

    @property
    def roller_slip(self) -> NDArray:
        """Lag of the spins behind pure rolling (C, Z), as a fraction [-]; not a number when they are at rest.

        Of spins as `cage_slip` is of the cage: 0 in pure rolling, 1 where a roller does not spin.
        """
        return _lag(self.unknowns.spin_drift, self.balance.rolling_spin)

    @property
    def roller_tilt(self) -> NDArray:
        """Tilt (C, Z) of the rollers in the plane through the bearing axis [rad]."""
        relative = self.unknowns.tilt
        if self.balance.roller.axial_modes > 1:
            relative = relative + self.deviation[:, OUTER, :, 1]
        return relative / (self.balance.roller.raceways.slices.length / 2)

    @property
    def ring_displacement(self) -> NDArray:
        """Displacement (C, 2), y and z, of the inner ring against the outer one [m]."""
        return self.unknowns.ring[:TILT_Z, :, 0].T

    @property
    def ring_tilt(self) -> NDArray:
        """Slopes (C, 2), dz/dx and dy/dx, of the inner ring [rad]."""
        return self.unknowns.ring[TILT_Z:CAGE, :, 0].T

    @property
    def load_direction(self) -> NDArray:
        """Azimuth of the radial load (C) [rad], 0 when there is none."""
        points = self.balance.points
        return np.arctan2(points.load_y, points.load_z)[:, 0]

    # -- ribs ----------------------------------------------------------------------------------

    @property
    def ring_shift(self) -> NDArray | None:
        """Displacement of the inner ring along x (C) [m], its play left out; None without thrust on ribs."""
        return self.unknowns.shift[:, 0] if self.balance.layout.ribs else None

    @property
    def axial_stiffness(self) -> NDArray | None:
        """Axial load per shift of the ring (C) [N/m], everything else following; None without thrust."""
        if not self.balance.layout.ribs:
            return None
        load = np.zeros((*self.scaled.shape, 1))
        load[:, SHIFT, 0] = -1.0 / self.balance.scales.residual[:, SHIFT]
        change = bordered_system.solve(self.balance, self.system, load)[:, SHIFT, 0]
        return 1.0 / (change * self.balance.scales.unknown[:, SHIFT])

    @property
    def axial_load(self) -> NDArray | None:
        """Axial load on the inner ring (C) [N]; None without thrust on ribs."""
        return self.balance.points.axial_load[:, 0] if self.balance.layout.ribs else None

    @property
    def rib_radii(self) -> NDArray | None:
        """Radii (C, 2) of the contacts on the ribs [m]; None without thrust on ribs."""
        if not self.balance.layout.ribs:
            return None
        bearing, cases = self.balance.roller.bearing, len(self.scaled)
        each = (bearing.pitch_diameter / 2 + level for level in bearing.rib_levels)
        return np.stack([np.broadcast_to(np.ravel(radius), cases) for radius in each], axis=1)

    @property
    def rib_thrust(self) -> NDArray | None:
        """Force of the inner ring's rib on each roller along x (C, Z) [N], handed on to the outer ring's."""
        return None if self.rollers.ribs is None else self.rollers.ribs.thrust

    @property
    def rib_sliding(self) -> NDArray | None:
        """Ribs over the ends of the rollers (C, 2, Z) [m/s], along the motion."""
        return None if self.rollers.ribs is None else self.rollers.ribs.sliding.swapaxes(0, 1)

    @property
    def rib_friction(self) -> NDArray | None:
        """Friction of the ribs on the rollers (C, 2, Z) [N], along the motion."""
        return None if self.rollers.ribs is None else self.rollers.ribs.friction.swapaxes(0, 1)

    @property
    def rib_heat(self) -> NDArray | None:
        """Heat of the ends of the rollers on the ribs (C, 2, Z) [W]."""
        ribs = self.rollers.ribs
        return None if ribs is None else (ribs.friction * ribs.sliding).swapaxes(0, 1)

    @property
    def rib_pressure(self) -> NDArray | None:
        """Peak pressure of the contacts on the ribs (C, 2, Z) [Pa]."""
        roller, ribs = self.balance.roller, self.balance.roller.bearing.ribs
        if self.rib_thrust is None or ribs is None:
            return None
        load = np.abs(self.rib_thrust)
        return np.stack([rib_pressure(load, 1 / ribs.end_radius, each) for each in roller.rib_moduli], axis=1)

    # -- forces --------------------------------------------------------------------------------

    @property
    def traction(self) -> NDArray:
        """Traction of the raceways on the rollers (C, 2, Z) [N], signed like the sliding."""
        return self.rollers.contact.traction.swapaxes(0, 1)

    @property
    def rolling_shear(self) -> NDArray:
        """Inlet shear at the raceways (C, 2, Z) [N], signed along the rolling."""
        return (self.rollers.sense * self.rollers.contact.rolling.force).swapaxes(0, 1)

    @property
    def sliding(self) -> NDArray:
        """Raceway over roller surface (C, 2, Z) [m/s]."""
        return self.rollers.sliding.swapaxes(0, 1)

    @property
    def entrainment(self) -> NDArray:
        """Mean surface speed (C, 2, Z) [m/s]."""
        return self.rollers.entrainment.swapaxes(0, 1)

    @property
    def cage_force(self) -> NDArray:
        """Force of the pockets on the rollers along the motion (C, Z) [N]."""
        return self.rollers.pocket[0]

    @property
    def acting(self) -> ActingForces:
        """Every force on rollers and cage as it acts."""
        roller = self.balance.roller
        return ActingForces(self.rollers, roller.bearing, roller.raceways.slices, self.floating)

    @property
    def applied_load(self) -> NDArray:
        """Load on the inner ring (C, 2), y and z [N]."""
        return np.concatenate([self.balance.points.load_y, self.balance.points.load_z], axis=1)

    @property
    def ring_moment(self) -> NDArray:
        """Moments (C, 2) [N m] that act on the inner ring from outside: applied, or held by its guide."""
        if self.balance.roller.axial_modes == 1:
            return np.zeros((len(self.scaled), 2))
        kinematics, inner = self.balance.kinematics, self.rollers.contact.force[INNER, :, None]
        moments = np.array(kinematics.tilted(self._along_inner[None], inner))[:, 0]
        if self.rollers.ribs is not None and kinematics.ribs is not None:
            moments = moments + kinematics.ribs.radius * kinematics.outwards[::-1] * self.rollers.ribs.thrust
        return -moments.sum(-1).T

    @property
    def _along_inner(self) -> NDArray:
        """Force of the inner raceway on the rollers along their motion (C, Z) [N]."""
        pressure = 1 - 2 * self.balance.roller.bearing.diameter_ratio  # of the inlet, against its shear
        along = self.traction[:, INNER] + pressure * self.rolling_shear[:, INNER]
        return along if self.rib_friction is None else along + self.rib_friction[:, INNER]

    @property
    def roller_row(self) -> NDArray | None:
        """Number of the row of each roller (C, Z), from 0; None of one row."""
        bearing = self.balance.roller.bearing
        if bearing.row_count == 1:
            return None
        return np.tile(np.arange(bearing.row_count).repeat(bearing.rollers), (len(self.scaled), 1))

    @property
    def roller_station(self) -> NDArray | None:
        """Places of the rollers along the axis (C, Z) [m]; None where all are in the middle of the rings."""
        stations = self.balance.roller.bearing.stations
        return None if stations is None else np.broadcast_to(stations, self.roller_speed.shape)

    @property
    def row_load(self) -> NDArray | None:
        """Force along y and z that each row takes for the inner ring (C, R, 2) [N]; None of one row."""
        if self.balance.layout.rows == 1:
            return None
        pushed = self.balance.kinematics.pushed(self._along_inner[None], self.loads[None, :, INNER])[:, 0]
        return -self._of_rows(pushed).transpose(1, 2, 0)

    @property
    def row_load_factor(self) -> NDArray | None:
        """Largest force that a row takes over an even share of the radial load (C) [-]; None of one row.

        Not a number without a radial load.
        """
        if self.row_load is None:
            return None
        even = np.hypot(*self.applied_load.T) / self.balance.layout.rows
        largest = np.hypot(*np.moveaxis(self.row_load, -1, 0)).max(axis=1)
        return np.divide(largest, even, out=np.full_like(even, np.nan), where=even > 0)

    @property
    def row_loss(self) -> NDArray | None:
        """Power lost by sliding and in the inlets of each row (C, R) [W]; None of one row."""
        if self.balance.layout.rows == 1:
            return None
        rolling = self.rollers.sense.swapaxes(0, 1) * self.entrainment
        return self._of_rows((self.traction * self.sliding + 2 * self.rolling_shear * rolling).sum(1))

    def _of_rows(self, values: NDArray) -> NDArray:
        """Sums (..., R) of values (..., Z) over the rollers of each row."""
        return values.reshape(*values.shape[:-1], self.balance.layout.rows, -1).sum(-1)

    @property
    def land_torque(self) -> NDArray:
        """Torque of the guiding land on the cage (C) [N m]."""
        if self.floating is not None:
            return self.floating.torque
        roller = self.balance.roller
        return land_torque(self._land_speed, roller.bearing.cage, roller.lubrication.oil).torque[:, 0]

    @property
    def _land_speed(self) -> NDArray:
        """Speed of the guiding ring against the cage (C, 1) [rad/s]."""
        guidance = self.balance.roller.bearing.cage.guidance
        return self.balance.points.guiding_speed(guidance) - self._cage_speed

    @cached_property
    def floating(self) -> FloatingCage | None:
        """Where a cage with a free centre floats in its land; None for one that is held."""
        if not self.balance.roller.bearing.cage.free:
            return None
        return self.balance.floating(self.unknowns, self.rollers.pocket)

    @property
    def cage_offset(self) -> NDArray | None:
        """Centre (C, 2) of a free cage from that of its guiding ring [m]; None for one that is held."""
        return None if self.floating is None else self.floating.offset

    @property
    def pocket_displacement(self) -> NDArray | None:
        """Rollers (C, Z) from the centre of their pockets along the motion [m], if its clearance is known."""
        bearing = self.balance.roller.bearing
        if bearing.cage.pocket_clearance is None:
            return None
        roller = bearing.roller
        stop = palmgren(roller.material, roller.material, roller.length) * roller.length
        return displacement_in_pocket(-self.cage_force, bearing.cage.pocket_clearance, stop)

    @property
    def driving_torque(self) -> NDArray:
        """Torque that turns the inner ring (C) [N m], with that of the land if it guides the cage."""
        bearing = self.balance.roller.bearing
        force = (self.traction + self.rolling_shear)[:, INNER]
        torque = (bearing.inner_radius * force).sum(-1) + self._rib_torque(INNER)
        return torque + self.land_torque if bearing.cage.guidance == "inner" else torque

    @property
    def outer_torque(self) -> NDArray:
        """Torque that turns or holds the outer ring (C) [N m], positive along the motion of the cage."""
        bearing = self.balance.roller.bearing
        force = (self.traction - self.rolling_shear)[:, OUTER]
        torque = (bearing.outer_radius * force).sum(-1) + self._rib_torque(OUTER)
        return torque + self.land_torque if bearing.cage.guidance == "outer" else torque

    def _rib_torque(self, race: int) -> NDArray | float:
        """What the rib of a ring adds to its torque (C) [N m]."""
        radii, friction = self.rib_radii, self.rib_friction
        return 0.0 if radii is None or friction is None else radii[:, race] * friction[:, race].sum(-1)

    @property
    def transport(self) -> NDArray:
        """Torque (C, Z) that the change of spin around the bearing takes from each roller [N m]."""
        return self.balance.spin_transport(self.unknowns.cage_drift, self.unknowns.spin_drift).torque

    @cached_property
    def losses(self) -> Losses:
        """Power loss by cause (C) [W]."""
        bearing, rollers, spin = self.balance.roller.bearing, self.rollers, self.roller_speed
        orbit = self._cage_speed * bearing.pitch_diameter / 2 * bearing.all_rollers
        return Losses(
            sliding=(self.traction * self.sliding).sum((1, 2)),
            rolling=2
            * (self.rolling_shear * (rollers.sense * rollers.entrainment).swapaxes(0, 1)).sum((1, 2)),
            drag=(rollers.drag * orbit)[:, 0],
            pocket=(rollers.pocket_brake * spin * bearing.roller.diameter / 2).sum(-1),
            land=self.land_torque * self._land_speed[:, 0],
            churning=(rollers.churning * spin).sum(-1),
            transport=(self.transport * spin).sum(-1),
            ribs=0.0 * self.cage_speed if self.rib_heat is None else self.rib_heat.sum((1, 2)),
        )

    @property
    def driving_power(self) -> NDArray:
        """Power that the rings put in (C) [W]."""
        inner_speed, outer_speed = self.balance.points.ring_speeds[..., 0]
        return self.driving_torque * inner_speed + self.outer_torque * outer_speed

    # -- contacts ------------------------------------------------------------------------------

    @property
    def slice_positions(self) -> NDArray:
        """Centres of the slices (C, K) from mid-roller [m]."""
        centres = self.balance.roller.raceways.slices.all_centres
        return np.broadcast_to(centres, (len(self.scaled), centres.shape[-1]))

    @cached_property
    def slice_pressure(self) -> NDArray:
        """Largest Hertz pressure (C, 2, Z, K) of each slice [Pa]."""
        pair = (each[..., None, None] for each in (self.contact_radius, self.contact_modulus))
        return peak_pressure(self.slice_loads, *pair)

    @property
    def azimuths(self) -> NDArray:
        """Places of the rollers (C, Z) from the load line [rad]."""
        azimuths = self.balance.roller.bearing.azimuths
        return np.broadcast_to(azimuths, (len(self.scaled), azimuths.shape[-1]))

    @property
    def contact_radius(self) -> NDArray:
        """Reduced radius R (C, 2) of the inner and the outer contact [m]."""
        return np.broadcast_to(self.balance.roller.raceways.radius[..., 0].T, (len(self.scaled), 2))

    @property
    def contact_modulus(self) -> NDArray:
        """E' (C, 2) of the inner and the outer contact [Pa]."""
        return np.broadcast_to(self.balance.roller.raceways.modulus[..., 0].T, (len(self.scaled), 2))

    @property
    def peak_pressure(self) -> NDArray:
        """Largest Hertz pressure (C, 2) at the inner and outer raceway [Pa]."""
        return peak_pressure(self.slice_loads.max(axis=(2, 3)), self.contact_radius, self.contact_modulus)

    @cached_property
    def life(self) -> NDArray:
        """Basic reference life L10 (C) [10^6 revolutions]."""
        inner, outer = self._loads_of_slices
        return basic_life(inner, outer, self.balance.roller.bearing, self.turning)

    @property
    def raceway_lives(self) -> NDArray:
        """Basic life (C, 2) of the inner and the outer raceway, each on its own [10^6 revolutions]."""
        inner, outer = self._loads_of_slices
        return raceway_lives(inner, outer, self.balance.roller.bearing, self.turning)

    @cached_property
    def _loads_of_slices(self) -> NDArray:
        """Load (2, C, Z, K) of each slice [N]."""
        width = np.reshape(self.balance.roller.raceways.slices.width, (-1, 1, 1, 1))
        return (self.slice_loads * width).swapaxes(0, 1)

    @property
    def turning(self) -> tuple[NDArray, NDArray]:
        """How far the inner and the outer ring turn against the load (C), 0 standing to 1 [-]."""
        points = self.balance.points
        inner, outer = turning_share(points.ring_speeds, points.relative_speed)[..., 0]
        return inner, outer

    @property
    def friction_intensity(self) -> NDArray:
        """Largest heat of sliding per area (C, 2, Z) [W/m2] of the slices of each contact, skew left out."""
        raceways, rollers = self.balance.roller.raceways, self.rollers
        load = np.moveaxis(rollers.contact.slice_load, -1, 0)  # (K, 2, C, Z)
        pull = raceways.traction(load, rollers.sliding, rollers.entrainment, self.unknowns.film)
        pair = raceways.radius, raceways.modulus
        return friction_intensity(pull.force, rollers.sliding, load, *pair).max(axis=0).swapaxes(0, 1)

    # -- stiffness -----------------------------------------------------------------------------

    @cached_property
    def tangent(self) -> Tangent:
        """Compliance and stiffness of the ring in these states."""
        held = ~self.balance.points.free_tilt[:, 0]
        return Tangent.of(self._free_to_tilt.balance, self._change_by_load, held)

    @property
    def raceway_forces_by_load(self) -> NDArray:
        """Change of roller forces on elastic raceways (C, 4, E, Z, M) by unit loads on a ring free to tilt.

        Loads are those of `Tangent.response`: forces along y and z, moments on the slopes dz/dx and dy/dx.
        """
        free = self._free_to_tilt
        return raceway_forces_by_load(free.balance, free.system, self._change_by_load)

    @cached_property
    def _change_by_load(self) -> NDArray:
        free = self._free_to_tilt
        if self.near is None:
            return change_by_load(free.balance, free.system)
        return change_by_load_near(free.balance, free.system, self.near._load_change)

    @cached_property
    def _load_change(self) -> LoadChange:
        """The same for other states near this one."""
        free = self._free_to_tilt
        return LoadChange(free.balance, free.system, self._change_by_load)

    @cached_property
    def _free_to_tilt(self) -> "BearingStates":
        """These states with a ring that is free to tilt."""
        balance = free_to_tilt(self.balance)
        if balance is self.balance:
            return self
        free = replace(self, balance=balance, scaled=balance.pack(self.unknowns))
        if balance.roller is self.balance.roller:  # rollers do not know who holds the ring
            free.know(balance.evaluate(free.scaled, self.system.response))
        return free


def _lag(drift: NDArray, rolling: NDArray) -> NDArray:
    """How far speeds (C, N) fall short of those in pure rolling (C, 1), as a fraction of these."""
    return np.divide(-drift, rolling, out=np.full(drift.shape, np.nan), where=rolling != 0)
