"""Speed against error: one case on every level of its ladder, cold and with its rings in the cache.

Levels are calls of a worker process, one after the other, so that nothing disturbs their times. Times are
medians.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory, gettempdir
from time import perf_counter
from typing import Any

import numpy as np

import quasidynamic as qd
from fem.errors import NotSolved
from fem.parts.material import ImpossiblePart
from flexbearing.api import check, run
from flexbearing.case import BadCase, Head
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.case.roller import Case
from flexbearing.coupling import PartnerFailed
from flexbearing.files import NotStored
from flexbearing.program.worker_processes import Processes
from flexbearing.quantities.roller import CAGE_SLIP
from flexbearing.report.studies.pareto_table import Measured, Study
from flexbearing.results import Result
from flexbearing.studies.engine import DIED, Done, completed
from flexbearing.studies.pareto_levels import (
    BALL_REFERENCE,
    BallCase,
    Level,
    ball_ladder,
    ladder,
    left_out,
    richest,
)
from flexbearing.studies.worker import rings_in

# Whatever else the machine does disturbs short runs most: they are repeated, cold ones up to a total.
CACHED_RUNS, COLD_RUNS, LONG = 5, 3, 20.0  # [s]
LEAST_SLIP = 0.01  # errors of smaller slips are relative to this one
# Ends that a computation has a name for; anything else is a mistake in the program and ends the study.
ENDS = PartnerFailed, ImpossiblePart, NotSolved, qd.ImpossiblePart, qd.OutOfRange, qd.NotSolved
LOADS = "inner_load", "outer_load", "contact_load"
STIFFNESSES = "total_stiffness", "stiffness_matrix"
TORQUES = "driving_torque", "friction_torque", "torque"
NAMES = (*LOADS, CAGE_SLIP.name, "life_L10", *STIFFNESSES, *TORQUES)  # a family has some of them
RADIAL = 2, 2  # of the stiffness matrix: force along z by displacement along z
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
    state: Mapping[str, np.ndarray]  # by the names in NAMES
    message: str = ""  # why there is no answer
    picked: str = ""  # levels that a target chose
    estimated: dict[str, float] = field(default_factory=dict)  # [-] errors that it estimated


class NoReference(RuntimeError):
    """The richest level has no result, so that there are no errors."""


def pareto(
    case: str | Path, overrides: Sequence[str] = (), *, solid: bool = False, tell: Tell | None = None
) -> Study:
    """Run a case on every level of its ladder.

    Raises `BadCase` when the case cannot be computed as it stands, or orders an accuracy; `NoReference` when
    the richest level fails or does not converge; `NotStored` when there is no room for temporary files.
    """
    checked = _with_levels(check(case, overrides))
    tell = tell or (lambda measured: None)
    best, levels, words = levels_of(checked, solid=solid)
    with TemporaryDirectory() as folder, closing(Processes(1)) as engine:
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
        title=checked.title,
        reference=reference,
        levels=tuple(found[level.name] for level in levels),
        left_out=words,
    )


def levels_of(case: Case | BallCase, *, solid: bool) -> tuple[Level, tuple[Level, ...], tuple[str, ...]]:
    """The reference, all other levels, and kinds of levels that are left out with the reason."""
    if isinstance(case, Case):
        return richest(case), ladder(case, solid=solid), left_out(case, solid=solid)
    return BALL_REFERENCE, ball_ladder(case), ()


def errors(approximate: Mapping[str, np.ndarray], true: Mapping[str, np.ndarray]) -> dict[str, float]:
    """How wrong a state is, by the names of `flexbearing.report.studies.pareto_table.OUTPUTS`."""
    loads = [name for name in LOADS if name in true]
    largest = max(float(np.abs(approximate[name] - true[name]).max()) for name in loads)
    found = {"load": largest / max(float(true[name].max()) for name in loads)}
    if CAGE_SLIP.name in true:
        slip = abs(float(approximate[CAGE_SLIP.name] - true[CAGE_SLIP.name]))
        found["slip"] = slip / max(abs(float(true[CAGE_SLIP.name])), LEAST_SLIP)
    for output, names in {"life": ("life_L10",), "stiffness": STIFFNESSES, "torque": TORQUES}.items():
        name = next((name for name in names if name in true), None)
        if name is not None:
            found[output] = _relative_error(_scalar(approximate[name]), _scalar(true[name]))
    return found


def _scalar(value: np.ndarray) -> float:
    """A scalar, the radial stiffness of a matrix, or the torque on the inner ring."""
    return float(value[RADIAL] if np.ndim(value) == 2 else np.ravel(value)[0])


def _relative_error(value: float, exact: float) -> float:
    """Relative error, zero where both are infinite."""
    return 0.0 if value == exact else abs(value / exact - 1)


def _with_levels(case: Head) -> Case | BallCase:
    if not isinstance(case, Case | FastCase | FourPointCase):
        raise BadCase(f'{case.source.path}: a case of kind "{case.kind}" has no ladder of levels')
    if isinstance(case, Case | FastCase) and case.accuracy.target is not None:
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
        raise NoReference(f"{case}: the reference was not computed: {done.raised or DIED}") from done.raised
    if answer.message:
        raise NoReference(f"{case}: the reference is not converged: {answer.message}")
    return answer


def _measured(done: Done, exact: Timed) -> Measured:
    """A level that ended, however that was; a mistake in the program goes on from here."""
    level, answer = done.argument.level, done.answer
    if done.raised and not isinstance(done.raised, (BadCase, *ENDS)):
        raise done.raised
    if answer is None:
        return Measured(
            name=level.name,
            settings=level.settings,
            message=str(done.raised or DIED),
            physics=level.physics,
        )
    return Measured(
        name=level.name,
        settings=level.settings,
        times=answer.times,
        errors={} if answer.message else errors(answer.state, exact.state),
        message=answer.message,
        physics=level.physics,
        picked=answer.picked,
        estimated=answer.estimated,
    )


def timed(wanted: Run) -> Timed:
    """Median seconds of runs with an empty cache and with a filled one, and the numbers."""
    _load(wanted.case, wanted.overrides)
    settings = (*wanted.overrides, *wanted.level.settings)
    cold: list[float] = []
    cached: list[float] = []
    with _temporary(wanted.folder) as folder:
        while not cold or (len(cold) < COLD_RUNS and sum(cold) < LONG):
            with rings_in(f"{folder}/rings{len(cold)}"):
                cold.append(_run(wanted.case, settings, folder)[0])
                for _ in range(-(-CACHED_RUNS // COLD_RUNS)):
                    seconds, result = _run(wanted.case, settings, folder)
                    cached.append(seconds)
    times = {"cold": median(cold), "cached": median(cached)}
    if result.attributes["status"] != "converged":
        return Timed(times, {}, str(result.attributes["message"]))
    state = result.flexible or result.rigid
    return Timed(
        times,
        {name: state[name] for name in NAMES if name in state},
        picked=_picked(result.attributes.get("choices") or {}),
        estimated=_told(result.attributes.get("error_estimate") or {}),
    )


def _run(case: str | Path, settings: Sequence[str], folder: str) -> tuple[float, Result]:
    began = perf_counter()
    result = run(case, settings, output=Path(folder) / "level.h5")
    return perf_counter() - began, result


def _picked(choices: Mapping[str, Any]) -> str:
    """Levels that a target chose, in words."""
    return ", ".join(f"{name} {choice['level']}" for name, choice in choices.items())


def _told(estimate: Mapping[str, Any]) -> dict[str, float]:
    """Errors that a target estimated, by the names of outputs."""
    names = {"load": "roller_load", "slip": CAGE_SLIP.name, "life": "life", "stiffness": "total_stiffness"}
    return {output: float(estimate[name]) for output, name in names.items() if name in estimate}


@lru_cache(maxsize=1)
def _load(case: str | Path, overrides: tuple[str, ...]) -> None:
    """Load what runs of a case need, before any is timed."""
    found = check(case, overrides)
    if not isinstance(found, Case):
        return
    if found.outer.kind != "rigid" or found.inner.kind != "rigid":
        import fem.section.revolved  # noqa: F401


@contextmanager
def _temporary(place: str) -> Iterator[str]:
    """A folder for results that are deleted, also where an exception names them."""
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
