"""The command as a function: read, search, answer, table and case of the optimum."""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, replace
from functools import cached_property, partial
from pathlib import Path
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from flexbearing.build.clearance import ROLLERS
from flexbearing.cache import configured
from flexbearing.case import BadCase, Head
from flexbearing.case.head import value_at
from flexbearing.case.text import tables
from flexbearing.families import FAMILIES
from flexbearing.files import require_folder, require_outputs, write
from flexbearing.optimise.answer import Optimum, answer, rank
from flexbearing.optimise.case_file import case_text, require_unedited
from flexbearing.optimise.correction import Corrected
from flexbearing.optimise.evaluations import (
    Evaluations,
    NotComputed,
    Point,
    Workers,
    designs_of,
    varied_rings,
)
from flexbearing.optimise.file import Problem, Settings, read
from flexbearing.optimise.goals import Measure, Numbers
from flexbearing.optimise.gradients import Gradients
from flexbearing.optimise.managed_search import from_design, managed_search
from flexbearing.optimise.search import (
    SPARE,
    Designs,
    End,
    ScaledProblem,
    SearchResult,
    examined,
    search,
    starts,
)
from flexbearing.optimise.variables import settings as of_point
from flexbearing.optimise.worker import SlopeRequest, slope_name, slope_rows
from flexbearing.program.threads import cores, limited_to, processes
from flexbearing.studies.engine import Engine
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.file.read import Source
from flexbearing.studies.placement import Placement
from flexbearing.studies.prepare import prepare
from flexbearing.studies.prepared_study import PreparedStudy
from flexbearing.studies.run import Work, guarded
from flexbearing.studies.table import journal
from flexbearing.studies.table.files import FORMS
from flexbearing.studies.worker import RowRequest, condense, rows

CASE, TABLE = "_optimum.toml", ".csv"  # behind the name: the case at the best point, all designs
VERIFICATIONS = 4  # of the best design until finer models meet its constraints
SCATTER = 1.25e-3  # of outputs over their size where another ring is meshed for every value
MESHED_DIGITS = 4  # of the share of a range, where another ring is meshed for every value
Tell = Callable[[SearchResult], None]
EMPTY: Settings = {}


def optimise(
    source: Source,
    output: str | Path = "results",
    *,
    case: Head | None = None,
    jobs: int | None = None,
    tell: Tell = lambda found: None,
    work: Callable[[Problem, Path], Workers] | None = None,
) -> Optimum:
    """Find the best design of an optimisation, from its file or as a dictionary.

    Designs that a former call with the same folder computed are taken from there.

    Raises `BadCase` for a wrong file, or a case that cannot be computed; `BadOutput`, `NotStored` as for a
    study.
    """
    problem, folder = read(source, FAMILIES, case), require_folder(Path(output))
    base, name, inputs = _sound(problem), problem.study.name, problem.study.inputs
    places = (*(folder / f"{name}{end}" for end in (TABLE, CASE)), base.journal(folder))
    table, best, path = require_outputs(places, inputs)
    require_unedited(best)
    meshed = varied_rings(problem)
    count = processes(jobs) if jobs else (cores() if meshed else 1)
    if meshed and not problem.surrogate:  # noise of meshes is all that closer designs differ by
        rounded = tuple(replace(each, digits=MESHED_DIGITS) for each in problem.variables)
        problem = replace(problem, variables=rounded)
    workers = replace((work or _bearings)(problem, folder), processes=count)
    with (
        limited_to(count),
        journal.opened(path, _names(problem)) as kept,
        _engine(count, base) as engine,
    ):
        start = partial(guarded, engine, kept, journal.begun(path))
        evaluations = Evaluations(problem, workers, start, kept, journal.read(path))
        surrogate = _searched_instead(evaluations) if problem.surrogate else None
        found = _Search(evaluations, surrogate, SCATTER if meshed else SPARE).optimum(tell)
    write(table, FORMS[TABLE][0](found.table))
    if found.usable:
        write(best, case_text(problem.study, found.settings, folder))
    else:
        best.unlink(missing_ok=True)  # of a former search
    return found


def _searched_instead(evaluations: Evaluations) -> Evaluations:
    """The surrogate, whose designs are not verified."""
    problem = evaluations.problem
    search = problem.search.model_copy(update={"verified": False})
    cheap = replace(problem, fixed={**problem.fixed, **problem.surrogate}, search=search)
    return replace(evaluations, problem=cheap, designs={}, refused={}, sharing={})


def _sound(problem: Problem) -> PreparedStudy:
    """The study of the case as it stands, which must be one that can be computed."""
    base = prepare(problem.study)
    base.plan.require_sound()
    _require_starts(problem)
    return base


def _require_starts(problem: Problem) -> None:
    """Refuse settings with which no start can be computed, by the table that they are in."""
    file, settings = problem.study.path.name, problem.search
    first = np.array([each.start for each in problem.variables])
    shares = starts(settings.starts, first, settings.seed)
    points = [[each.value(share) for each, share in zip(problem.variables, of, strict=True)] for of in shares]
    designs = [of_point(problem.variables, point, problem.lists) for point in points]
    if why := _impossible(problem, designs):
        table = "[vary]" if not _impossible(problem, [{}]) else "[set]"
        raise BadCase(f"{file}: {table}: {why}")
    if problem.surrogate and (why := _impossible(problem, designs, problem.surrogate)):
        raise BadCase(f"{file}: [surrogate]: {why}")
    for number, each in enumerate(problem.verify, 1):
        if each and (why := _impossible(problem, designs, each, target=True)):
            raise BadCase(f"{file}: [[verify]] {number}: {why}")


