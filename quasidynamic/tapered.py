"""How tapered rollers share load between rigid or elastic rings, with inertia, raceways without friction."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.inclined import INNER, OUTER, InclinedRollers
from quasidynamic.contact.line.load_law import peak_pressure
from quasidynamic.contact.line.slices import Slices
from quasidynamic.contact.rib import rib_pressure
from quasidynamic.errors import NotSolved
from quasidynamic.motion.tapered_speeds import TaperedSpeeds, tapered_speeds
from quasidynamic.parts.angular_contact_bearing import RingOperation
from quasidynamic.parts.material import contact_modulus
from quasidynamic.parts.tapered_bearing import TaperedRollerBearing
from quasidynamic.solve.rollers.inclined_equilibrium import InclinedSolution, inclined_equilibrium
from quasidynamic.solve.rollers.inclined_raceways import Compliance, between_elastic_raceways

PRESSED = 2.0  # times the approach of evenly loaded rollers: where the search begins, on the safe side


@dataclass(frozen=True)
class TaperedLoads:
    """Ring and rollers in balance. Z rollers, K slices; races are inner, outer."""

    bearing: TaperedRollerBearing
    operation: RingOperation
    slices: Slices
    speeds: TaperedSpeeds
    solution: InclinedSolution

    @property
    def slice_loads(self) -> NDArray:
        """Load per length (2, Z, K) [N/m], from the small end of the rollers to the large one."""
        return self.solution.state.slice_load

    @cached_property
    def loads(self) -> NDArray:
        """Load of the rollers on the raceways (2, Z) [N]."""
        return self.slice_loads @ self.slices.widths

    @cached_property
    def deflection(self) -> tuple[NDArray | None, NDArray | None]:
        """Displacement of elastic raceways at the slices (Z, K) [m] along their normals, into the rings."""
        shape = self.solution.shape
        if shape is None:
            return None, None
        at_slices = shape[..., :-1] @ self.slices.with_axial_modes(shape.shape[-1] - 1).modes.T
        inner, outer = (each if shape[race].any() else None for race, each in enumerate(at_slices))
        return inner, outer

    @property
    def rib_loads(self) -> NDArray:
        """Load of the rollers on the rib (Z) [N]."""
        return self.solution.state.rib_load

    @cached_property
    def roller_tilt(self) -> NDArray:
        """Turn of the rollers (Z) [rad], > 0 lifts the large end."""
        return self.solution.state.rollers[:, 2] / (self.slices.length / 2)

    @cached_property
    def _scale(self) -> NDArray:
        turn = self.bearing.pitch_diameter / 2
        return np.array([1.0, 1.0, 1.0, turn, turn])

    @cached_property
    def displacement(self) -> NDArray:
        """Of the inner ring: x, y, z [m], turns about y and z [rad]."""
        return self.solution.state.ring / self._scale

    @cached_property
    def reaction(self) -> NDArray:
        """Force of the rollers on the inner ring along x, y, z [N] and moments about y, z [N m]."""
        model = self.solution.state.on_ring
        return np.einsum("zde,zd->e", _model(self).sections, model) * self._scale

    @property
    def roller_row(self) -> NDArray | None:
        """Number of the row of each roller (Z); None of one row."""
        count = len(self.bearing.rows)
        return None if count == 1 else np.repeat(np.arange(count), self.bearing.rollers)

    @cached_property
    def row_load(self) -> NDArray:
        """What each row carries for the inner ring along x, y, z (rows, 3) [N]."""
        model = _model(self)
        each = np.einsum("zde,zd->ze", model.sections, self.solution.state.on_ring)
        return -each.reshape(len(self.bearing.rows), -1, 5).sum(1)[:, :3]

    @cached_property
    def load(self) -> NDArray:
        """What carries the inner ring, given loads and reactions where it is held (5) [N, N m]."""
        held = np.array([place is not None for place in self.operation.displacement])
        return np.where(held, -self.reaction, np.array(self.operation.load))

    @cached_property
    def stiffness(self) -> NDArray:
        """Tangent stiffness of the inner ring (5, 5) [N/m, N/rad, N m/m, N m/rad]; all of it, none held."""
        return self.solution.stiffness * np.outer(self._scale, self._scale)

    @cached_property
    def pressures(self) -> NDArray:
        r"""Peak pressure of the slices (2, Z, K) [Pa].

        With the radii at each slice, of the roller R_w = (D/2 + s sin(eps))/cos(eps) and of the raceway
        R_r = (r_m/cos(alpha) -+ R_w) at mid-contact, growing by s tan(alpha); of a barrel with its drop, of a
        hollow raceway of radius r growing by s tan(alpha) (1 +- R_r/r), which is zero of a sphere.

        Source
        ------
        Hertz; normal curvature of a cone, and of a ring that an arc sweeps.
        """
        radii = np.array([self.reduced_radius(race) for race in (INNER, OUTER)])[:, None]
        return peak_pressure(self.slice_loads, radii, self.moduli[:, None, None])

    @cached_property
    def moduli(self) -> NDArray:
        """E' of the inner and outer contact (2) [Pa]."""
        rings = (self.bearing.inner_ring, self.bearing.outer_ring)
        return np.array([contact_modulus(self.bearing.roller.material, ring) for ring in rings])

    def reduced_radius(self, race: int) -> NDArray:
        """Reduced radius along a contact (K) [m], race 0 inner, 1 outer; see `pressures`."""
        bearing, s = self.bearing, self.slices.centres
        angle, sign = (bearing.cone_angle, 1.0) if race == INNER else (bearing.cup_angle, -1.0)
        taper, middle = bearing.taper, bearing.roller.diameter / 2 / np.cos(bearing.taper)
        roller, hollow = middle + s * np.tan(taper), bearing.hollows[race]
        raceway = bearing.pitch_diameter / 2 / np.cos(angle) - sign * middle
        raceway = raceway + s * np.tan(angle) * (1 + sign * raceway * hollow)
        if hollow:
            roller = roller - bearing.roller.profile.drop(s, bearing.roller.length)
        return 1 / (1 / roller + sign / raceway)

    @cached_property
    def rib_pressures(self) -> NDArray:
        """Peak pressure of the rib contacts (Z) [Pa]."""
        return rib_pressure(self.rib_loads, self.bearing.rib.curvature, self._rib_modulus)

    @cached_property
    def _rib_modulus(self) -> float:
        """E* of end and rib [Pa]."""
        return contact_modulus(self.bearing.roller.material, self.bearing.inner_ring) / 2

    @cached_property
    def rib_reach(self) -> NDArray:
        r"""Farthest point of the rib contact from the roller's axis (Z) [m].

        .. math:: |b| + a,\quad a = \Big( \frac{3 Q_f R_s}{4 E^*} \Big)^{1/3}

        Source
        ------
        Johnson, Contact Mechanics (1985), sec. 4.2: a sphere on a flat face.
        """
        rib, modulus = self.bearing.rib, self._rib_modulus
        radius = np.cbrt(3 * self.rib_loads / (4 * modulus * rib.curvature)) if rib.curvature else 0.0
        return np.abs(rib.depth) + radius + 0 * self.rib_loads


