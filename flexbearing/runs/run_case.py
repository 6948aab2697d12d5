"""One case from file to file."""

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Any

from threadpoolctl import threadpool_limits

from flexbearing.case import AngularCase, AnyCase, Case, FourPointCase, read
from flexbearing.coupled.initial_state import InitialState, initial_state
from flexbearing.progress import Logged, Report
from flexbearing.results import Result, ResultFile, read as read_result
from flexbearing.runs import ball, roller
from flexbearing.runs.validate import require_possible

Opening = Callable[[Any], dict[str, Any]]
Solve = Callable[[Any, ResultFile, Report], dict[str, Any]]


def run(
    case: str | Path,
    output: str | Path | None = None,
    overrides: Sequence[str] = (),
    report: Report | None = None,
    start: str | Path | Result | None = None,
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
    start : path or Result, optional
        of a neighbouring case, at whose flexible end state newton begins; by default between rigid raceways

    Returns
    -------
    Result
        also when the iteration did not converge: `result.attributes["status"]` says so

    Raises
    ------
    BadCase
        when the case cannot be computed as it stands, or cannot start there
    BadResult
        when there is no complete result to start from
    """
    began = perf_counter()
    report = report or Logged()
    wanted = read(case, overrides)
    require_possible(wanted)
    near = None if start is None else initial_state(start, wanted)
    opening, solve = _job(wanted, near)
    path = Path(output) if output else Path("results") / f"{Path(case).stem}.h5"
    # The bearing's matrices are small: threads of the linear algebra would only wait for each other.
    with (
        threadpool_limits(limits=1, user_api="blas"),
        ResultFile(path, _head(wanted) | opening(wanted), wanted.kind) as file,
    ):
        ending = solve(wanted, file, report)
        file.finish(**ending, wall_time_s=perf_counter() - began)
    return read_result(path)


def _head(case: AnyCase) -> dict[str, object]:
    """Root attributes that every kind of case has."""
    return {
        "title": case.title,
        "case_text": case.source.text,
        "case_file": str(Path(case.source.path).resolve()),
        "case_overrides": list(case.source.overrides),
        "case_si": case.to_json(),
        "assumed": list(case.assumed),
        "calibrated": dict(case.calibrated),
    }


def _job(case: AnyCase, near: InitialState | None) -> tuple[Opening, Solve]:
    """What opens the file of a case, and what solves it."""
    match case:
        case Case():
            return roller.opening, partial(roller.solve, near=near)
        case FourPointCase():
            return ball.opening, ball.solve_four_point
        case AngularCase():
            return ball.opening, ball.solve_angular
