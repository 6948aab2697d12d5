"""Raceways of whole solids that are solved anew for every load."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cached_property
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from fem.condense import require_drawing
from fem.errors import NotSolved
from flexbearing.build.expansion import roller_length
from flexbearing.build.mesh_sizes import IN_SPACE, mesh_size
from flexbearing.build.ring_parts import NAMES, Race, part_of
from flexbearing.case.roller import Case
from flexbearing.coupling import PartnerFailed, Raceway, RacewayPair
from flexbearing.program.threads import of_solids
from flexbearing.progress import Report
from flexbearing.rings.condensed import named_failures
from flexbearing.rings.raceways import RigidRaceway, compliance_figures
from flexbearing.rings.resolution import patches

if TYPE_CHECKING:
    from fem.raceway.compliance import RacewayCompliance
    from fem.solid.full_solve import FullSolve


@dataclass(frozen=True)
class FullSolveRaceway:
    """A raceway whose every answer is one solve of its factored solid."""

    name: str  # for messages
    full_fe: "FullSolve"
    rigid = False
    solved_in_full = True

    @property
    def azimuths(self) -> NDArray:
        """Of the rollers (Z) [rad]."""
        return np.array(self.full_fe.solid.patches.azimuths)

    def answer(self, outward: NDArray) -> tuple[NDArray, NDArray]:
        """Outward deviations (Z, M) and mean translation (2) [m] under outward forces (Z, M) [N].

        Raises `PartnerFailed` when the residual of the solve stays too large.
        """
        with self._named_failure(self.name):
            return self.full_fe.answer(outward)

    def linearised(self, outward: NDArray) -> "RacewayCompliance":
        """The same for all forces, condensed by many solves: raises `PartnerFailed` as `answer` does."""
        return self._condensed

    def under(self, azimuths: NDArray) -> "FullSolveRaceway":
        """The same factored solid under rollers at other azimuths (Z) [rad]."""
        solid = self.full_fe.solid
        moved = replace(solid, patches=replace(solid.patches, azimuths=tuple(azimuths)))
        return replace(self, full_fe=replace(self.full_fe, solid=moved))

    def figures(self) -> dict[str, object]:
        """What the finite elements cost and how stiff the support is; condenses the solid."""
        return compliance_figures(self._condensed)

    @cached_property
    def _condensed(self) -> "RacewayCompliance":
        with self._named_failure(f"{self.name} at the end state"):
            return self.full_fe.condensed()

    @contextmanager
    def _named_failure(self, name: str) -> Iterator[None]:
        try:
            yield
        except NotSolved as problem:
            raise PartnerFailed(f"{name}: {problem}", "not solved") from problem


def full_fe_raceways(case: Case, azimuths: NDArray, report: Report) -> RacewayPair:
    """Mesh and factor the parts that are not rigid."""
    return RacewayPair(_raceway(case, "inner", azimuths, report), _raceway(case, "outer", azimuths, report))


def _raceway(case: Case, race: Race, azimuths: NDArray, report: Report) -> Raceway:
    name, part = NAMES[race], part_of(case, race)
    if part is None:
        return RigidRaceway(azimuths)
    from fem.solid.factored_solid import factored
    from fem.solid.full_solve import FullSolve

    began = perf_counter()
    report.stage(name, None)
    with named_failures(case, name):
        require_drawing(part, roller_length(case))
        threads = of_solids(case.accuracy.threads)
        solid = factored(part, patches(case, azimuths), mesh_size(case, IN_SPACE), threads)
    report.stage(f"{name}: {solid.stiffness.unknowns} unknowns, {perf_counter() - began:.1f} s", None)
    return FullSolveRaceway(name, FullSolve(solid=solid))
