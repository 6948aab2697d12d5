"""How raceways deflect in more axial shapes than a case exchanges: what the error of its life is judged by.

Shapes beyond the second bend the ring under one roller alone: supports of the ring far away, and bars
that pass under it, hardly change them. A coarse axial section answers for them.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import fem
from flexbearing.build.ring_parts import NAMES, Race, part_of
from flexbearing.case.roller import Case
from flexbearing.coupling import LinearPair
from flexbearing.coupling.partners import LinearRaceway
from flexbearing.progress import Report

if TYPE_CHECKING:
    from quasidynamic.outcome.bearing_states import BearingStates

MORE = 2  # axial shapes: of a pair one may do nothing, for symmetry
ORDER = 3  # of the elements: 13 % too compliant in the further shapes of a ring of 1.5 mm
SOFT = 1e9  # [N/m3] springs that hold a ring in place of lines or tooth forces
WORTH = 0.05  # of a roller's approach; calibrated: below it further shapes change a life by less than 0.2 %


def more_shapes_matter(states: "BearingStates", rings: LinearPair) -> NDArray:
    """Whether further shapes of a raceway could change the life: no softer than the last one known."""
    matter = np.zeros((len(states.scaled), 2), bool)
    for place, raceway in enumerate(rings.raceways):
        if raceway is not None:
            matter[:, place] = _worth(raceway.absolute, states, place)
    return matter


def with_more_shapes(
    case: Case, rings: LinearPair, races: Sequence[bool], report: Report
) -> tuple[NDArray | None, NDArray | None]:
    """Compliances of some raceways in more axial shapes."""
    found = [
        _compliance(case, race, raceway, report) if raceway and matter else None
        for race, raceway, matter in zip(NAMES, rings.raceways, races, strict=True)
    ]
    return found[0], found[1]


def _worth(absolute: NDArray, states: "BearingStates", race: int) -> NDArray:
    known, raceways = absolute.shape[1], states.balance.roller.raceways
    line_loads, width = states.slice_loads[:, race], np.reshape(raceways.slices.width, (-1, 1, 1))
    shapes = np.polynomial.legendre.legvander(raceways.slices.all_places, known + MORE - 1)[:, 1:]
    largest = np.abs(width * line_loads @ shapes).max(axis=(1, 2))
    softest = np.abs(np.einsum("zmzm->zm", absolute)[:, -1]).max()
    approach = raceways.softness[race, :, 0] * states.loads[:, race].max(axis=-1) ** 0.9
    return softest * largest > WORTH * approach


def _compliance(case: Case, race: Race, raceway: LinearRaceway, report: Report) -> NDArray | None:
    # not needed between rigid raceways
    from fem.parts.step_solid import StepSolid
    from flexbearing.rings.condensed import condensed, named_failures

    part, shapes, azimuths = part_of(case, race), raceway.absolute.shape[1] + MORE, raceway.azimuths
    if part is None or isinstance(part, StepSolid):
        return None
    if isinstance(part, fem.OuterRing):
        part = replace(part, support=_linear(part.support))
    structure = "smeared" if isinstance(part, fem.SquirrelCage) else "harmonics"
    coarse = {"structure": structure, "element_order": ORDER, "mesh_size": None, "raceway_mesh_size": None}
    coarse |= {"axial_shapes": shapes, "harmonics": None}
    coarser = case.model_copy(update={"accuracy": case.accuracy.model_copy(update=coarse)})
    name = f"{NAMES[race]} in more shapes"
    with named_failures(case, name):
        linear: Any = condensed(name, part, coarser, azimuths, report)  # nothing lifts off
        return linear.at(azimuths).absolute


def _linear(support: Any) -> Any:
    """A support that holds a ring under any load; far away from a roller it does not matter which."""
    if isinstance(support, fem.LineSupports | fem.PlanetGear):
        return fem.Foundation(radial=SOFT, axial=SOFT, tangential=SOFT)
    return replace(support, pushing=False) if isinstance(support, fem.Foundation) else support
