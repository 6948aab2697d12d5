"""The answer: the best design, how sure it is, what limits it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from time import perf_counter

import numpy as np

from flexbearing.findings import RowFinding
from flexbearing.findings.running import PRESSED_ENDS
from flexbearing.optimise.evaluations import Evaluations, NotComputed, Point
from flexbearing.optimise.file import Settings
from flexbearing.optimise.goals import Bound, Goal, Numbers
from flexbearing.optimise.search import FEASIBLE, End, SearchResult
from flexbearing.optimise.variables import Variable, settings
from flexbearing.studies.table import Table

HALF_SPACES = {"bearing.contact": "half_space", "life.edge_stress": False}  # which they contain already
PRESSED = "no best design: half-spaces have a higher peak pressure"
ALIKE = 1e-3  # relative difference of merits up to which starts agree


@dataclass(frozen=True)
class Active:
    """What keeps the optimum from being better."""

    words: str  # the constraint with its row, or the bound of a key
    unit: str
    gain: float  # relative change of the objective by one unit more room


@dataclass(frozen=True)
class Measured:
    """The objective and the constraints of a design."""

    what: str  # "the case", or how it is resolved
    objective: float | None  # in its unit; None where it has no result
    bounds: tuple[float, ...]  # the worst term of each constraint, in its unit
    missed: float = 0.0  # how far the worst one is missed, over its size
    message: str = ""


@dataclass(frozen=True)
class Peaks:
    """Peak pressure of the row and raceway of a design whose slices miss most of it."""

    sliced: float  # [MPa]
    whole: float  # [MPa] by half-spaces; NaN where they were not solved
    message: str = ""  # why there is none

    @property
    def hold(self) -> bool:
        """Whether half-spaces have no higher peak."""
        return 1 - self.sliced / self.whole <= PRESSED_ENDS.limit


@dataclass(frozen=True)
class Optimum:
    """What an optimisation found."""

    name: str
    goal: Goal
    bounds: tuple[Bound, ...]
    variables: tuple[Variable, ...]
    starts: tuple[SearchResult, ...]  # the best first
    how: dict[str, str]  # by the names of variables, how derivatives were found
    refused: dict[str, str]  # keys without derivatives at the equilibrium, and why
    case: Measured  # the case as it stands
    measured: Measured  # the best point
    verified: tuple[tuple[Measured, Measured], ...]  # of each [[verify]] the case and the best point
    active: tuple[Active, ...]
    designs: int
    cheap: int  # designs of the surrogate
    rows: int  # that were computed, the others stood in the journal
    table: Table
    settings: Settings  # of the case at the best point
    peaks: Peaks | None  # of the best point, also by half-spaces; None where slices have none
    violated: tuple[str, ...]  # rows of the best point that miss a constraint, with the value
    findings: tuple[RowFinding, ...]  # of all rows of the best point
    seconds: tuple[float, float]  # of the search, and of the case and what is verified

    @property
    def best(self) -> SearchResult:
        """The best start."""
        return self.starts[0]

    @property
    def converged(self) -> bool:
        """Whether the best point is an optimum that meets all constraints, and half-spaces have its peaks."""
        return self.best.end is End.CONVERGED and self.usable

    @property
    def feasible(self) -> bool:
        """Whether the best point has a result and meets all constraints."""
        return self.best.end not in (End.INFEASIBLE, End.NO_ANSWER) and not self.violated

    @property
    def usable(self) -> bool:
        """Whether the best point is feasible, with peak pressures that half-spaces have as well."""
        return self.feasible and (self.peaks is None or self.peaks.hold)

    @property
    def ending(self) -> str:
        """How the best start ended."""
        return str(self.best.end) if self.usable or not self.feasible else PRESSED

    @property
    def agreeing(self) -> tuple[SearchResult, ...]:
        """Starts that ended as well as the best one."""
        return tuple(
            each for each in self.starts if self.best.merit - each.merit <= ALIKE and each.missed <= ALIKE
        )


def answer(
    evaluations: Evaluations,
    surrogate: Evaluations | None,
    starts: Sequence[SearchResult],
    how: dict[str, str],
    seconds: tuple[float, float],
) -> Optimum:
    """Order what the starts found, and compute what is reported of the best."""
    began, problem, goal, bounds = perf_counter(), evaluations.problem, evaluations.goal, evaluations.bounds
    ordered = tuple(sorted(starts, key=rank))
    best, base = _settings(evaluations, ordered[0].point), evaluations.reference
    pairs = (design for extra in problem.verify for design in ({**base, **extra}, {**best, **extra}))
    designs = [base, *pairs]
    answers = iter(evaluations.of_settings(designs, evaluations.measures))
    case = measured("the case", next(answers), goal, bounds)
    verified = tuple(
        (
            measured(_words(extra), next(answers), goal, bounds),
            measured(_words(extra), next(answers), goal, bounds),
        )
        for extra in problem.verify
    )
    return Optimum(
        name=problem.study.name,
        goal=goal,
        bounds=bounds,
        variables=problem.variables,
        starts=ordered,
        how=how,
        refused=evaluations.refused,
        case=case,
        measured=measured("best", evaluations.at([ordered[0].point])[0], goal, bounds),
        verified=verified,
        active=tuple(_active(evaluations, ordered[0])),
        designs=len(evaluations.designs),
        cheap=len(surrogate.designs) if surrogate else 0,
        rows=evaluations.computed + (surrogate.computed if surrogate else 0),
        table=evaluations.table(),
        settings=best,
        peaks=_peaks(evaluations, best) if ordered[0].numbers else None,
        violated=tuple(_violated(evaluations, ordered[0])),
        findings=evaluations.findings(ordered[0].point),
        seconds=(seconds[0], seconds[1] + perf_counter() - began),
    )


def rank(found: SearchResult) -> tuple[bool, float, float]:
    """Starts with all constraints met first, the largest merit first; of the others the least missed."""
    infeasible = found.end in (End.INFEASIBLE, End.NO_ANSWER)
    return infeasible, found.missed if infeasible else 0.0, -found.merit


def _settings(evaluations: Evaluations, point: Point) -> Settings:
    problem = evaluations.problem
    return {**problem.fixed, **settings(problem.variables, point, problem.lists)}


def _words(extra: Settings) -> str:
    return ", ".join(f"{key} = {value}" for key, value in extra.items())


def measured(
    what: str, numbers: Numbers | NotComputed | None, goal: Goal, bounds: Sequence[Bound]
) -> Measured:
    """Objective and constraints from the outputs of a design."""
    if not isinstance(numbers, Numbers):
        return Measured(what, None, (), message=str(numbers or "no answer"))
    worst, missed = [], 0.0
    for bound in bounds:
        values, margins = bound.measure.terms(numbers).values, bound.margins(numbers).values
        worst.append(float(values[np.argmin(margins)]))
        missed = max(missed, -float(margins.min()))
    return Measured(what, goal.value(goal.measure.terms(numbers)), tuple(worst), missed)


def _peaks(evaluations: Evaluations, best: Settings) -> Peaks | None:
    """Peak pressures of a design that was searched with slices, checked by half-spaces."""
    measures = evaluations.workers.peaks
    if not measures:
        return None
    sliced, whole = evaluations.of_settings([best, {**best, **HALF_SPACES}], measures)
    both = [
        np.array([numbers.values[measure.text] for measure in measures]).ravel()
        if isinstance(numbers, Numbers)
        else np.array([np.nan])
        for numbers in (sliced, whole)
    ]
    if not all(np.isfinite(each).all() for each in both):
        return Peaks(float(both[0].max()), np.nan, str(whole))
    place = (both[0] / both[1]).argmin()
    return Peaks(float(both[0][place]), float(both[1][place]))


def _violated(evaluations: Evaluations, best: SearchResult) -> Iterator[str]:
    """Constraints that a design misses in some row, with the value there."""
    if best.numbers is None:
        return
    for bound in evaluations.bounds:
        values = bound.measure.terms(best.numbers).values
        for row in np.flatnonzero(bound.margins(best.numbers).values < -FEASIBLE):
            where = evaluations.row_words(int(row), bound.measure)
            yield f"{bound.words}{where}: {values[row]:.6g}"


def _active(evaluations: Evaluations, best: SearchResult) -> Iterator[Active]:
    """Constraints and bounds of keys that are met with a multiplier above zero."""
    if best.optimality is None or best.numbers is None:
        return
    found, sign, place = best.optimality, evaluations.goal.sign, 0
    for bound in evaluations.bounds:
        for row in range(len(bound.margins(best.numbers).values)):
            if found.bounds[place] > 0:
                where = evaluations.row_words(row, bound.measure)
                yield Active(
                    f"{bound.words}{where}", bound.measure.unit, sign * found.bounds[place] / bound.size
                )
            place += 1
    for each, value, multiplier in zip(evaluations.problem.variables, best.point, found.ends, strict=True):
        if multiplier:
            unit = f" {each.unit}" if each.unit else ""
            side = ">=" if multiplier < 0 else "<="
            gain = sign * abs(multiplier) / each.by_share(value)
            yield Active(f"{each.name} {side} {value:g}{unit}", each.unit or "1", gain)
