"""From start to end: Newton's method, a better start, pseudo-time, and an ending for every case."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.bearing import BearingBalance
from quasidynamic.solve.contact_search import contact_search
from quasidynamic.solve.endings import Ending
from quasidynamic.solve.newton import Sweep, newton
from quasidynamic.solve.pseudo_time import Pace, pseudo_time

ROUNDS = 12  # of pseudo-time, each followed by Newton's method

Start = Callable[[BearingBalance], NDArray]


@dataclass(frozen=True)
class Solved:
    """Where C cases ended; filled while they are solved."""

    unknowns: NDArray  # (C, N) scaled
    endings: list[Ending]
    evaluations: NDArray  # (C)

    def left(self) -> NDArray:
        """Cases that may still be solved."""
        done = (Ending.CONVERGED, Ending.UNDETERMINED)
        return np.array([case for case, ending in enumerate(self.endings) if ending not in done], int)

    def follow(self, sweeps: Iterator[Sweep], cases: NDArray) -> None:
        """Take over how some cases end."""
        for sweep in sweeps:
            here = cases[sweep.cases]
            self.evaluations[here] += 1
            for place, (case, ending) in enumerate(zip(here, sweep.endings, strict=True)):
                if ending is not Ending.NONE:
                    self.unknowns[case], self.endings[case] = sweep.unknowns[place], ending


def solve(balance: BearingBalance, start: NDArray, better: Start) -> Solved:
    """Solve all cases: Newton's method from the start; those left, from a better start and in pseudo-time.

    Parameters
    ----------
    balance : BearingBalance
        C cases
    start : array (C, N)
        scaled unknowns to begin with
    better : callable
        a start that costs more, for some of the cases
    """
    endings = [Ending.UNDETERMINED if free else Ending.NONE for free in balance.undetermined]
    solved = Solved(start.copy(), endings, np.zeros(len(start), int))
    left = solved.left()
    if len(left):
        solved.follow(newton(_some(balance, left), start[left]), left)
    left = solved.left()
    if len(left):
        unknowns = better(_some(balance, left))
        solved.follow(newton(_some(balance, left), unknowns), left)
        _lead(balance, solved, left, unknowns)
    return solved


def _lead(balance: BearingBalance, solved: Solved, cases: NDArray, unknowns: NDArray) -> None:
    """Go through pseudo-time, trying Newton's method after every round."""
    left = solved.left()
    unknowns, pace = unknowns[np.isin(cases, left)], Pace.first(len(left))
    for _ in range(ROUNDS):
        if not len(left):
            return
        here, led = _some(balance, left), unknowns.copy()
        time, shift = pace.time.copy(), pace.shift.copy()
        for sweep, pace_now in pseudo_time(here, unknowns, pace):
            solved.evaluations[left[sweep.cases]] += 1
            led[sweep.cases] = sweep.unknowns
            time[sweep.cases], shift[sweep.cases] = pace_now.time, pace_now.shift
        solved.follow(newton(here, led), left)
        still = np.isin(left, solved.left())
        left, unknowns, pace = left[still], led[still], Pace(time[still], shift[still])


def _some(balance: BearingBalance, cases: NDArray) -> BearingBalance:
    return balance if len(cases) == len(balance.points) else balance.take(cases)


def iterate(balance: BearingBalance, unknowns: NDArray) -> Iterator[Sweep]:
    """Yield the accepted iterates of one case whose raceways yield: contact first, then Newton's method."""
    last = None
    for last in contact_search(balance, unknowns):
        yield last
    assert last is not None  # the search yields its start
    if last.endings[0] is not Ending.NONE:
        return
    for sweep in newton(balance, last.unknowns):
        if sweep.number and (sweep.accepted[0] or sweep.endings[0] is not Ending.NONE):
            yield sweep.numbered(last.number + sweep.number)
