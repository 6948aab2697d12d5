"""Other equilibria of an operating point, found by solving from other spins, films and slips."""

from dataclasses import dataclass, replace
from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import INNER, Unknowns
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.several.indicator import doubts, is_loaded, rigid_balance
from quasidynamic.solve.rollers.pseudo_time import growth_rates
from quasidynamic.solve.rollers.static_equilibrium import film_at, frictionless_loads
from quasidynamic.solve.rollers.strategy import solve_each
from quasidynamic.solve.start.frictionless import frictionless_ring
from quasidynamic.solve.step_length import SolverOutcome

MUCH = 0.03  # of the largest load
DOUBTFUL = 4  # rollers that films decide on most
SLOW = 0.3, -0.5  # spins over the fastest that leave a film too thin to touch
SLOW_EXIT = 0.2  # spin of rollers behind a loaded zone that ends earlier, over that of the fastest
ENTRY_SHIFTS, EXIT_SHIFTS = (
    (-1, 0, 1, 2),
    (-2, -1, 0, 1),
)  # rollers by which a loaded zone begins and ends later
SLIPS = (1e-3, 0.1, 0.25, 0.45, 0.7, 0.9)  # of the cage
UNLOADED_SPINS = (-0.3, 0.3)  # over rolling
SCATTERED = 12  # patterns of either kind, fewer
MOST_SPINS = 1000  # in the patterns of a kind, for large bearings
DIFFERENT = 1e-3  # of the largest load, or of the spin in pure rolling, by which two equilibria differ
ROUNDS = 3  # of pseudo-time between elastic raceways, which move a roller out of a contact again
FOLLOWED = 3  # equilibria of the highest and of the lowest load, around which more are searched
FILM_ROUNDS = 2  # films and place of the ring, one after the other, at the spins of a start


class Patterns(NamedTuple):
    """Spins of P patterns over that of pure rolling, and drifts of the cage from it."""

    spin: NDArray  # (P, Z) [-]
    cage_drift: NDArray  # (P) [rad/s]

    @classmethod
    def of(cls, spins: list[NDArray], cage_drift: NDArray | float) -> "Patterns":
        """Patterns of a list of spins (Z), with their drifts or one drift for all."""
        return cls(np.array(spins), np.broadcast_to(cage_drift, len(spins)))

    def joined(self, other: "Patterns") -> "Patterns":
        """Both, one after the other."""
        return Patterns(*(np.concatenate(pair) for pair in zip(self, other, strict=True)))


def near(state: Equilibrium) -> Patterns:
    """Some rollers fast or slow, and loaded zones that begin or end some rollers earlier or later."""
    rolling = _spin(state)
    spins = [*_fast_or_slow(state, rolling), *_shifted_zones(state, rolling)]
    return Patterns.of(spins, state.unknowns.cage_drift[0, 0])


