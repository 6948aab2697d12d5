"""Friction of rollers with one slice under loads that are known."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import Unknowns
from quasidynamic.contact.cage import land_torque
from quasidynamic.contact.drag import churning_torque
from quasidynamic.solve.rollers.static_equilibrium import (
    frictionless_loads,
    outward_force,
    slice_loads,
    static_equilibrium,
)
from quasidynamic.solve.start.frictionless import static_unknowns

NEAREST = np.log(1e-13)  # to rolling on one raceway, over the distance to rolling on the other
SPIN_HALVINGS = 20  # of the logarithm of that distance
SMALLEST_LOAD = 1e-9  # [N]
BRAKED_HALVINGS = 26  # of the spins between rolling backwards and nearly rolling
NEARLY_ROLLING = 0.999  # of the spin in pure rolling
MAX_SWEEPS = 40  # around the bearing: spins of unloaded rollers travel by a pitch in each
SMALL_CHANGE = 1e-3  # of the spin in pure rolling in a sweep


@dataclass(frozen=True)
class LumpedRollers:
    """Rollers of one slice under static loads, at a given cage speed."""

    balance: BearingBalance

    def at(self, slip: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """Drifts of the spins (C, Z), friction over load at the inner ring (C), torque on the cage (C).

        The torque [N m] is positive when it drives the cage the way it turns.
        """
        balance = self.balance
        cage_drift = -slip[:, None] * balance.rolling_cage
        state = static_unknowns(balance, cage_drift)
        line_load = frictionless_loads(balance, state) / balance.roller.raceways.slices.length
        drift, forces = self._drifts(line_load, cage_drift)
        t_i, _, r_i, _ = forces
        tangential = (t_i + (1 - 2 * balance.roller.bearing.diameter_ratio) * r_i).sum(-1)
        load = (line_load[0] * balance.roller.raceways.slices.length).sum(-1)
        friction = tangential / np.maximum(load, SMALLEST_LOAD)
        return drift, friction, self.driving_torque(forces, cage_drift)

    def driving_torque(self, forces: NDArray, cage_drift: NDArray) -> NDArray:
        """Torque (C) [N m] of tractions and shears (4, C, Z), drag and land, along the way the cage turns."""
        return self.cage_torque(forces, cage_drift)[0] * np.sign(self.balance.rolling_cage[:, 0])

    def cage_torque(self, forces: NDArray, cage_drift: NDArray) -> tuple[NDArray, NDArray]:
        """Signed torque on the cage (C) [N m], its slope (C) [N m s] while forces of rollers stay."""
        bearing = self.balance.roller.bearing
        (t_i, t_o, r_i, r_o), g = forces, bearing.diameter_ratio
        driving = bearing.pitch_diameter / 2 * (t_i + t_o + (1 - 2 * g) * r_i - (1 + 2 * g) * r_o)
        resistance, slope = self._resistance(self.balance.rolling_cage + cage_drift)
        return driving.sum(-1) + resistance, slope

    def _drifts(self, line_load: NDArray, cage_drift: NDArray) -> tuple[NDArray, NDArray]:
        """Drifts at which the tractions balance, and the forces there.

        They lie between rolling on the inner and on the outer raceway, mostly so close to one of them
        that the logarithm of the distance has to be halved.
        """
        bearing = self.balance.roller.bearing
        r_w = bearing.roller.diameter / 2
        inner = -cage_drift * bearing.inner_radius / r_w + np.zeros(line_load.shape[1:])
        outer = cage_drift * bearing.outer_radius / r_w + np.zeros(line_load.shape[1:])
        # Rolling on the inner raceway is the faster spin when the cage lags behind forwards.
        up = np.sign(inner - outer)

        def speeds_up(drift: NDArray) -> NDArray:
            t_i, t_o, r_i, r_o = self.forces(line_load, cage_drift, drift)
            return (t_i - t_o - r_i - r_o) * up > 0

        inwards = speeds_up((inner + outer) / 2)
        end, way = np.where(inwards, inner, outer), np.where(inwards, outer - inner, inner - outer)
        low, high = np.full(end.shape, NEAREST), np.full(end.shape, np.log(0.5))
        for _ in range(SPIN_HALVINGS):
            middle = (low + high) / 2
            further = speeds_up(end + way * np.exp(middle)) != inwards
            low, high = np.where(further, middle, low), np.where(further, high, middle)
        drift = end + way * np.exp((low + high) / 2)
        return drift, self._balanced(*self.forces(line_load, cage_drift, drift))

    def braked(self, slice_load: NDArray, cage_drift: NDArray, drift: NDArray) -> NDArray:
        """Drifts (C, Z); those at which rollers balance where friction of the pocket holds them back.

        A roller that hardly anything presses may are at rest in its pocket, or nearly so. Halving, as
        traction and friction of the pocket are at their limits on the way there; each roller beside the
        present spins of its neighbours, from which it gets its own. Loads are those per length (K, 2, C, Z)
        [N/m] of slices: a light roller touches with few of them.
        """
        balance, rolling = self.balance, self.balance.rolling_spin
        transport = balance.spin_transport(cage_drift, drift)

        def lags(spin: NDArray) -> NDArray:
            taken = transport.torque + transport.by_spin * (spin - rolling - drift)
            return self._driven(slice_load, cage_drift, spin - rolling, taken) < 0

        low, high = -rolling + np.zeros(drift.shape), NEARLY_ROLLING * rolling + np.zeros(drift.shape)
        held = lags(high)
        if not held.any():
            return drift
        for _ in range(BRAKED_HALVINGS):
            middle = (low + high) / 2
            slower = lags(middle)
            low, high = np.where(slower, low, middle), np.where(slower, middle, high)
        return np.where(held, (low + high) / 2 - rolling, drift)

    def _driven(self, slice_load: NDArray, cage_drift: NDArray, drift: NDArray, taken: NDArray) -> NDArray:
        """Force at the surface of the rollers (C, Z) [N] that drives their spin the way they roll.

        What transport has taken [N m] is subtracted.
        """
        roller, motion = self.balance.roller, self.balance.motion(cage_drift, drift)
        raceways, (sliding, entrainment, sense) = roller.raceways, self.surfaces(cage_drift, drift)
        load = raceways.slices.total(slice_load)
        film = raceways.film(load, sliding, entrainment).thickness
        t_i, t_o = raceways.slices.total(raceways.traction(slice_load, sliding, entrainment, film).force)
        r_i, r_o = sense * raceways.rolling(load, entrainment).force
        g, (drag, _) = roller.bearing.diameter_ratio, roller.drag(motion.cage_speed)
        pocket = drag - self.balance.weight[1] - t_i - t_o - (1 - 2 * g) * r_i + (1 + 2 * g) * r_o
        full = motion.spin / np.hypot(motion.spin, motion.standstill_spin)
        brake = roller.bearing.cage.pocket_friction * full * np.abs(pocket)
        taken = taken + self._churning(motion.spin)
        driving = t_i - t_o - r_i - r_o - brake - taken / (roller.bearing.roller.diameter / 2)
        return driving * np.sign(self.balance.rolling_spin)

    def _churning(self, spin: NDArray) -> NDArray | float:
        """Torque (C, Z) [N m] of the mixture against the spin."""
        lubrication = self.balance.roller.lubrication
        if lubrication.churning_gap is None:
            return 0.0
        share, gap = lubrication.oil_fraction, lubrication.churning_gap
        roller = self.balance.roller.bearing.roller
        return churning_torque(spin, roller, lubrication.oil, oil_fraction=share, gap=gap).torque

    @staticmethod
    def _balanced(t_i: NDArray, t_o: NDArray, r_i: NDArray, r_o: NDArray) -> NDArray:
        """Let the larger traction follow from the smaller one: halving does not find it on a steep slope."""
        inner_is_small = np.abs(t_i) < np.abs(t_o)
        return np.array(
            [
                np.where(inner_is_small, t_i, t_o + r_i + r_o),
                np.where(inner_is_small, t_i - r_i - r_o, t_o),
                r_i,
                r_o,
            ]
        )

    def forces(self, line_load: NDArray, cage_drift: NDArray, drift: NDArray) -> NDArray:
        """Traction at both raceways and rolling shear at both (4, C, Z) [N]."""
        raceways, length = self.balance.roller.raceways, self.balance.roller.raceways.slices.length
        sliding, entrainment, sense = self.surfaces(cage_drift, drift)
        load = line_load * length
        film = raceways.film(load, sliding, entrainment).thickness
        pull = raceways.traction(line_load, sliding, entrainment, film)
        shear = raceways.rolling(load, entrainment)
        return np.concatenate([pull.force * length, sense * shear.force])

    def surfaces(self, cage_drift: NDArray, drift: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """Sliding and entrainment speed (2, C, Z) [m/s], sense of rolling [-]."""
        return self.balance.roller.surfaces(self.balance.motion(cage_drift, drift), self.balance.points)

    def _resistance(self, cage_speed: NDArray) -> tuple[NDArray, NDArray]:
        """Torque (C) of oil-air mixture and land on the cage [N m], its slope by the cage speed [N m s]."""
        bearing, points = self.balance.roller.bearing, self.balance.points
        lever = bearing.pitch_diameter / 2 * bearing.all_rollers
        drag, drag_slope = self.balance.roller.drag(cage_speed)
        ring_speed = points.guiding_speed(bearing.cage.guidance)
        land = land_torque(ring_speed - cage_speed, bearing.cage, self.balance.roller.lubrication.oil)
        return (land.torque - lever * drag)[:, 0], (-land.by_speed - lever * drag_slope)[:, 0]


def held_back(balance: BearingBalance, start: Unknowns) -> Unknowns:
    """Spins of rollers that their pockets hold back in a slow bearing, and where these rollers rest then.

    Spins by loads, and loads by the lift of pocket friction, which goes with the spin; a sweep hands spins on
    to the next roller.
    """
    slow = ~(np.abs(balance.rolling_cage + start.cage_drift) > balance.slow_cage)[:, 0]
    if not slow.any():
        return start
    slow &= ~(outward_force(balance, start).min(axis=1) > 0.0)
    if slow.all():
        return _braked(balance, start)
    cases = np.flatnonzero(slow)
    return start.with_cases(cases, _braked(balance.take(cases), start.take(cases))) if len(cases) else start


def _braked(balance: BearingBalance, start: Unknowns) -> Unknowns:
    """Spins of rollers that pockets hold back, handed on until those of each case hardly change."""
    lumped, running = LumpedRollers(balance), np.ones((len(balance.points), 1), bool)
    for _ in range(MAX_SWEEPS):
        slice_load = slice_loads(balance, start, uneven=True)
        braked = lumped.braked(slice_load, start.cage_drift, start.spin_drift)
        spin_drift = np.where(running, braked, start.spin_drift)
        change = np.abs((spin_drift - start.spin_drift) / balance.rolling_spin).max(axis=1, keepdims=True)
        start = static_equilibrium(balance, start._replace(spin_drift=spin_drift), uneven=True)
        running &= ~(change < SMALL_CHANGE)
        if not running.any():
            break
    return start
