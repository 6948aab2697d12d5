"""Designs that are computed, each once: rows of a study, which a second start finds in its journal."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import chain
from math import isnan

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.findings import RowFinding
from flexbearing.optimise.file import Problem, Settings
from flexbearing.optimise.goals import Bound, Goal, Measure, Numbers
from flexbearing.optimise.variables import keys_of, settings
from flexbearing.optimise.worker import beside, for_slopes, slope_name
from flexbearing.studies.engine import Engine
from flexbearing.studies.file import Axis
from flexbearing.studies.file.read import CollectedOutput
from flexbearing.studies.plan import Row
from flexbearing.studies.prepare import prepare
from flexbearing.studies.prepared_study import PreparedStudy
from flexbearing.studies.run import Work, compute_missing
from flexbearing.studies.table import Table, journal
from flexbearing.studies.table.duty import Cycles

DESIGN = "design"  # axis of the table
NEAR = 0.02  # step of the shares after which a design is likely to be the last
Point = tuple[float, ...]  # values of the variables in their units


class NotComputed(ValueError):
    """A design without a result in some row; the message says why."""


@dataclass(frozen=True)
class Workers:
    """What computes rows and slopes."""

    values: Work
    slopes: Callable[[Sequence[str]], Work]  # given all keys; a row holds those that its identity names
    processes: int = 1  # that share the keys of a design
    peaks: tuple[
        Measure, ...
    ] = ()  # peak pressures that half-spaces check; none where slices do not have them


def designs_of(problem: Problem, designs: Sequence[Settings]) -> PreparedStudy:
    """The study of the case with some settings; a key that a design does not set stays as the case has it."""
    first = (*problem.fixed, *keys_of(problem.variables))
    keys = tuple(dict.fromkeys((*first, *(key for each in designs for key in each))))
    rows = tuple(tuple(each.get(key) for key in keys) for each in designs)
    measures = problem.goal(None).measure, *(bound.measure for bound in problem.bounds(None))
    collect = tuple(
        CollectedOutput(name, text) for name, text in {each.name: each.text for each in measures}.items()
    )
    axes = Axis(DESIGN, keys, rows), *problem.study.axes
    prepared = prepare(replace(problem.study, axes=axes, collect=collect))
    return replace(
        prepared, plan=replace(prepared.plan, fewest=1, side_by_side=False)
    )  # rows that are known stay


def varied_rings(problem: Problem) -> bool:
    """Whether another elastic ring is meshed where a variable changes."""
    ends = [[each.value(share) for each in problem.variables] for share in (0.4, 0.6)]
    designs = [{**problem.fixed, **settings(problem.variables, values, problem.lists)} for values in ends]
    variants = designs_of(problem, designs).plan.variants
    return variants[0].rings != variants[-1].rings


@dataclass
class Evaluations:
    """Designs of a problem and what became of them."""

    problem: Problem
    workers: Workers
    engine: Callable[[int], Engine]
    kept: journal.Journal
    rows: dict[str, Row]  # by identity
    designs: dict[Point, Numbers | NotComputed] = field(default_factory=dict)  # in their order
    refused: dict[str, str] = field(default_factory=dict)  # keys without derivatives, and why
    sharing: dict[Point, int] = field(default_factory=dict)  # workers that found the slopes of a design
    computed: int = 0  # rows that were not in the journal

    @cached_property
    def cycles(self) -> Cycles | None:
        """The duty cycle, with the speeds of its rows."""
        spectrum = self.problem.study.spectrum
        if spectrum is None:
            return None
        length = len(self.problem.study.axes[-1].rows)
        return Cycles(spectrum, designs_of(self.problem, [{}]).speeds.reshape(-1, length), ())

    @cached_property
    def goal(self) -> Goal:
        """What is made best; a linear one is scaled by its value in the case as it stands.

        Raises `BadCase` for a linear one of a case without a result.
        """
        goal = self.problem.goal(self.cycles)
        if goal.logarithmic:
            return goal
        (numbers,) = self.of_settings([self.reference], (goal.measure,))
        if isinstance(numbers, NotComputed):
            raise BadCase(
                f"{self.problem.study.path.name}: a linear scale needs the case to be solved: {numbers}"
            )
        return replace(goal, size=abs(goal.value(goal.measure.terms(numbers))) or 1.0)

    @cached_property
    def bounds(self) -> tuple[Bound, ...]:
        """What stays within bounds."""
        return self.problem.bounds(self.cycles)

    @property
    def measures(self) -> tuple[Measure, ...]:
        """Everything that is measured of a design."""
        return self.problem.goal(self.cycles).measure, *(bound.measure for bound in self.bounds)

    @property
    def reference(self) -> Settings:
        """Of the case that the best design is compared with: its own ones but for the operation of all."""
        return {key: value for key, value in self.problem.fixed.items() if key.startswith("operation.")}

    @property
    def texts(self) -> tuple[str, ...]:
        """Outputs that rows hold."""
        return tuple(dict.fromkeys(measure.text for measure in self.measures))

    def at(self, points: Sequence[Point]) -> list[Numbers | NotComputed]:
        """Outputs of designs at points, side by side."""
        new = [point for point in dict.fromkeys(points) if point not in self.designs]
        if new:
            answers = self.of_settings([self._settings(point) for point in new], self.measures)
            self.designs |= zip(new, answers, strict=True)
        return [self.designs[point] for point in points]

    def of_settings(
        self, designs: Sequence[Settings], measures: Sequence[Measure]
    ) -> list[Numbers | NotComputed]:
        """Outputs of the case with some settings, side by side."""
        prepared, texts = designs_of(self.problem, designs), tuple(measure.text for measure in measures)
        self._compute(prepared, texts, self.workers.values)
        return self._numbers(prepared, texts)

    def verified(self, point: Point) -> Numbers | NotComputed:
        """Outputs of a design with the first settings that verify it, its own computed beside it."""
        settings = self._settings(point)
        own = [] if point in self.designs else [settings]
        finer = {**settings, **self.problem.verify[0]}
        *beside, numbers = self.of_settings([*own, finer], self.measures)
        self.designs |= zip([point], beside, strict=False)
        return numbers

    def slopes(self, point: Point, keys: Sequence[str]) -> dict[str, dict[str, NDArray]]:
        """Derivatives of outputs of a design by keys: by key those (R) of each text, by the key in SI.

        Keys that have none in some row are left out.
        """
        texts, verified = self.texts, self._verified_beside(point)
        sharing = self.sharing.setdefault(point, max(1, self.workers.processes - verified))
        groups = [group for first in range(sharing) if (group := keys[first::sharing])]
        design, work = self._settings(point), self.workers.slopes(keys)
        prepared = for_slopes(designs_of(self.problem, [design]), groups)
        if verified:
            both = designs_of(self.problem, [design, {**design, **self.problem.verify[0]}])
            batch, either = beside(both, groups, work, self.workers.values)
            self._compute(batch, (), either)
        else:
            self._compute(prepared, (), work)
        per_group = len(prepared.plan.variants) // len(groups)
        found = {}
        for place, key in ((place, key) for place, group in enumerate(groups) for key in group):
            variants = prepared.plan.variants[place * per_group : (place + 1) * per_group]
            rows, those = (
                [self.rows[each.identity] for each in variants],
                [slope_name(text, key) for text in texts],
            )
            columns = np.array([[row.values.get(name, np.nan) for name in those] for row in rows])
            if np.isfinite(columns).all():
                found[key] = dict(zip(texts, columns.T, strict=True))
            else:
                self.refused.setdefault(key, next(filter(None, (_why(row, key) for row in rows)), "it jumps"))
        return found

    def _verified_beside(self, point: Point) -> bool:
        """Whether a worker verifies a design while others find its slopes: the first, and a last one."""
        problem, former = self.problem, [each for each in self.sharing if each != point]
        if point in self.sharing or self.workers.processes == 1 or not problem.search.verified:
            return False

        def shares(of: Point) -> NDArray:
            return np.array([each.share(value) for each, value in zip(problem.variables, of, strict=True)])

        return not former or min(np.abs(shares(each) - shares(point)).max() for each in former) <= NEAR

    def rings(self, points: Sequence[Point]) -> list[tuple[str, ...]]:
        """Which elastic rings designs have."""
        prepared = designs_of(self.problem, [self._settings(point) for point in points])
        per_design = len(prepared.plan.variants) // len(points)
        return [variant.rings for variant in prepared.plan.variants[::per_design]]

    def findings(self, point: Point) -> tuple[RowFinding, ...]:
        """What the rows of a design report; empty of one that is not computed."""
        variants = designs_of(self.problem, [self._settings(point)]).plan.variants
        known = (row for each in variants if (row := self.rows.get(each.identity)))
        return tuple(chain.from_iterable(row.findings for row in known))

    def row_words(self, row: int, measure: Measure) -> str:
        """Conditions of a row of a design, " (operation.misalignment = 4 arcmin)"; empty where it has one."""
        axes = self.problem.study.axes
        if measure.cycles is not None:
            axes = axes[:-1]
        places = np.unravel_index(row, [len(axis.rows) for axis in axes]) if axes else ()
        words = [
            f"{key} = {value}"
            for axis, place in zip(axes, places, strict=True)
            for key, value in zip(axis.keys, axis.rows[int(place)], strict=True)
        ]
        return f" ({', '.join(words)})" if words else ""

    def table(self) -> Table:
        """All designs that can be, as the table of a study."""
        prepared = designs_of(self.problem, [self._settings(point) for point in self.designs])
        per_design = len(prepared.plan.variants) // len(self.designs)
        impossible = {problem.number // per_design for problem in prepared.plan.problems}
        some = [point for number, point in enumerate(self.designs) if number not in impossible]
        return designs_of(self.problem, [self._settings(point) for point in some]).table(self.rows)

    def _settings(self, point: Point) -> Settings:
        problem = self.problem
        return {**problem.fixed, **settings(problem.variables, point, problem.lists)}

    def _compute(self, prepared: PreparedStudy, texts: Sequence[str], work: Work) -> None:
        """Compute what is neither known nor in the journal."""
        known = {
            identity: row
            for variant in prepared.plan.variants
            if (row := self.rows.get(identity := variant.identity)) and _complete(row, texts)
        } | {"": Row("", "bad input", "", 0.0)}  # designs that cannot be have no identity
        before = len(known)
        compute_missing(prepared, known, work, self.engine, self.kept, lambda progress: None)
        self.computed += len(known) - before
        self.rows |= known

    def _numbers(self, prepared: PreparedStudy, texts: Sequence[str]) -> list[Numbers | NotComputed]:
        plan = prepared.plan
        per_design = len(plan.variants) // len(plan.axes[0].rows)
        why = {problem.number: problem.message for problem in plan.problems}
        found: list[Numbers | NotComputed] = []
        for first in range(0, len(plan.variants), per_design):
            numbers = range(first, first + per_design)
            rows = [self.rows[plan.variants[number].identity] for number in numbers]
            wrong = [
                f"{plan.settings(number)}: {why.get(number) or row.why or row.status}"
                for number, row in zip(numbers, rows, strict=True)
                if not _complete(row, texts) or not row.converged
            ]
            values = {text: np.array([row.values.get(text, np.nan) for row in rows]) for text in texts}
            found.append(NotComputed(wrong[0]) if wrong else Numbers(values))
        return found


def _why(row: Row, key: str) -> str:
    """Why a row has no derivatives by a key; empty where it does not say."""
    return row.message or next((f"{key}: {each.text}" for each in row.findings if key in each.places), "")


def _complete(row: Row, texts: Sequence[str]) -> bool:
    """Whether a row has all that is wanted, or ended without."""
    return not row.converged or all(not isnan(row.values.get(text, np.nan)) for text in texts)
