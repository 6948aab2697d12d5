"""Undamped Newton steps that find out which rollers touch elastic raceways."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.solve.outcome import SolverOutcome
from quasidynamic.solve.rollers.newton import Iterate, norm, step
from quasidynamic.solve.rollers.static_equilibrium import (
    film_at,
    frictionless_loads,
    static_equilibrium,
    tilts_between_raceways,
)
from quasidynamic.solve.rollers.step_bounds import bounded, bounded_spins

MAX_STEPS = 40
SMALL_CHANGE = 0.2  # of the largest approach of a roller and its outer raceway


def contact_search(balance: BearingBalance, unknowns: NDArray) -> Iterator[Iterate]:
    """Yield undamped steps of one case until displacements hardly change.

    After each step the rollers are put into static equilibrium. The load law is nearly linear, so a full step
    solves the problem of the rollers that touched before it, however far it overshoots; damped steps would be
    many and small. Friction is not linear at all: the change of the spins is limited.
    """
    case, accepted = np.array([0]), np.array([True])
    system = balance.evaluate(unknowns)
    yield Iterate(0, case, unknowns, system, [SolverOutcome.RUNNING], accepted)
    for number in range(1, MAX_STEPS + 1):
        change = step(balance, system)
        small = SMALL_CHANGE * unknowns[0, balance.layout.field(0)].max()
        contacts_kept = bool(np.abs(change[0, balance.layout.displacements]).max() < small)
        if contacts_kept:
            unknowns = bounded(balance, unknowns, unknowns + change)
        else:
            after = bounded_spins(balance, unknowns, unknowns + change)
            moved = tilts_between_raceways(balance, balance.unpack(after))
            moved = static_equilibrium(balance, moved, uneven=True)
            film = film_at(balance, moved, frictionless_loads(balance, moved, uneven=True))
            unknowns = balance.pack(moved._replace(film=film))
        system = balance.evaluate(unknowns)
        outcome = SolverOutcome.RUNNING if np.isfinite(norm(system)[0]) else SolverOutcome.NOT_FINITE
        yield Iterate(number, case, unknowns, system, [outcome], accepted)
        if contacts_kept or outcome is not SolverOutcome.RUNNING:
            return
