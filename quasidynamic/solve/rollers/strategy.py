"""From start to end: Newton's method, a better start, pseudo-time, a heavier load, settled time."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.solve.rollers.load_continuation import from_heavier_load
from quasidynamic.solve.rollers.newton import Iterate, newton
from quasidynamic.solve.rollers.pseudo_time import StepLimits, pseudo_time
from quasidynamic.solve.rollers.settled_time import through_settled_time
from quasidynamic.solve.start.lumped import held_back
from quasidynamic.solve.step_length import SolverOutcome

# Rounds of pseudo-time, each followed by Newton's method: before a heavier load, after it, at restarts.
ROUNDS = (3, 9, 3)
MOST_WORK = 4000  # evaluations of a case: the hardest that are solved take 3600, nearly all less than 700

Start = Callable[[BearingBalance], NDArray]


class NotAlike(ValueError):
    """Arrays that cannot be joined, as only one of them depends on the case."""


def overlaid(under: Any, over: Sequence[tuple[NDArray, Any]]) -> Any:
    """Nested named tuples of arrays of many cases, the last of others counts for its cases.

    The axis of the cases is that along which both differ in length; arrays of one shape are those of every
    case.

    >>> overlaid(np.zeros((2, 3)), [(np.array([2]), np.ones((2, 1)))]).tolist()
    [[0.0, 0.0, 1.0], [0.0, 0.0, 1.0]]

    Raises `NotAlike` where there is no such axis.
    """
    if not over:
        return under
    if isinstance(under, tuple):
        parts = ([(cases, above[place]) for cases, above in over] for place in range(len(under)))
        return type(under)(*map(overlaid, under, parts))
    if under is None:
        return None
    joined = under
    for cases, above in over:
        if above.shape == under.shape:
            continue
        axes = np.flatnonzero(np.not_equal(under.shape, above.shape)) if under.ndim == above.ndim else ()
        if len(axes) != 1 or above.shape[axes[0]] != len(cases):
            raise NotAlike(f"shapes {under.shape} and {above.shape}")
        joined = under.copy() if joined is under else joined
        joined[(*[slice(None)] * axes[0], cases)] = above
    return joined


@dataclass
class SolvedCases:
    """How the solves of C cases ended; filled while they are solved."""

    unknowns: NDArray  # (C, N) scaled
    outcomes: list[SolverOutcome]
    evaluations: NDArray  # (C)
    budget: int = MOST_WORK  # evaluations of a case after which no other way is tried
    ends: list[tuple[NDArray, Iterate]] = field(default_factory=list)  # where Newton's method ended for some

    @property
    def system(self) -> Linearisation | None:
        """Residual and derivatives of all cases where Newton's method ended; None where it did not."""
        if not self.ends or len(self.ends[0][0]) < len(self.unknowns):
            return None
        unknowns, accepted = self.unknowns.copy(), np.zeros(len(self.unknowns), bool)
        (_, first), *later = self.ends
        unknowns[:], accepted[:], system = first.unknowns, first.accepted, first.system
        for cases, iterate in later:
            unknowns[cases], accepted[cases] = iterate.unknowns, iterate.accepted
        if not accepted.all() or not np.array_equal(unknowns, self.unknowns):
            return None
        try:
            return overlaid(system, [(cases, iterate.system) for cases, iterate in later])
        except NotAlike:
            return None

    def unsolved(self) -> NDArray:
        """Cases that may still be solved."""
        done = (SolverOutcome.CONVERGED, SolverOutcome.UNDETERMINED)
        left = np.array([case for case, outcome in enumerate(self.outcomes) if outcome not in done], int)
        return left[self.evaluations[left] < self.budget]

    def name_work_limit(self) -> None:
        """Say of cases that all ways together left unsolved that they took as much work as a case may."""
        for case in np.flatnonzero(self.evaluations >= MOST_WORK):
            if self.outcomes[case] not in (SolverOutcome.CONVERGED, SolverOutcome.UNDETERMINED):
                self.outcomes[case] = SolverOutcome.WORK

    def follow(self, iterates: Iterator[Iterate], cases: NDArray) -> None:
        """Store how the solves of some cases end."""
        for iterate in iterates:
            running = cases[iterate.cases]
            self.evaluations[running] += 1
            if SolverOutcome.CONVERGED in iterate.outcomes:
                self.ends.append((running, iterate))
            for case, unknowns, outcome in zip(running, iterate.unknowns, iterate.outcomes, strict=True):
                if outcome is not SolverOutcome.RUNNING:
                    self.unknowns[case], self.outcomes[case] = unknowns, outcome


