"""Nominal stresses of the bars of a squirrel cage at an end state, from its condensed stiffness."""

from typing import TYPE_CHECKING

from flexbearing.build import ring_parts
from flexbearing.case.roller import Case
from flexbearing.coupled.states import EndStates
from flexbearing.coupling.raceway_pair import OUTWARD

if TYPE_CHECKING:
    from fem.cage.bar_forces import NominalStresses


def nominal_stresses(case: Case, end: EndStates) -> "NominalStresses | None":
    """Section forces and nominal stresses of the bars, without a solve."""
    if end.rings.outer is None:
        return None
    import fem
    from fem.cage import bar_forces
    from fem.raceway.bar_response import BarResponse

    response = end.rings.outer.bar_response
    part = ring_parts.outer_part(case) if isinstance(response, BarResponse) else None
    if not isinstance(response, BarResponse) or not isinstance(part, fem.SquirrelCage):
        return None
    states, azimuths = end.states, end.states.balance.roller.bearing.azimuths
    return bar_forces.nominal_stresses(part, response, azimuths, OUTWARD[1] * states.forces[..., 1, :, :])
