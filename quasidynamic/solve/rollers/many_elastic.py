"""Many cases between the same elastic raceways: some by contact searches, others from those around."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.solve.rollers.contact_search import contact_search
from quasidynamic.solve.rollers.newton import newton
from quasidynamic.solve.rollers.solved_neighbours import local_fit, spread_out
from quasidynamic.solve.rollers.strategy import SolvedCases
from quasidynamic.solve.step_length import SolverOutcome

CASES_AT_ONCE = 64  # their slices fit into the processor's cache
FIRST = 8  # cases that are solved by contact searches, or the root of their number
ALIKE = 1e-6  # scaled difference of unknowns of one equilibrium
GROWTH = 3  # of the number of solved cases, before others are solved from them

Starts = Callable[[NDArray], NDArray]  # scaled unknowns (n, N) that some cases begin with alone; NaN: none
Alone = Callable[[int], tuple[NDArray, SolverOutcome, int]]  # unknowns (N), outcome, evaluations of a case


class Way(StrEnum):
    """How a case was solved."""

    NONE = ""
    FITTED = "from a fit to solved cases around"
    SEARCHED = "after a contact search from its start"
    CONFIRMED = "from a fit, and after a contact search from its start"
    ALONE = "alone"


@dataclass(frozen=True)
class ManyCases:
    """C cases between the same elastic raceways and how far they are solved; filled while they are."""

    balance: BearingBalance  # of C cases
    coordinates: NDArray  # (C, P) of what differs between them
    starts: Starts
    alone: Alone
    solved: SolvedCases
    ways: list[Way]  # (C)

    @classmethod
    def of(cls, balance: BearingBalance, coordinates: NDArray, starts: Starts, alone: Alone) -> "ManyCases":
        """Cases that are not solved yet."""
        count = len(coordinates)
        solved = SolvedCases(
            np.zeros((count, balance.layout.size)), [SolverOutcome.RUNNING] * count, np.zeros(count, int)
        )
        return cls(balance, coordinates, starts, alone, solved, [Way.NONE] * count)

    def solve(self) -> None:
        """Solve all cases.

        Some that are spread over all coordinates are searched, then more and more cases are solved from a fit
        to the solved ones around; where Newton's method fails from there, they are searched.
        """
        count = len(self.coordinates)
        end = min(count, max(FIRST, int(np.sqrt(count))))
        order = spread_out(self.coordinates, end)
        self.search(self.by_load(order[:end]))
        while end < count:
            begin, end = end, GROWTH * end
            self._solve_around(self.by_load(order[begin:end]), order[:begin])

    def search(self, cases: NDArray, way: Way = Way.SEARCHED) -> None:
        """Solve some cases as each is solved alone: by contact searches side by side, failures one by one."""
        for some in a_few(cases):
            found = self.starts(some)
            begun = np.isfinite(found).all(axis=1)
            some, found = some[begun], found[begun]
            for iterate in contact_search(self.balance.take(some), found):
                self.solved.evaluations[some[iterate.cases]] += 1
                found[iterate.cases] = iterate.unknowns
            self._newton(some, found, way)
        self._solve_alone(self._unsolved(cases))

    def confirm(self, cases: NDArray) -> None:
        """Make sure that some cases, which may have several equilibria, end where each ends alone.

        What a fit and a search lead to alike is taken; anything else is solved alone. Unknowns that are found
        again stay as they were, to the last digit.
        """
        before = self.solved.unknowns[cases]
        self.search(np.array([case for case in cases if self.ways[case] is Way.FITTED], int), Way.CONFIRMED)
        confirmed = np.array([self.ways[case] is Way.CONFIRMED for case in cases])
        doubtful = cases[~(confirmed & self._alike(cases, before))]
        self._solve_alone(np.array([case for case in doubtful if self.ways[case] is not Way.ALONE], int))
        again = self._alike(cases, before)
        self.solved.unknowns[cases[again]] = before[again]

    def _alike(self, cases: NDArray, before: NDArray) -> NDArray:
        """Which of some cases are as they were before."""
        return np.abs(self.solved.unknowns[cases] - before).max(axis=1, initial=0.0) < ALIKE

    def _solve_alone(self, cases: NDArray) -> None:
        for case in cases:
            unknowns, outcome, evaluations = self.alone(int(case))
            self.solved.unknowns[case], self.solved.outcomes[case] = unknowns, outcome
            self.solved.evaluations[case] += evaluations
            self.ways[case] = Way.ALONE

    def by_load(self, cases: NDArray) -> NDArray:
        """The same cases, those of similar loads and speeds side by side: similar rollers touch there."""
        points = self.balance.points
        return cases[np.lexsort((points.relative_speed[cases, 0], points.load[cases, 0]))]

    def _solve_around(self, cases: NDArray, tried: NDArray) -> None:
        """Solve some cases from those that were tried before."""
        known = np.setdiff1d(tried, self._unsolved(tried))
        if len(known):
            fit = local_fit(self.coordinates[known], self.coordinates[cases])
            for some in a_few(np.arange(len(cases))):
                self._newton(cases[some], fit.take(some).of(self.solved.unknowns[known]), Way.FITTED)
        self.search(self._unsolved(cases))

    def _newton(self, cases: NDArray, starts: NDArray, way: Way) -> None:
        """Try Newton's method from starts (n, N) of a few cases."""
        self.solved.follow(newton(self.balance.take(cases), starts), cases)
        for case in cases:
            self.ways[case] = way

    def _unsolved(self, cases: NDArray) -> NDArray:
        """Those of some cases that are not solved."""
        return np.array([c for c in cases if self.solved.outcomes[c] is not SolverOutcome.CONVERGED], int)


def a_few(cases: NDArray) -> Iterator[NDArray]:
    """Yield cases that are solved side by side."""
    for first in range(0, len(cases), CASES_AT_ONCE):
        yield cases[first : first + CASES_AT_ONCE]
