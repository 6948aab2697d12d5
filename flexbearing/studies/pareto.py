"""Speed against error: one case on every level of its ladder, cold and with its rings in the cache."""

import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

import numpy as np

import quasidynamic as qd
from fem.errors import NotSolved
from fem.parts.material import ImpossiblePart
from flexbearing.api import check, run
from flexbearing.cache.store import VARIABLE
from flexbearing.case import BadCase, Head
from flexbearing.case.roller import Case
from flexbearing.coupling import PartnerFailed
from flexbearing.files import NotStored
from flexbearing.quantities.roller import CAGE_SLIP
from flexbearing.report.studies.pareto_table import OUTPUTS, Measured, Study
from flexbearing.results import Result
from flexbearing.studies.pareto_levels import Level, ladder, left_out, richest

CACHED_RUNS, SHORT = 3, 1.0  # [s] whatever else the machine does disturbs short runs most: they are repeated
LEAST_SLIP = 0.01  # errors of smaller slips are relative to this one
# Ends that a computation has a name for; anything else is a mistake in the program and ends the study.
ENDS = PartnerFailed, ImpossiblePart, NotSolved, qd.ImpossiblePart, qd.OutOfRange, qd.NotSolved
Tell = Callable[[Measured], None]


class NoReference(RuntimeError):
    """The richest level has no answer, so that there are no errors."""


def pareto(
    case: str | Path, overrides: Sequence[str] = (), *, solid: bool = False, tell: Tell | None = None
) -> Study:
    """Run a case on every level of its ladder.

    Parameters
    ----------
    case : path
        case file of a roller bearing
    overrides : sequence of str
        `"key=value"` settings that replace those of the file, on every level
    solid : bool
        whether the full solid is among the levels
    tell : callable (Measured), optional
        told of every level as soon as it is measured

    Returns
    -------
    Study
        also of levels that failed, with their message

    Raises
    ------
    BadCase
        when the case cannot be computed as it stands, or is no roller bearing
    NoReference
        when the richest level fails or does not converge
    NotStored
        when there is no room for temporary files
    """
    roller_case = _rollers(check(case, overrides))
    tell = tell or (lambda measured: None)
    if roller_case.outer.kind != "rigid" or roller_case.inner.kind != "rigid":
        import fem.section.revolved  # noqa: F401  # loaded before any run is timed
    best = richest(roller_case)
    try:
        times, exact = _timed(case, (*overrides, *best.settings))
    except ENDS as problem:
        raise NoReference(f"{case}: the reference has no answer: {problem}") from problem
    if problem := _problem(exact):
        raise NoReference(f"{case}: the reference is not converged: {problem}")
    reference = Measured(
        name=best.name, settings=best.settings, times=times, errors=dict.fromkeys(OUTPUTS, 0.0)
    )
    tell(reference)
    levels = []
    for level in ladder(roller_case, solid=solid):
        levels.append(_measured(case, overrides, level, exact))
        tell(levels[-1])
    return Study(
        title=roller_case.title,
        reference=reference,
        levels=tuple(levels),
        left_out=left_out(roller_case, solid=solid),
    )


def errors(result: Result, exact: Result) -> dict[str, float]:
    """How wrong a result is, by the names of `flexbearing.report.studies.pareto_table.OUTPUTS`.

    Parameters
    ----------
    result, exact : Result
        of the same case, converged

    Returns
    -------
    dict
        relative errors [-]
    """
    approximate, true = result.flexible, exact.flexible
    loads = ("inner_load", "outer_load")
    largest = max(float(np.abs(approximate[name] - true[name]).max()) for name in loads)
    slip = abs(float(approximate[CAGE_SLIP.name] - true[CAGE_SLIP.name]))
    return {
        "load": largest / max(float(true[name].max()) for name in loads),
        "slip": slip / max(abs(float(true[CAGE_SLIP.name])), LEAST_SLIP),
        "life": _relative_error(float(approximate["life_L10"]), float(true["life_L10"])),
        "stiffness": _relative_error(float(approximate["total_stiffness"]), float(true["total_stiffness"])),
    }


def _relative_error(value: float, exact: float) -> float:
    """Relative error, zero where both are infinite."""
    return 0.0 if value == exact else abs(value / exact - 1)


def _rollers(case: Head) -> Case:
    if not isinstance(case, Case):
        raise BadCase(
            f"{case.source.path}: only roller bearings have a ladder of levels, this is a {case.kind}"
        )
    if case.accuracy.target is not None:
        raise BadCase(
            f"{case.source.path}: accuracy.target chooses levels by itself, here all are run; leave it out"
        )
    return case


def _measured(case: str | Path, overrides: Sequence[str], level: Level, exact: Result) -> Measured:
    try:
        times, result = _timed(case, (*overrides, *level.settings))
    except (BadCase, *ENDS) as problem:
        return Measured(name=level.name, settings=level.settings, message=str(problem))
    if problem := _problem(result):
        return Measured(name=level.name, settings=level.settings, times=times, message=problem)
    return Measured(name=level.name, settings=level.settings, times=times, errors=errors(result, exact))


def _problem(result: Result) -> str:
    """Why a result is none, empty if it is one."""
    return "" if result.attributes["status"] == "converged" else str(result.attributes["message"])


def _timed(case: str | Path, settings: Sequence[str]) -> tuple[dict[str, float], Result]:
    """Seconds of a run with an empty cache and of the fastest of some with a filled one, and its result."""
    with _temporary() as folder, _cache(folder):
        seconds = []
        while len(seconds) < 2 or (len(seconds) <= CACHED_RUNS and min(seconds) < SHORT):
            began = perf_counter()
            result = run(case, settings, output=Path(folder) / "level.h5")
            seconds.append(perf_counter() - began)
    return {"cold": seconds[0], "cached": min(seconds[1:])}, result


@contextmanager
def _temporary() -> Iterator[str]:
    """A folder for results that nobody keeps, whatever an exception says of them."""
    with TemporaryDirectory() as folder:
        try:
            yield folder
        except NotStored as problem:
            raise NotStored(
                f"{Path(folder).parent}: no room for the results of the levels. Free space there, or name "
                "another folder for temporary files in TMPDIR."
            ) from problem
        except BaseException as problem:
            problem.__notes__ = []
            raise


@contextmanager
def _cache(folder: str) -> Iterator[None]:
    """Keep condensed rings in a folder of its own."""
    previous = os.environ.get(VARIABLE)
    os.environ[VARIABLE] = folder
    try:
        yield
    finally:
        if previous is None:
            del os.environ[VARIABLE]
        else:
            os.environ[VARIABLE] = previous
