"""The rings as one partner of the coupling: condensed, inner and outer side by side."""

from dataclasses import dataclass
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

import fem
from flexbearing.case import Case
from flexbearing.compute import assemble
from flexbearing.compute.progress import Report

if TYPE_CHECKING:
    from fem.compliance import RacewayCompliance


@dataclass(frozen=True)
class CondensedRings:
    """Condensed raceways; None where a ring is rigid. Index 0 inner, 1 outer."""

    raceways: tuple["RacewayCompliance | None", "RacewayCompliance | None"]

    @property
    def rigid(self) -> bool:
        """Whether nothing yields."""
        return all(raceway is None for raceway in self.raceways)

    @property
    def compliance(self) -> tuple[NDArray | None, NDArray | None]:
        """Outward deviation per outward force (Z, M, Z, M) [m/N]."""
        inner, outer = (None if raceway is None else raceway.matrix for raceway in self.raceways)
        return inner, outer

    def deviation(self, forces: NDArray) -> NDArray:
        """Outward deviations (2, Z, M) [m]; rollers push the inner raceway inwards."""
        shapes = np.zeros_like(forces)
        for race, (raceway, sign) in enumerate(zip(self.raceways, (-1.0, 1.0), strict=True)):
            if raceway is not None:
                shapes[race] = sign * np.tensordot(raceway.matrix, forces[race], axes=2)
        return shapes

    def translation(self, forces: NDArray) -> NDArray:
        """Rigid translations (2, 2) of inner and outer raceway along (y, z) [m]."""
        moved = np.zeros((2, 2))
        for race, (raceway, sign) in enumerate(zip(self.raceways, (-1.0, 1.0), strict=True)):
            if raceway is not None:
                moved[race] = sign * np.tensordot(raceway.translation, forces[race], axes=2)
        return moved

    def figures(self) -> dict[str, dict]:
        """What the finite elements cost and how stiff the supports are, for the result file."""
        return {
            name: {
                "unknowns": raceway.unknowns,
                "elements": raceway.elements,
                "support_stiffness_N_per_m": raceway.support_stiffness,
                "seconds": raceway.seconds,
            }
            for name, raceway in zip(("inner", "outer"), self.raceways, strict=True)
            if raceway is not None
        }


def condensed(case: Case, azimuths: NDArray, report: Report) -> CondensedRings:
    """Mesh, factor and condense the parts that are not rigid; nothing happens for those that are."""
    return CondensedRings(
        (
            _condensed("inner ring and shaft", assemble.inner_part(case), case, azimuths, report),
            _condensed("outer ring", assemble.outer_part(case), case, azimuths, report),
        )
    )


def _condensed(name: str, part: assemble.Part | None, case: Case, azimuths: NDArray, report: Report):
    if part is None:
        return None
    # Loads NGSolve, which takes a second: only cases with a flexible part wait for it.
    from fem.compliance import condense

    began = perf_counter()
    raceway = condense(
        part,
        fem.Patches(
            azimuths=tuple(azimuths),
            length=assemble.roller_length(case),
            shapes=case.accuracy.axial_shapes,
            width=case.accuracy.patch_width,
        ),
        fem.Mesh(
            order=case.accuracy.element_order,
            size=case.accuracy.mesh_size,
            raceway_size=case.accuracy.raceway_mesh_size,
        ),
        thread_number=case.accuracy.threads,
        report=lambda stage, fraction=None: report.stage(f"{name}: {stage}", fraction),
    )
    report.stage(f"{name}: {raceway.unknowns} unknowns, {perf_counter() - began:.1f} s", None)
    return raceway
