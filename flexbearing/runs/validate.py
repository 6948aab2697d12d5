"""Whether a case can be computed, found out without computing it."""

from typing import TYPE_CHECKING, Any

import fem
from flexbearing.case import BadCase, Head
from flexbearing.case.as_written import require_readable
from flexbearing.case.family import Family
from quasidynamic import ImpossiblePart, OutOfRange

if TYPE_CHECKING:
    from flexbearing.case.balls.angular_contact import FastCase


def require_possible(case: Head, family: Family) -> None:
    """Build everything that needs no mesh.

    Raises `BadCase` where physics or geometry forbid it.
    """
    require_readable(case)
    try:
        family.build()(case)
    except (ImpossiblePart, OutOfRange, fem.ImpossiblePart) as problem:
        raise BadCase(f"{case.source.path}: {problem}") from problem


def require_drawing(case: Head) -> None:
    """Open the drawing of a case that has one, in a process of its own.

    Raises `BadCase` where it does not hold such a part, or cannot be read.
    """
    if getattr(case, "drawing", None) is None:
        return
    from fem.condense import require_drawing as opened  # a case without a drawing loads no mesh
    from fem.errors import NotSolved
    from flexbearing.case.balls.angular_contact import FastCase

    try:
        opened(*(_groove(case) if isinstance(case, FastCase) else _raceway(case)))
    except (fem.ImpossiblePart, NotSolved) as problem:
        raise BadCase(f"{case.source.path}: {problem}") from problem


def _raceway(case: Head) -> tuple[Any, float]:
    """Drawn ring of rollers, and the length that they load [m]."""
    from flexbearing.build.expansion import roller_length
    from flexbearing.build.ring_parts import outer_part
    from flexbearing.case.roller import Case

    assert isinstance(case, Case)  # no other one has a drawing
    return outer_part(case), roller_length(case)


def _groove(case: "FastCase") -> tuple[Any, float]:
    """Drawn ring of balls, and the width of its groove [m]."""
    from flexbearing.rings.grooves import shape_of

    shape = shape_of(case, "outer")
    assert shape
    return shape.part, shape.length
