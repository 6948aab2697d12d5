"""Newton's method on spins and cage speed alone, all normal loads and films kept."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import Unknowns
from quasidynamic.solve.rollers.elastic_system import cyclic_tridiagonal
from quasidynamic.solve.rollers.static_equilibrium import frictionless_loads
from quasidynamic.solve.start.lumped import LumpedRollers

STEPS = 12
NEAR_ENOUGH = 1e-2  # of nominal speeds
CAGE_CHANGE, SPIN_CHANGE = 0.3, 0.5  # of nominal speeds in a step


class _Drifts(NamedTuple):
    """Drifts from pure rolling, with their Newton steps and what is unbalanced."""

    cage: NDArray  # (C, 1) [rad/s]
    spin: NDArray  # (C, Z) [rad/s]
    cage_step: NDArray  # (C, 1) [rad/s]
    spin_step: NDArray  # (C, Z) [rad/s]
    unbalanced: NDArray  # (C, 1) sum of squared forces [N2]

    def where(self, better: NDArray, other: "_Drifts") -> "_Drifts":
        """These drifts in the cases that are better, the others elsewhere."""
        return _Drifts(*(np.where(better, mine, its) for mine, its in zip(self, other, strict=True)))


def balanced_drifts(
    balance: BearingBalance, static: Unknowns, cage_drift: NDArray, spin_drift: NDArray
) -> tuple[NDArray, NDArray]:
    """Drifts of cage (C, 1) and spins (C, Z) at which friction nearly balances under the loads of `static`.

    Unloaded rollers get their spin from those before them: it travels around the bearing by a roller or
    two with every step of Newton's method. Here a step costs a tenth of one with all slices. A start
    only: after `STEPS` the least unbalanced drifts are returned, balanced or not.
    """
    friction = _Friction.of(balance, static, cage_drift, spin_drift)
    best, damping = friction.at(cage_drift, spin_drift), np.ones_like(cage_drift)
    cage, spin = np.abs(balance.rolling_cage), np.abs(balance.rolling_spin)
    for _ in range(STEPS):
        size = np.maximum(np.abs(best.cage_step) / cage, np.abs(best.spin_step).max(-1, keepdims=True) / spin)
        running = ~(size < NEAR_ENOUGH)
        if not running.any():
            break
        trial = friction.at(
            best.cage + np.clip(damping * best.cage_step, -CAGE_CHANGE * cage, CAGE_CHANGE * cage),
            best.spin + np.clip(damping * best.spin_step, -SPIN_CHANGE * spin, SPIN_CHANGE * spin),
        )
        better = running & (trial.unbalanced < best.unbalanced)
        best, damping = trial.where(better, best), np.where(better, 1.0, damping / 2)
    return best.cage, best.spin


@dataclass(frozen=True)
class _Friction:
    """Balance of spins and cage under constant loads."""

    rollers: LumpedRollers
    line_load: NDArray  # (2, C, Z) [N/m]
    film: NDArray  # (2, C, Z) [m]
    shear: NDArray  # (2, C, Z) [N] of the inlets, without sense

    @classmethod
    def of(cls, balance, static: Unknowns, cage_drift: NDArray, spin_drift: NDArray) -> "_Friction":
        rollers, raceways = LumpedRollers(balance), balance.roller.raceways
        load = frictionless_loads(balance, static, uneven=bool(static.tilt.any()))
        sliding, entrainment, _ = rollers.surfaces(cage_drift, spin_drift)
        return cls(
            rollers,
            load / raceways.slices.length,
            raceways.film(load, sliding, entrainment).thickness,
            raceways.rolling(load, entrainment).force,
        )

    def at(self, cage_drift: NDArray, spin_drift: NDArray) -> _Drifts:
        """Newton step at these drifts: spins as a cyclic ring, bordered by the cage."""
        balance = self.rollers.balance
        bearing = balance.roller.bearing
        r_w, r_m = bearing.roller.diameter / 2, bearing.pitch_diameter / 2
        traction, by_speed, sense = self._traction(cage_drift, spin_drift)
        shear = sense * self.shear
        transport = balance.spin_transport(cage_drift, spin_drift)
        spin = r_w * (traction[0] - traction[1] - shear[0] - shear[1]) - transport.torque
        by_spin, by_cage = r_w * (by_speed[:, 0] - by_speed[:, 1])
        sides = np.array([-spin, by_cage - transport.by_cage])
        alone, per_cage = cyclic_tridiagonal(
            by_spin - transport.by_spin,
            transport.by_before,
            transport.by_after,
            sides,
            balance.layout.rows,
        )
        torque, slope = self.rollers.cage_torque(np.concatenate([traction, shear]), cage_drift)
        row, corner = r_m * by_speed[0].sum(0), slope + (r_m * by_speed[1].sum(0)).sum(-1)
        cage_step = -(torque + (row * alone).sum(-1)) / (corner - (row * per_cage).sum(-1))
        return _Drifts(
            cage_drift,
            spin_drift,
            cage_step[:, None],
            alone - per_cage * cage_step[:, None],
            ((spin / r_w) ** 2).sum(-1, keepdims=True) + (torque[:, None] / r_m) ** 2,
        )

    def _traction(self, cage_drift: NDArray, spin_drift: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """Tractions (2, C, Z) [N], slopes by spin and cage speed (2, 2, C, Z) [N s], sense of rolling."""
        roller = self.rollers.balance.roller
        sliding, entrainment, sense = self.rollers.surfaces(cage_drift, spin_drift)
        pull = roller.raceways.traction(self.line_load, sliding, entrainment, self.film)
        force, by_sliding, by_entrainment = (
            roller.raceways.slices.length * each
            for each in (pull.force, pull.by_sliding, pull.by_entrainment)
        )
        slides, rolls = roller.speed_slopes
        return force, by_sliding * slides + by_entrainment * sense * rolls, sense
