"""Bearing and rings until they agree, by one method after the other."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.roller import Case
from flexbearing.case.roller.numerics import Coupling
from flexbearing.coupled import states
from flexbearing.coupled.states import InitialState
from flexbearing.coupling import (
    RULES,
    Iteration,
    PartnerFailed,
    RacewayPair,
    StoppingCriterion,
    fixed_point,
    newton,
    relaxed,
)
from flexbearing.progress import Report
from flexbearing.results import Recorder
from quasidynamic import Equilibrium, NotSolved, RollerBearing
from quasidynamic.solve.rollers.static_equilibrium import series_stiffness

OnIteration = Callable[[int, Iteration, float], None]  # number and seconds of an iteration
FROM_INITIAL_STATE = "newton from an initial state"
FALLBACK = ("newton", "iqn-ils", "aitken", "relaxed")  # after the method of the case, in this order


@dataclass(frozen=True)
class BearingPartner:
    """The bearing as the coupling knows it: its failures carry the coupling's name."""

    model: RollerBearing

    def solve(self, start=None, deviation=None) -> Equilibrium:
        """Equilibrium between raceways of given deviations.

        Raises
        ------
        PartnerFailed
            when the bearing found no equilibrium
        """
        try:
            return self.model.solve(start, deviation)
        except NotSolved as failure:
            raise PartnerFailed(str(failure), str(failure.outcome)) from failure

    def roller_stiffness(self, state: Equilibrium) -> NDArray:
        """Stiffness of every roller between its raceways (Z) [N/m], as if it were untilted."""
        return series_stiffness(state.balance, state.unknowns)[0]

    def iterate(self, compliance, start, deviation) -> Iterator[Equilibrium]:
        """Newton iterates between elastic raceways.

        Raises
        ------
        PartnerFailed
            when the bearing found no equilibrium
        """
        try:
            yield from self.model.iterate(compliance, start, deviation)
        except NotSolved as failure:
            raise PartnerFailed(str(failure), str(failure.outcome)) from failure


@dataclass(frozen=True)
class Attempt:
    """How one method ended."""

    method: str
    iterations: int  # of all attempts so far
    status: str
    message: str
    ending: str
    state: Equilibrium
    error: float = np.inf  # largest of load change, mismatch and unbalanced force at its end [-]

    @property
    def between_flexible_raceways(self) -> bool:
        """Whether its state is a finite one between flexible raceways, and not where it began."""
        balance = self.state.balance
        begun = bool(balance.layout.elastic_raceways) or balance.deviation is not None
        return begun and bool(np.isfinite(self.state.residual))

    def record(self) -> dict[str, object]:
        """What the result file says of it."""
        return {
            "iterations": self.iterations,
            "status": self.status,
            "message": self.message,
        }


def nearest(attempts: Sequence[Attempt]) -> Attempt | None:
    """The attempt that came nearest to an equilibrium; None without a state between flexible raceways."""
    with_state = [attempt for attempt in attempts if attempt.between_flexible_raceways]
    return min(with_state, key=lambda attempt: attempt.error, default=None)


def summary(attempts: Sequence[Attempt]) -> str:
    """What became of all attempts: the message of the one that converged, or of every one."""
    if attempts[-1].status == "converged":
        return attempts[-1].message
    best = nearest(attempts)
    stored = "" if best is None else f"; the stored state is that of {best.method}, which came nearest"
    each = "; ".join(f"{attempt.method}: {attempt.message}" for attempt in attempts)
    return f"no method brought bearing and rings to an equilibrium{stored}: {each}"


