"""A cylindrical roller bearing: between rigid raceways, then coupled with its rings."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from flexbearing.build import clearance, roller_bearing
from flexbearing.build.ring_parts import part_of
from flexbearing.case.roller import Case
from flexbearing.coupled import states
from flexbearing.coupled.attempts import FROM_INITIAL_STATE, CoupledBearing, nearest, records, summary
from flexbearing.coupled.coupled import BearingPartner
from flexbearing.coupled.states import InitialState
from flexbearing.coupling import LinearPair, PartnerFailed, RacewayPair
from flexbearing.progress import Report
from flexbearing.results import Recorder
from flexbearing.rings.raceways import RigidRaceway
from flexbearing.runs import life_error, notes, passage
from flexbearing.runs.postprocess import Postprocessing
from flexbearing.runs.tilt import TiltComparison
from quasidynamic import Equilibrium, RollerBearing, SolverOutcome
from quasidynamic.note import Note, graded, information

if TYPE_CHECKING:
    from flexbearing.accuracy.shared import Levels
    from flexbearing.rings.raceways import Ahead

RIGID = LinearPair(None, None)
WORK_LIMIT = str(SolverOutcome.WORK)


@dataclass(frozen=True)
class ResolvedCase:
    """A case at definite levels of its resolution."""

    model: RollerBearing
    rings: Callable[[], RacewayPair]
    attributes: Mapping[str, Any] = field(default_factory=dict)  # of the result file
    notes: Callable[[Equilibrium], Iterable[Note]] = lambda end: ()  # on an end state that converged


def opening(case: Case) -> dict[str, object]:
    """Root attributes that are known before anything is solved."""
    return {
        "method": case.coupling.method,
        "tilt": {"inner_ring": case.operation.tilt},
        "notes": [note.record() for note in graded(notes.of_case(case))],
        "clearance": clearance.record(case),
    }


def solve(
    case: Case,
    record: Recorder,
    report: Report,
    near: InitialState | None = None,
    levels: "Levels | None" = None,
    ahead: "Ahead | None" = None,
) -> dict[str, object]:
    """Write iterations and blocks; returns the root attributes that say how it ended.

    A case with a target is solved at the `levels` that were chosen for it and others, where they are given.
    The outer ring may be condensed `ahead`, in a process of its own.
    """
    postprocessing = Postprocessing(case, record, report)
    resolved = _resolved(case, postprocessing, report, ahead, levels)
    ending = _solve(case, resolved, postprocessing, report, near)
    if near is not None and postprocessing.solved:
        ending |= _start(near, ending["attempts"], postprocessing)
    return ending | dict(resolved.attributes) | postprocessing.attributes()


def _resolved(
    case: Case, postprocessing: Postprocessing, report: Report, ahead: "Ahead | None", levels: "Levels | None"
) -> ResolvedCase:
    """At the levels of the case, or at those that its target requires."""
    model = roller_bearing.bearing(case)
    usual = ResolvedCase(model, partial(_raceways, case, model.bearing.azimuths, report, ahead))
    if case.accuracy.target is None:
        return usual
    if levels is not None:
        return _at_shared_levels(case, usual, levels, postprocessing, report)
    from flexbearing.accuracy import Unusable
    from flexbearing.accuracy.adaptive import adaptive_resolution
    from flexbearing.accuracy.shared import UsualLevels
    from flexbearing.accuracy.trials import ROLLERS

    try:
        resolution = adaptive_resolution(case, ROLLERS, report)
    except Unusable as problem:
        return _at_shared_levels(case, usual, UsualLevels(str(problem)), postprocessing, report)
    return ResolvedCase(
        resolution.trials.model(resolution.place),
        lambda: resolution.trial.rings,
        resolution.attributes(),
        lambda end: resolution.notes(end.loads),
    )


def _raceways(case: Case, azimuths: NDArray, report: Report, ahead: "Ahead | None") -> RacewayPair:
    """Both raceways; finite elements are loaded for those that deflect."""
    if part_of(case, "inner") is None and part_of(case, "outer") is None:
        return RacewayPair(RigidRaceway(azimuths), RigidRaceway(azimuths))
    if case.coupling.structure == "full":
        from flexbearing.rings.full_solve import full_fe_raceways

        return full_fe_raceways(case, azimuths, report)
    from flexbearing.rings.condensed import condensed_raceways

    return condensed_raceways(case, azimuths, report, ahead)


def _at_shared_levels(
    case: Case, usual: ResolvedCase, levels: "Levels", postprocessing: Postprocessing, report: Report
) -> ResolvedCase:
    """At levels that were chosen for more cases than this one, or at the usual ones where none could be."""
    postprocessing.notes.extend(levels.notes())
    if levels.place is None:
        return replace(usual, attributes=levels.attributes())
    from flexbearing.accuracy.levels import ladders
    from flexbearing.accuracy.trials import Trials

    trials = Trials(case, ladders(case), report)
    return ResolvedCase(trials.model(levels.place), partial(trials.rings, levels.place), levels.attributes())


def _solve(
    case: Case,
    resolved: ResolvedCase,
    postprocessing: Postprocessing,
    report: Report,
    initial: InitialState | None,
) -> dict[str, object]:
    """Rigid equilibrium, then the rings, then both coupled; returns how it ended."""
    partner = BearingPartner(resolved.model)
    report.stage("rigid raceways", None)
    try:
        rigid = partner.solve(_between_rigid_raceways(resolved.model, initial))
    except PartnerFailed as failure:
        return _not_solved(f"rigid raceways: {failure}", failure)
    postprocessing.store("rigid", resolved.model, rigid, RIGID)
    try:
        rings = resolved.rings()
    except PartnerFailed as failure:
        return _not_solved(str(failure), failure)
    if rings.rigid:
        passed = _passage(case, resolved.model, rings, rigid, postprocessing, report)
        errors = _slice_error(case, resolved.model, rings, rigid, postprocessing)
        return _all_rigid(resolved, rigid, postprocessing) | passed | errors
    report.stage("bearing and rings coupled", None)
    attempts = CoupledBearing(case.coupling, partner, rings, rigid, initial and initial.state).solve(
        postprocessing.record, report, states.iteration
    )
    last, converged = attempts[-1], attempts[-1].status == "converged"
    stored = last if converged else nearest(attempts)
    ending = _ending(last.status, summary(attempts, stored), last.iterations) | records(attempts)
    if stored is None:  # no method found a first state between flexible raceways
        return ending
    try:
        tangent, figures = rings.linearised(stored.state.forces), rings.figures()
    except PartnerFailed as failure:  # rings that fail at the end state may have been why it did not converge
        failed = {"status": "not solved", "message": str(failure), "ending": failure.ending}
        return ending | failed if converged else ending
    postprocessing.store("flexible", resolved.model, stored.state, tangent, converged=converged)
    if converged:
        figures = _of_springs(figures, postprocessing)
        postprocessing.notes.extend([*resolved.notes(stored.state), *notes.of_structure(figures)])
        ending |= _tilt(TiltComparison.at(case, resolved.model, stored.state, tangent), postprocessing)
        ending |= _passage(case, resolved.model, rings, stored.state, postprocessing, report)
        ending |= _slice_error(case, resolved.model, rings, stored.state, postprocessing)
    return ending | {"structure": figures}


def _between_rigid_raceways(model: RollerBearing, initial: InitialState | None) -> Equilibrium | None:
    """Where the bearing starts between rigid raceways; None: from its static load distribution."""
    return None if initial is None or initial.rigid is None else model.state(initial.rigid)


def _of_springs(figures: dict[str, Any], postprocessing: Postprocessing) -> dict[str, Any]:
    """Figures of the rings without the stiffness of their supports, where it is none in series."""
    if postprocessing.solved["flexible"].end.in_series[0]:
        return figures
    absent = {"support_stiffness_N_per_m": None, "support_stiffness_error_N_per_m": None}
    return {
        race: {**each, **{name: None for name in absent if name in each}} for race, each in figures.items()
    }


def _all_rigid(
    resolved: ResolvedCase, rigid: Equilibrium, postprocessing: Postprocessing
) -> dict[str, object]:
    """The end of a case without a flexible part."""
    postprocessing.repeat_rigid()
    postprocessing.notes.extend(resolved.notes(rigid))
    force, moment = rigid.unbalanced
    words = f"ring, rollers and cage in balance to {force:.1e} N and {moment:.1e} N m"
    ending = _ending("converged", f"every part is rigid; {words}", 0)
    return ending | {"ending": str(rigid.status)}


def _tilt(comparison: TiltComparison, postprocessing: Postprocessing) -> dict[str, object]:
    postprocessing.notes.extend(comparison.notes())
    return {"tilt": comparison.record()}


def _passage(
    case: Case,
    model: RollerBearing,
    rings: RacewayPair,
    end: Equilibrium,
    postprocessing: Postprocessing,
    report: Report,
) -> dict[str, object]:
    """Other positions of the rollers where the case requires them, or a note where they matter to people."""
    if case.operation.roller_positions is None:
        if postprocessing.record.others != "left out":
            postprocessing.notes.extend(passage.notes(case, model, rings, end))
        return {}
    passed = passage.passage(case, model, rings, end, report)
    postprocessing.notes.extend(passed.notes())
    return {"passage": passed.record()}


def _slice_error(
    case: Case, model: RollerBearing, rings: RacewayPair, end: Equilibrium, postprocessing: Postprocessing
) -> dict[str, Any]:
    """Errors by slices for a file; a run in memory, as in a study, spends no time on them."""
    return life_error.record(case, model, rings, end) if postprocessing.record.stores else {}


def _start(initial: InitialState, attempts: Any, postprocessing: Postprocessing) -> dict[str, Any]:
    """Where the coupling started; a note where that is not the initial state."""
    if initial.rigid is not None and not attempts:
        return {"started_from": initial.source}
    attempt = attempts.get(FROM_INITIAL_STATE, {"status": "not reached", "message": "nothing was iterated"})
    if attempt["status"] == "converged":
        return {"started_from": initial.source}
    postprocessing.notes.append(
        information("start-not-used", f"start {initial.source}: not used: {attempt['message']}")
    )
    return {"started_from": "rigid raceways"}


def _not_solved(message: str, failure: PartnerFailed) -> dict[str, object]:
    status = WORK_LIMIT if failure.ending == WORK_LIMIT else "not solved"
    return _ending(status, message, 0) | {"ending": failure.ending}


def _ending(status: str, message: str, iterations: int) -> dict[str, object]:
    return {
        "status": status, "message": message, "iterations": iterations, "structure": {}, "attempts": {}
    }  # fmt: skip
