"""What decides a condensed part: how it is made, discretised and resolved; nothing that solves is loaded."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

import fem
from fem.condense import BEAM, HARMONICS, SMEARED, SOLID
from fem.parts.step_solid import StepSolid
from flexbearing.build.expansion import roller_length
from flexbearing.build.mesh_sizes import IN_SPACE, ON_A_SECTION, mesh_size, nodes_of
from flexbearing.build.roller_bearing import row_distance
from flexbearing.case.roller import Case
from flexbearing.program.threads import of_solids

if TYPE_CHECKING:
    from flexbearing.build.ring_parts import Part

WITH_A_SLEEVE = (3, 1.2, 0.4)  # smeared bars are worth no more
PATCH = 0.1  # width of a load patch over the roller length


def resolved(
    part: "Part", case: Case, azimuths: NDArray | None = None
) -> "tuple[Part, fem.Discretisation, fem.Resolution]":
    """What decides a condensed part; the azimuths (Z) [rad] of the rollers matter for whole solids alone."""
    discretisation = discretisation_of(part, case)
    places = np.zeros(1) if azimuths is None else azimuths
    return part, discretisation, _resolution(part, discretisation, case, places)


def discretisation_of(part: "Part", case: Case) -> fem.Discretisation:
    """Choice of the case, or what suits the part."""
    if case.accuracy.structure == "solid" or isinstance(part, StepSolid):
        return SOLID
    if case.accuracy.structure == "beam":
        return BEAM
    if case.accuracy.structure == "smeared" and isinstance(part, fem.SquirrelCage):
        return SMEARED
    return HARMONICS


def _resolution(
    part: "Part", discretisation: fem.Discretisation, case: Case, azimuths: NDArray
) -> fem.Resolution:
    in_space = discretisation is SOLID or isinstance(part, fem.SquirrelCage)
    usual = WITH_A_SLEEVE if discretisation is SMEARED else IN_SPACE if in_space else ON_A_SECTION
    loads = patches(case, azimuths)
    rollers = {"azimuths": loads.azimuths, "patch_width": loads.width} if discretisation is SOLID else {}
    return fem.Resolution(
        length=loads.length,
        axial_modes=loads.axial_modes,
        mesh_size=mesh_size(case, usual),
        harmonics=None if discretisation is SOLID else case.accuracy.harmonics,
        threads=of_solids(case.accuracy.threads),
        nodes_of=nodes_of(case, "inner" if isinstance(part, fem.RingOnShaft) else "outer"),
        row_distance=row_distance(case),
        **rollers,
    )


def patches(case: Case, azimuths: NDArray) -> fem.Patches:
    """What rollers load of a whole solid."""
    length = roller_length(case)
    return fem.Patches(
        azimuths=tuple(azimuths),
        length=length,
        axial_modes=case.accuracy.axial_shapes,
        width=case.accuracy.patch_width or PATCH * length,
    )
