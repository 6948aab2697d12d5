"""Drifts of cage and spins from pure rolling at which friction about balances, under static loads."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import Unknowns
from quasidynamic.solve.rollers.static_equilibrium import (
    frictionless_loads,
)
from quasidynamic.solve.start.friction import balanced_drifts
from quasidynamic.solve.start.frictionless import static_unknowns
from quasidynamic.solve.start.lumped import LumpedRollers, held_back
from quasidynamic.solve.start.tilted import tilted_by_moments

SMALL_SLIP = 0.1  # slip up to which the centrifugal force and the spins of unloaded rollers change little
HELD_ROUNDS = (
    2  # of spins by the loads, and of loads by the lift of pocket friction, which goes with the spin
)
TRIAL_SLIPS = np.geomspace(1e-5, 0.98, 9)  # slips that are looked at for a start


def static_start(balance: BearingBalance) -> NDArray:
    """Scaled unknowns (C, N) near equilibrium: both raceways of a roller in series, no tilt.

    The ring displacement along the load is one scalar root; films are those of pure rolling.
    """
    start = tilted_by_moments(balance, static_unknowns(balance, np.zeros_like(balance.rolling_cage)))
    cage_drift, spin_drift = guessed_drifts(balance, start)
    guess = start._replace(cage_drift=cage_drift, spin_drift=spin_drift)
    scaled = balance.pack(held_back(balance, guess))
    slipping = np.flatnonzero(np.abs(cage_drift) > SMALL_SLIP * np.abs(balance.rolling_cage))
    if len(slipping):  # less centrifugal force, and spins that follow from each other
        slow = balance.take(slipping)
        static = tilted_by_moments(slow, static_unknowns(slow, cage_drift[slipping]))
        drifts = balanced_drifts(slow, static, cage_drift[slipping], spin_drift[slipping])
        scaled[slipping] = slow.pack(static._replace(cage_drift=drifts[0], spin_drift=drifts[1]))
    return scaled


def guessed_drifts(balance: BearingBalance, static: Unknowns) -> tuple[NDArray, NDArray]:
    """Drifts of cage (C, 1) and spins (C, Z) at a slip where tractions about drive the cage.

    Each roller shares the sliding between its raceways as if friction grew with load and sliding;
    between the slips that are looked at, the torque on the cage is interpolated over their logarithm.
    """
    cases, bearing = len(balance.points), balance.roller.bearing
    load = frictionless_loads(
        balance, static, uneven=bool(static.tilt.any())
    )  # of rollers tilted by a moment
    inner_share = load[1] / load.sum(0)
    r_i, r_o = bearing.inner_radius, bearing.outer_radius
    spin_per_cage = (inner_share * (r_i + r_o) - r_i) / (bearing.roller.diameter / 2)
    case = np.arange(len(TRIAL_SLIPS) * cases) % cases  # all cases at each slip
    lumped = LumpedRollers(balance.take(case))
    cage_drift = -np.repeat(TRIAL_SLIPS, cases)[:, None] * lumped.balance.rolling_cage
    line_load = load[:, case] / lumped.balance.roller.bearing.roller.length
    forces = lumped.forces(line_load, cage_drift, cage_drift * spin_per_cage[case])
    torque = lumped.driving_torque(forces, cage_drift).reshape(len(TRIAL_SLIPS), cases)
    slip = _sign_change(np.log(TRIAL_SLIPS), torque)
    cage_drift = -np.exp(slip)[:, None] * balance.rolling_cage
    return cage_drift, cage_drift * spin_per_cage


def _sign_change(places: NDArray, values: NDArray) -> NDArray:
    """Where values (places, C) become positive first, interpolated; an end where there is no such place."""
    each = np.arange(values.shape[1])
    positive = values > 0
    last = np.where(positive.any(0), positive.argmax(0), len(places) - 1)
    first = np.maximum(last - 1, 0)
    before, after = values[first, each], values[last, each]
    rise = after - before
    weight = np.where((before < 0) & (after > 0), -before / np.where(rise > 0, rise, 1.0), 1.0)
    return places[first] + weight * (places[last] - places[first])