def equilibrium(bearing: BearingPartner, rings: RacewayPair, coupling: Coupling) -> Equilibrium:
    """Equilibrium of a bearing and its rings by newton, or where it fails by `iqn-ils`; nothing is stored.

    Raises
    ------
    NotSolved
        where neither converges; the message has those of both
    """
    criterion = StoppingCriterion(tolerance=coupling.tolerance, limit=coupling.max_iterations)
    try:
        rigid, messages = bearing.solve(), []
    except PartnerFailed as failure:
        raise NotSolved(f"rigid raceways: {failure}") from failure
    for method in FALLBACK[:2]:
        given = bearing, rings, rigid, criterion
        *_, last = newton(*given) if method == "newton" else fixed_point(*given, RULES[method])
        if last.status == "converged":
            return last.state
        messages.append(f"{method}: {last.message or last.status}")
    raise NotSolved("no equilibrium of bearing and rings: " + "; ".join(messages))


@dataclass(frozen=True)
class CoupledBearing:
    """Bearing and rings of a case, from the rigid equilibrium on."""

    case: Case
    partner: BearingPartner
    rings: RacewayPair
    rigid: Equilibrium
    initial: InitialState | None = None  # where newton starts first

    def solve(self, record: Recorder, report: Report) -> list[Attempt]:
        """Iterate by one method after the other, and store every iteration; the last attempt counts."""
        attempts: list[Attempt] = []
        stored = partial(_stored, record, report)
        for attempt in self.attempts(stored):
            attempts.append(attempt)
            if attempt.status != "converged":
                report.stage(f"{attempt.method}: {attempt.message}", None)
        return attempts

    def attempts(self, on_iteration: OnIteration = lambda number, step, seconds: None) -> Iterator[Attempt]:
        """Yield one attempt after the other up to the one that converges; each iteration is handed on."""
        done = 0
        for method in self._methods():
            attempt = self._attempt(method, on_iteration, done)
            yield attempt
            done = attempt.iterations
            if attempt.status == "converged":
                return

    def _methods(self) -> tuple[str, ...]:
        """Methods in the order in which they are tried."""
        first = self.case.coupling.method
        able = FALLBACK[1:] if self.rings.solved_in_full else FALLBACK  # newton needs the tangent
        others = tuple(method for method in able if method != first)
        methods = (first, *others) if self.case.coupling.fallback else (first,)
        return methods if self.initial is None else (FROM_INITIAL_STATE, *methods)

    def _attempt(self, method: str, on_iteration: OnIteration, done: int) -> Attempt:
        began, last = perf_counter(), None
        for last in self._iterations(method):
            on_iteration(done + last.number, last, perf_counter() - began)
            began = perf_counter()
        assert last is not None  # every method yields at least once
        message = last.message or _message(method, last, self.case)
        errors = last.load_change, last.mismatch, last.state.residual
        error = max(errors) if np.isfinite(errors).all() else np.inf
        return Attempt(method, done + last.number, last.status, message, str(last.ending), last.state, error)

    def _iterations(self, method: str) -> Iterator[Iteration[Equilibrium]]:
        coupling = self.case.coupling
        criterion = StoppingCriterion(tolerance=coupling.tolerance, limit=coupling.max_iterations)
        if method == "newton":
            return newton(self.partner, self.rings, self.rigid, criterion)
        if method == FROM_INITIAL_STATE and self.initial is not None:
            return self._from_initial_state(self.initial, criterion)
        rule = partial(relaxed, relaxation=coupling.relaxation) if method == "relaxed" else RULES[method]
        return fixed_point(self.partner, self.rings, self.rigid, criterion, rule)

    def _from_initial_state(
        self, initial: InitialState, criterion: StoppingCriterion
    ) -> Iterator[Iteration[Equilibrium]]:
        try:
            start = initial.state(self.partner, self.rings, self.rigid)
        except PartnerFailed as failure:
            yield Iteration(1, self.rigid, np.inf, np.inf, "not solved", str(failure), failure.ending)
            return
        yield from newton(self.partner, self.rings, start, criterion)


def _stored(record: Recorder, report: Report, number: int, step: Iteration, seconds: float) -> None:
    """Store an iteration, and report it."""
    record.iteration(number, states.iteration(step, seconds))
    report.iteration(step)


def _message(method: str, last: Iteration, case: Case) -> str:
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
        f"of {last.mismatch:.1e} (converged is below {case.coupling.tolerance:.0e}){advice}"
    )