def _impossible(
    problem: Problem, designs: Sequence[Settings], more: Settings = EMPTY, *, target: bool = False
) -> str:
    """Why none of some designs can be computed with more settings; empty where one can."""
    why = ""
    for design in designs:
        plan = designs_of(problem, [{**problem.fixed, **design, **more}]).plan
        if plan.corners and not target:
            return "accuracy.target chooses levels anew for every design; put it into [[verify]]"
        if not plan.problems:
            return ""
        why = why or plan.problems[0].message
    return why


def _names(problem: Problem) -> list[str]:
    """Names of the numbers in the journal: outputs, and their slopes."""
    measures = problem.goal(None).measure, *(bound.measure for bound in problem.bounds(None))
    texts = dict.fromkeys(measure.text for measure in measures)
    texts |= dict.fromkeys(each.text for each in _peaks(problem))
    return [*texts, *(slope_name(text, each.key) for text in texts for each in problem.variables)]


def _bearings(problem: Problem, folder: Path) -> Workers:
    """What computes the bearings of this program."""
    cache = str(folder / f"{problem.study.name}.rings") if configured().folder is None else None
    measures = problem.goal(None).measure, *(bound.measure for bound in problem.bounds(None))
    texts = tuple(dict.fromkeys(measure.text for measure in measures))
    ring = partial(condense, cache=cache)

    def slopes(keys: Sequence[str]) -> Work:
        return Work(partial(slope_rows, request=SlopeRequest(texts, tuple(keys)), cache=cache), ring)

    peaks = _peaks(problem)
    request = RowRequest((*texts, *(each.text for each in peaks if each.text not in texts)))
    return Workers(Work(partial(rows, request=request, cache=cache), ring), slopes, peaks=peaks)


def _peaks(problem: Problem) -> tuple[Measure, ...]:
    """Peak pressures that half-spaces check; none of balls, and none that they have anyway."""
    contact = problem.fixed.get("bearing.contact", value_at(tables(problem.study.text), "bearing.contact"))
    if problem.study.kind != ROLLERS or contact not in (None, "", "slices"):
        return ()
    names = (f"peak_pressure.{race}" for race in ("inner", "outer"))
    return tuple(Measure(name, f"{name} [MPa]", "MPa") for name in names)


@contextmanager
def _engine(count: int, base: PreparedStudy) -> Iterator[Callable[[int], Engine]]:
    """What gives the engine of each batch of designs: worker processes stay from one to the next."""
    if count == 1:
        yield lambda tasks: Serial()
        return
    engine = Placement(count).engine(base.plan)(count)
    close, engine.close = engine.close, lambda: None
    try:
        yield lambda tasks: engine
    finally:
        close()


@dataclass(frozen=True)
class _Search:
    """The search from all starts."""

    evaluations: Evaluations
    surrogate: Evaluations | None  # with the same rows; None: the case itself is searched
    spare: float  # margin up to which a constraint counts as used up

    def optimum(self, tell: Tell) -> Optimum:
        """What is found; `tell` is called with the end of each start."""
        began, found, settings = perf_counter(), [], self.evaluations.problem.search
        first = np.array([each.start for each in self.evaluations.problem.variables])
        points, seconds = list(starts(settings.starts, first, settings.seed)), 0.0
        problem = ScaledProblem(self._gradients, spare=self.spare)
        if settings.verified:
            problem, seconds = self._as_verified(problem.point(points[0]))
        for start in points:
            best = max((each.merit for each in found if each.end is End.CONVERGED), default=-np.inf)
            found.append(self._from(replace(problem, best=best), start, found))
            tell(found[-1])
        if settings.verified:
            seconds += self._until_verified(found)
        times = perf_counter() - began - seconds, seconds
        return answer(self.evaluations, self.surrogate, found, self._gradients.how, times)

    @cached_property
    def _gradients(self) -> Gradients:
        return Gradients(self.evaluations)

    @cached_property
    def _cheap(self) -> Gradients | None:
        return self.surrogate and Gradients(self.surrogate)

    def _as_verified(self, point: Point) -> tuple[ScaledProblem, float]:
        """The case with the values that finer models have at a design, and the time that these took [s]."""
        began = perf_counter()
        if self.evaluations.workers.processes > 1:
            with suppress(NotComputed):  # which its values tell
                self._gradients.at(point)  # while a worker verifies it
        numbers = self.evaluations.verified(point)
        designs: Designs = self._gradients
        if isinstance(numbers, Numbers) and isinstance(self.evaluations.at([point])[0], Numbers):
            designs = Corrected(designs, designs, point, numbers)
        return ScaledProblem(designs, spare=self.spare), perf_counter() - began

    def _until_verified(self, found: list[SearchResult]) -> float:
        """Go on from the best until it is an optimum with the values of finer models; their time [s]."""
        seconds = 0.0
        for number in range(VERIFICATIONS):
            place = min(range(len(found)), key=lambda each: rank(found[each]))
            best, begin = found[place], found[place].start
            problem, more = self._as_verified(best.point)
            there = examined(problem, problem.shares(best.point), best.iterations, best.message)
            found[place], seconds = replace(there, start=begin), seconds + more
            if there.end not in (End.STALLED, End.INFEASIBLE) or number == VERIFICATIONS - 1:
                break
            found[place] = replace(self._on(problem, there), start=begin)
        return seconds

    def _from(self, problem: ScaledProblem, start: NDArray, known: Sequence[SearchResult]) -> SearchResult:
        if self._cheap is None:
            return search(problem, start)
        return managed_search(problem, self._cheap, start, known)

    def _on(self, problem: ScaledProblem, there: SearchResult) -> SearchResult:
        shares = problem.shares(there.point)
        if self._cheap is None:
            return search(problem, shares)
        return from_design(problem, self._cheap, shares, there.iterations)
