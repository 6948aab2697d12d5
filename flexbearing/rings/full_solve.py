"""The rings as whole solids that are solved anew for every load."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexbearing.build import ring_parts
from flexbearing.case.roller import Case
from flexbearing.coupling import PartnerFailed
from flexbearing.progress import Report
from flexbearing.rings.condensed import IN_SPACE, patches, told, wishes
from flexbearing.rings.raceways import CondensedRings

if TYPE_CHECKING:
    from fem.solid.full_solve import FullSolve

NAMES = ("inner ring and shaft", "outer ring")
SIGNS = (-1.0, 1.0)  # rollers push the inner raceway inwards


@dataclass(frozen=True)
class WholeRings:
    """Factored solids; None where a ring is rigid. Index 0 inner, 1 outer."""

    raceways: tuple["FullSolve | None", "FullSolve | None"]

    @property
    def rigid(self) -> bool:
        """Whether nothing yields."""
        return all(raceway is None for raceway in self.raceways)

    def deviation(self, forces: NDArray) -> NDArray:
        """Outward deviations (2, Z, M) [m], by one solve of every solid; raises `PartnerFailed`."""
        shapes = np.zeros_like(forces)
        for race, raceway in enumerate(self.raceways):
            if raceway is not None:
                with _answering(NAMES[race]):
                    shapes[race], _ = raceway.answer(SIGNS[race] * forces[race])
        return shapes

    @cached_property
    def condensed(self) -> CondensedRings:
        """The same solids condensed: what derivatives, such as the stiffness of the bearing, ask for."""
        with _answering("rings at the end state"):
            inner, outer = (None if raceway is None else raceway.condensed() for raceway in self.raceways)
        return CondensedRings((inner, outer))

    def figures(self) -> dict[str, dict]:
        """What the finite elements cost and how stiff the supports are, for the result file."""
        return self.condensed.figures()


@contextmanager
def _answering(name: str) -> Iterator[None]:
    """Give a failure of a solve the name that the coupling knows."""
    from fem.assembly.factorisation import NotSolved

    try:
        yield
    except NotSolved as problem:
        raise PartnerFailed(f"{name}: {problem}", "not solved") from problem


def whole(case: Case, azimuths: NDArray, report: Report) -> WholeRings:
    """Mesh and factor the parts that are not rigid.

    Raises
    ------
    PartnerFailed
        when a part has no trustworthy answer
    """
    parts = ring_parts.inner_part(case), ring_parts.outer_part(case)
    inner, outer = (_factored(race, part, case, azimuths, report) for race, part in enumerate(parts))
    return WholeRings((inner, outer))


def _factored(
    race: int, part: ring_parts.Part | None, case: Case, azimuths: NDArray, report: Report
) -> "FullSolve | None":
    if part is None:
        return None
    from fem.solid.factored_solid import factored
    from fem.solid.full_solve import FullSolve

    began = perf_counter()
    report.stage(NAMES[race], None)
    with told(case, NAMES[race]):
        solid = factored(part, patches(case, azimuths), wishes(case, IN_SPACE), case.accuracy.threads)
    seconds = perf_counter() - began
    report.stage(f"{NAMES[race]}: {solid.stiffness.unknowns} unknowns, {seconds:.1f} s", None)
    return FullSolve(solid=solid)
