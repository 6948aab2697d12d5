"""Starts at a large slip of the cage, with a ring that friction pushes aside."""

from functools import partial

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.solve.rollers.static_equilibrium import film_at, frictionless_loads, static_equilibrium
from quasidynamic.solve.start.frictionless import frictionless_ring, static_unknowns
from quasidynamic.solve.start.lumped import LumpedRollers, held_back
from quasidynamic.solve.start.tilted import tilted_by_moments

TRIAL_SLIPS = np.array([0.003, 0.01, 0.03, 0.08, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 0.96, 0.99])
SMALLEST_SLIP = 1e-10
SLIP_HALVINGS = 12  # of the logarithm between two of `TRIAL_SLIPS`


def slipping_start(balance: BearingBalance, logit_offset: float = 0.0) -> NDArray:
    """Scaled unknowns (C, N) with the cage slip at which lumped rollers drive the cage just enough.

    For light loads at high speed, where the slip is not small, and for a ring that friction pushes
    aside. Rollers have one slice; the spins follow from the tractions at each slip, the slip from
    the torque on the cage, the place of the ring from the loads with their friction.

    `logit_offset` moves the slip away from that, by so much on the scale of ln(slip / (1 - slip)).
    """
    slip = driven_slip(balance)
    return _start_at(balance, slip / (slip + (1 - slip) * np.exp(-logit_offset)))


RESTARTS = tuple(partial(slipping_start, logit_offset=logit_offset) for logit_offset in (1.5, -1.5, 4.0))


def driven_slip(balance: BearingBalance) -> NDArray:
    """Least slip (C) at which lumped rollers drive the cage against its resistance."""
    cases = len(balance.points)
    case = np.tile(np.arange(cases), len(TRIAL_SLIPS))
    lumped, slips = LumpedRollers(balance.take(case)), np.repeat(TRIAL_SLIPS, cases)
    drives = (lumped.at(slips)[2] > 0).reshape(len(TRIAL_SLIPS), cases)
    # The least slip at which the rollers drive the cage, and the one before it, where it lags.
    least = np.where(drives.any(0), drives.argmax(0), len(TRIAL_SLIPS) - 1)
    low, high = np.where(least > 0, TRIAL_SLIPS[least - 1], SMALLEST_SLIP), TRIAL_SLIPS[least]
    lumped = LumpedRollers(balance)
    for _ in range(SLIP_HALVINGS):
        middle = np.sqrt(low * high)
        drives = lumped.at(middle)[2] > 0
        low, high = np.where(drives, low, middle), np.where(drives, middle, high)
    return np.sqrt(low * high)


def _start_at(balance: BearingBalance, slip: NDArray) -> NDArray:
    """Scaled unknowns (C, N) of lumped rollers at a slip (C), the ring where they hold the load."""
    points = balance.points
    drift, friction, _ = LumpedRollers(balance).at(slip)
    turned = np.arctan2(points.load_y, points.load_z) - friction[:, None]
    cage_drift = -balance.rolling_cage * slip[:, None]
    unknowns = static_unknowns(balance, cage_drift)._replace(spin_drift=drift)
    unknowns = unknowns._replace(film=film_at(balance, unknowns, frictionless_loads(balance, unknowns)))
    load = points.load * np.sin(turned), points.load * np.cos(turned)
    resting = static_equilibrium(balance, frictionless_ring(balance, unknowns, np.array(load)[..., 0]))
    return balance.pack(held_back(balance, tilted_by_moments(balance, resting)))
