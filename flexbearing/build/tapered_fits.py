"""What fits, heat and speed do to a tapered roller bearing: cone and cup come closer or part."""

from math import cos
from typing import Any

from flexbearing.build import clearance, plain_rings
from flexbearing.case.tapered import TaperedCase
from quasidynamic.clearance import OperatingClearance
from quasidynamic.note import Note, information
from quasidynamic.parts.tapered_bearing import axial_approach


def from_fits(case: TaperedCase) -> OperatingClearance:
    """Steps of a clearance on the diameter, in the plane of the roller centres; 0 before mounting.

    Rings are plain ones that end at the raceways in that plane: an assumption, the thick end of a cone and
    its rib make them stiffer.
    """
    own, materials = case.bearing, case.materials
    axis, cone = own.angles
    chord = own.roller.diameter / cos(own.cup_angle - axis)  # across the roller, normal to each raceway
    inside, outside = own.pitch_diameter - chord / cos(cone), own.pitch_diameter + chord / cos(own.cup_angle)
    return plain_rings.from_fits(
        case,
        (materials.inner_ring, inside),
        (materials.outer_ring, outside),
        ("roller", materials.roller, (outside - inside) / 2),
        case.operation,
    )


def closer(case: TaperedCase) -> float:
    """Axial distance by which cone and cup are closer than before mounting [m]."""
    return axial_approach(clearance.operating(case), case.bearing.cup_angle)


def record(case: TaperedCase) -> dict[str, Any]:
    """The clearance and how it came about, for the result file; empty without fits."""
    return {} if case.bearing.fits is None else clearance.record(case) | {"verdict": _words(closer(case))}


def notes(case: TaperedCase) -> tuple[Note, ...]:
    """What fits, heat and speed do along the axis, also at the ends of the tolerances."""
    if case.bearing.fits is None:
        return ()
    words = f"fits, heat and speed: {_words(closer(case))}"
    if case.bands:
        ends = (1e6 * closer(case.within_tolerances(place)) for place in ("loosest", "tightest"))
        words += ", {:.1f} to {:.1f} um within the tolerances of the fits".format(*ends)
    return (information("fitted-cone", words),)


def _words(closer: float) -> str:
    return f"cone and cup are closer by {1e6 * closer:.1f} um along the axis than before mounting"
