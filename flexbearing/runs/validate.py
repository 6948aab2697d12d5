"""Whether a case can be computed, found out without computing it."""

import fem
from flexbearing.case import BadCase, Head
from flexbearing.case.as_written import require_readable
from flexbearing.case.family import Family
from quasidynamic import ImpossiblePart, OutOfRange


def require_possible(case: Head, family: Family) -> None:
    """Build everything that needs no mesh.

    Raises
    ------
    BadCase
        where physics or geometry forbid it
    """
    require_readable(case)
    try:
        family.build()(case)
    except (ImpossiblePart, OutOfRange, fem.ImpossiblePart) as problem:
        raise BadCase(f"{case.source.path}: {problem}") from problem