def far(state: Equilibrium) -> Patterns:
    """Other slips of the cage, and spins that nothing orders; the same at every call."""
    loaded, rollers = is_loaded(state.cases)[0], state.balance.layout.rollers
    slipping = [(slip, spin) for slip in SLIPS for spin in UNLOADED_SPINS]
    spins = [np.where(loaded, 1 - slip, min(spin, 1 - slip)) for slip, spin in slipping]
    rng = np.random.default_rng(rollers)
    number = min(SCATTERED, 1 + MOST_SPINS // rollers)
    scattered = [rng.uniform(-0.2, 1.0, rollers) for _ in range(number)]
    scattered += [np.where(rng.random(rollers) < 0.5, 1.0, rng.uniform(0, 0.6)) for _ in range(number)]
    drifts = -np.array([slip for slip, _ in slipping]) * state.balance.rolling_cage[0, 0]
    return Patterns.of(spins, drifts).joined(Patterns.of(scattered, state.unknowns.cage_drift[0, 0]))


def _spin(state: Equilibrium) -> NDArray:
    """Spins (Z) over that of pure rolling."""
    return state.roller_speed / state.balance.rolling_spin[0, 0]


def in_order(state: Equilibrium) -> NDArray:
    """Rollers (Z) in the order in which they pass the load, from opposite to it."""
    sense = np.sign(state.balance.rolling_cage[0, 0])
    before = (state.balance.roller.bearing.azimuths - state.load_direction) * sense + np.pi
    return np.argsort(np.mod(before, 2 * np.pi))


def _fast_or_slow(state: Equilibrium, rolling: NDArray) -> list[NDArray]:
    """Rollers that films decide on most, and those at the ends of the loaded zone, in every combination."""
    fastest = rolling[is_loaded(state.cases)[0]].max()
    doubtful, ends = np.argsort(-doubts(state.cases)[0])[:DOUBTFUL], _ends(state)
    spins = []
    for rollers, slow in (*((doubtful, slow) for slow in SLOW), (ends, SLOW[-1])):
        for chosen in product((1.0, slow), repeat=len(rollers)):
            spins.append(rolling.copy())
            spins[-1][rollers] = np.multiply(chosen, fastest)
    return spins


def _ends(state: Equilibrium) -> NDArray:
    """The first and the last roller that carry much, and those beyond them."""
    order, load = in_order(state), state.loads[INNER]
    first, last = np.flatnonzero(load[order] > MUCH * load.max())[[0, -1]]
    return np.array(sorted({*order[[first - 1, first, last, (last + 1) % len(order)]].tolist()}))


def _shifted_zones(state: Equilibrium, rolling: NDArray) -> list[NDArray]:
    """Loaded zones with other ends; none where nearly all rollers are loaded."""
    order = in_order(state)
    loaded, spin = is_loaded(state.cases)[0][order], rolling[order]
    first, last = np.flatnonzero(loaded)[[0, -1]]
    if last - first >= len(order) - 3:
        return []
    spins = []
    for begin in first + np.array(ENTRY_SHIFTS):
        for end in last + np.array(EXIT_SHIFTS):
            if 0 <= begin <= end < len(order) and (begin, end) != (first, last):
                spins.append(_zone(spin, (first, last), (begin, end), spin[loaded].max()))
    return [each[np.argsort(order)] for each in spins]


def _zone(spin: NDArray, old: tuple[int, int], new: tuple[int, int], fastest: float) -> NDArray:
    """Spins (Z), in order of passage, with the loaded zone between other rollers."""
    changed, (begin, end) = spin.copy(), new
    changed[begin : end + 1] = np.maximum(spin[begin : end + 1], fastest)
    for roller in range(old[0], begin):  # rollers that are loaded later go on slowing down
        changed[roller] = 2 * changed[roller - 1] - changed[roller - 2]
    if end < old[1]:
        changed[end + 1 :] = np.minimum(changed[end + 1 :], SLOW_EXIT * fastest)
    return changed


def other_equilibria(state: Equilibrium) -> tuple[Equilibrium, ...]:
    """Stable equilibria of the same operating point that differ from one that is known.

    Every one is solved to the tolerance of any other. Raceways keep the shape that they have in the known
    one: those of an elastic pair do not follow the loads.
    """
    search = _Search(rigid_balance(state), state.axial_modes)
    known = search.at(rigid_balance(state).pack(state.unknowns)[0])
    found = search.new([known], near(known), rounds=0)
    further = far(known) if found else near(known).joined(far(known))
    found += search.new([known, *found], further, rounds=1)
    left = list(found)
    for number in range(min(len(found), FOLLOWED)):  # from the ends of what is known, to widen it
        end = sorted(left, key=_largest_load)[-1 if number % 2 == 0 else 0]
        more = search.new([known, *found], near(end), rounds=0)
        left = [other for other in left if other is not end] + more
        found += more
    return tuple(sorted(found, key=_largest_load))


def _largest_load(state: Equilibrium) -> float:
    return float(state.loads[INNER].max())


def between_elastic_raceways(
    state: Equilibrium, compliance: tuple[NDArray | None, NDArray | None], unloaded: NDArray | None
) -> Equilibrium | None:
    """Equilibrium between elastic raceways near one between raceways of the same shape."""
    size = state.balance.layout.rollers * state.balance.roller.axial_modes
    inner, outer = (None if matrix is None else matrix.reshape(size, size) for matrix in compliance)
    balance = replace(state.balance, compliance=(inner, outer), deviation=unloaded)
    by_load = state.deviation if unloaded is None else state.deviation - unloaded
    start = state.unknowns._replace(deviation=np.moveaxis(by_load, -1, 1)[:, :, None])
    solved = solve_each(balance, balance.pack(start), ROUNDS)
    if solved.outcomes[0] is not SolverOutcome.CONVERGED:
        return None
    return replace(state, balance=balance, scaled=solved.unknowns[0])


def stable(state: Equilibrium) -> bool:
    """Whether small disturbances of cage and spins decay."""
    return bool(np.real(growth_rates(state.balance, state.system)).max() < 0)


def differ(one: Equilibrium, other: Equilibrium) -> bool:
    """Whether two equilibria are not the same: in a load, or in the spin of a roller."""
    load = np.abs(one.loads - other.loads).max() / max(one.loads[INNER].max(), other.loads[INNER].max())
    spin = np.abs(one.roller_speed - other.roller_speed).max() / abs(one.balance.rolling_spin[0, 0])
    return bool(max(load, spin) > DIFFERENT)


@dataclass(frozen=True)
class _Search:
    """Solves from patterns of spins, side by side."""

    balance: BearingBalance  # of one case between raceways of a given shape
    axial_modes: int

    def at(self, scaled: NDArray) -> Equilibrium:
        return Equilibrium(self.balance, scaled, SolverOutcome.CONVERGED, 0, self.axial_modes)

    def new(self, known: list[Equilibrium], patterns: Patterns, rounds: int) -> list[Equilibrium]:
        """Stable equilibria reached from the patterns that differ from the known ones and from each other."""
        alike = np.zeros(len(patterns.spin), int)
        many, bases = self.balance.take(alike), known[0].unknowns.take(alike)
        with np.errstate(all="ignore"):  # a start may be absurd
            solved = solve_each(many, many.pack(started(many, bases, patterns)), rounds)
        new: list[Equilibrium] = []
        for unknowns, outcome in zip(solved.unknowns, solved.outcomes, strict=True):
            if outcome is SolverOutcome.CONVERGED:
                state = self.at(unknowns)
                if all(differ(state, other) for other in [*known, *new]) and stable(state):
                    new.append(state)
        return new


def started(many: BearingBalance, bases: Unknowns, patterns: Patterns) -> Unknowns:
    """Unknowns of P cases with given spins and slips; films and the ring's place follow without friction."""
    start = bases._replace(
        cage_drift=patterns.cage_drift[:, None],
        spin_drift=(patterns.spin - 1) * many.rolling_spin,
    )
    load = np.array([many.points.load_y[:, 0], many.points.load_z[:, 0]])
    for _ in range(FILM_ROUNDS):
        start = start._replace(film=film_at(many, start, frictionless_loads(many, start)))
        start = frictionless_ring(many, start, load)
    return start
