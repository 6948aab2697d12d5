"""Whether a case of any kind can be computed, found out without computing it."""

from flexbearing.case import AngularCase, AnyCase, BadCase, Case, FourPointCase
from flexbearing.compute import angular, assemble, four_point
from quasidynamic import ImpossiblePart, OutOfRange


def require_possible(case: AnyCase) -> None:
    """Build everything that needs no mesh; raises `BadCase` where physics or geometry forbid it."""
    try:
        match case:
            case Case():
                assemble.require_possible(case)
            case FourPointCase():
                four_point.bearing(case)
            case AngularCase():
                angular.bearing(case)
                angular.operation(case)
    except (ImpossiblePart, OutOfRange) as problem:
        raise BadCase(f"{case.source.path}: {problem}") from problem
