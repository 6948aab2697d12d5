"""A cylindrical roller bearing: between rigid raceways, then together with its rings."""

from flexbearing.case import Case
from flexbearing.compute import assemble, clearance, notes
from flexbearing.compute.fitted import FittedRings
from flexbearing.compute.outcome import Outcome
from flexbearing.compute.progress import Report
from flexbearing.compute.rings import condensed
from flexbearing.compute.structure import CondensedRings
from flexbearing.compute.together import BearingPartner, Coupled
from flexbearing.coupling import PartnerFailed
from flexbearing.results import ResultFile


def opening(case: Case) -> dict[str, object]:
    """Root attributes that are known before anything is solved."""
    return {
        "method": case.coupling.method,
        "notes": list(notes.of_case(case)),
        "clearance": clearance.record(case),
    }


def solve(case: Case, file: ResultFile, report: Report) -> dict[str, object]:
    """Write iterations and blocks; returns the root attributes that say how it ended."""
    outcome = Outcome(case, file)
    ending = _solve(case, file, outcome, report)
    return ending | outcome.attributes()


def _solve(case: Case, file: ResultFile, outcome: Outcome, report: Report) -> dict[str, object]:
    """Rigid equilibrium, then the rings, then both together; returns how it ended."""
    model = assemble.bearing(case)
    partner = BearingPartner(model)
    report.stage("rigid raceways", None)
    rigid_rings = CondensedRings((None, None))
    try:
        rigid = partner.solve()
    except PartnerFailed as failure:
        ending = _ending("not solved", f"rigid raceways: {failure}", 0, rigid_rings)
        return ending | {"ending": failure.ending}
    outcome.store("rigid", rigid, rigid_rings)
    outcome.notes.extend(notes.of_choice(model))
    try:
        rings = condensed(case, model.bearing.azimuths, report)
    except PartnerFailed as failure:
        return _ending("not solved", str(failure), 0, rigid_rings) | {"ending": failure.ending}
    if rings.rigid:
        outcome.store("flexible", rigid, rigid_rings)
        ending = _ending("converged", "every part is rigid: nothing to iterate", 0, rings)
        return ending | {"ending": str(rigid.status)}
    report.stage("bearing and rings together", None)
    attempts = Coupled(case, partner, rings, rigid).together(file, report)
    last = attempts[-1]
    near = rings.linearised(last.state.forces)
    outcome.store("flexible", last.state, near, converged=last.status == "converged")
    ending = _ending(last.status, last.message, last.iterations, rings)
    return ending | {"ending": last.ending, "attempts": {one.method: one.record() for one in attempts}}


def _ending(
    status: str, message: str, iterations: int, rings: CondensedRings | FittedRings
) -> dict[str, object]:
    return {
        "status": status,
        "message": message,
        "iterations": iterations,
        "structure": rings.figures(),
        "attempts": {},
    }
