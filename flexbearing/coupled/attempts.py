"""A bearing and its rings until they agree, by one method after the other."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from time import perf_counter
from typing import Any, Generic

import numpy as np
from numpy.typing import ArrayLike

from flexbearing.case.coupling import MethodsOfCoupling
from flexbearing.coupling import (
    RULES,
    Bearing,
    Iteration,
    PartnerFailed,
    RacewayPair,
    StoppingCriterion,
    fixed_point,
    newton,
    relaxed,
)
from flexbearing.coupling.partners import S
from flexbearing.progress import Report
from flexbearing.results import Recorder
from quasidynamic import NotSolved, SolverOutcome

OnIteration = Callable[[int, Iteration, float], None]  # number and seconds of an iteration
Values = Callable[[Iteration, float], Mapping[str, ArrayLike]]  # quantities of an iteration, by its seconds
Start = Callable[[Bearing[S], RacewayPair, S], S]
FROM_INITIAL_STATE = "newton from an initial state"
FALLBACK = ("newton", "iqn-ils", "aitken", "relaxed")  # after the method of the case, in this order


class NotCoupled(NotSolved):
    """No method brought a bearing and its rings to an equilibrium; `status` is that of the last one."""

    def __init__(self, message: str, outcome: str, status: str):
        super().__init__(message, outcome)
        self.status = status


@dataclass(frozen=True)
class Attempt(Generic[S]):
    """How one method ended."""

    method: str
    iterations: int  # of all attempts so far
    status: str
    message: str
    ending: str
    state: S
    between_flexible_raceways: bool  # whether its state is a finite one there, and not where it began
    error: float = np.inf  # largest of load change, mismatch and unbalanced force at its end [-]


def records(attempts: Sequence[Attempt]) -> dict[str, Any]:
    """Root attributes of a result that say how methods ended."""
    last, words = attempts[-1], ("iterations", "status", "message")
    each = {attempt.method: {word: getattr(attempt, word) for word in words} for attempt in attempts}
    return {"iterations": last.iterations, "ending": last.ending, "attempts": each}


def nearest(attempts: Sequence[Attempt[S]]) -> Attempt[S] | None:
    """The attempt that came nearest to an equilibrium; None without a state between flexible raceways."""
    with_state = [attempt for attempt in attempts if attempt.between_flexible_raceways]
    return min(with_state, key=lambda attempt: attempt.error, default=None)


def summary(attempts: Sequence[Attempt], best: Attempt | None) -> str:
    """The message of the attempt that converged, or of the `best`, whose state is stored, and the others.

    Without a state between flexible raceways it is the message of the first one.
    """
    if attempts[-1].status == "converged":
        return attempts[-1].message
    shown = best or attempts[0]
    others = ", ".join(each.method for each in attempts if each is not shown)
    also = f" (neither did {others}: see `attempts` in the result)" if others else ""
    stored = ", whose last state is stored" if best else ""
    return f"no equilibrium of bearing and rings by {shown.method}{stored}{also}: {shown.message}"


@dataclass(frozen=True)
class CoupledBearing(Generic[S]):
    """Bearing and rings of a case, from the rigid equilibrium on."""

    coupling: MethodsOfCoupling
    partner: Bearing[S]
    rings: RacewayPair
    rigid: S
    initial: Start[S] | None = None  # gives a state where newton starts first, or raises `PartnerFailed`

    def solve(self, record: Recorder, report: Report, values: Values) -> list[Attempt[S]]:
        """Iterate by one method after the other, and store every iteration; the last attempt counts."""
        attempts: list[Attempt[S]] = []
        stored = partial(_stored, record, report, values)
        for attempt in self.attempts(stored):
            attempts.append(attempt)
            if attempt.status != "converged":
                report.stage(f"{attempt.method}: {attempt.message}", None)
        return attempts

    def attempts(
        self, on_iteration: OnIteration = lambda number, step, seconds: None
    ) -> Iterator[Attempt[S]]:
        """Yield one attempt after the other up to the one that converges; each iteration is handed on."""
        done = 0
        for method in self._methods():
            attempt = self._attempt(method, on_iteration, done)
            yield attempt
            done = attempt.iterations
            no_balance = method == "newton" and attempt.ending == SolverOutcome.TOO_SOFT
            if attempt.status == "converged" or no_balance:  # which no other method has either
                return

    def _methods(self) -> tuple[str, ...]:
        """Methods in the order in which they are tried."""
        first = self.coupling.method
        able = FALLBACK[1:] if self.rings.solved_in_full else FALLBACK  # newton needs the tangent
        others = tuple(method for method in able if method != first)
        methods = (first, *others) if self.coupling.fallback else (first,)
        return methods if self.initial is None else (FROM_INITIAL_STATE, *methods)

    def _attempt(self, method: str, on_iteration: OnIteration, done: int) -> Attempt[S]:
        began, last = perf_counter(), None
        for last in self._iterations(method):
            on_iteration(done + last.number, last, perf_counter() - began)
            began = perf_counter()
        assert last is not None  # every method yields at least once
        message = last.message or _message(method, last, self.coupling)
        errors = last.load_change, last.mismatch, last.state.residual
        error = max(errors) if np.isfinite(errors).all() else np.inf
        between, count = np.isfinite(last.state.residual) and last.state is not self.rigid, done + last.number
        ended = last.status, message, str(last.ending), last.state
        return Attempt(method, count, *ended, bool(between), error)

    def _iterations(self, method: str) -> Iterator[Iteration[S]]:
        coupling = self.coupling
        criterion = StoppingCriterion(tolerance=coupling.tolerance, limit=coupling.max_iterations)
        if method == "newton":
            return newton(self.partner, self.rings, self.rigid, criterion)
        if method == FROM_INITIAL_STATE and self.initial is not None:
            return self._from_initial_state(self.initial, criterion)
        rule = partial(relaxed, relaxation=coupling.relaxation) if method == "relaxed" else RULES[method]
        return fixed_point(self.partner, self.rings, self.rigid, criterion, rule)

    def _from_initial_state(self, initial: Start[S], criterion: StoppingCriterion) -> Iterator[Iteration[S]]:
        try:
            start = initial(self.partner, self.rings, self.rigid)
        except PartnerFailed as failure:
            yield Iteration(1, self.rigid, np.inf, np.inf, "not solved", str(failure), failure.ending)
            return
        yield from newton(self.partner, self.rings, start, criterion)


def _stored(
    record: Recorder, report: Report, values: Values, number: int, step: Iteration, seconds: float
) -> None:
    """Store an iteration, and report it."""
    record.iteration(number, values(step, seconds))
    report.iteration(step)


def _message(method: str, last: Iteration, coupling: MethodsOfCoupling) -> str:
    if last.status == "converged":
        return (
            f"loads changed by {last.load_change:.1e} of the largest in the last iteration, "
            f"unbalanced force {last.state.residual:.1e} of the load"
        )
    advice = "; try newton, or a smaller coupling.relaxation" if method == "relaxed" else ""
    if last.status == "not finite":
        return f"stopped after {last.number} iterations at numbers that are not finite{advice}"
    return (
        f"stopped after {last.number} iterations with load changes of {last.load_change:.1e} and a mismatch "
        f"of {last.mismatch:.1e} (converged is below {coupling.tolerance:.0e}){advice}"
    )
