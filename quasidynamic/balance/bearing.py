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
        scale[BORDER + 3 * self.rollers :] = 1e-4  # [m] a large deviation of a thin ring
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

    def evaluate(self, scaled: NDArray, film: NDArray) -> Evaluation:
        """Residual and Jacobian at scaled unknowns (N), with lagged films (2, Z) [m]."""
        outputs = self.roller.respond(self.inputs(scaled, film), film)
        residual = self.scatter @ outputs.value.ravel()
        blocks = outputs.gradient @ self.gather.reshape(self.rollers, -1, self.size)
        jacobian = self.scatter @ blocks.reshape(-1, self.size)
        self._add_ring_and_cage(scaled * self.unknown_scale, residual, jacobian)
        self._add_spin_inertia(scaled * self.unknown_scale, residual, jacobian)
        return Evaluation(
            residual / self.residual_scale,
            jacobian * self.unknown_scale / self.residual_scale[:, None],
            outputs.state,
        )

    def _add_ring_and_cage(self, x: NDArray, residual: NDArray, jacobian: NDArray) -> None:
        operation = self.roller.operation
        residual[Z] += operation.radial_load
        residual[TILT_Z] += operation.moment
        if not operation.free_tilt:
            for row in (TILT_Z, TILT_Y):
                scale = self.residual_scale[row] / self.unknown_scale[row]
                residual[row], jacobian[row, row] = scale * x[row], scale
        drag, ring = self._land
        residual[CAGE] += drag * (ring - x[CAGE])
        jacobian[CAGE, CAGE] -= drag
        deviations = slice(BORDER + 3 * self.rollers, self.size)
        residual[deviations] += x[deviations]
        jacobian[deviations, deviations] += np.eye(self.size - deviations.start)

    def _add_spin_inertia(self, x: NDArray, residual: NDArray, jacobian: NDArray) -> None:
        """-J omega_c dw/dphi, differenced towards the roller ahead of which this one comes."""
        if not self.spin_inertia:
            return
        rows = np.arange(self.rollers) + self.roller_unknown(2).start
        before = np.roll(rows, 1 if x[CAGE] >= 0 else -1)
        factor = self.roller.bearing.roller.inertia * self.rollers / (2 * np.pi)
        change = x[rows] - x[before]
        residual[rows] -= factor * abs(x[CAGE]) * change
        jacobian[rows, rows] -= factor * abs(x[CAGE])
        jacobian[rows, before] += factor * abs(x[CAGE])
        jacobian[rows, CAGE] -= factor * np.sign(x[CAGE]) * change

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
