"""How raceways deflect in more axial shapes than a case exchanges: what the error of its life is judged by.

Shapes beyond the second bend the ring under one roller alone: whatever holds the ring far away, and bars
that pass under it, hardly change them. A coarse axial section answers for them.
"""

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import fem
from fem.parts.step_solid import StepSolid
from flexbearing.build.ring_parts import NAMES, Race, part_of
from flexbearing.case.roller import Case
from flexbearing.coupling import LinearPair
from flexbearing.progress import Report
from flexbearing.rings.condensed import condensed, named_failures

if TYPE_CHECKING:
    from quasidynamic import Equilibrium

MORE = 2  # axial shapes: of a pair one may do nothing, for symmetry
ORDER = 3  # of the elements: 13 % too compliant in the further shapes of a ring of 1.5 mm
SOFT = 1e9  # [N/m3] springs that hold a ring in place of lines or tooth forces
WORTH = 0.05  # of a roller's approach; calibrated: below it further shapes change a life by less than 0.2 %


def with_more_shapes(
    case: Case, state: "Equilibrium", rings: LinearPair, report: Report
) -> tuple[NDArray | None, NDArray | None]:
    """Compliances in more axial shapes, where these matter.

    Parameters
    ----------
    case : Case
        with its parts
    state : Equilibrium
        between these rings
    rings : LinearPair
        at the forces of the state
    report : Report
        hears of parts that are condensed

    Returns
    -------
    tuple of arrays (Z, M', Z, M') or None
        outward deviation per outward force [m/N] of the inner and the outer raceway; None where the raceway
        is rigid, where further shapes cannot matter, and for a part from a drawing, which has no section

    Raises
    ------
    PartnerFailed
        when a part has no trustworthy answer
    """
    pairs = zip(NAMES, rings.raceways, strict=True)
    found = [
        _compliance(case, race, state, raceway.absolute.shape[1] + MORE, report)
        if raceway and _worth(raceway.absolute, state, place)
        else None
        for place, (race, raceway) in enumerate(pairs)
    ]
    return found[0], found[1]


def _worth(absolute: NDArray, state: "Equilibrium", race: int) -> bool:
    """Whether further shapes could change the life: they are no softer than the last one known."""
    known = absolute.shape[1]
    line_loads, roller = state.slice_loads[race], state.balance.roller
    positions = 2 * state.slice_positions / roller.raceways.slices.length
    width = roller.raceways.slices.width
    forces = width * line_loads @ np.polynomial.legendre.legvander(positions, known + MORE - 1)[:, 1:]
    softest = np.abs(np.einsum("zmzm->zm", absolute)[:, -1]).max()
    approach = roller.raceways.softness[race, 0, 0] * state.loads[race].max() ** 0.9
    return bool(softest * np.abs(forces).max() > WORTH * approach)


def _compliance(case: Case, race: Race, state: "Equilibrium", shapes: int, report: Report) -> NDArray | None:
    part = part_of(case, race)
    if part is None or isinstance(part, StepSolid):
        return None
    if isinstance(part, fem.OuterRing):
        part = replace(part, support=_linear(part.support))
    structure = "smeared" if isinstance(part, fem.SquirrelCage) else "harmonics"
    coarse = {"structure": structure, "element_order": ORDER, "mesh_size": None, "raceway_mesh_size": None}
    coarse |= {"axial_shapes": shapes, "harmonics": None}
    coarser = case.model_copy(update={"accuracy": case.accuracy.model_copy(update=coarse)})
    azimuths = state.balance.roller.bearing.azimuths
    name = f"{NAMES[race]} in more shapes"
    with named_failures(case, name):
        linear: Any = condensed(name, part, coarser, azimuths, report)  # nothing lifts off
        return linear.at(azimuths).absolute


def _linear(support: Any) -> Any:
    """A support that holds a ring whatever presses on it; far away from a roller it does not matter which."""
    if isinstance(support, fem.LineSupports | fem.PlanetGear):
        return fem.Foundation(radial=SOFT, axial=SOFT, tangential=SOFT)
    return replace(support, pushing=False) if isinstance(support, fem.Foundation) else support
