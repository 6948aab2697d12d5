"""Balance of the whole bearing: rollers, ring, cage, and raceways that yield."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.cage import FloatingCage, floating_cage
from quasidynamic.balance.points import OperatingPoints
from quasidynamic.balance.roller import (
    CAGE_SPEED,
    FILM_I,
    SPIN,
    STILL,
    VALUE,
    Motion,
    RollerBalance,
    RollerInputs,
    RollerState,
)
from quasidynamic.balance.spin_transport import SpinTransport, spin_transport
from quasidynamic.contact.land import land_torque
from quasidynamic.contact.load import GAP_ROUNDING
from quasidynamic.motion.speeds import rolling_cage_speed, rolling_roller_speed

INNER, OUTER = 0, 1
Y, Z, TILT_Z, TILT_Y, CAGE = range(5)
BORDER = 5  # unknowns of ring and cage, before those of the rollers
FRICTION = 1e-2  # usual size of friction over load
LENGTH = 1e-6  # [m] size of approaches and displacements
ANGLE = 1e-3  # [rad]
IDLE = 1e-3  # share of the centrifugal force that stands for a load
SPIN_CHANGE = 0.5  # of the spin in pure rolling in a step
FILM = 1e-4  # [m] far above any film: a step is judged by its forces, not by how far films lag behind
LARGE_DEVIATION = 1e-4  # [m] of a thin ring


class Unknowns(NamedTuple):
    """Unknowns of C cases in SI units."""

    ring: NDArray  # (4, C, 1) displacement y, z [m], slopes dz/dx, dy/dx [rad]
    cage_drift: NDArray  # (C, 1) cage speed less that of pure rolling [rad/s]
    approach: NDArray  # (C, Z) at the outer raceway [m]
    tilt: NDArray  # (C, Z) tilt approach at the outer raceway [m], zero when rollers are aligned
    film: NDArray  # (2, C, Z) [m]
    spin_drift: NDArray  # (C, Z) spin less that of pure rolling [rad/s]
    deviation: NDArray  # (2, M, C, Z) outward, of raceways that yield [m]


class Linearisation(NamedTuple):
    """Scaled residual of C cases and its derivatives, sorted by who feels whom.

    `table[row, column]` (.., C, Z) holds what a roller's unknowns, and then the unknowns of the
    border and the deviations at this roller, do to its own balances, the last of them its spin;
    then its part in the balances of the border (five rows) and in the forces on yielding raceways.
    """

    residual: NDArray  # (C, N)
    table: NDArray  # (rows, columns, C, Z)
    border: NDArray  # (C, 5, 5) what border unknowns do to border balances without any roller
    before: NDArray  # (C, 1) what the spin of the roller before does to the balance of spin
    after: NDArray  # (C, 1) the same for the roller after
    loading: NDArray  # (C) largest roller load over the reference force, at least 1
    cage_speed: NDArray  # (C) over its size, without sign
    state: RollerState


@dataclass(frozen=True, kw_only=True)
class BearingBalance:
    """Residuals that vanish at equilibrium, as a function of scaled unknowns (C, N).

    Unknowns of a case: ring displacement y, z [m]; ring slopes dz/dx, dy/dx [rad]; cage speed
    less that of pure rolling [rad/s]; then field by field over the rollers the approach at the outer
    raceway, the tilt approach there unless rollers are aligned, inner and outer film [m] and the
    spin less that of pure rolling [rad/s], so that small slips keep their digits; then the
    shape coefficients [m] of every yielding raceway's deviation, roller by roller.
    """

    roller: RollerBalance
    points: OperatingPoints
    clearance: float  # [m] operating, diametral
    compliance: tuple[NDArray | None, NDArray | None] = (None, None)  # inner, outer (Z M, Z M) [m/N]
    deviation: NDArray | None = None  # (2, Z, M) given shape of the raceways, outward [m]
    spin_inertia: bool = True

    def take(self, cases: NDArray) -> "BearingBalance":
        """Balance of some of the cases."""
        return replace(self, points=self.points.take(cases))

    # -- sizes ---------------------------------------------------------------------------------

    @cached_property
    def rollers(self) -> int:
        """Number of rollers."""
        return self.roller.bearing.rollers

    @cached_property
    def own(self) -> int:
        """Number of unknowns of each roller."""
        return 4 + (self.roller.shapes > 1)

    @cached_property
    def yielding(self) -> list[int]:
        """Raceways that yield, by index."""
        return [race for race, matrix in enumerate(self.compliance) if matrix is not None]

    @cached_property
    def size(self) -> int:
        """Number N of unknowns of a case."""
        return BORDER + self.rollers * (self.own + len(self.yielding) * self.roller.shapes)

    # -- unknowns ------------------------------------------------------------------------------

    def unpack(self, scaled: NDArray) -> Unknowns:
        """Unknowns in SI units from scaled ones (C, N)."""
        x = scaled * self.unknown_scale
        cases, m = len(x), self.roller.shapes
        split = BORDER + self.rollers * self.own
        fields = x[:, BORDER:split].reshape(cases, self.own, self.rollers).transpose(1, 0, 2)
        deviation = np.zeros((2, m, cases, self.rollers))
        if self.yielding:
            given = x[:, split:].reshape(cases, len(self.yielding), self.rollers, m)
            deviation[self.yielding] = given.transpose(1, 3, 0, 2)
        return Unknowns(
            ring=x[:, :CAGE].T[..., None],
            cage_drift=x[:, CAGE:BORDER],
            approach=fields[0],
            tilt=fields[1] if m > 1 else np.zeros(fields[0].shape),
            film=fields[-3:-1],
            spin_drift=fields[-1],
            deviation=deviation,
        )

    def pack(self, unknowns: Unknowns) -> NDArray:
        """Scaled unknowns (C, N), the inverse of `unpack`; what this balance does not know is left out."""
        m, cases = self.roller.shapes, len(unknowns.cage_drift)
        tilt = [unknowns.tilt] if m > 1 else []
        fields = [unknowns.approach, *tilt, *unknowns.film, unknowns.spin_drift]
        x = [unknowns.ring[..., 0].T, unknowns.cage_drift, *fields]
        if self.yielding:
            shapes = np.zeros((2, m, cases, self.rollers))
            common = min(m, unknowns.deviation.shape[1])
            shapes[:, :common] = unknowns.deviation[:, :common]
            x.append(shapes[self.yielding].transpose(2, 0, 3, 1).reshape(cases, -1))
        return np.concatenate(x, axis=1) / self.unknown_scale

    def field(self, which: int) -> slice:
        """Place of a roller's unknown (0 approach, ..., -1 spin) among the unknowns of a case."""
        start = BORDER + which % self.own * self.rollers
        return slice(start, start + self.rollers)

    def bounded(self, before: NDArray, after: NDArray) -> NDArray:
        """Keep approaches at the outer raceway and films positive: at most nine tenths go in a step.

        A roller thrown off the outer raceway, or a film below zero, has no slope that leads back. The
        spin of a roller that hardly anything drives may be sent anywhere: it moves by a share only.
        """
        held, (approach, films, spin) = after.copy(), self._bounded_fields
        least, most = before[:, spin] - SPIN_CHANGE, before[:, spin] + SPIN_CHANGE
        held[:, spin] = np.minimum(np.maximum(after[:, spin], least), most)
        held[:, films] = np.maximum(after[:, films], 0.1 * before[:, films])
        old, new = self._largest_approach(before), self._largest_approach(after)
        lowest = np.minimum(old, 0.1 * old) - 3 * GAP_ROUNDING / LENGTH
        held[:, approach] += np.maximum(lowest - new, 0.0)
        return held

    @cached_property
    def _bounded_fields(self) -> tuple[slice, slice, slice]:
        """Places of approaches at the outer raceway, films and spins among the unknowns of a case."""
        return self.field(0), slice(self.field(-3).start, self.field(-2).stop), self.field(-1)

    def _largest_approach(self, scaled: NDArray) -> NDArray:
        """Approach (C, Z) where each roller is nearest to the outer raceway, whatever its shape, scaled."""
        centre = scaled[:, self._bounded_fields[0]]
        if self.roller.shapes == 1:
            return centre
        if not self.yielding and self.deviation is None:
            return centre + np.abs(scaled[:, self.field(1)])
        beyond = self.inputs(self.unpack(scaled)).approach[OUTER, 1:] / LENGTH
        shape = self.roller.raceways.slices.shape[:, 1:]
        return centre + np.einsum("km,mcz->kcz", shape, beyond).max(0)

    @cached_property
    def displacements(self) -> NDArray:
        """Places of the unknowns that are displacements of rings, rollers and raceways."""
        rollers = np.arange(BORDER, BORDER + self.rollers * (self.own - 3))
        return np.concatenate([[Y, Z], rollers, np.arange(BORDER + self.rollers * self.own, self.size)])

    # -- scales --------------------------------------------------------------------------------

    @cached_property
    def rolling_cage(self) -> NDArray:
        """Cage speed in pure rolling (C, 1) [rad/s]."""
        points, ratio = self.points, self.roller.bearing.diameter_ratio
        return rolling_cage_speed(points.inner_speed, points.outer_speed, ratio)

    @cached_property
    def rolling_spin(self) -> NDArray:
        """Roller spin in pure rolling (C, 1) [rad/s]."""
        points, ratio = self.points, self.roller.bearing.diameter_ratio
        return rolling_roller_speed(points.inner_speed, points.outer_speed, ratio)

    @cached_property
    def reference_force(self) -> NDArray:
        """Force that residuals are measured against (C, 1) [N]: the applied one.

        A small share of the centrifugal force of the rollers takes its place where that is larger.
        """
        bearing, points = self.roller.bearing, self.points
        centrifugal, _ = self.roller.centrifugal(self.rolling_cage)
        tilting = points.moment / bearing.roller.length
        return np.maximum(np.maximum(points.load, tilting), IDLE * centrifugal)

    @cached_property
    def undetermined(self) -> NDArray:
        """Whether nothing holds the ring (C): neither load nor moment, and every roller with its gap."""
        points = self.points
        idle = (points.load == 0) & (points.moment == 0)
        if self.deviation is not None or self.yielding or not idle.any():
            return np.zeros(len(points), bool)
        reach = np.hypot(points.slope_y, points.slope_z) * self.roller.bearing.roller.length / 2
        return (idle & (2 * reach <= self.clearance))[:, 0]

    @cached_property
    def unknown_scale(self) -> NDArray:
        """Size of each unknown (C, N): micrometres, milliradians, nominal speeds."""
        scale = np.full((len(self.points), self.size), LENGTH)
        spin = np.abs(self.rolling_spin)
        scale[:, TILT_Z:CAGE] = ANGLE
        scale[:, CAGE:BORDER] = np.maximum(np.abs(self.rolling_cage), 1e-3 * spin)
        scale[:, self.field(-1)] = spin
        return scale

    @cached_property
    def _row_scale(self) -> NDArray:
        """Size of each kind of balance (rows, C): of a roller's own, of the border's, of deviations.

        Friction is about a hundredth of the load that causes it, and so is the size of its balances.
        """
        bearing, own = self.roller.bearing, self.own
        half = bearing.roller.length / 2
        tilt = [half] if self.roller.shapes > 1 else []
        levers = [1.0, *tilt, 0.0, 0.0, FRICTION * bearing.roller.diameter / 2]
        levers += [1.0, 1.0, half, half, FRICTION * bearing.pitch_diameter / 2]
        scale = np.full(
            (own + BORDER + self.roller.shapes * len(self.yielding), len(self.points)), LARGE_DEVIATION
        )
        scale[: own + BORDER] = np.array(levers)[:, None] * self.reference_force[:, 0]
        scale[own - 3 : own - 1] = FILM
        return scale

    @cached_property
    def residual_scale(self) -> NDArray:
        """Size of each residual (C, N)."""
        own, border = self._row_scale[: self.own], self._row_scale[self.own : self.own + BORDER]
        scale = np.full((len(self.points), self.size), LARGE_DEVIATION)
        scale[:, :BORDER] = border.T
        scale[:, BORDER : BORDER + self.own * self.rollers] = own.T.repeat(self.rollers, axis=1)
        return scale

    # -- geometry ------------------------------------------------------------------------------

    @cached_property
    def _radial(self) -> NDArray:
        """Sine and cosine of the roller azimuths (2, Z): components y and z of what points outwards."""
        azimuth = self.roller.bearing.azimuths
        return np.array([np.sin(azimuth), np.cos(azimuth)])

    def inputs(self, x: Unknowns) -> RollerInputs:
        """What the rollers are given; outward deviations move the raceways towards (inner) or away."""
        m, (y, z) = self.roller.shapes, x.ring[:TILT_Z]
        sin, cos = self._radial
        approach = np.zeros((2, m, *x.spin_drift.shape))
        approach[INNER, 0] = y * sin + z * cos - x.approach + (x.film[0] + x.film[1] - self.clearance / 2)
        approach[OUTER, 0] = x.approach
        if m > 1:
            slope_z, slope_y = x.ring[TILT_Z:]
            half = self.roller.raceways.slices.length / 2
            approach[INNER, 1] = half * (slope_z * cos + slope_y * sin) - x.tilt
            approach[OUTER, 1] = x.tilt
        if self.yielding or self.deviation is not None:
            self._deviate(approach, x.deviation if self.deviation is None else x.deviation + self._given)
        return RollerInputs(approach, x.film, self.motion(x.cage_drift, x.spin_drift))

    @staticmethod
    def _deviate(approach: NDArray, deviation: NDArray) -> None:
        """Add outward deviations of the raceways to the approaches, both (2, M, C, Z), in place.

        The roller follows the outer raceway's height and tilt but not its waviness: those two
        change the inner approach, the rest the outer one.
        """
        inner, outer = deviation
        approach[INNER] += inner
        approach[INNER, :2] -= outer[:2]
        approach[OUTER, 2:] -= outer[2:]

    def speeds(self, x: Unknowns) -> tuple[NDArray, NDArray]:
        """Spins (C, Z) and cage speed (C, 1) [rad/s]."""
        motion = self.motion(x.cage_drift, x.spin_drift)
        return motion.spin, motion.cage_speed

    def motion(self, cage_drift: NDArray, spin_drift: NDArray) -> Motion:
        """Motion of the rollers with these drifts (C, 1), (C, Z) [rad/s]."""
        spin, cage_speed = self.rolling_spin + spin_drift, self.rolling_cage + cage_drift
        return Motion(spin_drift, cage_drift, spin, cage_speed, self._still_spin)

    @cached_property
    def _still_spin(self) -> NDArray:
        """Spin (C, 1) [rad/s] below which rollers stand still."""
        return STILL * self.rolling_spin

    @cached_property
    def _given(self) -> NDArray:
        """Given deviation as (2, M, 1, Z) [m]."""
        assert self.deviation is not None
        return np.moveaxis(self.deviation, -1, 1)[:, :, None]

    # -- evaluation ----------------------------------------------------------------------------

    def evaluate(self, scaled: NDArray) -> Linearisation:
        """Residual and derivatives at scaled unknowns (C, N)."""
        # A trial step may be absurd: what overflows shows in its residual.
        with np.errstate(all="ignore"):
            return self._evaluated(scaled)

    def _evaluated(self, scaled: NDArray) -> Linearisation:
        x = self.unpack(scaled)
        inputs = self.inputs(x)
        response = self.roller.respond(inputs, self.points)
        graded, floating = self._rows(response.table), None
        if self.roller.bearing.cage.free:
            floating = self._float(x, response.table, graded)
        rows, table = graded[:, VALUE], self._columns(graded)
        transport = self._add_spin_transport(x, rows, table)
        border, border_by = self._border(x.ring[TILT_Z:CAGE, :, 0], inputs.motion.cage_speed, floating)
        border += rows[self.own : self.own + BORDER].sum(-1)
        residual = [border.T, rows[: self.own].transpose(1, 0, 2).reshape(len(scaled), -1)]
        residual += self._yield(x, rows[self.own + BORDER :])
        table *= self._table_scale
        chain, border_scale = self._chain_scale
        return Linearisation(
            residual=np.concatenate(residual, axis=1) / self.residual_scale,
            table=table,
            border=border_by * border_scale,
            before=transport.by_before * chain,
            after=transport.by_after * chain,
            loading=np.maximum(
                1.0, response.state.contact.force[OUTER, 0].max(-1) / self.reference_force[:, 0]
            ),
            cage_speed=np.abs(inputs.motion.cage_speed / self.unknown_scale[:, CAGE:BORDER])[:, 0],
            state=response.state,
        )

    @cached_property
    def _column_scale(self) -> NDArray:
        """Size of the unknowns in the columns of the table (columns, C, 1)."""
        own = self.unknown_scale[:, BORDER : BORDER + self.own * self.rollers : self.rollers].T
        yields = np.full((len(self.yielding) * self.roller.shapes, len(self.points)), LENGTH)
        return np.concatenate([own, self.unknown_scale[:, :BORDER].T, yields])[..., None]

    @cached_property
    def _chain_scale(self) -> tuple[NDArray, NDArray]:
        """Size of spins over that of their balances (C, 1), and the same for the border (C, 5, 5)."""
        own, row = self.own, self._row_scale
        border = self.unknown_scale[:, None, :BORDER] / row[own : own + BORDER].T[..., None]
        return self._column_scale[own - 1] / row[own - 1][:, None], border

    @cached_property
    def _table_scale(self) -> NDArray:
        """Size of the unknowns over that of the residuals (rows, columns, C, 1)."""
        return self._column_scale[None] / self._row_scale[:, None, :, None]

    def _rows(self, response: NDArray) -> NDArray:
        """Rows of the table from those of a roller's response (rows, inputs + 1, C, Z)."""
        m, own = self.roller.shapes, self.own
        cage, tangential = response[own], response[own + 1]
        first = len(response) - 2 * m  # row of the forces conjugate to the shapes
        inner = response[first : first + m]
        rows = np.zeros((own + BORDER + m * len(self.yielding), *response.shape[1:]))
        rows[:own] = response[:own]
        rows[own + Y : own + Z + 1] = self._pushed(tangential, inner[0])
        if m > 1:
            sin, cos = self._radial
            moment = -self.roller.raceways.slices.length / 2 * inner[1]
            free = self.points.free_tilt
            rows[own + TILT_Z], rows[own + TILT_Y] = free * (moment * cos), free * (moment * sin)
        rows[own + CAGE] = cage
        for place, race in enumerate(self.yielding):
            start = first + race * m
            rows[own + BORDER + place * m : own + BORDER + (place + 1) * m] = response[start : start + m]
        return rows

    def _columns(self, gradient: NDArray) -> NDArray:
        """Derivatives by the unknowns (rows, columns, C, Z) from those by a roller's inputs."""
        m, own = self.roller.shapes, self.own
        table = np.zeros((len(gradient), own + BORDER + m * len(self.yielding), *gradient.shape[2:]))
        inner, outer = gradient[:, :m], gradient[:, m : 2 * m]
        spin, cage, film = gradient[:, SPIN], gradient[:, CAGE_SPEED], gradient[:, FILM_I:VALUE]
        np.subtract(outer[:, 0], inner[:, 0], out=table[:, 0])
        np.add(film, inner[:, :1], out=table[:, own - 3 : own - 1])
        table[:, own - 1] = spin
        np.multiply(self._radial[:, None], inner[:, :1], out=table[:, own + Y : own + Z + 1])
        table[:, own + CAGE] = cage
        if m > 1:
            (sin, cos), half = self._radial, self.roller.raceways.slices.length / 2
            table[:, 1] = outer[:, 1] - inner[:, 1]
            table[:, own + TILT_Z] = half * cos * inner[:, 1]
            table[:, own + TILT_Y] = half * sin * inner[:, 1]
        for place, race in enumerate(self.yielding):
            here = table[:, own + BORDER + place * m : own + BORDER + (place + 1) * m]
            here[:] = inner if race == INNER else -np.concatenate([inner[:, :2], outer[:, 2:]], axis=1)
        return table

    def spin_transport(self, cage_drift: NDArray, spin_drift: NDArray) -> SpinTransport:
        """What the change of spin around the bearing takes at these drifts (C, 1), (C, Z) [rad/s]."""
        inertia = self.roller.bearing.roller.inertia if self.spin_inertia else 0.0
        return spin_transport(spin_drift, self.rolling_cage + cage_drift, self.rolling_spin, inertia)

    def _add_spin_transport(self, x: Unknowns, rows: NDArray, table: NDArray) -> SpinTransport:
        """Add the transport of spin to its balance, but for what the neighbours' spins do there."""
        taken, row = self.spin_transport(x.cage_drift, x.spin_drift), self.own - 1
        rows[row] -= taken.torque
        table[row, row] -= taken.by_spin
        table[row, self.own + CAGE] -= taken.by_cage
        return taken

    def floating(self, x: Unknowns, pockets: NDArray) -> FloatingCage:
        """Cage in its land; `pockets` (2, C, Z) [N] push rollers along the motion and outwards."""
        push = self._pushed(*pockets[:, None])[:, 0].sum(-1).T
        bearing = self.roller.bearing
        cage_speed = self.speeds(x)[1][:, 0]
        return floating_cage(push, cage_speed, self.points, bearing.cage, self.roller.lubrication.oil)

    def _pushed(self, along: NDArray, outward: NDArray) -> NDArray:
        """Force (2, n, C, Z) [N], y and z, on what pushes rollers (n, C, Z) along the motion and outwards."""
        backwards, inwards = self._reactions
        return backwards * along + inwards * outward

    @cached_property
    def _reactions(self) -> NDArray:
        """Directions y and z against the motion of the rollers and inwards (2, 2, 1, 1, Z)."""
        sin, cos = self._radial
        return np.array([[-cos, sin], [-sin, -cos]])[:, :, None, None]

    def _float(self, x: Unknowns, response: NDArray, graded: NDArray) -> FloatingCage:
        """Let the land's torque follow from the pockets' push; a guiding inner ring bears that push."""
        own = self.own
        pockets = response[own + 2 : own + 4]
        found, push = self.floating(x, pockets[:, VALUE]), self._pushed(*pockets)
        value = graded[own + CAGE, VALUE].copy()
        graded[own + CAGE] += np.einsum("ci,i...cz->...cz", found.by_push, push)
        graded[own + CAGE, VALUE] = value  # the torque itself is one of the border
        if self.roller.bearing.cage.guidance == "inner":
            graded[[own + Y, own + Z]] += push
        return found

    def _border(
        self, slopes: NDArray, cage_speed: NDArray, floating: FloatingCage | None
    ) -> tuple[NDArray, NDArray]:
        """Loads from outside on ring and cage (5, C), their derivatives by the border (C, 5, 5).

        The ring has slopes (2, C), the cage its speed (C, 1).
        """
        points, cage = self.points, self.roller.bearing.cage
        hold, push = self._outside
        value, by = push.copy(), hold.copy()
        value[TILT_Z:CAGE] += hold[:, TILT_Z, TILT_Z] * slopes  # both tilts are held alike
        if floating is None:
            ring = points.outer_speed if cage.guidance == "outer" else points.inner_speed
            land = land_torque(ring - cage_speed, cage, self.roller.lubrication.oil)
            value[CAGE], by[:, CAGE, CAGE] = land.torque[:, 0], -land.by_speed[:, 0]
            return value, by
        value[CAGE], by[:, CAGE, CAGE] = floating.torque, floating.by_speed
        if cage.guidance == "inner":
            value[[Y, Z]] += floating.thrown.T
            by[:, [Y, Z], CAGE] += floating.thrown_by_speed
        return value, by

    @cached_property
    def _outside(self) -> tuple[NDArray, NDArray]:
        """Stiffness that holds the tilts (C, 5, 5), and the loads on the ring (5, C)."""
        points = self.points
        push, hold = np.zeros((BORDER, len(points))), np.zeros((len(points), BORDER, BORDER))
        push[Y], push[Z] = points.load_y[:, 0], points.load_z[:, 0]
        free = points.free_tilt[:, 0]
        # Any stiffness holds a tilt where it shall be; this one has the size of the other rows.
        stiffness = np.where(free, 0.0, self._row_scale[self.own + TILT_Z] / ANGLE)
        hold[:, TILT_Z, TILT_Z] = hold[:, TILT_Y, TILT_Y] = stiffness
        # A ring that tilts freely has no given slope, one that is held no moment.
        push[TILT_Z] = points.moment_z[:, 0] - stiffness * points.slope_z[:, 0]
        push[TILT_Y] = points.moment_y[:, 0] - stiffness * points.slope_y[:, 0]
        return hold, push

    def _yield(self, x: Unknowns, forces: NDArray) -> list[NDArray]:
        """Deviation minus compliance times load (C, Z M) [m]; rollers push the inner raceway inwards."""
        m, residuals = self.roller.shapes, []
        for place, race in enumerate(self.yielding):
            matrix = self.compliance[race]
            assert matrix is not None  # or it would not yield
            load = np.moveaxis(forces[place * m : (place + 1) * m], 0, -1).reshape(len(self.points), -1)
            deviation = np.moveaxis(x.deviation[race], 0, -1).reshape(load.shape)
            residuals.append(deviation - (-1.0 if race == INNER else 1.0) * load @ matrix.T)
        return residuals
