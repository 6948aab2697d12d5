"""Roller cases solved side by side: which may be, between which rings."""

from collections.abc import Iterator, Sequence, Set
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexbearing.accuracy.ladder import Place
from flexbearing.accuracy.levels import case_at, ladders
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
from flexbearing.runs import validate_roller
from flexbearing.runs.together import ANSWER, Together
from quasidynamic import (
    ImpossiblePart,
    OutOfRange,
    RollerBearing,
    SolverOutcome,
    solve_many,
    solve_many_elastic,
)
from quasidynamic.outcome.equilibria import Equilibria

if TYPE_CHECKING:
    from flexbearing.accuracy.shared import Levels

AT_ONCE = 256  # cases whose outputs are arrays together: larger tasks are split, which solves nothing again
RIGID = "rigid"  # block of states between rigid raceways, which is also the answer of a case without others


def solved_together(
    cases: Sequence[Case], blocks: Set[str], levels: "Levels | None" = None
) -> Iterator[Together]:
    """Yield cases that converge side by side.

    Left out are cases with `accuracy.target` whose levels are not given, with several positions of the
    rollers or with stresses of rings or contacts, those coupled by another method than newton, or with rings
    that are not linear or that no other case has; cases that cannot be; and what does not converge.

    Parameters
    ----------
    cases : sequence of Case
        as they were read
    blocks : set of str
        of the wanted outputs: states on the way to the answer are yielded for "rigid" only
    levels : Levels, optional
        of cases with a target, which share them

    Yields
    ------
    Together
    """
    resolved = {
        place: _Resolved(case, None if levels is None else levels.place)
        for place, case in enumerate(cases)
        if levels is not None or case.accuracy.target is None
    }
    models = {place: model for place, each in resolved.items() if (model := _model(each))}
    kinds: dict[tuple[str | None, str], list[int]] = {}
    for place, model in models.items():
        kind = _rings(resolved[place], model), cases[place].bearing.contact
        kinds.setdefault(kind, []).append(place)
    for (rings, _), places in kinds.items():
        alike = _Alike(
            [resolved[place] for place in places], [models[place] for place in places], np.array(places)
        )
        if rings is None:
            yield from alike.between_rigid_rings()
        elif len(places) > 1:
            yield from alike.between_elastic_rings(with_rigid=RIGID in blocks)


@dataclass(frozen=True)
class _Resolved:
    """A case as it stands, or at a level of each choice."""

    case: Case
    levels: Place | None

    def model(self) -> RollerBearing:
        """The bearing."""
        model = roller_bearing.bearing(self.case)
        if self.levels is None:
            return model
        return model_at(model, self.case, ladders(self.case), self.levels)

    def part(self, race: Race) -> Case | None:
        """The case as a part is resolved, for at least as many axial modes as the bearing has."""
        if self.levels is None:
            return self.case
        resolved = case_at(self.case, ladders(self.case), self.levels, race)
        return None if resolved is None else with_most_modes(resolved)


def _model(resolved: _Resolved) -> RollerBearing | None:
    """Bearing of a case that may be solved beside others; None where it needs a run of its own."""
    case = resolved.case
    if not side_by_side(case):
        return None
    try:
        model = resolved.model()
        validate_roller.require_around(case, model.bearing)
    except (ImpossiblePart, OutOfRange):  # which its own run tells
        return None
    return model


def side_by_side(case: Case) -> bool:
    """Whether a case may be solved beside others, as far as its choices tell.

    Parameters
    ----------
    case : Case
        as it was read

    Returns
    -------
    bool
    """
    if case.operation.roller_positions is not None or case.outputs.subsurface_stresses:
        return False
    if not _elastic(case):
        return True
    return case.coupling.method == "newton" and not case.outputs.stresses and is_linear(case)


def _elastic(case: Case) -> bool:
    return case.inner.kind != "rigid" or case.outer.kind != "rigid"


def _rings(resolved: _Resolved, model: RollerBearing) -> str | None:
    """What names the elastic rings of a case, the accuracy they are condensed with and their rollers."""
    case = resolved.case
    if not _elastic(case) or not any(resolved.part(race) for race in RACES):
        return None
    parts = tuple(ring_parts.part_of(case, race) for race in RACES)
    return _name(parts, case.accuracy.model_dump_json(), roller_length(case), tuple(model.bearing.azimuths))


@lru_cache(maxsize=64)  # most cases of a study have the rings of the one before
def _name(*what: object) -> str:
    return digest(what)


@dataclass(frozen=True)
class _Alike:
    """Cases between the same rings."""

    resolved: list[_Resolved]
    models: list[RollerBearing]
    places: NDArray  # among all cases

    def between_rigid_rings(self) -> Iterator[Together]:
        """Cases without an elastic ring."""
        return self._converged(solve_many(self.models), self._no_rings, (*ANSWER, RIGID))

    def between_elastic_rings(self, *, with_rigid: bool) -> Iterator[Together]:
        """Cases between the same elastic rings; those between rigid raceways before, if they are wanted."""
        try:
            rings = self._raceways()
        except (BadCase, PartnerFailed):  # which the run of each of them tells
            return
        starts = solve_many(self.models) if with_rigid else None
        if starts is not None:
            yield from self._converged(starts, self._no_rings, (RIGID,))
        initial = [pair.initial_deviation for pair in rings]
        known = [each for each in initial if each is not None]
        shapes = [np.zeros_like(known[0]) if each is None else each for each in initial] if known else None
        deviation = None if shapes is None else np.array(shapes)
        found = solve_many_elastic(self.models, rings[0].compliance, starts, deviation)
        yield from self._converged(found, rings, ANSWER)

    def _raceways(self) -> list[LinearPair]:
        """Raceways of each case, in the axial modes of its bearing."""
        first = self.models[0]
        parts: dict[Race, list[Case | None]] = {
            race: [each.part(race) for each in self.resolved] for race in RACES
        }
        return linear_raceways(parts, first.bearing.azimuths, first.axial_modes, Logged())

    @property
    def _no_rings(self) -> list[LinearPair]:
        return [LinearPair(None, None)] * len(self.resolved)

    def _converged(
        self, found: Equilibria, rings: list[LinearPair], blocks: tuple[str, ...]
    ) -> Iterator[Together]:
        """What converged, some at once."""
        of_all = [each.case for each in self.resolved]
        for batch in found.batches:
            solved = np.flatnonzero([outcome is SolverOutcome.CONVERGED for outcome in batch.outcomes])
            for first in range(0, len(solved), AT_ONCE):
                some = solved[first : first + AT_ONCE]
                part = batch if len(some) == len(batch) else batch.take(some)
                cases, models, pairs = (
                    [values[place] for place in part.places] for values in (of_all, self.models, rings)
                )
                yield Together(cases, models, replace(part, places=self.places[part.places]), pairs, blocks)
