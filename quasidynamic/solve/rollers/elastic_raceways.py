"""One case between elastic raceways: contacts first, then Newton's method; where it fails, other starts."""

from collections.abc import Generator, Iterator, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.solve.rollers.contact_search import contact_search
from quasidynamic.solve.rollers.load_continuation import Continuation
from quasidynamic.solve.rollers.newton import Iterate, newton
from quasidynamic.solve.rollers.stiffness_continuation import from_stiffer_raceways
from quasidynamic.solve.rollers.strategy import SolvedCases, Start, solve, solve_each
from quasidynamic.solve.step_length import SolverOutcome

BUDGET = 300  # evaluations of the bearing between raceways that keep their shape
ROUNDS = 3  # of pseudo-time

Ends = tuple[Iterate, Iterate]  # of a search, and of Newton's method after it


def iterate(
    balance: BearingBalance, unknowns: NDArray, near: bool, restarts: Sequence[Start]
) -> Iterator[Iterate]:
    """Yield the accepted iterates of one case with elastic raceways.

    Newton's method begins where full steps found which rollers touch. Where it fails it begins where damped
    steps found them, then after some pseudo-time of cage and spins, then with the bearing solved between
    raceways of that shape, and at last where nearly rigid raceways lead to that grow softer step by step.
    """
    end = yield from _by_searches(balance, unknowns, near, restarts)
    if _failed(end):
        softer = _from_stiffer_raceways(balance, unknowns, restarts)
        _, last = yield from _newton_after(balance, softer, end.number)
        end = end.numbered(last.number) if _failed(last) else last
    if _failed(end):
        yield end


def _by_searches(
    balance: BearingBalance, unknowns: NDArray, near: bool, restarts: Sequence[Start] = ()
) -> Generator[Iterate, None, Iterate]:
    """Yield accepted iterates after one search and the next; returns how they ended.

    Without `restarts` only the searches are tried.
    """
    found, end = yield from _newton_after(balance, contact_search(balance, unknowns, near))
    if near and _failed(end):
        far = contact_search(balance, unknowns)
        found, end = yield from _newton_after(balance, far, end.number)
    if _failed(end):
        damped = contact_search(balance, unknowns, damped=True)
        found, end = yield from _newton_after(balance, damped, end.number)
    if restarts and np.isfinite(found.unknowns).all():
        for last_way in (_after_pseudo_time, partial(_on_frozen_shape, restarts=restarts)):
            if _failed(end):
                _, end = yield from _newton_after(balance, last_way(balance, found), end.number)
    return end


def _from_stiffer_raceways(
    balance: BearingBalance, unknowns: NDArray, restarts: Sequence[Start]
) -> Iterator[Iterate]:
    """Yield the equilibrium that nearly rigid raceways lead to, softened step by step."""

    def solved(softer: BearingBalance, start: NDArray, thoroughly: bool) -> Continuation:
        end = _returned(_by_searches(softer, start, near=True, restarts=restarts if thoroughly else ()))
        return Continuation(None if _failed(end) else end.unknowns, end.number)

    reached = from_stiffer_raceways(balance, unknowns, solved)
    outcome = SolverOutcome.STALLED if reached.unknowns is None else SolverOutcome.RUNNING
    end = unknowns if reached.unknowns is None else reached.unknowns
    number, accepted = reached.evaluations, np.array([True])
    yield Iterate(number, np.array([0]), end, balance.evaluate(end), [outcome], accepted)


def _returned(iterates: Generator[Iterate, None, Iterate]) -> Iterate:
    """What a generator returns after all that it yields."""
    while True:
        try:
            next(iterates)
        except StopIteration as ended:
            return ended.value


def _failed(end: Iterate) -> bool:
    return end.outcomes[0] is not SolverOutcome.CONVERGED


def _newton_after(
    balance: BearingBalance, search: Iterator[Iterate], done: int = 0
) -> Generator[Iterate, None, Ends]:
    """Yield a search and Newton's method after it, numbered on; a failure is returned and not yielded."""
    found = None
    for found in search:
        if found.outcomes[0] is SolverOutcome.RUNNING and (found.number or not done):
            yield found.numbered(done + found.number)
    assert found is not None  # a search yields its start
    found = found.numbered(done + found.number)
    if found.outcomes[0] is not SolverOutcome.RUNNING:
        return found, found
    end = found
    for step in newton(balance, found.unknowns, found.system):
        end = step.numbered(found.number + step.number)
        if step.number and (step.outcomes[0] is SolverOutcome.CONVERGED or _is_step(step)):
            yield end
    return found, end


def _is_step(step: Iterate) -> bool:
    return bool(step.accepted[0]) and step.outcomes[0] is SolverOutcome.RUNNING


def _after_pseudo_time(balance: BearingBalance, found: Iterate) -> Iterator[Iterate]:
    """Yield what Newton's method leads to after pseudo-time of cage and spins."""
    yield _as_iterate(balance, solve_each(balance, found.unknowns, ROUNDS), found)


def _as_iterate(balance: BearingBalance, solved: SolvedCases, found: Iterate) -> Iterate:
    """The end of a solve as something that Newton's method may begin with, if it converged."""
    outcome = solved.outcomes[0]
    outcomes = [SolverOutcome.RUNNING if outcome is SolverOutcome.CONVERGED else outcome]
    system = balance.evaluate(solved.unknowns)
    number = int(solved.evaluations[0])
    return Iterate(number, found.cases, solved.unknowns, system, outcomes, found.accepted)


def _on_frozen_shape(balance: BearingBalance, found: Iterate, restarts: Sequence[Start]) -> Iterator[Iterate]:
    """Yield the bearing in equilibrium between raceways that keep the shape that a search found."""
    elastic = balance.unpack(found.unknowns)
    shape = np.moveaxis(elastic.deviation[:, :, 0], 1, -1)
    given = np.zeros_like(shape) if balance.deviation is None else balance.deviation
    frozen = replace(balance, compliance=(None, None), deviation=given + shape)
    solved = solve(frozen, frozen.pack(elastic), restarts, BUDGET)
    unknowns = balance.pack(frozen.unpack(solved.unknowns)._replace(deviation=elastic.deviation))
    yield _as_iterate(balance, replace(solved, unknowns=unknowns), found)
