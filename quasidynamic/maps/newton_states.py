"""States that Newton's method reaches from given starts, many side by side."""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.solve.rollers.newton import newton
from quasidynamic.solve.rollers.strategy import solve_each
from quasidynamic.solve.step_length import SolverOutcome

AT_ONCE = 64  # their slices fit into the processor's cache
BALANCED = 1e-8  # of the reference force; a step into absurd loads is balanced beside these only
EVALUATIONS = 16  # of Newton's method from a neighbouring state; more seldom end near it

Mapped = Callable[[Callable[[Any], Any], Iterable[Any]], Iterator[Any]]  # as the builtin `map`


@dataclass(frozen=True)
class Reached:
    """How n solves ended; what did not converge has NaN."""

    scaled: NDArray  # (n, N) unknowns
    loads: NDArray  # (n, 2, Z) of the rollers [N]
    spin: NDArray  # (n, Z) of the rollers over that of pure rolling [-]

    def __len__(self) -> int:
        return len(self.scaled)

    @property
    def converged(self) -> NDArray:
        """Which solves (n) converged."""
        return np.isfinite(self.scaled[:, 0])

    def take(self, some: NDArray) -> "Reached":
        """Some of them."""
        return Reached(self.scaled[some], self.loads[some], self.spin[some])

    @classmethod
    def joined(cls, parts: "Iterable[Reached]") -> "Reached":
        """All parts, one after the other."""
        scaled, loads, spin = zip(*((part.scaled, part.loads, part.spin) for part in parts), strict=True)
        return cls(np.concatenate(scaled), np.concatenate(loads), np.concatenate(spin))


def apart(one: Reached, other: Reached) -> NDArray:
    """How far pairs of states differ (n): in a load over its largest, in a spin over pure rolling [-]."""
    largest, its_largest = (each.loads[:, 0].max(axis=1) for each in (one, other))
    loads = one.loads / largest[:, None, None] - other.loads / its_largest[:, None, None]
    return np.maximum(np.abs(loads).max(axis=(1, 2)), np.abs(one.spin - other.spin).max(axis=1))


def by_newton(task: tuple[BearingBalance, NDArray]) -> Reached:
    """States near starts (n, N), scaled, by Newton's method alone."""
    balance, starts = task
    found, systems = np.full(starts.shape, np.nan), []
    with np.errstate(all="ignore"):  # a start may be absurd
        for iterate in newton(balance, starts):
            done = np.array([outcome is SolverOutcome.CONVERGED for outcome in iterate.outcomes])
            found[iterate.cases[done]] = iterate.unknowns[done]
            evaluated = done & iterate.accepted  # else the system is that of a step which was not taken
            systems.append((iterate.cases[evaluated], evaluated, iterate.system))
            if iterate.number >= EVALUATIONS:
                break
    return _of_systems(balance, found, systems)


def by_pseudo_time(task: tuple[BearingBalance, NDArray]) -> Reached:
    """States from starts (n, N), scaled, wherever they lead, with a round of pseudo-time."""
    balance, starts = task
    with np.errstate(all="ignore"):
        solved = solve_each(balance, starts, rounds=1)
    ended = np.array([outcome is SolverOutcome.CONVERGED for outcome in solved.outcomes])
    return of_unknowns(balance, np.where(ended[:, None], solved.unknowns, np.nan))


def of_unknowns(balance: BearingBalance, scaled: NDArray) -> Reached:
    """Loads and spins of unknowns (n, N), scaled; NaN where forces are not in balance."""
    return _of_systems(balance, scaled, [])


def _of_systems(
    balance: BearingBalance, scaled: NDArray, known: list[tuple[NDArray, NDArray, Linearisation]]
) -> Reached:
    """The same, where cases, which of a system they are, and that system are known of some."""
    count, rollers = len(scaled), balance.layout.rollers
    loads, residual = np.full((count, 2, rollers), np.nan), np.full(count, np.nan)
    missing = np.isfinite(scaled[:, 0])
    for cases, *_ in known:
        missing[cases] = False
    rest = np.flatnonzero(missing)
    if len(rest):
        known = [*known, (rest, np.ones(len(rest), bool), balance.take(rest).evaluate(scaled[rest]))]
    for cases, evaluated, system in known:
        loads[cases] = system.state.contact.force[:, 0, evaluated].swapaxes(0, 1)
        residual[cases] = np.abs(system.residual[evaluated]).max(axis=1)
    balanced = (residual < BALANCED)[:, None]
    spin = balance.speeds(balance.unpack(scaled))[0] / balance.rolling_spin
    return Reached(
        np.where(balanced, scaled, np.nan),
        np.where(balanced[..., None], loads, np.nan),
        np.where(balanced, spin, np.nan),
    )


def tasks(
    balance_of: Callable[[NDArray], BearingBalance], scaled: NDArray, at_once: int = AT_ONCE
) -> list[tuple[BearingBalance, NDArray]]:
    """Balances and unknowns (n, N), some at once; similar ones should stand side by side."""
    places = np.arange(len(scaled))
    few = (places[first : first + at_once] for first in range(0, len(places), at_once))
    return [(balance_of(some), scaled[some]) for some in few]


def in_batches(
    balance_of: Callable[[NDArray], BearingBalance],
    starts: NDArray,
    solve: Callable[[tuple[BearingBalance, NDArray]], Reached],
    mapped: Mapped,
    at_once: int = AT_ONCE,
) -> Reached:
    """States from all starts (n, N), some at once; similar ones should stand side by side."""
    return Reached.joined(mapped(solve, tasks(balance_of, starts, at_once)))
