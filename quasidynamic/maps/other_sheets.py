"""States of other sheets, searched by solves from other spins and slips that are spread over a map."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.maps.newton_states import AT_ONCE, Mapped, by_pseudo_time, in_batches
from quasidynamic.maps.points import GridPoints
from quasidynamic.maps.sheets import connect_all
from quasidynamic.maps.states import States
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.several.search import Patterns, far, in_order, near, started
from quasidynamic.solve.step_length import SolverOutcome

SEED = 20  # of points and patterns at random, the same at every call
POINTS = 48  # of a round
PATTERNS, CROSSED, ZONES = 4, 3, 3  # of a point: around a state, between two states, zones at random
SLOWING = 0.6  # spin over rolling that a roller loses in a radian behind the zone, at most
SLIPS = 1e-4, 0.9  # of the cage
SEARCHED_AT_ONCE = 512  # starts of a call: few take long, and the fewer calls, the fewer end with these alone
QUIET, QUIET_AMONG_SEVERAL = 2, 4  # rounds without another state, after which the search ends
MOST_ROUNDS = 40


def search(
    points: GridPoints, states: States, mapped: Mapped, tell: Callable[[str], None]
) -> tuple[int, bool]:
    """Search states of other sheets where several are likely; every one is continued over the map.

    A sheet covers many points as a rule: a few starts at points all over the map find it as surely as many
    starts at one point.
    """
    rng, quiet = np.random.default_rng(SEED), 0
    if not states.doubtful.any() and states.stable_count.max(initial=0) < 2:
        return 0, True
    for number in range(MOST_ROUNDS):
        before, several = len(states), np.flatnonzero(states.stable_count > 1)
        doubtful = np.union1d(states.point[states.doubtful], several)
        some = rng.choice(doubtful, min(POINTS, len(doubtful)), replace=False)
        where = f"from {len(some)} of {len(doubtful)} points where several states are likely"
        tell(f"other sheets: round {number + 1} of at most {MOST_ROUNDS}, {where}")
        _try(points, states, some, rng, mapped)
        connect_all(points, states, mapped)
        quiet = quiet + 1 if len(states) == before else 0
        if quiet == (QUIET_AMONG_SEVERAL if states.stable_count.max() > 1 else QUIET):
            return number + 1, True
    return MOST_ROUNDS, False


def _try(points: GridPoints, states: States, some: NDArray, rng: np.random.Generator, mapped: Mapped) -> None:
    """Solve from patterns at random around a state at random of each of some points."""
    begun = np.array([rng.choice(states.at_point[point]) for point in some])
    chosen = [_patterns(points, states, state, rng) for state in begun]
    every = np.repeat(begun, [len(each.spin) for each in chosen])
    patterns = Patterns(*(np.concatenate(parts) for parts in zip(*chosen, strict=True)))
    starts = np.concatenate(
        [
            _starts(points, states, every[few], Patterns(patterns.spin[few], patterns.cage_drift[few]))
            for few in (slice(first, first + AT_ONCE) for first in range(0, len(every), AT_ONCE))
        ]
    )
    there = states.point[every]
    found = in_batches(
        lambda batch: points.at(there[batch]), starts, by_pseudo_time, mapped, SEARCHED_AT_ONCE
    )
    states.add(there, found)


def _patterns(points: GridPoints, states: States, state: int, rng: np.random.Generator) -> Patterns:
    """Some of the spins and slips around a state."""
    balance, scaled = points.at(states.point[[state]]), states.reached.scaled[state]
    known = Equilibrium(balance, scaled, SolverOutcome.CONVERGED, 0, points.axial_modes)
    every = near(known).joined(far(known))
    chosen = rng.choice(len(every.spin), min(PATTERNS, len(every.spin)), replace=False)
    around = Patterns(every.spin[chosen], every.cage_drift[chosen])
    every_kind = around.joined(_zones(known, rng))
    others = [other for other in states.at_point[states.point[state]] if other != state]
    if not others:
        return every_kind
    return every_kind.joined(_crossed(points, states, state, rng.choice(others), rng))


def _zones(known: Equilibrium, rng: np.random.Generator) -> Patterns:
    """Rollers that roll in a zone at random and slow down behind it, cages that slip by any share."""
    rollers = known.balance.layout.rollers
    begin, end = rng.uniform(0, 0.5, (ZONES, 1)), rng.uniform(0.5, 1, (ZONES, 1))
    passed = np.arange(rollers) / rollers  # of a turn, from opposite to the load
    behind = 2 * np.pi * np.mod(passed - end, 1.0)  # the zone [rad]
    rolls = (passed >= begin) & (passed <= end)
    in_order_of_passage = np.where(rolls, 1.0, 1.0 - rng.uniform(0, SLOWING, (ZONES, 1)) * behind)
    spin = np.empty_like(in_order_of_passage)
    spin[:, in_order(known)] = in_order_of_passage
    smallest, largest = SLIPS
    slip = smallest * (largest / smallest) ** rng.random(ZONES)
    return Patterns(spin, -slip * known.balance.rolling_cage[0, 0])


def _crossed(points: GridPoints, states: States, one: int, other: int, rng: np.random.Generator) -> Patterns:
    """Rollers in an arc at random as one state has them, all others as another state of the same point."""
    spins, rollers = states.reached.spin[[one, other]], states.reached.spin.shape[1]
    begin, length = rng.integers(0, rollers, CROSSED), rng.integers(1, rollers, CROSSED)
    place = np.mod(np.arange(rollers) - begin[:, None], rollers)
    balance = points.at(states.point[[one, other]])
    drifts = balance.unpack(states.reached.scaled[[one, other]]).cage_drift[:, 0]
    share = rng.random(CROSSED)
    spin = np.where(place < length[:, None], spins[0], spins[1])
    return Patterns(spin, share * drifts[0] + (1 - share) * drifts[1])


def _starts(points: GridPoints, states: States, some: NDArray, patterns: Patterns) -> NDArray:
    """Scaled unknowns (n, N) with the spins and slips of patterns, around states (n)."""
    balance = points.at(states.point[some])
    known = BearingStates(balance, states.reached.scaled[some], points.axial_modes)
    with np.errstate(all="ignore"):  # a start may be absurd
        unknowns = started(_in_shape(balance, known), known.unknowns, patterns)
    return balance.pack(unknowns._replace(deviation=known.unknowns.deviation))


def _in_shape(balance: BearingBalance, known: BearingStates) -> BearingBalance:
    """The same balance between raceways that keep the shape of the known states."""
    if not balance.layout.elastic_raceways:
        return balance
    return replace(balance, compliance=(None, None), deviation=known.deviation)
