"""Newton steps that find out which rollers touch elastic raceways."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.unknowns import CAGE, INNER, OUTER, TILT_Z, Unknowns
from quasidynamic.solve.rollers.bordered_system import Shift
from quasidynamic.solve.rollers.newton import Iterate, bounded, bounded_spins, norm, step
from quasidynamic.solve.rollers.static_equilibrium import (
    film_at,
    frictionless_loads,
    lying_on_a_raceway,
    static_equilibrium,
    tilts_between_raceways,
)
from quasidynamic.solve.step_length import SolverOutcome

MAX_STEPS = 40
MAX_STEPS_NEAR = 12  # where the start is nearly the solution, or it is not
SMALL_CHANGE = 0.2  # of the largest approach of a roller and its outer raceway
LARGEST_TILT = 300.0  # scaled change of a slope of the ring in a step: 0.3 rad
LOADED = 1e-3  # of the largest load, above which a roller turns like the most loaded one
SMALL_SLIP = 0.01  # of the cage, up to which rollers may be closer to pure rolling
NEARLY = 0.1  # length of the scaled residual of displacements
SHORTEST_STEP = 2.0**-7  # of a step that is damped
HELD = Shift(spin=1e9, cage=1e9)  # on the diagonal of the scaled matrix: spins and cage do not move


class Start(NamedTuple):
    """Where a search of C cases begins."""

    unknowns: NDArray  # (C, N) scaled
    leading: NDArray  # (C) the most loaded roller

    def take(self, cases: NDArray) -> "Start":
        """Start of some of the cases."""
        return Start(self.unknowns[cases], self.leading[cases])


def contact_search(
    balance: BearingBalance, unknowns: NDArray, near: bool = False, damped: bool = False
) -> Iterator[Iterate]:
    """Yield steps of the running cases; a case leaves when its displacements hardly change.

    The load law is nearly linear, so a full step solves the problem of the rollers that touched before it,
    however far it overshoots; damped steps would be many and small. After a step the rollers are put into
    static equilibrium. Friction is not linear at all: cage and spins stay as they are at the start, and every
    roller that is loaded turns like the most loaded one of the start.
    """
    cases = np.arange(len(unknowns))
    system = balance.evaluate(unknowns)
    yield Iterate(0, cases, unknowns, system, [SolverOutcome.RUNNING] * len(cases), cases >= 0)
    start, fast = Start(unknowns, _most_loaded(system)), not (near or damped)
    found = fast & (_unbalanced(balance, system) < NEARLY)
    for number in range(1, (MAX_STEPS_NEAR if near else MAX_STEPS) + 1):
        if found.all():
            return
        if found.any():
            left = np.flatnonzero(~found)
            cases, balance, unknowns, start = (
                cases[left],
                balance.take(left),
                unknowns[left],
                start.take(left),
            )
            system = balance.evaluate(unknowns)
        if near:
            unknowns, contacts_kept = _with_friction(balance, unknowns, system)
        else:
            unknowns, contacts_kept = _with_spins_held(balance, start, unknowns, system, damped)
        system = balance.evaluate(unknowns)
        ending = contacts_kept | ((not damped) & (_unbalanced(balance, system) < NEARLY))
        unknowns, system = _without_slip(balance, unknowns, system, ending)
        finite = np.isfinite(norm(system))
        outcomes = [SolverOutcome.RUNNING if each else SolverOutcome.NOT_FINITE for each in finite]
        yield Iterate(number, cases, unknowns, system, outcomes, cases >= 0)
        found = contacts_kept | ~finite | (fast & (_unbalanced(balance, system) < NEARLY))


def _with_spins_held(
    balance: BearingBalance, start: Start, unknowns: NDArray, system: Linearisation, damped: bool
) -> tuple[NDArray, NDArray]:
    """Settled unknowns after a step in which cage and spins keep their speeds; whether it was small (C)."""
    change = step(balance, system, shift=HELD)
    change[:, TILT_Z:CAGE] = np.clip(change[:, TILT_Z:CAGE], -LARGEST_TILT, LARGEST_TILT)
    length, before = np.ones((len(unknowns), 1)), _unbalanced(balance, system)
    moved = _turning_alike(balance, start, unknowns + change)
    while damped:
        worse = ~(_unbalanced(balance, balance.evaluate(moved)) < before) & (length[:, 0] > SHORTEST_STEP)
        if not worse.any():
            break
        length[worse] /= 2
        shorter = _turning_alike(balance, start, unknowns + length * change)
        moved = np.where(worse[:, None], shorter, moved)
    return moved, _is_small(balance, unknowns, np.where(length < 1.0, change, moved - unknowns))


def _turning_alike(balance: BearingBalance, start: Start, unknowns: NDArray) -> NDArray:
    """Settled unknowns with the speeds of a start, loaded rollers with those of its most loaded one."""
    begin = balance.unpack(start.unknowns)
    free = balance.unpack(unknowns)._replace(cage_drift=begin.cage_drift, spin_drift=begin.spin_drift)
    moved = _settled(balance, free)
    load = frictionless_loads(balance, moved, uneven=True)
    loaded = load[INNER] > LOADED * load[INNER].max(axis=1, keepdims=True)
    leading = np.take_along_axis(begin.spin_drift, start.leading[:, None], axis=1)
    moved = moved._replace(spin_drift=np.where(loaded, leading, begin.spin_drift))
    return balance.pack(moved._replace(film=film_at(balance, moved, load)))


def _without_slip(
    balance: BearingBalance, unknowns: NDArray, system: Linearisation, ending: NDArray
) -> tuple[NDArray, Linearisation]:
    """Unknowns, system; ending cases (C) in pure rolling where slips are small and it is closer to balance.

    Traction of a stiff oil reaches its limit at slips of 1e-11: those of one roller are far from balance at
    another, and Newton's method, which comes up from pure rolling in a few steps, overshoots from there.
    """
    x = balance.unpack(unknowns)
    ending = ending & (np.abs(x.cage_drift / balance.rolling_cage)[:, 0] < SMALL_SLIP)
    if not ending.any():
        return unknowns, system
    rolling = x._replace(cage_drift=np.zeros_like(x.cage_drift), spin_drift=np.zeros_like(x.spin_drift))
    without = balance.pack(rolling)
    there = balance.evaluate(without)
    closer = ending & (norm(there) < norm(system))
    if not closer.any():
        return unknowns, system
    chosen = np.where(closer[:, None], without, unknowns)
    return chosen, there if closer.all() else balance.evaluate(chosen)


def _unbalanced(balance: BearingBalance, system: Linearisation) -> NDArray:
    """Length of the scaled residual without films, spins and cage (C)."""
    forces = system.residual[:, balance.layout.forces]
    return np.sqrt(np.vecdot(forces, forces))


def _with_friction(
    balance: BearingBalance, unknowns: NDArray, system: Linearisation
) -> tuple[NDArray, NDArray]:
    """Unknowns after a step of all of them, settled unless it was small; whether it was (C)."""
    change = step(balance, system)
    small = _is_small(balance, unknowns, change)
    if small.all():
        return bounded(balance, unknowns, unknowns + change), small
    moved = _settled(balance, balance.unpack(bounded_spins(balance, unknowns, unknowns + change)))
    film = film_at(balance, moved, frictionless_loads(balance, moved, uneven=True))
    moved = balance.pack(moved._replace(film=film))
    if small.any():
        moved = np.where(small[:, None], bounded(balance, unknowns, unknowns + change), moved)
    return moved, small


def _settled(balance: BearingBalance, unknowns: Unknowns) -> Unknowns:
    """Rollers in static equilibrium between their raceways, tilted no more than these."""
    tilted = tilts_between_raceways(balance, unknowns)
    return lying_on_a_raceway(balance, static_equilibrium(balance, tilted, uneven=True))


def _is_small(balance: BearingBalance, unknowns: NDArray, change: NDArray) -> NDArray:
    """Whether displacements change by a small share of the largest approach (C)."""
    small = SMALL_CHANGE * unknowns[:, balance.layout.field(0)].max(axis=1)
    return np.abs(change[:, balance.layout.displacements]).max(axis=1) < small


def _most_loaded(system: Linearisation) -> NDArray:
    """Roller of the largest load on the inner raceway, or on the outer one where the inner has none (C)."""
    load = system.state.contact.force[:, 0]
    return np.where(load[INNER].any(axis=1, keepdims=True), load[INNER], load[OUTER]).argmax(axis=1)
