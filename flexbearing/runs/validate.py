"""Whether a case of any kind can be computed, found out without computing it."""

import fem
from flexbearing.build import ring_parts, roller_bearing
from flexbearing.case import AngularCase, AnyCase, BadCase, Case, FourPointCase
from flexbearing.runs import angular_contact, four_point, life
from quasidynamic import ImpossiblePart, OutOfRange
from quasidynamic.contact.flange import flange_corner


def require_possible(case: AnyCase) -> None:
    """Build everything that needs no mesh; raises `BadCase` where physics or geometry forbid it."""
    try:
        match case:
            case Case():
                _build_roller_bearing(case)
            case FourPointCase():
                four_point.bearing(case)
            case AngularCase():
                angular_contact.bearing(case)
                angular_contact.operation(case)
    except (ImpossiblePart, OutOfRange, fem.ImpossiblePart) as problem:
        raise BadCase(f"{case.source.path}: {problem}") from problem


def _build_roller_bearing(case: Case) -> None:
    bearing = roller_bearing.bearing(case).bearing
    life.require_possible(case, bearing)
    if flange := roller_bearing.flange(case):
        flange_corner(flange, bearing)
    ring_parts.outer_part(case)
    ring_parts.inner_part(case)
    ring_parts.require_held_in_housing(case)
