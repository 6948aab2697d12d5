"""Raceways of parts that differ a little from that of a case, on the moved nodes of its mesh."""

from dataclasses import replace
from typing import TYPE_CHECKING

from numpy.typing import NDArray

from fem.condense import SOLID
from fem.parts.resolution import Shape
from flexbearing.build.ring_parts import NAMES, Race, part_of
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.progress import Report
from flexbearing.rings.condensed import condensed_part, named_failures, on_supports
from flexbearing.rings.resolution import resolved
from flexbearing.rings.supported import is_on_supports

if TYPE_CHECKING:
    from fem.raceway.compliance import RacewayCompliance


def raceway_of_shape(
    case: Case, race: Race, shape: Shape, outward: NDArray, azimuths: NDArray, report: Report
) -> "RacewayCompliance":
    """A raceway near given forces of a part and a band of another shape, right to first order of the change.

    Raises `BadCase` when the part cannot be, or has other faces; `PartnerFailed` when it has no trustworthy
    answer.
    """
    part = part_of(case, race)
    assert part  # a rigid raceway has no shape
    part, discretisation, resolution = resolved(part, case, azimuths)
    if discretisation is SOLID:
        raise BadCase(
            f"{case.source.path}: {NAMES[race]}: nodes of a whole solid are not moved; "
            'allowed is another accuracy.structure, such as "harmonics"'
        )
    meshed = Shape(part=part, length=resolution.length, row_distance=resolution.row_distance)
    resolution = replace(
        resolution,
        length=shape.length,
        row_distance=shape.row_distance,
        nodes_of=meshed,
        first_order=True,
    )
    arguments = shape.part, discretisation, resolution
    with named_failures(case, NAMES[race]):
        if race == "outer" and is_on_supports(case):
            return on_supports(arguments, case, azimuths, report).linearised(outward)
        return condensed_part(NAMES[race], arguments, report).at(azimuths)
