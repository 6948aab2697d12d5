"""Roller cases solved side by side: which may be, between which rings, and why others are not."""

from collections.abc import Iterator, Sequence, Set
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexbearing.accuracy.case_levels import case_at
from flexbearing.accuracy.ladder import Place
from flexbearing.accuracy.levels import ladders
from flexbearing.accuracy.trials import model_at, with_most_modes
from flexbearing.build import ring_parts, roller_bearing
from flexbearing.build.expansion import roller_length
from flexbearing.build.ring_parts import Race
from flexbearing.cache.key import digest
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.coupling import LinearPair, PartnerFailed
from flexbearing.progress import Logged
from flexbearing.rings.condensed import RACES, is_linear, linear_raceways
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic import (
    ImpossiblePart,
    NotSolved,
    OutOfRange,
    RollerBearing,
    SolverOutcome,
    solve_many,
    solve_many_elastic,
)
from quasidynamic.outcome.equilibrium import Equilibria
from quasidynamic.solve.rollers.newton import MAX_EVALUATIONS

if TYPE_CHECKING:
    from flexbearing.accuracy.shared import Levels

AT_ONCE = 256  # cases whose outputs are arrays together: larger tasks are split, which solves nothing again
RIGID = "rigid"  # block of states between rigid raceways, which is also the answer of a case without others
ANSWER = ("", "flexible")  # the block that answers a case, which is also that of outputs that name none


@dataclass(frozen=True)
class Solved:
    """Cases that were solved side by side."""

    places: list[int]  # among all cases
    rows: SolvedRows
    blocks: tuple[str, ...]  # of their results that these states are

    @property
    def answer(self) -> bool:
        """Whether these states answer the cases, and are not on the way to it."""
        return "" in self.blocks


@dataclass(frozen=True)
class LeftOut:
    """A case that needs a run of its own."""

    place: int  # among all cases
    why: str = ""  # empty: there is no other case between its rings to be solved beside


def solved_side_by_side(
    cases: Sequence[Case], blocks: Set[str], levels: "Levels | None" = None
) -> Iterator[Solved | LeftOut]:
    """Yield cases that converge side by side, and those that do not with the reason."""
    kinds: dict[tuple[str | None, str], list[_CaseAtLevel]] = {}
    for place, case in enumerate(cases):
        found = _resolved(place, case, levels)
        if isinstance(found, LeftOut):
            yield found
        else:
            kinds.setdefault((_rings(found), case.bearing.contact), []).append(found)
    for (rings, _), alike in kinds.items():
        if rings is None:
            yield from _between_rigid_rings(alike)
        elif len(alike) > 1:
            yield from _between_elastic_rings(alike, with_rigid=RIGID in blocks)
        else:
            yield LeftOut(alike[0].place)


@dataclass(frozen=True)
class _CaseAtLevel:
    """A case as it stands, or at a level of each choice, with its bearing."""

    place: int  # among all cases
    case: Case
    levels: Place | None
    model: RollerBearing

    def part(self, race: Race) -> Case | None:
        """The case as a part is resolved, for at least as many axial modes as the bearing has."""
        if self.levels is None:
            return self.case
        resolved = case_at(self.case, ladders(self.case), self.levels, race)
        return None if resolved is None else with_most_modes(resolved)


def _resolved(place: int, case: Case, levels: "Levels | None") -> _CaseAtLevel | LeftOut:
    """A case that may be solved beside others."""
    why = needs_own_run(case)
    if levels is None and case.accuracy.target is not None:
        why = "accuracy.target chooses levels of its own"
    if why:
        return LeftOut(place, why)
    chosen = None if levels is None else levels.place
    try:
        model = roller_bearing.bearing(case)
        if chosen is not None:
            model = model_at(model, case, ladders(case), chosen)
    except (ImpossiblePart, OutOfRange) as problem:
        return LeftOut(place, str(problem))
    return _CaseAtLevel(place, case, chosen, model)


def needs_own_run(case: Case) -> str:
    """Say which choice of a case keeps it from being solved beside others; empty where none does."""
    if case.operation.roller_positions is not None:
        return "operation.roller_positions: each position begins at the one before"
    if not _elastic(case):
        return ""
    if case.coupling.method != "newton":
        return f'coupling.method = "{case.coupling.method}"'
    if case.coupling.max_iterations < MAX_EVALUATIONS:
        return f"coupling.max_iterations = {case.coupling.max_iterations}"
    if case.outputs.stresses:
        return "outputs.stresses"
    return "" if is_linear(case) else "rings or supports that do not deflect linearly"


