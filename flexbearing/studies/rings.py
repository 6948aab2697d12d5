"""Which elastic rings a case has: variants between the same ones are computed together."""

from flexbearing.build.ring_parts import part_of
from flexbearing.cache.key import digest
from flexbearing.case import Head
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.case.roller import Case


def rings(case: Head) -> tuple[str, ...]:
    """Digests of the elastic rings of a case.

    Parameters
    ----------
    case : Head
        as it was read

    Returns
    -------
    tuple of str
        of the inner and the outer ring; empty between rigid ones
    """
    if isinstance(case, Case):
        parts = [part_of(case, race) for race in ("inner", "outer")]
        accuracy = case.accuracy.model_dump()
        return tuple(digest([part, accuracy]) for part in parts if part is not None)
    if isinstance(case, FourPointCase) and not case.rings.rigid:
        return (digest(case.model_dump(include={"bearing", "materials", "rings"})),)
    return ()
