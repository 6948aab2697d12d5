"""Newton steps that find out which rollers touch elastic raceways."""

from collections.abc import Iterator
from functools import partial

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.unknowns import CAGE, INNER, OUTER, TILT_Z, Unknowns
from quasidynamic.solve.outcome import SolverOutcome
from quasidynamic.solve.rollers.bordered_system import Shift
from quasidynamic.solve.rollers.newton import Iterate, norm, step
from quasidynamic.solve.rollers.static_equilibrium import (
    film_at,
    frictionless_loads,
    lying_on_a_raceway,
    static_equilibrium,
    tilts_between_raceways,
)
from quasidynamic.solve.rollers.step_bounds import bounded, bounded_spins

MAX_STEPS = 40
MAX_STEPS_NEAR = 12  # where the start is nearly the solution, or it is not
SMALL_CHANGE = 0.2  # of the largest approach of a roller and its outer raceway
LARGEST_TILT = 300.0  # scaled change of a slope of the ring in a step: 0.3 rad
LOADED = 1e-3  # of the largest load, above which a roller turns like the most loaded one
SMALL_SLIP = 0.01  # of the cage, up to which rollers may be nearer to pure rolling
NEARLY = 0.1  # length of the scaled residual of displacements
SHORTEST_STEP = 2.0**-7  # of a step that is damped
HELD = Shift(spin=1e9, cage=1e9)  # on the diagonal of the scaled matrix: spins and cage do not move


def contact_search(
    balance: BearingBalance, unknowns: NDArray, near: bool = False, damped: bool = False
) -> Iterator[Iterate]:
    """Yield steps of one case until displacements hardly change.

    The load law is nearly linear, so a full step solves the problem of the rollers that touched before it,
    however far it overshoots; damped steps would be many and small. After a step the rollers are put into
    static equilibrium. Friction is not linear at all: cage and spins stay as they are at the start, and every
    roller that is loaded turns like the most loaded one of the start.

    Parameters
    ----------
    balance : BearingBalance
        of one case
    unknowns : array (1, N)
        start, scaled
    near : bool
        whether the start is nearly the solution, such as that of a similar case: then cage and spins
        move too, the spins by a limited share
    damped : bool
        whether steps are halved until forces and deviations are nearer to balance: slower, and for very soft
        raceways, where full steps leap between sets of touching rollers
    """
    case, accepted = np.array([0]), np.array([True])
    system = balance.evaluate(unknowns)
    yield Iterate(0, case, unknowns, system, [SolverOutcome.RUNNING], accepted)
    start = balance.unpack(unknowns)
    shortest = SHORTEST_STEP if damped else 1.0
    advance = _with_friction if near else partial(_with_spins_held, start, _most_loaded(system), shortest)
    for number in range(1, (MAX_STEPS_NEAR if near else MAX_STEPS) + 1):
        if not (near or damped) and _unbalanced(balance, system) < NEARLY:
            return
        unknowns, contacts_kept = advance(balance, unknowns, system)
        system = balance.evaluate(unknowns)
        if contacts_kept or (not damped and _unbalanced(balance, system) < NEARLY):
            unknowns, system = _without_slip(balance, unknowns, system)
        outcome = SolverOutcome.RUNNING if np.isfinite(norm(system)[0]) else SolverOutcome.NOT_FINITE
        yield Iterate(number, case, unknowns, system, [outcome], accepted)
        if contacts_kept or outcome is not SolverOutcome.RUNNING:
            return


def _with_spins_held(
    start: Unknowns,
    leading: int,
    shortest: float,
    balance: BearingBalance,
    unknowns: NDArray,
    system: Linearisation,
) -> tuple[NDArray, bool]:
    """Settled unknowns after a step in which cage and spins keep their speeds, and whether it was small."""
    change = step(balance, system, shift=HELD)
    change[:, TILT_Z:CAGE] = np.clip(change[:, TILT_Z:CAGE], -LARGEST_TILT, LARGEST_TILT)
    length, before = 1.0, _unbalanced(balance, system)
    while True:
        moved = _turning_alike(balance, start, leading, unknowns + length * change)
        if length <= shortest or _unbalanced(balance, balance.evaluate(moved)) < before:
            return moved, _is_small(balance, unknowns, change if length < 1.0 else moved - unknowns)
        length /= 2


def _turning_alike(balance: BearingBalance, start: Unknowns, leading: int, unknowns: NDArray) -> NDArray:
    """Settled unknowns with the speeds of a start, loaded rollers with those of its most loaded one."""
    free = balance.unpack(unknowns)._replace(cage_drift=start.cage_drift, spin_drift=start.spin_drift)
    moved = _settled(balance, free)
    load = frictionless_loads(balance, moved, uneven=True)
    loaded = load[INNER] > LOADED * load[INNER].max()
    spins = np.where(loaded, start.spin_drift[:, leading, None], start.spin_drift)
    moved = moved._replace(spin_drift=spins)
    return balance.pack(moved._replace(film=film_at(balance, moved, load)))


def _without_slip(
    balance: BearingBalance, unknowns: NDArray, system: Linearisation
) -> tuple[NDArray, Linearisation]:
    """The unknowns and their system, in pure rolling where slips are small and that is nearer to balance.

    Traction of a stiff oil reaches its limit at slips of 1e-11: those of one roller are far from balance at
    another, and Newton's method, which comes up from pure rolling in a few steps, overshoots from there.
    """
    x = balance.unpack(unknowns)
    slip = np.abs(x.cage_drift / balance.rolling_cage).max()
    if not slip < SMALL_SLIP:
        return unknowns, system
    rolling = x._replace(cage_drift=np.zeros_like(x.cage_drift), spin_drift=np.zeros_like(x.spin_drift))
    without = balance.pack(rolling)
    there = balance.evaluate(without)
    return (without, there) if norm(there)[0] < norm(system)[0] else (unknowns, system)


def _unbalanced(balance: BearingBalance, system: Linearisation) -> float:
    """Length of the scaled residual without films, spins and cage."""
    layout, residual = balance.layout, system.residual[0]
    return float(np.linalg.norm(np.concatenate([residual[:CAGE], residual[layout.displacements[2:]]])))


def _with_friction(balance: BearingBalance, unknowns: NDArray, system: Linearisation) -> tuple[NDArray, bool]:
    """Unknowns after a step of all of them, settled unless it was small."""
    change = step(balance, system)
    if _is_small(balance, unknowns, change):
        return bounded(balance, unknowns, unknowns + change), True
    moved = _settled(balance, balance.unpack(bounded_spins(balance, unknowns, unknowns + change)))
    film = film_at(balance, moved, frictionless_loads(balance, moved, uneven=True))
    return balance.pack(moved._replace(film=film)), False


def _settled(balance: BearingBalance, unknowns: Unknowns) -> Unknowns:
    """Rollers in static equilibrium between their raceways, tilted no more than these."""
    tilted = tilts_between_raceways(balance, unknowns)
    return lying_on_a_raceway(balance, static_equilibrium(balance, tilted, uneven=True))


def _is_small(balance: BearingBalance, unknowns: NDArray, change: NDArray) -> bool:
    """Whether displacements change by a small share of the largest approach."""
    small = SMALL_CHANGE * unknowns[0, balance.layout.field(0)].max()
    return bool(np.abs(change[0, balance.layout.displacements]).max() < small)


def _most_loaded(system: Linearisation) -> int:
    """The roller of the largest load on the inner raceway, or on the outer one where the inner has none."""
    load = system.state.contact.force[:, 0, 0]
    return int(load[INNER if load[INNER].any() else OUTER].argmax())
