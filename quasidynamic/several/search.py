"""Other equilibria of an operating point, found by solving from other spins, films and slips."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import INNER, Unknowns
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.several.indicator import rigid_balance
from quasidynamic.several.starts import Patterns, far, near
from quasidynamic.solve.outcome import SolverOutcome
from quasidynamic.solve.rollers.pseudo_time import growth_rates
from quasidynamic.solve.rollers.static_equilibrium import film_at, frictionless_loads
from quasidynamic.solve.rollers.strategy import solve_each
from quasidynamic.solve.start.frictionless import frictionless_ring

DIFFERENT = 1e-3  # of the largest load, or of the spin in pure rolling, by which two equilibria differ
ROUNDS = 3  # of pseudo-time between elastic raceways, which move a roller out of a contact again
FOLLOWED = 3  # equilibria of the highest and of the lowest load, around which more are searched
FILM_ROUNDS = 2  # films and place of the ring, one after the other, at the spins of a start


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
