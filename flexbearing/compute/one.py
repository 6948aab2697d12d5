"""One case from file to file."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter

from threadpoolctl import threadpool_limits

from flexbearing.case import Case, read
from flexbearing.compute import assemble, clearance, datasets, notes
from flexbearing.compute.outcome import Outcome
from flexbearing.compute.progress import Logged, Report
from flexbearing.compute.structure import CondensedRings, condensed
from flexbearing.coupling import Ending, Iteration, PartnerFailed, newton, relaxed
from flexbearing.results import Result, ResultFile
from flexbearing.results import read as read_result
from quasidynamic import Equilibrium, NotSolved, RollerBearing


@dataclass(frozen=True)
class BearingPartner:
    """The bearing as the coupling knows it: its failures carry the coupling's name."""

    model: RollerBearing

    def solve(self, start=None, deviation=None) -> Equilibrium:
        """Equilibrium between raceways of a given shape."""
        try:
            return self.model.solve(start, deviation)
        except NotSolved as failure:
            raise PartnerFailed(str(failure), str(failure.ending)) from failure

    def iterate(self, compliance, start) -> Iterator[Equilibrium]:
        """Newton iterates between raceways that yield."""
        try:
            yield from self.model.iterate(compliance, start)
        except NotSolved as failure:
            raise PartnerFailed(str(failure), str(failure.ending)) from failure


def run(
    case: str | Path,
    output: str | Path | None = None,
    overrides: Sequence[str] = (),
    report: Report | None = None,
) -> Result:
    """Compute a case and store it.

    Parameters
    ----------
    case : path
        case file
    output : path, optional
        result file, written as `<output>.part` until complete; default `results/<case>.h5`
    overrides : sequence of str
        `"key=value"` settings that replace those of the file
    report : Report, optional
        hears of stages and iterations; default is the log

    Returns
    -------
    Result
        also when the iteration did not converge: `result.attributes["status"]` says so

    Raises
    ------
    BadCase
        when the case cannot be computed as it stands
    """
    began = perf_counter()
    report = report or Logged()
    wanted = read(case, overrides)
    assemble.require_possible(wanted)
    path = Path(output) if output else Path("results") / f"{Path(case).stem}.h5"
    # The bearing's matrices are small: threads of the linear algebra would only wait for each other.
    with threadpool_limits(limits=1, user_api="blas"), ResultFile(path, _opening(wanted)) as file:
        outcome = Outcome(wanted, file)
        ending = _solve(wanted, file, outcome, report)
        file.finish(**ending, **outcome.attributes(), wall_time_s=perf_counter() - began)
    return read_result(path)


def _opening(case: Case) -> dict[str, object]:
    return {
        "title": case.title,
        "method": case.coupling.method,
        "case_text": case.source.text,
        "case_overrides": list(case.source.overrides),
        "case_si": case.to_json(),
        "assumed": list(case.assumed),
        "calibrated": dict(case.calibrated),
        "notes": list(notes.of_case(case)),
        "clearance": clearance.record(case),
    }


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
    rings = condensed(case, model.bearing.azimuths, report)
    if rings.rigid:
        outcome.store("flexible", rigid, rings)
        ending = _ending("converged", "every part is rigid: nothing to iterate", 0, rings)
        return ending | {"ending": str(rigid.status)}
    report.stage("bearing and rings together", None)
    last = _iterate(case, partner, rings, rigid, file, report)
    outcome.store("flexible", last.state, rings, converged=last.status == "converged")
    ending = _ending(last.status, last.message or _sentence(last, case), last.number, rings)
    return ending | {"ending": str(last.ending)}


def _iterate(case, partner, rings, rigid, file, report) -> Iteration[Equilibrium]:
    ending = Ending(tolerance=case.coupling.tolerance, limit=case.coupling.max_iterations)
    if case.coupling.method == "relaxed":
        steps = relaxed(partner, rings, rigid, ending, case.coupling.relaxation)
    else:
        steps = newton(partner, rings, rigid, ending)
    began = perf_counter()
    step = None
    for step in steps:
        file.iteration(step.number, datasets.iteration(step, perf_counter() - began))
        report.iteration(step)
        began = perf_counter()
    assert step is not None  # both methods yield at least once
    return step


def _sentence(last: Iteration, case: Case) -> str:
    if last.status == "converged":
        return (
            f"loads changed by {last.load_change:.1e} of the largest in the last iteration, "
            f"unbalanced force {last.state.residual:.1e} of the load"
        )
    return (
        f"{case.coupling.method} stopped after {last.number} iterations with load changes of "
        f"{last.load_change:.1e} (converged is below {case.coupling.tolerance:.0e})"
        + (
            "; try coupling.method = newton, or a smaller coupling.relaxation"
            if case.coupling.method == "relaxed"
            else ""
        )
    )


def _ending(status: str, message: str, iterations: int, rings: CondensedRings) -> dict[str, object]:
    return {"status": status, "message": message, "iterations": iterations, "structure": rings.figures()}