def tapered_loads(
    bearing: TaperedRollerBearing,
    operation: RingOperation,
    slices: int = 40,
    raceways: Sequence[Compliance] = (None, None),
) -> TaperedLoads:
    r"""Balance of rollers and inner ring, the outer ring standing still in its place or giving way.

    .. math:: Q_o N_o + Q_i N_i + Q_f N_f = (0, F_c),\quad M_o - M_i + h Q_f = M_g,

    and the forces on the inner ring by virtual work. Centrifugal force and gyroscopic moment depend on the
    speeds of pure rolling alone: all forces are those of one convex energy, and the stiffness is symmetric.

    Parameters
    ----------
    bearing : TaperedRollerBearing
        geometry, materials and load law
    operation : RingOperation
        load or displacement in each direction, and speeds; the axial force acts towards its `side`
    slices : int
        number of slices of each roller
    raceways : sequence of arrays (Z, M + 1, Z, M + 1) and (Z, M, Z, M)
        compliance of the inner and the outer raceway [m/N]: displacement along the normal into the ring by
        forces along it, both in Legendre modes of the place towards the large end, without that of a
        half-space under the own line; last of the inner one the mean along the raceway, towards the rib; None
        of a rigid one

    Raises
    ------
    NotSolved
        when nothing holds the ring, or no balance is found

    Source
    ------
    Statics of rigid bodies; the load law of cylindrical rollers for every slice, see `InclinedRollers`.

    Valid
    -----
    Rigid or linear rings, the rib on the section of the inner one; raceways and rib without friction; no film
    between roller and raceway, no cage. Contact begins smoothly over `gap_rounding`.
    """
    speeds = tapered_speeds(bearing, operation.inner_speed, operation.outer_speed)
    sliced = Slices(slices, bearing.roller.length)
    _require_thrust(bearing, operation, speeds.centrifugal_force)
    _require_footing(bearing, operation)
    dead = np.array([*_inertia(bearing, speeds), speeds.gyroscopic_moment / (sliced.length / 2)])
    model = InclinedRollers.of(bearing, sliced, dead)
    turn = bearing.pitch_diameter / 2
    load = np.array(operation.load) / [1.0, 1.0, 1.0, turn, turn]
    held = np.array([place is not None for place in operation.displacement])
    start = _start(bearing, operation, model, load)
    if all(raceway is None for raceway in raceways):
        solution = inclined_equilibrium(model, load, held, start)
    else:
        solution = between_elastic_raceways(model, load, held, start, raceways)
    return TaperedLoads(bearing, operation, sliced, speeds, solution)


