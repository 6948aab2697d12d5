"""Balance of one roller between its raceways and in its pocket, for all rollers at once."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.gradient import Graded
from quasidynamic.contact.drag import orbit_drag
from quasidynamic.contact.raceway import ContactState, RacewayContact
from quasidynamic.parts.bearing import CylindricalRollerBearing
from quasidynamic.parts.operation import Operation

CAGE_FORCE_ROUNDING = 0.5  # [N] width over which the pocket force changes side
STILL = 1e-6  # of the nominal surface speed: keeps powers of the entrainment speed finite


class RollerState(NamedTuple):
    """Everything that happens at the rollers (Z each) in one state."""

    inner: ContactState
    outer: ContactState
    sliding: NDArray  # (2, Z) raceway over roller surface, inner, outer [m/s]
    entrainment: NDArray  # (2, Z) [m/s] >= 0
    film: NDArray  # (2, Z) [m] used in this state
    cage_force: NDArray  # (Z) on the roller along +t [N]
    drag: float  # oil-air mixture on one roller, against +t [N]


class Outputs(NamedTuple):
    """What a roller hands to the balance of the whole bearing: columns (Z, outputs)."""

    value: NDArray
    gradient: NDArray  # (Z, outputs, inputs)
    state: RollerState


@dataclass(frozen=True, kw_only=True)
class RollerBalance:
    """Equations of one roller.

    Inputs of roller j: M shape coefficients of the approach at the inner and M at the outer
    raceway [m], spin relative to the cage [rad/s], cage speed [rad/s].

    Outputs: M conjugate forces at the inner and M at the outer raceway [N]; residuals of the
    radial force [N], tilt moment [N m] and spin [N m]; the roller's torque on the cage [N m]; the
    tangential force that the inner ring exerts, rolling pressure included [N].
    """

    bearing: CylindricalRollerBearing
    operation: Operation
    inner: RacewayContact
    outer: RacewayContact
    oil_fraction: float

    @property
    def shapes(self) -> int:
        """Number M of axial shapes."""
        return self.inner.slices.shapes

    def respond(self, inputs: NDArray, film: NDArray) -> Outputs:
        """Evaluate the equations of all rollers.

        Parameters
        ----------
        inputs : array (Z, 2 M + 2)
            see the class
        film : array (2, Z)
            inner and outer film [m], lagged: no derivative is taken
        """
        sliding, speed, entrainment, speed_by = self._surface_speeds(inputs)
        m = self.shapes
        states = (
            self.inner.state(inputs[:, :m], sliding[0].value, entrainment[0], film[0]),
            self.outer.state(inputs[:, m : 2 * m], sliding[1].value, entrainment[1], film[1]),
        )
        (q_i, m_i, t_i, r_i), (q_o, m_o, t_o, r_o) = (
            self._forces(state, race, sliding[race], speed[race], speed_by[race])
            for race, state in enumerate(states)
        )
        s, g = self.operation.direction, self.bearing.diameter_ratio
        r_i, r_o = s * r_i, s * r_o
        drag, drag_by_cage = orbit_drag(inputs[0, -1], self.bearing, self.inner.oil, self.oil_fraction)
        cage_force = self._cage_only(inputs, drag, drag_by_cage) - (
            t_i + t_o + (1 - 2 * g) * r_i - (1 + 2 * g) * r_o
        )
        pocket = self.bearing.cage.pocket_friction * cage_force.rounded_abs(CAGE_FORCE_ROUNDING)
        r_w, r_m = self.bearing.roller.diameter / 2, self.bearing.pitch_diameter / 2
        radial = q_i - q_o + self._centrifugal(inputs) + (s * self.bearing.cage.pocket_friction) * cage_force
        spin = r_w * (t_i - t_o - r_i - r_o - s * pocket)
        cage_torque = (-r_m) * cage_force - (s * r_w) * pocket
        rows = (radial, m_o - m_i, spin, cage_torque, t_i + (1 - 2 * g) * r_i)
        return Outputs(
            *self._stacked(states, rows),
            RollerState(
                *states,
                sliding=np.array([u.value for u in sliding]),
                entrainment=np.array(entrainment),
                film=film,
                cage_force=cage_force.value,
                drag=drag,
            ),
        )

    def _surface_speeds(self, inputs: NDArray):
        """Sliding of raceway over roller, rolling speed, its magnitude and slope at each raceway."""
        r_w, r_i, r_o = self.bearing.roller.diameter / 2, self.bearing.inner_radius, self.bearing.outer_radius
        spin, cage = self._input(inputs, -2), self._input(inputs, -1)
        inner = self._constant(inputs, self.operation.inner_speed * r_i) - r_i * cage
        outer = self._constant(inputs, self.operation.outer_speed * r_o) - r_o * cage
        sliding = (inner - r_w * spin, outer + r_w * spin)
        rolling = (0.5 * (inner + r_w * spin), 0.5 * (r_w * spin - outer))
        nominal = abs(self.operation.inner_speed - self.operation.outer_speed) * r_i
        magnitude = tuple(np.hypot(v.value, STILL * nominal) for v in rolling)
        slope = tuple(v.value / size for v, size in zip(rolling, magnitude, strict=True))
        return sliding, rolling, magnitude, slope

    def _forces(self, state: ContactState, race: int, sliding: Graded, speed: Graded, speed_by: NDArray):
        """Load, tilt moment, traction and rolling shear of one raceway as graded quantities."""
        m = self.shapes
        here = slice(race * m, (race + 1) * m)

        def by_approach(derivative: NDArray) -> NDArray:
            gradient = np.zeros_like(sliding.gradient)
            gradient[:, here] = derivative
            return gradient

        entrained = speed_by[:, None] * speed.gradient
        lever = self.inner.slices.length / 2
        load = Graded(state.force[:, 0], by_approach(state.force_by_approach[:, 0]))
        moment = lever * Graded(state.force[:, 1], by_approach(state.force_by_approach[:, 1]))
        traction = Graded(
            state.traction,
            by_approach(state.traction_by_approach)
            + state.traction_by_sliding[:, None] * sliding.gradient
            + state.traction_by_entrainment[:, None] * entrained,
        )
        rolling = Graded(
            state.rolling.force,
            state.rolling.by_load[:, None] * load.gradient
            + state.rolling.by_entrainment[:, None] * entrained,
        )
        return load, moment, traction, rolling

    def _centrifugal(self, inputs: NDArray) -> Graded:
        """Centrifugal force of a roller, m r_m omega_c^2 [N]."""
        cage = self._input(inputs, -1)
        factor = self.bearing.roller.mass * self.bearing.pitch_diameter / 2
        return Graded(factor * cage.value**2, 2 * factor * cage.value[:, None] * cage.gradient)

    def _cage_only(self, inputs: NDArray, value: float, slope: float) -> Graded:
        """A quantity that depends on the cage speed alone."""
        cage = self._input(inputs, -1)
        return Graded(np.full(len(inputs), value), slope * cage.gradient)

    @staticmethod
    def _input(inputs: NDArray, column: int) -> Graded:
        gradient = np.zeros_like(inputs)
        gradient[:, column] = 1.0
        return Graded(inputs[:, column], gradient)

    @staticmethod
    def _constant(inputs: NDArray, value: float) -> Graded:
        return Graded(np.full(len(inputs), value), np.zeros_like(inputs))

    def _stacked(self, states, rows) -> tuple[NDArray, NDArray]:
        m = self.shapes
        rollers, width = rows[0].gradient.shape
        gradient = np.zeros((rollers, 2 * m + len(rows), width))
        for race, state in enumerate(states):
            here = slice(race * m, (race + 1) * m)
            gradient[:, here, here] = state.force_by_approach
        gradient[:, 2 * m :] = np.stack([row.gradient for row in rows], axis=1)
        value = np.column_stack([states[0].force, states[1].force, *(row.value for row in rows)])
        return value, gradient
