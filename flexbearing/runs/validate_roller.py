"""The parts of a roller bearing, built without a mesh to see whether they can be."""

from flexbearing.build import ring_parts, roller_bearing
from flexbearing.case.roller import Case
from flexbearing.runs import life
from quasidynamic.contact.flange import flange_corner


def build(case: Case) -> None:
    """Build bearing, flange and rings; raises `ImpossiblePart` or `OutOfRange` where they cannot be."""
    bearing = roller_bearing.bearing(case).bearing
    life.require_possible(case, bearing)
    if flange := roller_bearing.flange(case):
        flange_corner(flange, bearing)
    ring_parts.outer_part(case)
    ring_parts.inner_part(case)
    ring_parts.require_held_in_housing(case)
