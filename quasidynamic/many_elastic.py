"""Many bearings between the same elastic raceways."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from quasidynamic.columns import columns_of
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.equilibrium import Batch, Equilibria, Equilibrium
from quasidynamic.roller import Compliance, RollerBearing, side_by_side_batches, solve_many
from quasidynamic.several.indicator import each_several_likely
from quasidynamic.solve.rollers.many_elastic import ManyCases, Way, a_few
from quasidynamic.solve.rollers.parametric_balance import between
from quasidynamic.solve.rollers.solved_neighbours import coordinates
from quasidynamic.solve.step_length import SolverOutcome


def solve_many_elastic(
    bearings: Sequence[RollerBearing],
    compliance: Compliance,
    starts: Equilibria | None = None,
    deviation: NDArray | None = None,
) -> Equilibria:
    """Equilibria of many bearings between the same elastic raceways.

    The answers are those of `RollerBearing.iterate` one after the other. Bearings that differ in operation
    and clearance only are solved side by side, most of them from a fit to solved ones around. Where several
    equilibria are likely a bearing is solved from its own start besides, and alone where both differ: which
    one is reached never depends on its neighbours. Bearings that are solved from a fit alone need no start.

    Rollers and axial modes of the bearings are those of the raceways. The compliance (Z, M, Z, M) is the
    outward deviation of inner and outer raceway per outward force [m/N], None is rigid; the deviation, (2, Z,
    M) or (bearings, 2, Z, M) [m], is outward and there without any roller load. Starts are equilibria of the
    same bearings between rigid raceways, as `solve_many` finds them; without, those that are needed are
    solved.

    There is an equilibrium for each bearing, also where none was reached; its `ways` count how they were
    solved. A start that was not reached is returned as it is.
    """
    unsolved = () if starts is None else starts.unsolved
    begun = np.setdiff1d(np.arange(len(bearings)), unsolved)
    batches = [] if starts is None else [_start(starts[place], place) for place in unsolved]
    kinds = side_by_side_batches([bearings[place] for place in begun], max(len(begun), 1))
    for some, together in kinds:
        places = begun[some]
        given = deviation if deviation is None or deviation.ndim == 3 else deviation[places]
        alike = _Group(together, [bearings[place] for place in places], compliance, given)
        if starts is not None:
            alike.starts.update(enumerate(starts[place] for place in places))
        batches += alike.solved(places)
    return Equilibria(tuple(batches))


def _start(start: Equilibrium, place: int) -> Batch:
    """A start as the answer."""
    return Batch(np.array([place]), start.cases, (start.status,), np.array([0]), (Way.NONE,))


@dataclass(frozen=True)
class _Group:
    """Bearings that differ in numbers only."""

    together: RollerBearing  # which stands for them
    bearings: list[RollerBearing]
    compliance: Compliance
    deviation: NDArray | None  # (2, Z, M) or (bearings, 2, Z, M)
    starts: dict[int, Equilibrium] = field(default_factory=dict)  # between rigid raceways; filled as needed

    def solved(self, places: NDArray) -> Iterator[Batch]:
        """Yield the bearings, which have places among all, in batches."""
        each = self.deviation if self.deviation is not None and self.deviation.ndim == 4 else None
        balance = self.together.balance(len(places), aligned=False)
        balance = between(balance, self.compliance, self.deviation)

        def begin(cases: NDArray) -> NDArray:
            self._begin(cases)
            begun = [balance.layout.joined(self.starts[int(case)].unknowns)[0] for case in cases]
            begun = np.array(begun) / balance.take(cases).scales.unknown
            begun[[not _converged(self.starts[int(case)]) for case in cases]] = np.nan
            return begun

        def alone(case: int) -> tuple[NDArray, SolverOutcome, int]:
            self._begin(np.array([case]))
            last, shape = self.starts[case], self.deviation if each is None else each[case]
            if _converged(last):
                *_, last = self.bearings[case].iterate(self.compliance, last, shape)
                return last.scaled, last.status, last.number
            unknowns = balance.layout.joined(last.unknowns) / balance.take(np.array([case])).scales.unknown
            return unknowns[0], last.status, last.number

        numbers = columns_of(self.together, len(places))
        many = ManyCases.of(balance, coordinates(numbers, each), begin, alone)
        with np.errstate(all="ignore"):  # a trial step may be absurd
            many.solve()
            for some in a_few(many.by_load(np.arange(len(places)))):
                yield self._batch(many, some, places)

    def _begin(self, cases: NDArray) -> None:
        """Solve the starts of some cases that are not known."""
        unknown = [int(case) for case in cases if int(case) not in self.starts]
        if unknown:
            self.starts.update(
                zip(unknown, solve_many([self.bearings[case] for case in unknown]), strict=True)
            )

    def _batch(self, many: ManyCases, cases: NDArray, places: NDArray) -> Batch:
        """Some cases, those with several likely equilibria where each ends alone."""
        states = BearingStates(
            many.balance.take(cases), many.solved.unknowns[cases], self.together.axial_modes
        )
        doubtful = each_several_likely(states)
        if doubtful.any():
            many.confirm(cases[doubtful])
            confirmed = many.solved.unknowns[cases]
            if not np.array_equal(confirmed, states.scaled):
                states = BearingStates(states.balance, confirmed, states.axial_modes)
                doubtful = each_several_likely(states)
        outcomes, ways = (tuple(of[case] for case in cases) for of in (many.solved.outcomes, many.ways))
        return Batch(places[cases], states, outcomes, many.solved.evaluations[cases], ways, doubtful)


def _converged(start: Equilibrium) -> bool:
    return start.status is SolverOutcome.CONVERGED