def _model(loads: TaperedLoads) -> InclinedRollers:
    return InclinedRollers.of(loads.bearing, loads.slices, np.zeros(3))


def _inertia(bearing: TaperedRollerBearing, speeds: TaperedSpeeds) -> NDArray:
    """Centrifugal force along the axis and outwards (2) [N]; without a rib what raceways carry of it."""
    force, normal = speeds.centrifugal_force, np.array([-bearing.up, bearing.along])
    return np.array([0.0, force]) if bearing.rib.stiffness else force * bearing.along * normal


def least_thrust(bearing: TaperedRollerBearing, radial: float, centrifugal: float) -> float:
    r"""Axial load below which the cone leaves the cup.

    .. math:: F_x = F_r \tan\alpha_o + Z F_c \frac{\sin\alpha_o}{\cos\alpha_o + \sin\alpha_o \tan\alpha_f}

    The outer contacts carry both loads; those that the rib and centrifugal force alone press carry the
    second part.

    Parameters
    ----------
    bearing : TaperedRollerBearing
        Z, angles of cup and rib
    radial : float
        F_r [N]
    centrifugal : float
        F_c on a roller [N]

    Returns
    -------
    float
        F_x [N]

    Source
    ------
    Statics of rollers and ring, derived here.

    Valid
    -----
    Necessary at any place of the ring; sufficient where the ring may not tilt and rollers are many.
    """
    cup, rib = bearing.cup_angle, bearing.rib.angle
    pressed = centrifugal / (np.cos(cup) + np.sin(cup) * np.tan(rib))
    return float(radial * np.tan(cup) + bearing.all_rollers * pressed * np.sin(cup))


def _require_thrust(bearing: TaperedRollerBearing, operation: RingOperation, centrifugal: float) -> None:
    """Raise where the axial load is below `least_thrust`."""
    axial, y, z, *_ = operation.load
    held = [place is not None for place in operation.displacement]
    if held[0] or bearing.opposed:
        return
    least = least_thrust(bearing, float(np.hypot(0.0 if held[1] else y, 0.0 if held[2] else z)), centrifugal)
    if bearing.side * axial <= least:
        raise NotSolved(
            f"axial load of {bearing.side * axial:.4g} N towards the cup: above {least:.4g} N are needed, "
            "for the radial load and the centrifugal force of the rollers, or the cone leaves the cup; "
            "give a larger operation.load.axial, or hold the ring by operation.displacement.axial",
            "undetermined",
        )


def _require_footing(bearing: TaperedRollerBearing, operation: RingOperation) -> None:
    """Raise where a load on rollers between washers acts beyond their outer ends, and may tilt the ring."""
    axial, *_, about_y, about_z = operation.load
    free = [place is None for place in operation.displacement]
    lever = (bearing.pitch_diameter + bearing.roller.length) / 2
    if bearing.cone_angle < np.pi / 2 or not (free[0] and free[3] and free[4]):
        return
    if (turning := float(np.hypot(about_y, about_z))) >= abs(axial) * lever:
        raise NotSolved(
            f"a moment of {turning:.4g} N m on {abs(axial):.4g} N tips the ring over the outer ends of the "
            f"rollers, {1e3 * lever:.4g} mm off the axis; make it smaller, or hold operation.tilt",
            "undetermined",
        )


def _start(
    bearing: TaperedRollerBearing, operation: RingOperation, model: InclinedRollers, load: NDArray
) -> NDArray:
    """First place of the ring (5) [m], pressed into the rollers as far as it will be, or further."""
    places = np.array([place or 0.0 for place in operation.displacement])
    places[3:] *= bearing.pitch_diameter / 2
    held = np.array([place is not None for place in operation.displacement])
    steep = max(np.sin(bearing.cup_angle), 0.02)
    even = max(abs(load[0]) / steep, 5 * float(np.hypot(load[1], load[2])), 2 * np.abs(load[3:]).max())
    line_load = np.asarray(even / bearing.rollers / bearing.roller.length)
    approach = PRESSED * (float(np.max(model.law.approach(line_load))) + float(np.mean(model.drops)))
    pressed = bearing.side * places[0]
    if bearing.opposed:
        pressed = bearing.rows[0].closer  # by each other, or apart by a play that the thrust takes up
        places[0] = places[0] if held[0] else np.sign(load[0]) * max(-pressed, 0.0)
    elif not held[0]:
        places[0] = bearing.side * (approach + model.gap) / steep
        return places
    if not held[1:3].all() and (radial := float(np.hypot(load[1], load[2]))):
        push = approach + model.gap - pressed * np.sin(bearing.cup_angle)
        places[1:3] += np.where(held[1:3], 0.0, max(push, 0.0) * load[1:3] / radial)
    return places
