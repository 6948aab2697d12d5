"""How far the resolution of cases may put their lives off."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.roller import Case
from flexbearing.coupled.coupled import BearingPartner
from flexbearing.coupled.states import EndStates
from flexbearing.coupling import LinearPair, PartnerFailed, RacewayPair, StoppingCriterion, newton
from flexbearing.progress import Report
from flexbearing.quantities.roller import CAGE_SLIP
from flexbearing.rings.more_shapes import more_shapes_matter, with_more_shapes
from quasidynamic import Equilibrium, RollerBearing
from quasidynamic.note import NO_KEYS, Keys, Note, outside
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.finer_life import ERROR_OVER_CHANGE, FINER, Compliances, life_errors

RESOLVED = 0.05  # of the life: an error that is worth a word (assumed)


RESOLVING = ("accuracy.slices", "accuracy.axial_shapes", "accuracy.target")  # keys


@dataclass(frozen=True)
class LifeErrors:
    """Estimated numerical errors of the lives of C states."""

    values: NDArray | None  # (C) over the life [-], not a number where there is none; None without any
    sought: NDArray | None = None  # (C) whether an error was looked for
    problems: tuple[str, ...] = ()  # (C) what kept further axial shapes away; empty: nothing

    def notes(self, case: int) -> tuple[Note, ...]:
        """What is to be said of one of them."""
        if self.sought is None or not self.sought[case]:
            return ()
        value = np.nan if self.values is None else self.values[case]
        if np.isnan(value):
            words = "no error estimated: life with more axial modes: no line loads were found"
            return (_resolution(words),)
        problem, notes = self.problems[case], []
        if problem:
            notes.append(_resolution(f"its error counts slices, not axial shapes: {problem}"))
        if value > RESOLVED:
            words = f"numerical error of about {value:.0%}; more slices or axial shapes resolve it"
            notes.append(_resolution(words, dict.fromkeys(RESOLVING, "")))
        return tuple(notes)


def _resolution(words: str, keys: Keys = NO_KEYS) -> Note:
    return outside("life-resolution", f"life: {words}", keys)


def estimated(case: Case, states: BearingStates, rings: LinearPair, report: Report) -> LifeErrors:
    """Estimate what finer slices and more axial shapes would change; see `life_errors`."""
    sought = np.isfinite(states.life)
    if case.accuracy.target is not None or not sought.any():
        return LifeErrors(None)
    errors, problems = np.full(len(sought), np.nan), [""] * len(sought)
    matter = np.zeros((len(sought), 2), bool) if rings.rigid else more_shapes_matter(states, rings)
    for races in sorted({*map(tuple, matter[sought].tolist())}):
        some = np.flatnonzero(sought & (matter == races).all(axis=1))
        richer: Compliances = (None, None)
        try:
            if any(races):
                richer = with_more_shapes(case, rings, races, report)
        except PartnerFailed as problem:  # which leaves the error of the slices
            for place in some:
                problems[place] = str(problem)
        errors[some] = life_errors(states if len(some) == len(sought) else states.take(some), richer)
    return LifeErrors(None if np.isnan(errors).all() else errors, sought, tuple(problems))


def record(
    case: Case, model: RollerBearing, rings: RacewayPair, end: Equilibrium
) -> dict[str, dict[str, Any]]:
    """Estimate errors by the slices: the largest change with 2 and 4 times as many, times 1.6."""
    if case.accuracy.target is not None or rings.solved_in_full or not end.loads.max() > 0:
        return {}
    counts = [times * model.slices for times in FINER]
    try:
        finer = [_solved(case, replace(model, slices=count), rings, end) for count in counts]
        numbers = [dict(_numbers(each, rings)) for each in (end, *finer)]
    except PartnerFailed:
        return {}
    value = numbers[0]
    changes = {
        name: [np.abs(other[name] - value[name]).max() / scale for other in numbers[1:]]
        for name in value
        if all(name in other for other in numbers[1:])
        and (scale := 1.0 if name == CAGE_SLIP.name else np.abs(value[name]).max()) > 0
    }
    errors = {name: ERROR_OVER_CHANGE * float(max(each)) for name, each in changes.items()}
    return {"slice_error": {"slices": counts, **{n: e for n, e in errors.items() if np.isfinite(e)}}}


def _solved(case: Case, model: RollerBearing, rings: RacewayPair, end: Equilibrium) -> Equilibrium:
    """The case with other slices, from its solution by Newton's method alone."""
    partner, coupling = BearingPartner(model), case.coupling
    if rings.rigid:
        return partner.solve(end)
    criterion = StoppingCriterion(tolerance=coupling.tolerance, limit=coupling.max_iterations)
    *_, last = newton(partner, rings, end, criterion)
    if last.status != "converged":
        raise PartnerFailed(last.message or last.status, last.ending)
    return last.state


def _numbers(state: Equilibrium, rings: RacewayPair) -> Iterator[tuple[str, Any]]:
    """The outputs whose errors are estimated."""
    end = EndStates(state.cases, rings.linearised(state.forces))
    yield "roller_load", state.loads
    yield CAGE_SLIP.name, state.cage_slip
    if end.stiffness is not None:
        yield "stiffness", end.between_raceways.radial_stiffness[0]
    yield "total_stiffness", end.with_supports.radial_stiffness[0]
    yield "peak_pressure", state.peak_pressure
    yield "driving_torque", state.driving_torque
