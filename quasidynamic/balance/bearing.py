"""Balance of the whole bearing: rollers, ring, cage, and raceways that yield."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.roller import RollerBalance, RollerState
from quasidynamic.contact.drag import land_drag
from quasidynamic.motion.speeds import rolling_cage_speed, rolling_roller_speed

INNER, OUTER = 0, 1
Y, Z, TILT_Z, TILT_Y, CAGE = range(5)
FRICTION = 1e-2  # usual size of friction over load
BORDER = 5  # unknowns of ring and cage, before those of the rollers


class Evaluation(NamedTuple):
    """Residual and Jacobian of a state, and what happens at its rollers."""

    residual: NDArray  # (N) scaled: unbalanced force over reference force
    jacobian: NDArray  # (N, N) of the scaled residual by the scaled unknowns
    rollers: RollerState
    loading: float  # largest roller load over the reference force, at least 1: rounding grows with it


@dataclass(frozen=True, kw_only=True)
class BearingBalance:
    """Residuals that vanish at equilibrium, as a function of scaled unknowns.

    Unknowns: ring displacement y, z [m]; ring tilts dz/dx, dy/dx [rad]; cage speed [rad/s]; then
    per roller the approach and the tilt approach at the outer raceway [m] and the spin [rad/s];
    then the shape coefficients [m] of every yielding raceway's deviation.
    """

    roller: RollerBalance
    compliance: tuple[NDArray | None, NDArray | None] = (None, None)  # inner, outer (Z M, Z M) [m/N]
    deviation: NDArray | None = None  # (2, Z, M) given shape of the raceways, outward [m]
    spin_inertia: bool = True

    # -- sizes ---------------------------------------------------------------------------------

    @property
    def rollers(self) -> int:
        """Number of rollers."""
        return self.roller.bearing.rollers

    @property
    def size(self) -> int:
        """Number of unknowns."""
        yielding = sum(matrix is not None for matrix in self.compliance)
        return BORDER + 3 * self.rollers + yielding * self.rollers * self.roller.shapes

    @property
    def yields(self) -> bool:
        """Whether a raceway yields together with the bearing."""
        return any(matrix is not None for matrix in self.compliance)

    @cached_property
    def displacements(self) -> NDArray:
        """Places of the unknowns that are displacements of rings, rollers and raceways [m]."""
        rollers = np.arange(self.roller_unknown(0).start, self.roller_unknown(1).stop)
        return np.concatenate([[Y, Z], rollers, np.arange(BORDER + 3 * self.rollers, self.size)])

    def roller_unknown(self, which: int) -> slice:
        """Place of the rollers' approach (0), tilt approach (1) or spin (2) among the unknowns."""
        start = BORDER + which * self.rollers
        return slice(start, start + self.rollers)

    def deviation_unknown(self, race: int) -> slice | None:
        """Place of a raceway's deviation among the unknowns; None when it is rigid."""
        if self.compliance[race] is None:
            return None
        before = race == OUTER and self.compliance[INNER] is not None
        width = self.rollers * self.roller.shapes
        start = BORDER + 3 * self.rollers + before * width
        return slice(start, start + width)

    # -- scales --------------------------------------------------------------------------------

    @cached_property
    def cage_speed(self) -> float:
        """Cage speed in pure rolling [rad/s]."""
        operation, bearing = self.roller.operation, self.roller.bearing
        return rolling_cage_speed(operation.inner_speed, operation.outer_speed, bearing.diameter_ratio)

    @cached_property
    def roller_speed(self) -> float:
        """Roller spin in pure rolling [rad/s]."""
        operation, bearing = self.roller.operation, self.roller.bearing
        return rolling_roller_speed(operation.inner_speed, operation.outer_speed, bearing.diameter_ratio)

    @cached_property
    def reference_force(self) -> float:
        """Force that residuals are measured against [N]: the largest that acts from outside."""
        bearing, operation = self.roller.bearing, self.roller.operation
        centrifugal = bearing.roller.mass * bearing.pitch_diameter / 2 * self.cage_speed**2
        tilting = abs(operation.moment) / bearing.roller.length
        return max(abs(operation.radial_load), centrifugal, tilting)

    @cached_property
    def unknown_scale(self) -> NDArray:
        """Size of each unknown (N): micrometres, milliradians, nominal speeds."""
        scale = np.full(self.size, 1e-6)
        scale[[TILT_Z, TILT_Y]] = 1e-3
        scale[CAGE] = max(abs(self.cage_speed), 1e-3 * abs(self.roller_speed))
        scale[self.roller_unknown(2)] = abs(self.roller_speed)
        return scale

    @cached_property
    def residual_scale(self) -> NDArray:
        """Size of each residual (N): the reference force, with the lever where it is a moment.

        Friction is about a hundredth of the load that causes it, and so is the size of its balances.
        """
        bearing, force = self.roller.bearing, self.reference_force
        scale = np.full(self.size, float(force))
        scale[[TILT_Z, TILT_Y]] = force * bearing.roller.length / 2
        scale[CAGE] = FRICTION * force * bearing.pitch_diameter / 2
        scale[self.roller_unknown(1)] = force * bearing.roller.length / 2
        scale[self.roller_unknown(2)] = FRICTION * force * bearing.roller.diameter / 2
        scale[self._deviations] = 1e-4  # [m] a large deviation of a thin ring
        return scale

    # -- linear maps between unknowns and rollers ----------------------------------------------

    @cached_property
    def gather(self) -> NDArray:
        """Inputs of every roller from the unknowns (Z (2 M + 2), N)."""
        m, count = self.roller.shapes, self.rollers
        each = np.arange(count)
        cos, sin = np.cos(self.roller.bearing.azimuths), np.sin(self.roller.bearing.azimuths)
        half = self.roller.inner.slices.length / 2
        maps = np.zeros((count, 2 * m + 2, self.size))
        approach, tilt, spin = (each + self.roller_unknown(k).start for k in range(3))
        maps[:, 0, Y], maps[:, 0, Z] = sin, cos
        maps[:, 1, TILT_Z], maps[:, 1, TILT_Y] = half * cos, half * sin
        maps[each, 0, approach] = -1.0
        maps[each, 1, tilt] = -1.0
        maps[each, m, approach] = 1.0
        maps[each, m + 1, tilt] = 1.0
        maps[each, 2 * m, spin] = 1.0
        maps[:, 2 * m + 1, CAGE] = 1.0
        self._gather_deviations(maps)
        return maps.reshape(-1, self.size)

    def _gather_deviations(self, maps: NDArray) -> None:
        """Let outward deviations move the raceways away from (outer) or towards (inner) the roller."""
        m, each = self.roller.shapes, np.arange(self.rollers)
        for race, sign in ((INNER, 1.0), (OUTER, -1.0)):
            place = self.deviation_unknown(race)
            if place is None:
                continue
            for shape in range(m):
                # The roller follows the outer raceway's height and tilt, but not its waviness:
                # those two change the inner approach, the rest the outer one.
                row = shape if race == INNER or shape < 2 else m + shape
                maps[each, row, place.start + each * m + shape] = sign

    @cached_property
    def scatter(self) -> NDArray:
        """Residuals from the outputs of every roller (N, Z (2 M + 5))."""
        m, count = self.roller.shapes, self.rollers
        each = np.arange(count)
        cos, sin = np.cos(self.roller.bearing.azimuths), np.sin(self.roller.bearing.azimuths)
        half = self.roller.inner.slices.length / 2
        radial, tilt, spin, cage, tangential = range(2 * m, 2 * m + 5)
        maps = np.zeros((self.size, count, 2 * m + 5))
        maps[Y, :, 0], maps[Y, :, tangential] = -sin, -cos
        maps[Z, :, 0], maps[Z, :, tangential] = -cos, sin
        if self.roller.operation.free_tilt:
            maps[TILT_Z, :, 1], maps[TILT_Y, :, 1] = -half * cos, -half * sin
        maps[CAGE, :, cage] = 1.0
        for which, row in enumerate((radial, tilt, spin)):
            maps[self.roller_unknown(which).start + each, each, row] = 1.0
        self._scatter_compliance(maps)
        return maps.reshape(self.size, -1)

    def _scatter_compliance(self, maps: NDArray) -> None:
        """Deviation minus compliance times load; rollers push the inner raceway inwards."""
        m = self.roller.shapes
        for race, sign in ((INNER, 1.0), (OUTER, -1.0)):
            place, matrix = self.deviation_unknown(race), self.compliance[race]
            if place is not None and matrix is not None:
                maps[place, :, race * m : (race + 1) * m] = sign * matrix.reshape(-1, self.rollers, m)

    @cached_property
    def _land(self) -> tuple[float, float]:
        """Drag of the cage land per speed difference [N m s], and the speed of its ring [rad/s]."""
        operation, cage = self.roller.operation, self.roller.bearing.cage
        ring = operation.outer_speed if cage.guidance == "outer" else operation.inner_speed
        return land_drag(cage, self.roller.inner.oil), ring

    # -- evaluation ----------------------------------------------------------------------------

    def inputs(self, scaled: NDArray, film: NDArray) -> NDArray:
        """Inputs of every roller (Z, 2 M + 2), see `RollerBalance`."""
        values = (self.gather @ (scaled * self.unknown_scale)).reshape(self.rollers, -1)
        values[:, 0] += film.sum(0) - self.roller.bearing.clearance / 2
        if self.deviation is not None:
            inner, outer = self.deviation
            m = self.roller.shapes
            values[:, :m] += inner
            values[:, :2] -= outer[:, :2]
            values[:, m + 2 : 2 * m] -= outer[:, 2:]
        return values

    def residual(self, scaled: NDArray, film: NDArray) -> tuple[NDArray, RollerState]:
        """Scaled residual (N) alone, and what happens at the rollers; see `evaluate`."""
        outputs = self.roller.respond(self.inputs(scaled, film), film)
        return self._residual(scaled, outputs.value) / self.residual_scale, outputs.state

    def evaluate(self, scaled: NDArray, film: NDArray) -> Evaluation:
        """Residual and Jacobian at scaled unknowns (N), with films (2, Z) [m] that are held."""
        outputs = self.roller.respond(self.inputs(scaled, film), film)
        blocks = outputs.gradient @ self.gather.reshape(self.rollers, -1, self.size)
        jacobian = self.scatter @ blocks.reshape(-1, self.size)
        self._add_linear_terms(jacobian)
        self._add_spin_inertia(scaled * self.unknown_scale, jacobian)
        return Evaluation(
            self._residual(scaled, outputs.value) / self.residual_scale,
            jacobian * self.unknown_scale / self.residual_scale[:, None],
            outputs.state,
            max(1.0, float(outputs.state.outer.force[:, 0].max()) / self.reference_force),
        )

    def _residual(self, scaled: NDArray, outputs: NDArray) -> NDArray:
        """Residual in newtons, newton metres and metres: outputs, applied load, land, yielding."""
        x, operation = scaled * self.unknown_scale, self.roller.operation
        residual = self.scatter @ outputs.ravel()
        residual[Z] += operation.radial_load
        if operation.free_tilt:
            residual[TILT_Z] += operation.moment
        else:
            residual[self._tilts] = self._tilt_stiffness * x[self._tilts]
        drag, ring = self._land
        residual[CAGE] += drag * (ring - x[CAGE])
        residual[self._deviations] += x[self._deviations]
        if self.spin_inertia:
            rows, before, factor = self._spin_chain(x)
            residual[rows] -= factor * abs(x[CAGE]) * (x[rows] - x[before])
        return residual

    def _add_linear_terms(self, jacobian: NDArray) -> None:
        if not self.roller.operation.free_tilt:
            jacobian[self._tilts, self._tilts] = self._tilt_stiffness
        jacobian[CAGE, CAGE] -= self._land[0]
        deviations = np.arange(self.size)[self._deviations]
        jacobian[deviations, deviations] += 1.0

    def _add_spin_inertia(self, x: NDArray, jacobian: NDArray) -> None:
        if not self.spin_inertia:
            return
        rows, before, factor = self._spin_chain(x)
        jacobian[rows, rows] -= factor * abs(x[CAGE])
        jacobian[rows, before] += factor * abs(x[CAGE])
        jacobian[rows, CAGE] -= factor * np.sign(x[CAGE]) * (x[rows] - x[before])

    def _spin_chain(self, x: NDArray) -> tuple[NDArray, NDArray, float]:
        """J omega_c dw/dphi, differenced upwind: places of each spin, of the one before it, J/dphi."""
        rows = np.arange(self.rollers) + self.roller_unknown(2).start
        before = np.roll(rows, 1 if x[CAGE] >= 0 else -1)
        return rows, before, self.roller.bearing.roller.inertia * self.rollers / (2 * np.pi)

    @property
    def _deviations(self) -> slice:
        return slice(BORDER + 3 * self.rollers, self.size)

    @property
    def _tilts(self) -> list[int]:
        return [TILT_Z, TILT_Y]

    @property
    def _tilt_stiffness(self) -> float:
        """Any stiffness holds a tilt at zero; this one has the size of the other rows [N m]."""
        return float(self.residual_scale[TILT_Z] / self.unknown_scale[TILT_Z])

    def film(self, state: RollerState) -> NDArray:
        """Films (2, Z) [m] that belong to a state's loads and speeds."""
        return np.array(
            [
                contact.film(forces.force[:, 0], sliding, entrainment)
                for contact, forces, sliding, entrainment in zip(
                    (self.roller.inner, self.roller.outer),
                    (state.inner, state.outer),
                    state.sliding,
                    state.entrainment,
                    strict=True,
                )
            ]
        )
