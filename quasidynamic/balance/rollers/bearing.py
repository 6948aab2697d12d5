"""Balance of the whole bearing: rollers, ring, cage, and elastic raceways."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.floating_cage import FloatingCage, floating_cage
from quasidynamic.balance.rollers.kinematics import (
    ApproachKinematics,
    RibLevers,
    SpinTransport,
    spin_transport,
)
from quasidynamic.balance.rollers.operating_points import OperatingPoints
from quasidynamic.balance.rollers.roller import (
    POCKET_STANDSTILL,
    VALUE,
    Motion,
    Response,
    RollerBalance,
    RollerInputs,
    RollerState,
)
from quasidynamic.balance.rollers.unknowns import (
    ANGLE,
    CAGE,
    OUTER,
    OUTWARD,
    SHIFT,
    TILT_Y,
    TILT_Z,
    Scales,
    UnknownLayout,
    Unknowns,
    Y,
    Z,
)
from quasidynamic.contact.cage import land_torque
from quasidynamic.contact.rib import EXPONENT as RIB_EXPONENT


class Linearisation(NamedTuple):
    """Scaled residual of C cases and its derivatives, block by block.

    Columns of `table[row, column]` (.., C, Z) are the unknowns of a roller, the last of them its spin, then
    those of the border, which are ring and cage, and the deviations that act on it at this roller. Rows are
    the balances of the roller, its part in the B balances of the border, and its forces on elastic
    raceways.
    """

    residual: NDArray  # (C, N)
    table: NDArray  # (rows, columns, C, Z)
    border: NDArray  # (C, B, B) border balances by border unknowns, without any roller
    before: NDArray  # (C, 1) balance of spin by the spin of the roller before
    after: NDArray  # (C, 1) the same for the roller after
    loading: NDArray  # (C) largest roller load over the reference force, at least 1
    cage_speed: NDArray  # (C) over its scale, without sign
    response: Response  # of the rollers, by their own inputs

    def of(self, cases: NDArray) -> "Linearisation":
        """Equations of some of the cases, for linear solves; the response of rollers stays that of all."""
        along = {"residual", "border", "before", "after", "loading", "cage_speed"}
        taken = {name: getattr(self, name)[cases] for name in along}
        return self._replace(table=self.table[:, :, cases], **taken)

    @property
    def state(self) -> RollerState:
        """What happens at the rollers."""
        return self.response.state


@dataclass(frozen=True, kw_only=True)
class BearingBalance:
    """Residuals that vanish at equilibrium, as a function of scaled unknowns (C, N).

    Speeds of the cage and of the rollers are unknown as differences from pure rolling, so that small slips
    keep their digits; `UnknownLayout` has the order of the unknowns.
    """

    roller: RollerBalance
    points: OperatingPoints
    compliance: tuple[NDArray | None, NDArray | None] = (None, None)  # inner, outer (Z M, Z M) [m/N]
    deviation: NDArray | None = None  # (2, Z, M) or (C, 2, Z, M) given shape of the raceways, outward [m]
    spin_inertia: bool = True

    def take(self, cases: NDArray) -> "BearingBalance":
        """Balance of some of the cases."""
        roller = self.roller.take(cases) if len(self.points) > 1 else self.roller
        points, deviation = self.points.take(cases), self.deviation
        if deviation is not None and deviation.ndim == 4:
            deviation = deviation[cases] if len(points) > 1 else deviation[cases][0]
        return replace(self, points=points, roller=roller, deviation=deviation)

    @cached_property
    def layout(self) -> UnknownLayout:
        """Order of the unknowns."""
        races = tuple(race for race, matrix in enumerate(self.compliance) if matrix is not None)
        return UnknownLayout(
            rollers=self.roller.bearing.all_rollers,
            axial_modes=self.roller.axial_modes,
            elastic_raceways=races,
            rows=self.roller.bearing.row_count,
            ribs=self.roller.on_ribs,
        )

    @cached_property
    def scales(self) -> Scales:
        """Scales of unknowns and residuals."""
        return Scales(layout=self.layout, roller=self.roller, points=self.points)

    @cached_property
    def kinematics(self) -> ApproachKinematics:
        """Approaches of the rollers by ring and raceways."""
        bearing = self.roller.bearing
        return ApproachKinematics(
            layout=self.layout,
            azimuths=bearing.azimuths,
            half_length=self.roller.raceways.slices.length / 2,
            stations=bearing.stations,
            ribs=self._rib_levers,
        )

    @property
    def _rib_levers(self) -> RibLevers | None:
        bearing, ribs = self.roller.bearing, self.roller.bearing.ribs
        if not self.layout.ribs or ribs is None:
            return None
        return RibLevers(radius=bearing.inner_radius + ribs.inner_height, distance=bearing.rib_distance)

    @cached_property
    def weight(self) -> NDArray:
        """Weight of the rollers (2, C, Z), outwards and along the motion [N]."""
        return self.roller.weight(self.points)

    @cached_property
    def slow_cage(self) -> NDArray:
        """Cage speed (C, 1) [rad/s] below which a roller's weight may pull it off the outer raceway.

        Twice its weight, with the friction of the pocket that holds it, is its centrifugal force there.
        """
        bearing, gravity = self.roller.bearing, np.hypot(self.points.gravity_y, self.points.gravity_z)
        return np.sqrt(4 * gravity * (1 + bearing.cage.pocket_friction) / bearing.pitch_diameter)

    @property
    def rolling_cage(self) -> NDArray:
        """Cage speed in pure rolling (C, 1) [rad/s]."""
        return self.scales.rolling_cage

    @property
    def rolling_spin(self) -> NDArray:
        """Roller spin in pure rolling (C, 1) [rad/s]."""
        return self.scales.rolling_spin

    def unpack(self, scaled: NDArray) -> Unknowns:
        """Unknowns in SI units from scaled ones (C, N)."""
        return self.layout.split(scaled * self.scales.unknown)

    def pack(self, unknowns: Unknowns) -> NDArray:
        """Scaled unknowns (C, N), the inverse of `unpack`; what this balance does not know is left out."""
        return self.layout.joined(unknowns) / self.scales.unknown

    @cached_property
    def undetermined(self) -> NDArray:
        """Whether nothing holds the ring (C): neither load nor moment, and every roller with its gap."""
        points = self.points
        idle = (points.load == 0) & (points.moment == 0)
        if self.deviation is not None or self.layout.elastic_raceways or not idle.any():
            return np.zeros(len(points), bool)
        bearing = self.roller.bearing
        from_middle = bearing.roller.length / 2
        if bearing.stations is not None:
            from_middle = from_middle + np.abs(bearing.stations)
        reach = np.hypot(points.slope_y, points.slope_z) * from_middle
        return (idle & (2 * reach <= bearing.clearances)).all(axis=1)

    @cached_property
    def even_shift(self) -> NDArray:
        """Shift of the ring (C, 1) [m] at which untilted rollers share the axial load evenly."""
        thrust = self.points.axial_load
        if not self.layout.ribs:
            return np.zeros_like(thrust)
        each = np.abs(thrust) / self.layout.rollers / self.roller.rib_stiffness
        return np.sign(thrust) * each ** (1 / RIB_EXPONENT)

    # -- approaches and speeds -----------------------------------------------------------------

    def inputs(self, x: Unknowns) -> RollerInputs:
        """Inputs of the rollers."""
        closing = self.kinematics.closing(x, self._deviation(x)) if self.layout.ribs else None
        motion = self.motion(x.cage_drift, x.spin_drift)
        return RollerInputs(self.approach(x), x.film, motion, self.weight, closing)

    def approach(self, x: Unknowns) -> NDArray:
        """Approaches of the rollers by axial modes (2, M, C, Z) at inner and outer raceway [m].

        Outward deviations move the raceways towards (inner) or away from them.
        """
        approach = self.kinematics.approach(x, self.roller.bearing.clearances)
        deviation = self._deviation(x)
        if deviation is not None:
            self.kinematics.deviate(approach, deviation)
        return approach

    def _deviation(self, x: Unknowns) -> NDArray | None:
        """Outward deviations (2, M, C, Z) [m] of both raceways, given and by forces; None of even ones."""
        if self.deviation is None:
            return x.deviation if self.layout.elastic_raceways else None
        given = self.deviation.reshape(-1, *self.deviation.shape[-3:])  # one, or one for each case
        return x.deviation + given.transpose(1, 3, 0, 2)

    def speeds(self, x: Unknowns) -> tuple[NDArray, NDArray]:
        """Spins (C, Z) and cage speed (C, 1) [rad/s]."""
        motion = self.motion(x.cage_drift, x.spin_drift)
        return motion.spin, motion.cage_speed

    def motion(self, cage_drift: NDArray, spin_drift: NDArray) -> Motion:
        """Motion of the rollers with these drifts (C, 1), (C, Z) [rad/s]."""
        spin, cage_speed = self.rolling_spin + spin_drift, self.rolling_cage + cage_drift
        return Motion(spin_drift, cage_drift, spin, cage_speed, POCKET_STANDSTILL * self.rolling_spin)

    # -- evaluation ----------------------------------------------------------------------------

    def evaluate(self, scaled: NDArray, response: Response | None = None) -> Linearisation:
        """Residual and derivatives at scaled unknowns (C, N); the `response` of rollers may be known."""
        # A trial step may be absurd: what overflows shows in its residual.
        with np.errstate(all="ignore"):
            return self._evaluated(scaled, response)

    def _evaluated(self, scaled: NDArray, response: Response | None) -> Linearisation:
        ring, scales, x = self.layout.per_roller, self.scales, self.unpack(scaled)
        if response is None:
            response = self.roller.respond(self.inputs(x), self.points)
        balances, floating = self.kinematics.rows(response.table, self.points.free_tilt), None
        if self.roller.bearing.cage.free:
            floating = self._add_floating_cage(x, response.table, balances)
        values, table = balances[:, VALUE], self.kinematics.columns(balances)
        transport = self.spin_transport(x.cage_drift, x.spin_drift)
        values[ring - 1] -= transport.torque
        table[ring - 1, ring - 1] -= transport.by_spin
        table[ring - 1, ring + CAGE] -= transport.by_cage
        cage_speed = self.rolling_cage + x.cage_drift
        border, border_by = self._border(x.ring[TILT_Z:CAGE, :, 0], cage_speed, floating)
        border += values[ring : ring + self.layout.border].sum(-1)
        residual = [border.T, values[:ring].transpose(1, 0, 2).reshape(len(scaled), -1)]
        residual += self._misfits(x, values[ring + self.layout.border :])
        table *= scales.table
        return Linearisation(
            residual=np.concatenate(residual, axis=1) / scales.residual,
            table=table,
            border=border_by * scales.border,
            before=transport.by_before * scales.spin,
            after=transport.by_after * scales.spin,
            loading=np.maximum(1.0, response.state.contact.force[OUTER, 0].max(-1) / scales.force[:, 0]),
            cage_speed=np.abs(cage_speed / scales.unknown[:, [CAGE]])[:, 0],
            response=response,
        )

    def spin_transport(self, cage_drift: NDArray, spin_drift: NDArray) -> SpinTransport:
        """What the change of spin around the bearing takes at these drifts (C, 1), (C, Z) [rad/s]."""
        inertia = self.roller.bearing.roller.inertia if self.spin_inertia else 0.0
        cage_speed, rows = self.rolling_cage + cage_drift, self.layout.rows
        return spin_transport(spin_drift, cage_speed, self.rolling_spin, inertia, rows)

    def floating(self, x: Unknowns, pockets: NDArray) -> FloatingCage:
        """Cage in its land; `pockets` (2, C, Z) [N] push rollers along the motion and outwards."""
        push = self.kinematics.pushed(*pockets[:, None])[:, 0].sum(-1).T
        bearing = self.roller.bearing
        cage_speed = self.speeds(x)[1]
        return floating_cage(push, cage_speed, self.points, bearing.cage, self.roller.lubrication.oil)

    def _add_floating_cage(self, x: Unknowns, response: NDArray, balances: NDArray) -> FloatingCage:
        """Add the land's torque by the pockets' push; a guiding inner ring carries that push."""
        ring = self.layout.per_roller
        pockets = response[ring + 2 : ring + 4]
        floating, push = self.floating(x, pockets[:, VALUE]), self.kinematics.pushed(*pockets)
        torque = balances[ring + CAGE, VALUE].copy()
        balances[ring + CAGE] += np.einsum("ci,i...cz->...cz", floating.by_push, push)
        balances[ring + CAGE, VALUE] = torque  # that of the land is one of the border
        if self.roller.bearing.cage.guidance == "inner":
            balances[[ring + Y, ring + Z]] += push
        return floating

    def _border(
        self, slopes: NDArray, cage_speed: NDArray, floating: FloatingCage | None
    ) -> tuple[NDArray, NDArray]:
        """Loads from outside on ring and cage (B, C), their derivatives by the border (C, B, B).

        The ring has slopes (2, C), the cage its speed (C, 1).
        """
        points, cage = self.points, self.roller.bearing.cage
        stiffness, load = self._outside
        value, by = load.copy(), stiffness.copy()
        value[TILT_Z:CAGE] += stiffness[:, TILT_Z, TILT_Z] * slopes  # both tilts are held alike
        if floating is None:
            ring_speed = points.guiding_speed(cage.guidance)
            land = land_torque(ring_speed - cage_speed, cage, self.roller.lubrication.oil)
            value[CAGE], by[:, CAGE, CAGE] = land.torque[:, 0], -land.by_speed[:, 0]
            return value, by
        value[CAGE], by[:, CAGE, CAGE] = floating.torque, floating.by_speed
        if cage.guidance == "inner":
            value[[Y, Z]] += floating.body_force.T
            by[:, [Y, Z], CAGE] += floating.body_force_by_speed
        return value, by

    @cached_property
    def _outside(self) -> tuple[NDArray, NDArray]:
        """Stiffness that holds the tilts (C, B, B), and the loads on the ring (B, C)."""
        points, ring, border = self.points, self.layout.per_roller, self.layout.border
        load, stiffness = np.zeros((border, len(points))), np.zeros((len(points), border, border))
        # Any stiffness holds a tilt at its given value; this one has the size of the other rows.
        # Aligned rollers hold a ring straight that nothing tilts.
        free = points.free_tilt[:, 0] & (self.roller.axial_modes > 1)
        held = np.where(free, 0.0, self.scales.row[ring + TILT_Z] / ANGLE)
        stiffness[:, TILT_Z, TILT_Z] = stiffness[:, TILT_Y, TILT_Y] = held
        load[Y], load[Z] = points.load_y[:, 0], points.load_z[:, 0]
        load[SHIFT:] = points.axial_load[:, 0]
        # A ring that tilts freely has no given slope, one that is held no moment.
        load[TILT_Z] = points.moment_z[:, 0] - held * points.slope_z[:, 0]
        load[TILT_Y] = points.moment_y[:, 0] - held * points.slope_y[:, 0]
        return stiffness, load

    def _misfits(self, x: Unknowns, forces: NDArray) -> list[NDArray]:
        """Deviations of elastic raceways less their deflections (C, Z M) [m] under contact forces."""
        m, misfits = self.roller.axial_modes, []
        for place, race in enumerate(self.layout.elastic_raceways):
            load = forces[place * m : (place + 1) * m].transpose(1, 2, 0).reshape(len(self.points), -1)
            deviation = x.deviation[race].transpose(1, 2, 0).reshape(load.shape)
            misfits.append(deviation - self.deflection(race, load.T).T)
        return misfits

    def deflection(self, race: int, forces: NDArray) -> NDArray:
        """Outward deflection (Z M, ...) [m] of an elastic raceway under contact forces (Z M, ...) [N]."""
        compliance = self.compliance[race]
        assert compliance is not None  # or the raceway would not be elastic
        return OUTWARD[race] * (compliance @ forces)

    @cached_property
    def felt_deflections(self) -> NDArray:
        """Deviations that act on rollers (Z, D, Z felt) [m] per contact force on elastic raceways [N]."""
        m, rollers, felt = self.layout.axial_modes, self.layout.rollers, self.kinematics.felt
        by_force = np.empty((rollers * len(felt), rollers, felt.shape[1]))
        for place, race in enumerate(self.layout.elastic_raceways):
            compliance, own = self.compliance[race], slice(place * m, (place + 1) * m)
            assert compliance is not None  # or the raceway would not be elastic
            deflection = OUTWARD[race] * compliance.reshape(rollers, m, -1)
            by_force[..., own] = (felt[:, own] @ deflection).reshape(-1, rollers, m)
        return np.ascontiguousarray(by_force.transpose(1, 2, 0))