def _elastic(case: Case) -> bool:
    return case.inner.kind != "rigid" or case.outer.kind != "rigid"


def _rings(resolved: _CaseAtLevel) -> str | None:
    """What names the elastic rings of a case, the accuracy they are condensed with and their rollers."""
    case = resolved.case
    if not _elastic(case) or not any(resolved.part(race) for race in RACES):
        return None
    parts = tuple(ring_parts.part_of(case, race) for race in RACES)
    azimuths = tuple(resolved.model.bearing.azimuths)
    rows = roller_length(case), roller_bearing.row_distance(case)
    return _name(parts, case.accuracy.model_dump_json(), rows, azimuths)


@lru_cache(maxsize=64)  # most cases of a study have the rings of the one before
def _name(*what: object) -> str:
    return digest(what)


def _between_rigid_rings(alike: Sequence[_CaseAtLevel]) -> Iterator[Solved | LeftOut]:
    """Cases without an elastic ring."""
    try:
        found = solve_many([each.model for each in alike])
    except (NotSolved, OutOfRange) as problem:
        yield from (LeftOut(each.place, str(problem)) for each in alike)
        return
    yield from _answers(alike, found, [LinearPair(None, None)] * len(alike), (*ANSWER, RIGID))


def _between_elastic_rings(alike: Sequence[_CaseAtLevel], *, with_rigid: bool) -> Iterator[Solved | LeftOut]:
    """Cases between the same elastic rings; those between rigid raceways before, if they are wanted."""
    models = [each.model for each in alike]
    try:
        rings = _raceways(alike)
        starts = solve_many(models) if with_rigid else None
        found = solve_many_elastic(models, rings[0].compliance, starts, _shapes(rings))
    except (BadCase, PartnerFailed, NotSolved, OutOfRange) as problem:
        yield from (LeftOut(each.place, str(problem)) for each in alike)
        return
    if starts is not None:
        yield from _converged(alike, starts, [LinearPair(None, None)] * len(alike), (RIGID,))
    yield from _answers(alike, found, rings, ANSWER)


def _raceways(alike: Sequence[_CaseAtLevel]) -> list[LinearPair]:
    """Raceways of each case, in the axial modes of its bearing."""
    first = alike[0].model
    parts: dict[Race, list[Case | None]] = {race: [each.part(race) for each in alike] for race in RACES}
    return linear_raceways(parts, first.bearing.azimuths, first.axial_modes, Logged())


def _shapes(rings: Sequence[LinearPair]) -> NDArray | None:
    """Deviations (C, 2, Z, M) of the raceways without load [m]; None where no pair has any."""
    each = [pair.initial_deviation for pair in rings]
    known = next((shape for shape in each if shape is not None), None)
    return None if known is None else np.array([np.zeros_like(known) if s is None else s for s in each])


def _answers(
    alike: Sequence[_CaseAtLevel], found: Equilibria, rings: Sequence[LinearPair], blocks: tuple[str, ...]
) -> Iterator[Solved | LeftOut]:
    """What converged, some at once, and what did not."""
    yield from _converged(alike, found, rings, blocks)
    for batch in found.batches:
        for place, outcome in zip(batch.places, batch.outcomes, strict=True):
            if outcome is not SolverOutcome.CONVERGED:
                yield LeftOut(alike[place].place, f"beside others: {outcome}")


def _converged(
    alike: Sequence[_CaseAtLevel], found: Equilibria, rings: Sequence[LinearPair], blocks: tuple[str, ...]
) -> Iterator[Solved]:
    for batch in found.batches:
        solved = np.flatnonzero([outcome is SolverOutcome.CONVERGED for outcome in batch.outcomes])
        for first in range(0, len(solved), AT_ONCE):
            some = solved[first : first + AT_ONCE]
            part = batch if len(some) == len(batch) else batch.take(some)
            these, pairs = ([values[place] for place in part.places] for values in (alike, rings))
            cases, models = [each.case for each in these], [each.model for each in these]
            rows = SolvedRows(cases, models, part.states, pairs, doubtful=part.doubtful)
            yield Solved([each.place for each in these], rows, blocks)
