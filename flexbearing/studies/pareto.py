"""Speed against error: one case on every level of its ladder, cold and with its rings in the cache.

Levels are calls of a worker process, one after the other, so that nothing disturbs their times.
"""

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory, gettempdir
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
from flexbearing.report.studies.pareto_table import Measured, Study
from flexbearing.studies.engine import DIED, Done, completed
from flexbearing.studies.engine.apart import Apart
from flexbearing.studies.pareto_levels import Level, ladder, left_out, richest

CACHED_RUNS, SHORT = 3, 1.0  # [s] whatever else the machine does disturbs short runs most: they are repeated
LEAST_SLIP = 0.01  # errors of smaller slips are relative to this one
# Ends that a computation has a name for; anything else is a mistake in the program and ends the study.
ENDS = PartnerFailed, ImpossiblePart, NotSolved, qd.ImpossiblePart, qd.OutOfRange, qd.NotSolved
LOADS = "inner_load", "outer_load"
NAMES = (*LOADS, CAGE_SLIP.name, "life_L10", "total_stiffness")
Tell = Callable[[Measured], None]


@dataclass(frozen=True)
class Run:
    """A case on one of its levels."""

    case: str | Path
    overrides: tuple[str, ...]
    level: Level
    folder: str  # of temporary files

    @property
    def name(self) -> str:
        """That of the level."""
        return self.level.name


@dataclass(frozen=True)
class Timed:
    """What a run cost and what it gave."""

    times: dict[str, float]  # [s] by the names in `flexbearing.report.studies.pareto_table.TIMES`
    flexible: Mapping[str, np.ndarray]  # by the names in NAMES
    message: str = ""  # why there is no answer


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
        also of levels that failed, or whose process died, with their message

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
    best, levels = richest(roller_case), ladder(roller_case, solid=solid)
    with TemporaryDirectory() as folder, closing(Apart()) as engine:
        runs = [Run(case, tuple(overrides), level, folder) for level in (best, *levels)]
        (done,) = completed(runs[:1], timed, engine)
        exact = _reference(done)
        reference = _measured(done, exact)
        tell(reference)
        found: dict[str, Measured] = {}
        for done in completed(runs[1:], timed, engine):
            found[done.argument.name] = _measured(done, exact)
            tell(found[done.argument.name])
    return Study(
        title=roller_case.title,
        reference=reference,
        levels=tuple(found[level.name] for level in levels),
        left_out=left_out(roller_case, solid=solid),
    )


def errors(result: Timed, exact: Timed) -> dict[str, float]:
    """How wrong a result is, by the names of `flexbearing.report.studies.pareto_table.OUTPUTS`.

    Parameters
    ----------
    result, exact : Timed
        of the same case, with an answer

    Returns
    -------
    dict
        relative errors [-]
    """
    approximate, true = result.flexible, exact.flexible
    largest = max(float(np.abs(approximate[name] - true[name]).max()) for name in LOADS)
    slip = abs(float(approximate[CAGE_SLIP.name] - true[CAGE_SLIP.name]))
    return {
        "load": largest / max(float(true[name].max()) for name in LOADS),
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
            f'{case.source.path}: only roller bearings have a ladder of levels; kind is "{case.kind}"'
        )
    if case.accuracy.target is not None:
        raise BadCase(
            f"{case.source.path}: accuracy.target chooses levels by itself, here all are run; leave it out"
        )
    return case


def _reference(done: Done) -> Timed:
    """The answer that errors are measured against."""
    case, answer = done.argument.case, done.answer
    if done.raised and not isinstance(done.raised, ENDS):
        raise done.raised
    if answer is None:
        raise NoReference(f"{case}: the reference has no answer: {done.raised or DIED}") from done.raised
    if answer.message:
        raise NoReference(f"{case}: the reference is not converged: {answer.message}")
    return answer


def _measured(done: Done, exact: Timed) -> Measured:
    """A level that ended, however that was; a mistake in the program goes on from here."""
    level, answer = done.argument.level, done.answer
    if done.raised and not isinstance(done.raised, (BadCase, *ENDS)):
        raise done.raised
    if answer is None:
        return Measured(name=level.name, settings=level.settings, message=str(done.raised or DIED))
    off = {} if answer.message else errors(answer, exact)
    return Measured(
        name=level.name, settings=level.settings, times=answer.times, errors=off, message=answer.message
    )


def timed(wanted: Run) -> Timed:
    """Seconds of a run with an empty cache and of the fastest of some with a filled one, and its numbers.

    Parameters
    ----------
    wanted : Run
        what a worker process is given

    Returns
    -------
    Timed
    """
    _load(wanted.case, wanted.overrides)
    settings, seconds = (*wanted.overrides, *wanted.level.settings), []
    with _temporary(wanted.folder) as folder, _cache(folder):
        while len(seconds) < 2 or (len(seconds) <= CACHED_RUNS and min(seconds) < SHORT):
            began = perf_counter()
            result = run(wanted.case, settings, output=Path(folder) / "level.h5")
            seconds.append(perf_counter() - began)
    times = {"cold": seconds[0], "cached": min(seconds[1:])}
    if result.attributes["status"] != "converged":
        return Timed(times, {}, str(result.attributes["message"]))
    return Timed(times, {name: result.flexible[name] for name in NAMES})


@lru_cache(maxsize=1)
def _load(case: str | Path, overrides: tuple[str, ...]) -> None:
    """Load what runs of a case need, before any is timed."""
    found = check(case, overrides)
    if found.outer.kind != "rigid" or found.inner.kind != "rigid":
        import fem.section.revolved  # noqa: F401


@contextmanager
def _temporary(place: str) -> Iterator[str]:
    """A folder for results that nobody keeps, whatever an exception says of them."""
    with TemporaryDirectory(dir=place) as folder:
        try:
            yield folder
        except NotStored as problem:
            raise NotStored(
                f"{gettempdir()}: no room for the results of the levels. Free space there, or name "
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
