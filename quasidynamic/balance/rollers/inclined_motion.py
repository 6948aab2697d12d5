"""Balance of tapered rollers about their own axes, and of their cages, by friction at given loads."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.kinematics import SpinTransport, spin_transport
from quasidynamic.balance.rollers.roller import POCKET_ROUNDING, POCKET_STANDSTILL, RIB_CREEP, STANDSTILL
from quasidynamic.contact.cage import land_torque
from quasidynamic.contact.drag import churning_torque
from quasidynamic.contact.drag.orbit_drag import roller_drag_force
from quasidynamic.contact.film import FilmLaw, starved_film
from quasidynamic.contact.line.load_law import SMALLEST_LOAD
from quasidynamic.contact.line.slices import Slices
from quasidynamic.contact.lubrication import Lubrication
from quasidynamic.motion.tapered_speeds import TaperedSpeeds
from quasidynamic.parts.roller_bearing import Cage
from quasidynamic.parts.tapered_bearing import TaperedRollerBearing

SIDE = np.array([1.0, -1.0])[:, None, None]  # of the roller's surface along its motion: inner, outer contact


class MotionState(NamedTuple):
    """Friction of moving rollers: Z rollers, K slices, R rows with a cage each; inner race first."""

    spin: NDArray  # (Z) against the cage [rad/s]
    orbit: NDArray  # (Z) speed of the roller's cage [rad/s]
    sliding: NDArray  # (2, Z, K) raceway over roller [m/s]
    rolling: NDArray  # (2, Z, K) mean of both surface speeds, signed [m/s]
    film: NDArray  # (2, Z, K) [m]
    traction: NDArray  # (2, Z, K) on the roller, along the motion [N]
    shear: NDArray  # (2, Z, K) of the inlet on either surface, signed like the rolling [N]
    rib_sliding: NDArray  # (Z) rib over the roller's end, along the motion [m/s]
    rib_force: NDArray  # (Z) of the rib on the roller, along the motion [N]
    drag: NDArray  # (Z) of the mixture, against the motion [N]
    churning: NDArray  # (Z) torque against the spin, signed like it [N m]
    pocket_force: NDArray  # (Z) of the pocket on the roller, along the motion [N]
    pocket_brake: NDArray  # (Z) friction of the pocket against the spin, signed like it [N]
    transport: NDArray  # (Z) torque that the change of spin around the bearing takes [N m]
    on_raceways: NDArray  # (2, Z) torque of raceways and rib on the roller about the bearing's axis [N m]
    land: NDArray  # (R) torque of the land on the cage [N m]
    imbalance: NDArray  # (Z + R) torque that is left on the spins and on the cages [N m]
    slopes: NDArray  # (Z + R, Z + R) of it by spins and cage speeds [N m s]


@dataclass(frozen=True, kw_only=True)
class InclinedMotion:
    r"""Equations of spins w and cage speeds omega_c of rollers under given loads.

    With the speeds of raceways and rollers at places s of a contact, in the frame of the cage,

    .. math:: v_r = (\Omega - \omega_c)(r + s \sin\alpha),\quad v_w = \pm w (D/2 + s \sin\varepsilon),

    slices slide by u = v_r - v_w and roll by (v_r + v_w)/2. Tractions T and shear S of the inlets are in
    balance with rib, churning, pocket and the change of the spin about the axis of each roller,

    .. math:: \sum \pm \rho\,(T - S) + b F_f - M_C - \mu_p |F_p| \tfrac D2 = J \omega_c \frac{dw}{d\varphi}

    and all rollers of a row with its cage about the axis of the bearing,

    .. math:: \sum_j \Big[ \sum r\,(T + S) + r_f F_f - r_m F_D \Big] + M_L = 0

    The force of the pocket follows from that along the orbit, where 2 S r/r_w is the pressure of the inlet
    through the axis of the roller, which is r_w from that of the bearing:

    .. math:: F_p = F_D - \sum [T + (2 r/r_w - 1) S] - F_f

    Source
    ------
    Statics and kinematics of rigid bodies, derived here; angle zero has the equations of `RollerBalance`.

    Valid
    -----
    Loads are those without friction. Moments that would skew the rollers are left to cage and rib without
    friction; rollers have no weight.
    """

    bearing: TaperedRollerBearing
    slices: Slices
    ring_speeds: tuple[float, float]  # [rad/s] inner, outer
    pure_rolling: TaperedSpeeds
    slice_loads: NDArray  # (2, Z, K) [N/m]
    rib_loads: NDArray  # (Z) [N]
    radius: NDArray  # (2, 1, K) [m] reduced
    modulus: NDArray  # (2, 1, 1) [Pa] E'
    lubrication: Lubrication
    rib_friction: float  # [-] Coulomb
    cage: Cage

    # -- motion --------------------------------------------------------------------------------

    @cached_property
    def radii(self) -> tuple[NDArray, NDArray]:
        """Of the raceways from the axis of the bearing, and of the roller from its own (2, 1, K) [m]."""
        bearing, s = self.bearing, self.slices.centres
        cone, cup = np.sin([bearing.cone_angle, bearing.cup_angle])
        raceways = np.array([bearing.inner_radius + s * cone, bearing.outer_radius + s * cup])
        roller = bearing.roller.diameter / 2 + s * np.sin(bearing.taper)
        return raceways[:, None], np.broadcast_to(roller, (2, 1, len(s)))

    @cached_property
    def _pressure_share(self) -> NDArray:
        """Force along the orbit per shear of the inlet on the roller (2, 1, K) [-], with its pressure."""
        raceways, rollers = self.radii
        up = np.cos([self.bearing.cone_angle, self.bearing.cup_angle])[:, None, None]
        return 2 * raceways / (raceways + SIDE * rollers * up) - 1

    @cached_property
    def _geometric_sliding(self) -> NDArray:
        """Sliding in pure rolling (2, 1, K) [m/s], zero in the middle of the contacts."""
        s, bearing = self.slices.centres, self.bearing
        cones = np.sin([bearing.cone_angle, bearing.cup_angle])[:, None, None]
        rings = (np.array(self.ring_speeds) - self.pure_rolling.orbit)[:, None, None]
        return s * (rings * cones - SIDE * self.pure_rolling.spin * np.sin(bearing.taper))

    @cached_property
    def _slowest(self) -> float:
        """Mean surface speed [m/s] that counts as none."""
        inner, outer = self.ring_speeds
        return STANDSTILL * self.bearing.inner_radius * abs(inner - outer)

    @cached_property
    def smallest_load(self) -> NDArray:
        """Load per length (2, 1, K) [N/m] under which a film is held."""
        return SMALLEST_LOAD * self.modulus * self.radius

    @cached_property
    def _film_load(self) -> NDArray:
        return np.hypot(self.slice_loads, self.smallest_load)

    @cached_property
    def _laws(self):
        laws, slices = self.lubrication, self.slices
        film = FilmLaw(
            formula=laws.film,
            radius=self.radius,
            modulus=self.modulus,
            oil=laws.oil,
            inlet_heating=laws.inlet_heating,
        )
        contact = {"radius": self.radius, "modulus": self.modulus, "length": slices.length, "oil": laws.oil}
        return film, laws.traction(**contact)

    def state(self, spin_drift: NDArray, cage_drift: NDArray) -> MotionState:
        """Friction and balance of rollers whose spins (Z) and cages (R) differ from pure rolling [rad/s].

        Forces are arrays (3, ...): values, slopes by spin, slopes by cage speed.
        """
        bearing, (raceways, rollers) = self.bearing, self.radii
        drift = np.repeat(cage_drift, bearing.rollers)
        spin, orbit = self.pure_rolling.spin + spin_drift, self.pure_rolling.orbit + drift
        sliding, rolling = self._surfaces(spin_drift, drift)
        film, traction, shear = self._at_slices(sliding, rolling)
        rib_sliding, rib = self._rib(spin_drift, drift)
        drag, churning = self._drag(orbit), self._churning(spin)
        middle, lever = bearing.pitch_diameter / 2, bearing.roller.diameter / 2
        on_raceways = (raceways * (traction + shear)).sum(-1)
        on_raceways[:, 0] += bearing.rib_radius * rib
        about_bearing = on_raceways.sum(1) - middle * drag
        pocket = drag - (traction + self._pressure_share * shear).sum((1, 3)) - rib
        brake = self._pocket_brake(pocket, spin)
        about_roller = (SIDE * rollers * (traction - shear)).sum((1, 3))
        about_roller += bearing.rib.depth * rib - churning - lever * brake
        transport, land = self._transport(spin_drift, cage_drift), self._land(cage_drift)
        on_cages = about_bearing[0].reshape(len(cage_drift), -1).sum(1) + land[0]
        return MotionState(
            spin=spin,
            orbit=orbit,
            sliding=sliding,
            rolling=rolling,
            film=film,
            traction=traction[0],
            shear=shear[0],
            rib_sliding=rib_sliding,
            rib_force=rib[0],
            drag=drag[0],
            churning=churning[0],
            pocket_force=pocket[0],
            pocket_brake=brake[0],
            transport=transport.torque.ravel(),
            on_raceways=on_raceways[0],
            land=land[0],
            imbalance=np.concatenate([about_roller[0] - transport.torque.ravel(), on_cages]),
            slopes=_slopes(about_roller[1:], about_bearing[1:], transport, land[1]),
        )

    # -- forces --------------------------------------------------------------------------------

    def _surfaces(self, spin_drift: NDArray, drift: NDArray) -> tuple[NDArray, NDArray]:
        """Sliding and mean surface speed (2, Z, K) [m/s]; nothing large cancels in the sliding."""
        raceways, rollers = self.radii
        drifts = raceways * drift[:, None], SIDE * rollers * spin_drift[:, None]
        rings = (np.array(self.ring_speeds) - self.pure_rolling.orbit)[:, None, None]
        rolling = (rings * raceways + SIDE * rollers * self.pure_rolling.spin - drifts[0] + drifts[1]) / 2
        return self._geometric_sliding - drifts[0] - drifts[1], rolling

    def _at_slices(self, sliding: NDArray, rolling: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """Film (2, Z, K) [m]; traction and shear of the inlets (3, 2, Z, K) [N], signed like the rolling."""
        laws, widths, (raceways, rollers) = self.lubrication, self.slices.widths, self.radii
        film_law, traction_law = self._laws
        entrainment = np.hypot(rolling, self._slowest)
        sense = rolling / entrainment
        film = film_law(self._film_load, sliding, entrainment)
        if laws.inlet_length is not None:
            film = starved_film(film, self._film_load, self.radius, self.modulus, laws.inlet_length)
        pull = traction_law(self.slice_loads, sliding, entrainment, film.thickness)
        by_sliding = pull.by_sliding + pull.by_film * film.by_sliding
        by_rolling = sense * (pull.by_entrainment + pull.by_film * film.by_entrainment) / 2
        slopes = SIDE * rollers * (by_rolling - by_sliding), -raceways * (by_rolling + by_sliding)
        geometry = self.radius, self.modulus, widths
        inlet = laws.rolling(self.slice_loads * widths, entrainment, geometry, laws.oil)
        turning = (1 - sense * sense) / entrainment * inlet.force + sense * sense * inlet.by_entrainment
        shear = sense * inlet.force, SIDE * rollers * turning / 2, -raceways * turning / 2
        return film.thickness, np.array([pull.force, *slopes]) * widths, np.array(shear)

    def _rib(self, spin_drift: NDArray, drift: NDArray) -> tuple[NDArray, NDArray]:
        """Sliding (Z) [m/s] and friction (3, Z) [N], rounded through rest, see `RIB_CREEP`."""
        in_rolling, depth, radius = (
            self.pure_rolling.rib_sliding,
            self.bearing.rib.depth,
            self.bearing.rib_radius,
        )
        sliding = in_rolling - drift * radius - spin_drift * depth
        creep = np.hypot(RIB_CREEP * in_rolling, self._slowest)
        size, limit = np.hypot(sliding, creep), self.rib_friction * self.rib_loads
        slope = limit * (creep / size) ** 2 / size
        return sliding, np.array([limit * sliding / size, -depth * slope, -radius * slope])

    def _drag(self, orbit: NDArray) -> NDArray:
        """Force of the mixture on rollers (3, Z) [N]."""
        laws, roller, middle = self.lubrication, self.bearing.roller, self.bearing.pitch_diameter / 2
        area = roller.length * max(roller.diameter - self.cage.thickness, 0.0)
        stream = laws.oil, laws.oil_fraction, laws.drag_coefficient
        force, by_speed = roller_drag_force(orbit * middle, area, roller.diameter, *stream)
        return np.array([force, np.zeros_like(force), by_speed * middle])

    def _churning(self, spin: NDArray) -> NDArray:
        """Torque of the mixture against the spin (3, Z) [N m]; zero without a gap."""
        laws, churning = self.lubrication, np.zeros((3, len(spin)))
        if laws.churning_gap is not None:
            gap, fraction = laws.churning_gap, laws.oil_fraction
            churning[:2] = churning_torque(
                spin, self.bearing.roller, laws.oil, oil_fraction=fraction, gap=gap
            )
        return churning

    def _pocket_brake(self, pocket: NDArray, spin: NDArray) -> NDArray:
        """Friction of pockets (3, Z) [N] by their forces, rounded as that of cylindrical rollers."""
        smallest = self.smallest_load[0].mean() * self.slices.length
        share = pocket[0] / np.hypot(pocket[0], POCKET_ROUNDING * smallest)
        speed = np.hypot(spin, POCKET_STANDSTILL * self.pure_rolling.spin)
        sense, size = spin / speed, pocket[0] * share
        brake = sense * share * (2 - share * share) * pocket
        brake[0] = sense * size
        brake[1] += (1 - sense * sense) / speed * size
        return self.cage.pocket_friction * brake

    def _transport(self, spin_drift: NDArray, cage_drift: NDArray) -> SpinTransport:
        """Torque that the change of spin takes, rows as cases."""
        spins = spin_drift.reshape(len(cage_drift), -1)
        orbit = self.pure_rolling.orbit + cage_drift[:, None]
        return spin_transport(spins, orbit, np.asarray(self.pure_rolling.spin), self.bearing.roller.inertia)

    def _land(self, cage_drift: NDArray) -> NDArray:
        """Torque of the land on the cages, and its slope by their speed (2, R) [N m]."""
        guide = self.ring_speeds[self.cage.guidance == "outer"]
        ahead = guide - (self.pure_rolling.orbit + cage_drift)
        land = land_torque(ahead, self.cage, self.lubrication.oil)
        return np.array([land.torque, -land.by_speed])


def _slopes(own_by: NDArray, about_by: NDArray, carried: SpinTransport, land_by_cage: NDArray) -> NDArray:
    """Slopes (Z + R, Z + R) of all balances, from those of rollers (2, Z) by spin and cage speed."""
    rows, count = carried.torque.shape
    rollers = rows * count
    slopes = np.zeros((rollers + rows, rollers + rows))
    each, row = np.arange(rollers), np.repeat(np.arange(rows), count)
    before, after = (row * count + (each + step) % count for step in (-1, 1))
    slopes[each, each] = own_by[0] - carried.by_spin[row, 0]
    slopes[each, before] += carried.by_before[row, 0]
    slopes[each, after] += carried.by_after[row, 0]
    slopes[each, rollers + row] = own_by[1] - carried.by_cage.ravel()
    slopes[rollers + row, each] = about_by[0]
    at = rollers + np.arange(rows)
    slopes[at, at] = about_by[1].reshape(rows, count).sum(1) + land_by_cage
    return slopes
