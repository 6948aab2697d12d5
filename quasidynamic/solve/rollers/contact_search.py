"""Undamped Newton steps that find out which rollers touch raceways that yield."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.solve.outcome import SolverOutcome
from quasidynamic.solve.rollers.newton import Sweep, norm, step
from quasidynamic.solve.rollers.static_equilibrium import between_raceways, film_at, resting_loads, settled
from quasidynamic.solve.rollers.step_bounds import bounded, bounded_spins

LIMIT = 40  # steps
SMALL_CHANGE = 0.2  # of the largest approach of a roller and its outer raceway


def contact_search(balance: BearingBalance, unknowns: NDArray) -> Iterator[Sweep]:
    """Yield undamped steps of one case, rollers settled after each, until displacements hardly change.

    The load law is nearly linear, so a full step solves the problem of the rollers that touched
    before it, however far it overshoots; a damped one crawls. Friction is not linear at all: spins are held.
    """
    system, one = balance.evaluate(unknowns), np.array([True])
    yield Sweep(0, np.array([0]), unknowns, system, [SolverOutcome.RUNNING], one)
    for number in range(1, LIMIT + 1):
        change = step(balance, system)
        small = SMALL_CHANGE * unknowns[0, balance.layout.field(0)].max()
        found = bool(np.abs(change[0, balance.layout.displacements]).max() < small)
        if found:
            unknowns = bounded(balance, unknowns, unknowns + change)
        else:
            after = bounded_spins(balance, unknowns, unknowns + change)
            moved = between_raceways(balance, balance.unpack(after))
            moved = settled(balance, moved, shaped=True)
            film = film_at(balance, moved, resting_loads(balance, moved, shaped=True))
            unknowns = balance.pack(moved._replace(film=film))
        system = balance.evaluate(unknowns)
        outcome = SolverOutcome.RUNNING if np.isfinite(norm(system)[0]) else SolverOutcome.NOT_FINITE
        yield Sweep(number, np.array([0]), unknowns, system, [outcome], one)
        if found or outcome is not SolverOutcome.RUNNING:
            return