def solve(
    balance: BearingBalance, start: NDArray, restarts: Sequence[Start], budget: int = MOST_WORK
) -> SolvedCases:
    """Solve all cases, those that one method leaves unsolved by the next one."""
    outcomes = [
        SolverOutcome.UNDETERMINED if free else SolverOutcome.RUNNING for free in balance.undetermined
    ]
    solved = SolvedCases(start.copy(), outcomes, np.zeros(len(start), int), budget)
    left = solved.unsolved()
    if len(left):
        solved.follow(newton(_cases_of(balance, left), start[left]), left)
    _find_spins(balance, solved)
    for number, restart in enumerate(restarts):
        left = solved.unsolved()
        if not len(left):
            break
        unknowns = start.copy()
        unknowns[left] = restart(_cases_of(balance, left))
        slipping = unknowns.copy()
        solved.follow(newton(_cases_of(balance, left), unknowns[left]), left)
        if number:
            _through_pseudo_time(balance, solved, unknowns, ROUNDS[2])
            continue
        _through_pseudo_time(balance, solved, unknowns, ROUNDS[0])
        _through_settled_time(balance, solved, (start, slipping))
        for case in solved.unsolved():
            left = MOST_WORK - int(solved.evaluations[case])
            lighter = from_heavier_load(balance.take(np.array([case])), restart, left)
            solved.evaluations[case] += lighter.evaluations
            if lighter.unknowns is not None:
                solved.unknowns[case], solved.outcomes[case] = lighter.unknowns[0], SolverOutcome.CONVERGED
        _through_pseudo_time(balance, solved, unknowns, ROUNDS[1])
    solved.name_work_limit()
    return solved


def solve_each(balance: BearingBalance, starts: NDArray, rounds: int) -> SolvedCases:
    """Solve every case from its own start, to wherever that leads."""
    solved = SolvedCases(starts.copy(), [SolverOutcome.RUNNING] * len(starts), np.zeros(len(starts), int))
    solved.follow(newton(balance, starts), np.arange(len(starts)))
    _through_pseudo_time(balance, solved, starts.copy(), rounds)
    return solved


def _find_spins(balance: BearingBalance, solved: SolvedCases) -> None:
    """Try Newton's method from where it ended, with the spins that pockets leave to unloaded rollers."""
    left = solved.unsolved()
    if not len(left):
        return
    balance_left, ended = _cases_of(balance, left), solved.unknowns[left]
    held = balance_left.pack(held_back(balance_left, balance_left.unpack(ended)))
    other = np.flatnonzero((held != ended).any(axis=1) & np.isfinite(held).all(axis=1))
    if len(other):
        solved.follow(newton(_cases_of(balance_left, other), held[other]), left[other])


def _through_pseudo_time(
    balance: BearingBalance, solved: SolvedCases, unknowns: NDArray, rounds: int
) -> None:
    """Move `unknowns` (C, N) through pseudo-time, trying Newton's method after every round."""
    limits = StepLimits.first(len(unknowns))
    for _ in range(rounds):
        left = solved.unsolved()
        if not len(left):
            return
        balance_left = _cases_of(balance, left)
        for iterate, limits_now in pseudo_time(balance_left, unknowns[left], limits.take(left)):
            cases = left[iterate.cases]
            solved.evaluations[cases] += 1
            unknowns[cases] = iterate.unknowns
            limits.time[cases], limits.ring_step[cases] = limits_now.time, limits_now.ring_step
        solved.follow(newton(balance_left, unknowns[left]), left)


def _through_settled_time(balance: BearingBalance, solved: SolvedCases, starts: Sequence[NDArray]) -> None:
    """Let cage and spins settle from each start (C, N), between rings and rollers that are at rest."""
    if balance.layout.elastic_raceways or balance.layout.ribs or balance.deviation is not None:
        return
    for start in starts:
        for case in solved.unsolved():
            one = np.array([case])
            settled = through_settled_time(balance.take(one), start[one])
            solved.evaluations[case] += settled.evaluations
            if settled.unknowns is not None:
                solved.unknowns[case], solved.outcomes[case] = settled.unknowns[0], SolverOutcome.CONVERGED


def _cases_of(balance: BearingBalance, cases: NDArray) -> BearingBalance:
    return balance if len(cases) == len(balance.points) else balance.take(cases)
