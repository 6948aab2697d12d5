"""A cylindrical roller bearing: between rigid raceways, then together with its rings."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

from flexbearing.accuracy import Unusable
from flexbearing.accuracy.adaptive import adaptive_resolution
from flexbearing.build import clearance, roller_bearing
from flexbearing.case.roller import Case
from flexbearing.coupled.coupled import WARM, BearingPartner, Coupled
from flexbearing.coupled.initial_state import InitialState
from flexbearing.coupling import PartnerFailed
from flexbearing.progress import Report
from flexbearing.results import ResultFile
from flexbearing.rings.condensed import Rings, condensed
from flexbearing.rings.full_solve import WholeRings, whole
from flexbearing.rings.raceways import CondensedRings
from flexbearing.runs import notes
from flexbearing.runs.postprocess import Postprocessing
from quasidynamic import Equilibrium, RollerBearing


@dataclass(frozen=True)
class Resolved:
    """A case at definite levels of its resolution."""

    model: RollerBearing
    rings: Callable[[], Rings | WholeRings]
    attributes: Mapping[str, Any] = field(default_factory=dict)  # of the result file
    notes: Callable[[Equilibrium], Iterable[str]] = lambda end: ()  # on an end state that converged


def opening(case: Case) -> dict[str, object]:
    """Root attributes that are known before anything is solved."""
    return {
        "method": case.coupling.method,
        "notes": list(notes.of_case(case)),
        "clearance": clearance.record(case),
    }


def solve(
    case: Case, file: ResultFile, report: Report, near: InitialState | None = None
) -> dict[str, object]:
    """Write iterations and blocks; returns the root attributes that say how it ended."""
    postprocessing = Postprocessing(case, file)
    resolved = _resolved(case, postprocessing, report)
    ending = _solve(case, resolved, file, postprocessing, report, near)
    if near is not None:
        ending |= _start(near, ending["attempts"], postprocessing)
    return ending | dict(resolved.attributes) | postprocessing.attributes()


def _resolved(case: Case, postprocessing: Postprocessing, report: Report) -> Resolved:
    """At the levels of the case, or at those that its target asks for."""
    model = roller_bearing.bearing(case)
    solved = whole if case.coupling.structure == "full" else condensed
    usual = Resolved(model, lambda: solved(case, model.bearing.azimuths, report))
    if case.accuracy.target is None:
        return usual
    try:
        found = adaptive_resolution(case, report)
    except Unusable as problem:
        postprocessing.notes.append(
            f"accuracy.target: nothing could be chosen or estimated, so the usual levels are used: {problem}"
        )
        return Resolved(model, usual.rings, {"choices": {}, "error_estimate": {}})
    return Resolved(found.model, lambda: found.rings, found.attributes(), found.notes)


def _solve(
    case: Case,
    resolved: Resolved,
    file: ResultFile,
    postprocessing: Postprocessing,
    report: Report,
    near: InitialState | None,
) -> dict[str, object]:
    """Rigid equilibrium, then the rings, then both together; returns how it ended."""
    partner = BearingPartner(resolved.model)
    report.stage("rigid raceways", None)
    rigid_rings = CondensedRings((None, None))
    try:
        rigid = partner.solve()
    except PartnerFailed as failure:
        ending = _ending("not solved", f"rigid raceways: {failure}", 0, rigid_rings)
        return ending | {"ending": failure.ending}
    postprocessing.store("rigid", rigid, rigid_rings)
    postprocessing.notes.extend(notes.of_choice(resolved.model))
    try:
        rings = resolved.rings()
    except PartnerFailed as failure:
        return _ending("not solved", str(failure), 0, rigid_rings) | {"ending": failure.ending}
    if rings.rigid:
        postprocessing.store("flexible", rigid, rigid_rings)
        postprocessing.notes.extend(resolved.notes(rigid))
        ending = _ending("converged", "every part is rigid: nothing to iterate", 0, rings)
        return ending | {"ending": str(rigid.status)}
    report.stage("bearing and rings together", None)
    attempts = Coupled(case, partner, rings, rigid, near).together(file, report)
    last = attempts[-1]
    final = rings.condensed if isinstance(rings, WholeRings) else rings.linearised(last.state.forces)
    converged = last.status == "converged"
    postprocessing.store("flexible", last.state, final, converged=converged)
    if converged:
        postprocessing.notes.extend(resolved.notes(last.state))
    ending = _ending(last.status, last.message, last.iterations, rings)
    return ending | {"ending": last.ending, "attempts": {one.method: one.record() for one in attempts}}


def _start(near: InitialState, attempts: Any, postprocessing: Postprocessing) -> dict[str, object]:
    """Where the coupling started; a note where that is not the neighbour."""
    tried = attempts.get(WARM, {"status": "not reached", "message": "nothing was iterated"})
    if tried["status"] == "converged":
        return {"started_from": near.name}
    postprocessing.notes.append(f"start {near.name}: not used: {tried['message']}")
    return {"started_from": "rigid raceways"}


def _ending(status: str, message: str, iterations: int, rings: Rings | WholeRings) -> dict[str, object]:
    return {
        "status": status,
        "message": message,
        "iterations": iterations,
        "structure": rings.figures(),
        "attempts": {},
    }
