"""Roller cases solved side by side: which may be, between which rings."""

from collections.abc import Iterator, Sequence, Set
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from flexbearing.build import ring_parts, roller_bearing
from flexbearing.build.expansion import roller_length
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

AT_ONCE = 32  # cases whose matrices fit into the processor's cache
RIGID = "rigid"  # block of states between rigid raceways, which is also the answer of a case without others


def solved_together(cases: Sequence[Case], blocks: Set[str]) -> Iterator[Together]:
    """Yield cases that converge side by side.

    Left out are cases with `accuracy.target`, with several positions of the rollers or with stresses, those
    coupled by another method than newton, or with rings that are not linear or that no other case has; cases
    that cannot be; and what does not converge.

    Parameters
    ----------
    cases : sequence of Case
        as they were read
    blocks : set of str
        of the wanted outputs: states on the way to the answer are yielded for "rigid" only

    Yields
    ------
    Together
    """
    models = {place: model for place, case in enumerate(cases) if (model := _model(case))}
    kinds: dict[str | None, list[int]] = {}
    for place, model in models.items():
        kinds.setdefault(_rings(cases[place], model), []).append(place)
    for rings, places in kinds.items():
        alike = _Alike(
            [cases[place] for place in places], [models[place] for place in places], np.array(places)
        )
        if rings is None:
            yield from alike.between_rigid_rings()
        elif len(places) > 1:
            yield from alike.between_elastic_rings(with_rigid=RIGID in blocks)


def _model(case: Case) -> RollerBearing | None:
    """Bearing of a case that may be solved beside others; None where it needs a run of its own."""
    if case.accuracy.target is not None or case.operation.roller_positions is not None:
        return None
    if _elastic(case) and (case.coupling.method != "newton" or case.outputs.stresses or not is_linear(case)):
        return None
    try:
        validate_roller.build(case)
        return roller_bearing.bearing(case)
    except (ImpossiblePart, OutOfRange):  # which its own run tells
        return None


def _elastic(case: Case) -> bool:
    return case.inner.kind != "rigid" or case.outer.kind != "rigid"


def _rings(case: Case, model: RollerBearing) -> str | None:
    """What names the elastic rings of a case, the accuracy they are condensed with and their rollers."""
    if not _elastic(case):
        return None
    parts = [ring_parts.part_of(case, race) for race in RACES]
    return digest([parts, case.accuracy.model_dump(), roller_length(case), model.bearing.azimuths])


@dataclass(frozen=True)
class _Alike:
    """Cases between the same rings."""

    cases: list[Case]
    models: list[RollerBearing]
    places: NDArray  # among all cases

    def between_rigid_rings(self) -> Iterator[Together]:
        """Cases without an elastic ring."""
        return self._converged(solve_many(self.models), self._no_rings, (*ANSWER, RIGID))

    def between_elastic_rings(self, *, with_rigid: bool) -> Iterator[Together]:
        """Cases between the same elastic rings; those between rigid raceways before, if they are wanted."""
        try:
            rings = linear_raceways(self.cases, self.models[0].bearing.azimuths, Logged())
        except (BadCase, PartnerFailed):  # which the run of each of them tells
            return
        starts = solve_many(self.models)
        if with_rigid:
            yield from self._converged(starts, self._no_rings, (RIGID,))
        initial = [pair.initial_deviation for pair in rings]
        known = [each for each in initial if each is not None]
        shapes = [np.zeros_like(known[0]) if each is None else each for each in initial] if known else None
        deviation = None if shapes is None else np.array(shapes)
        found = solve_many_elastic(self.models, rings[0].compliance, starts, deviation)
        yield from self._converged(found, rings, ANSWER)

    @property
    def _no_rings(self) -> list[LinearPair]:
        return [LinearPair(None, None)] * len(self.cases)

    def _converged(
        self, found: Equilibria, rings: list[LinearPair], blocks: tuple[str, ...]
    ) -> Iterator[Together]:
        """What converged, some at once."""
        for batch in found.batches:
            solved = np.flatnonzero([outcome is SolverOutcome.CONVERGED for outcome in batch.outcomes])
            for first in range(0, len(solved), AT_ONCE):
                some = solved[first : first + AT_ONCE]
                part = batch if len(some) == len(batch) else batch.take(some)
                cases, models, pairs = (
                    [values[place] for place in part.places] for values in (self.cases, self.models, rings)
                )
                yield Together(cases, models, replace(part, places=self.places[part.places]), pairs, blocks)
