"""From start to end: Newton's method, a better start, pseudo-time, a heavier load."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.solve.outcome import SolverOutcome
from quasidynamic.solve.rollers.contact_search import contact_search
from quasidynamic.solve.rollers.load_continuation import from_heavier_load
from quasidynamic.solve.rollers.newton import Iterate, newton
from quasidynamic.solve.rollers.pseudo_time import StepLimits, pseudo_time

# Rounds of pseudo-time, each followed by Newton's method: before a heavier load, after it, at restarts.
ROUNDS = (3, 9, 3)

Start = Callable[[BearingBalance], NDArray]


@dataclass(frozen=True)
class Solved:
    """Where C cases ended; filled while they are solved."""

    unknowns: NDArray  # (C, N) scaled
    outcomes: list[SolverOutcome]
    evaluations: NDArray  # (C)

    def left(self) -> NDArray:
        """Cases that may still be solved."""
        done = (SolverOutcome.CONVERGED, SolverOutcome.UNDETERMINED)
        return np.array([case for case, outcome in enumerate(self.outcomes) if outcome not in done], int)

    def follow(self, sweeps: Iterator[Iterate], cases: NDArray) -> None:
        """Take over how some cases end."""
        for sweep in sweeps:
            here = cases[sweep.cases]
            self.evaluations[here] += 1
            for place, outcome in enumerate(sweep.outcomes):
                if outcome is not SolverOutcome.RUNNING:
                    self.unknowns[here[place]], self.outcomes[here[place]] = sweep.unknowns[place], outcome


def solve(balance: BearingBalance, start: NDArray, better: Sequence[Start]) -> Solved:
    """Solve all cases, those that one method leaves over by the next one.

    Parameters
    ----------
    balance : BearingBalance
        C cases
    start : array (C, N)
        scaled unknowns to begin with
    better : sequence of callables
        starts that cost more, tried one after the other for what is left
    """
    outcomes = [
        SolverOutcome.UNDETERMINED if free else SolverOutcome.RUNNING for free in balance.undetermined
    ]
    solved = Solved(start.copy(), outcomes, np.zeros(len(start), int))
    left = solved.left()
    if len(left):
        solved.follow(newton(_some(balance, left), start[left]), left)
    for number, restart in enumerate(better):
        left = solved.left()
        if not len(left):
            break
        led = start.copy()
        led[left] = restart(_some(balance, left))
        solved.follow(newton(_some(balance, left), led[left]), left)
        if number:
            _lead(balance, solved, led, ROUNDS[2])
            continue
        _lead(balance, solved, led, ROUNDS[0])
        _unload(balance, solved, restart)
        _lead(balance, solved, led, ROUNDS[1])
    return solved


def _lead(balance: BearingBalance, solved: Solved, led: NDArray, rounds: int) -> None:
    """Move `led` (C, N) through pseudo-time, trying Newton's method after every round."""
    pace = StepLimits.first(len(led))
    for _ in range(rounds):
        left = solved.left()
        if not len(left):
            return
        here = _some(balance, left)
        for sweep, now in pseudo_time(here, led[left], pace.take(left)):
            cases = left[sweep.cases]
            solved.evaluations[cases] += 1
            led[cases], pace.time[cases], pace.shift[cases] = sweep.unknowns, now.time, now.shift
        solved.follow(newton(here, led[left]), left)


def _unload(balance: BearingBalance, solved: Solved, better: Start) -> None:
    """Come down from a heavier load, one case after the other."""
    for case in solved.left():
        walk = from_heavier_load(balance.take(np.array([case])), better)
        solved.evaluations[case] += walk.evaluations
        if walk.unknowns is not None:
            solved.unknowns[case], solved.outcomes[case] = walk.unknowns[0], SolverOutcome.CONVERGED


def _some(balance: BearingBalance, cases: NDArray) -> BearingBalance:
    return balance if len(cases) == len(balance.points) else balance.take(cases)


def iterate(balance: BearingBalance, unknowns: NDArray) -> Iterator[Iterate]:
    """Yield the accepted iterates of one case whose raceways yield: contact first, then Newton's method."""
    last = None
    for last in contact_search(balance, unknowns):
        yield last
    assert last is not None  # the search yields its start
    if last.outcomes[0] is not SolverOutcome.RUNNING:
        return
    for sweep in newton(balance, last.unknowns):
        if sweep.number and (sweep.accepted[0] or sweep.outcomes[0] is not SolverOutcome.RUNNING):
            yield sweep.numbered(last.number + sweep.number)
