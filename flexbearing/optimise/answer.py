"""The answer: the best design, how sure it is, what limits it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from time import perf_counter

import numpy as np

from flexbearing.optimise.evaluations import Evaluations, NotComputed, Point
from flexbearing.optimise.file import Settings
from flexbearing.optimise.goals import Bound, Goal, Numbers
from flexbearing.optimise.search import End, Found
from flexbearing.optimise.variables import Variable, settings
from flexbearing.studies.table import Table

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
class Optimum:
    """What an optimisation found."""

    name: str
    goal: Goal
    bounds: tuple[Bound, ...]
    variables: tuple[Variable, ...]
    starts: tuple[Found, ...]  # the best first
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
    seconds: tuple[float, float]  # of the search, and of the case and what is verified

    @property
    def best(self) -> Found:
        """The best start."""
        return self.starts[0]

    @property
    def converged(self) -> bool:
        """Whether the best point is an optimum that meets all constraints, also where it is verified."""
        return self.best.end is End.CONVERGED

    @property
    def agreeing(self) -> tuple[Found, ...]:
        """Starts that ended as well as the best one."""
        return tuple(
            each for each in self.starts if self.best.merit - each.merit <= ALIKE and each.missed <= ALIKE
        )


def answer(
    evaluations: Evaluations,
    surrogate: Evaluations | None,
    starts: Sequence[Found],
    how: dict[str, str],
    seconds: tuple[float, float],
) -> Optimum:
    """Order what the starts found, and compute what is reported of the best."""
    began, problem, goal, bounds = perf_counter(), evaluations.problem, evaluations.goal, evaluations.bounds
    ordered = tuple(sorted(starts, key=rank))
    best = _settings(evaluations, ordered[0].point)
    designs = [{}, *(design for extra in problem.verify for design in ({**extra}, {**best, **extra}))]
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
        seconds=(seconds[0], seconds[1] + perf_counter() - began),
    )


def rank(found: Found) -> tuple[bool, float, float]:
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


def _active(evaluations: Evaluations, best: Found) -> Iterator[Active]:
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
