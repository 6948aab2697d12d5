"""One case, given its family, from what was read to its result file."""

from functools import partial
from pathlib import Path
from time import perf_counter

from threadpoolctl import threadpool_limits

from flexbearing.case import BadCase, Head
from flexbearing.case.family import Family
from flexbearing.progress import Logged, Report
from flexbearing.results import Result, ResultFile, read as read_result
from flexbearing.runs.validate import require_possible


def run_case(
    case: Head,
    family: Family,
    output: str | Path | None = None,
    report: Report | None = None,
    start: Result | None = None,
) -> Result:
    """Compute a case and store it.

    Parameters
    ----------
    case : Head
        as it was read
    family : Family
        its family
    output : path, optional
        result file, written as `<output>.part` until complete; default `results/<case>.h5`
    report : Report, optional
        hears of stages and iterations; default is the log
    start : Result, optional
        of a neighbouring case, at whose flexible end state newton begins; by default between rigid raceways

    Returns
    -------
    Result
        also when the iteration did not converge: `result.attributes["status"]` says so

    Raises
    ------
    BadCase
        when the case cannot be computed as it stands, or cannot start there
    """
    began = perf_counter()
    require_possible(case, family)
    solve = family.solve()
    if start is not None:
        if family.initial_state is None:
            raise BadCase(f"start {start.path}: a {case.kind} bearing starts from no other result")
        solve = partial(solve, near=family.initial_state()(start, case))
    path = Path(output) if output else Path("results") / f"{Path(case.source.path).stem}.h5"
    # The bearing's matrices are small: threads of the linear algebra would only wait for each other.
    with (
        threadpool_limits(limits=1, user_api="blas"),
        ResultFile(path, _head(case) | family.opening()(case), family) as file,
    ):
        ending = solve(case, file, report or Logged())
        file.finish(**ending, wall_time_s=perf_counter() - began)
    return read_result(path, {family.kind: family})


def _head(case: Head) -> dict[str, object]:
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
