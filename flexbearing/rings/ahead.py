"""The outer ring of a case, condensed beside everything that a run does before it needs the ring."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from flexbearing.build.ring_parts import part_of
from flexbearing.case.roller import Case
from flexbearing.program.threads import cores

if TYPE_CHECKING:
    from fem.raceway.harmonics import HarmonicCompliance

Ahead = Callable[[], "HarmonicCompliance"]


@contextmanager
def outer_ring_ahead(case: Case) -> Iterator[Ahead | None]:
    """Begin with the outer ring of a case in a process of its own."""
    part = part_of(case, "outer")
    chosen_later = case.accuracy.target is not None or case.coupling.structure == "full"
    if part is None or chosen_later or cores() == 1:
        yield None
        return
    # finite elements are not loaded between rigid rings
    from fem.condense import condensing, is_cage_in_space
    from flexbearing.cache import configured
    from flexbearing.rings.resolution import resolved

    arguments = resolved(part, case)
    if not is_cage_in_space(*arguments[:2]) or configured().holds(arguments):
        yield None
        return
    with condensing(*arguments) as answer:
        yield answer
