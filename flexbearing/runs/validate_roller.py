"""The parts of a roller bearing, built without a mesh to see whether they can be."""

from flexbearing.build import ring_parts, roller_bearing
from flexbearing.build.lubrication import lubrication
from flexbearing.case.roller import Case
from quasidynamic import CylindricalRollerBearing


def build(case: Case) -> None:
    """Build bearing, flange and rings; nothing that solves is loaded.

    Raises
    ------
    ImpossiblePart
        where a part cannot be
    OutOfRange
        where a law does not hold for it
    """
    bearing = roller_bearing.parts(case)
    roller_bearing.operation(case)
    lubrication(case)
    require_around(case, bearing)


def require_around(case: Case, bearing: CylindricalRollerBearing) -> None:
    """Build what a bearing is guided by and mounted in.

    Raises
    ------
    ImpossiblePart
        where a part cannot be
    OutOfRange
        where a law does not hold for it
    """
    if flange := roller_bearing.flange(case):
        from quasidynamic.contact.flange import flange_corner

        flange_corner(flange, bearing)
    ring_parts.outer_part(case)
    ring_parts.require_shoulder(case)
    ring_parts.require_held_in_housing(case)
    ring_parts.require_held_on_lines(case)
