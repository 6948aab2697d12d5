"""A solved state of the bearing, in physical units."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.bearing import CAGE, INNER, OUTER, TILT_Z, BearingBalance, Y, Z
from quasidynamic.balance.roller import RollerState
from quasidynamic.contact.hertz import peak_pressure
from quasidynamic.outcome.life import basic_life
from quasidynamic.solve import Step


@dataclass(frozen=True)
class Equilibrium:
    """What the bearing does in one state. Z rollers, M shapes, K slices; inner first, outer second."""

    balance: BearingBalance
    step: Step

    @property
    def status(self) -> str:
        """Empty while iterating; otherwise how the solve ended."""
        return self.step.status

    @property
    def residual(self) -> float:
        """Largest unbalanced force over the reference force [-]."""
        return self.step.residual

    @property
    def rollers(self) -> RollerState:
        """Forces and speeds at the rollers."""
        return self.step.evaluation.rollers

    @cached_property
    def unknowns(self) -> NDArray:
        """Unknowns of the balance in SI units."""
        return self.step.unknowns * self.balance.unknown_scale

    @property
    def forces(self) -> NDArray:
        """Generalised forces (2, Z, M) [N] of the rollers on the raceways; [..., 0] is the load."""
        return np.array([self.rollers.inner.force, self.rollers.outer.force])

    @property
    def slice_loads(self) -> NDArray:
        """Load per length (2, Z, K) [N/m]."""
        return np.array([self.rollers.inner.slice_load, self.rollers.outer.slice_load])

    @property
    def deviation(self) -> NDArray:
        """Shape coefficients (2, Z, M) of the outward raceway deviations [m]."""
        m, count = self.balance.roller.shapes, self.balance.rollers
        given = self.balance.deviation
        total = np.zeros((2, count, m)) if given is None else given.copy()
        for race in (INNER, OUTER):
            place = self.balance.deviation_unknown(race)
            if place is not None:
                total[race] += self.unknowns[place].reshape(count, m)
        return total

    @property
    def cage_speed(self) -> float:
        """Cage speed [rad/s]."""
        return float(self.unknowns[CAGE])

    @property
    def cage_slip(self) -> float:
        """Lag of the cage behind pure rolling, as a fraction [-]."""
        return 1.0 - self.cage_speed / self.balance.cage_speed

    @property
    def roller_speed(self) -> NDArray:
        """Spin (Z) relative to the cage [rad/s]."""
        return self.unknowns[self.balance.roller_unknown(2)]

    @property
    def roller_tilt(self) -> NDArray:
        """Tilt (Z) of the rollers in the plane through the bearing axis [rad]."""
        relative = self.unknowns[self.balance.roller_unknown(1)]
        return (relative + self.deviation[OUTER, :, 1]) / (self.balance.roller.inner.slices.length / 2)

    @property
    def ring_displacement(self) -> NDArray:
        """Displacement (y, z) of the inner ring against the outer one [m]."""
        return self.unknowns[[Y, Z]]

    @property
    def ring_tilt(self) -> NDArray:
        """Slopes (dz/dx, dy/dx) of the inner ring [rad]."""
        return self.unknowns[TILT_Z : TILT_Z + 2]

    @property
    def ring_moment(self) -> NDArray:
        """Moments (2) [N m] that act on the inner ring from outside: applied, or held by its guide."""
        moment = self.balance.roller.inner.slices.length / 2 * self.rollers.inner.force[:, 1]
        azimuth = self.balance.roller.bearing.azimuths
        return np.array([moment @ np.cos(azimuth), moment @ np.sin(azimuth)])

    @property
    def driving_torque(self) -> float:
        """Torque that turns the inner ring [N m]: traction and rolling shear at its raceway."""
        rolling = self.balance.roller.operation.direction * self.rollers.inner.rolling.force
        return float(self.balance.roller.bearing.inner_radius * (self.rollers.inner.traction + rolling).sum())

    @property
    def peak_pressure(self) -> NDArray:
        """Largest Hertz pressure (2) at the inner and outer raceway [Pa]."""
        roller = self.balance.roller
        return np.array(
            [
                peak_pressure(q.max(), contact.radius, contact.modulus)
                for q, contact in zip(self.slice_loads, (roller.inner, roller.outer), strict=True)
            ]
        )

    @property
    def life(self) -> float:
        """Basic reference life L10 [10^6 revolutions]."""
        inner, outer = self.slice_loads * self.balance.roller.inner.slices.width
        operation = self.balance.roller.operation
        return basic_life(
            inner,
            outer,
            self.balance.roller.bearing,
            (operation.inner_speed != 0.0, operation.outer_speed != 0.0),
        )

    @cached_property
    def _load_response(self) -> NDArray:
        """Change of the unknowns (N) per newton of radial load."""
        load = np.zeros(self.balance.size)
        load[Z] = 1.0 / self.balance.residual_scale[Z]
        return -np.linalg.solve(self.step.evaluation.jacobian, load) * self.balance.unknown_scale

    @property
    def stiffness(self) -> float:
        """Radial tangent stiffness between the rings, along the load [N/m]; the film is held."""
        return float(1.0 / self._load_response[Z])

    def change_of_forces(self) -> NDArray:
        """Change of the generalised forces (2, Z, M) per newton of radial load [-]."""
        m, count = self.balance.roller.shapes, self.balance.rollers
        change = (self.balance.gather @ self._load_response).reshape(count, -1)
        return np.array(
            [
                np.einsum("jab,jb->ja", state.force_by_approach, change[:, here])
                for state, here in (
                    (self.rollers.inner, slice(0, m)),
                    (self.rollers.outer, slice(m, 2 * m)),
                )
            ]
        )
