"""How a seat that is warmer or colder than the outer ring widens or cones its raceway."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import fem
from fem.errors import NotSolved
from flexbearing.build.expansion import expansion_coefficient, roller_length
from flexbearing.build.mesh_sizes import IN_SPACE, ON_A_SECTION, mesh_size, nodes_of
from flexbearing.build.ring_parts import outer_part
from flexbearing.cache import configured
from flexbearing.case import BadCase
from flexbearing.case.roller import Case

if TYPE_CHECKING:
    from fem.raceway.growth import RacewayGrowth


def seat_strain(case: Case) -> float:
    """Free expansion of the seat beyond that of the outer ring [-]; zero where they are equally warm."""
    temperatures = case.operation.temperatures
    if temperatures is None or temperatures.outer_seat is None:
        return 0.0
    warmer = temperatures.outer_seat - temperatures.outer_ring
    return expansion_coefficient(case, "outer_ring") * warmer


def seat_growth(case: Case, note: Callable[[str], None] = lambda text: None) -> "RacewayGrowth | None":
    """Growth of the outer raceway per `seat_strain`; None where the seat is as warm as the ring.

    Raises `BadCase` if it cannot be computed.
    """
    part = outer_part(case) if seat_strain(case) else None
    if not isinstance(part, fem.OuterRing | fem.SquirrelCage):
        return None
    resolution = fem.Resolution(
        length=roller_length(case),
        axial_modes=case.accuracy.axial_shapes,
        mesh_size=mesh_size(case, IN_SPACE if isinstance(part, fem.SquirrelCage) else ON_A_SECTION),
        nodes_of=nodes_of(case, "outer"),
    )

    def computed() -> "RacewayGrowth":
        from fem.condense import seat_growth as of_part

        return of_part(part, resolution)

    try:
        return configured().cached("RacewayGrowth", ("seat", part, resolution), computed, note)
    except fem.ImpossiblePart as problem:
        raise BadCase(f"{case.source.path}: outer ring: {problem}") from problem
    except NotSolved as problem:
        raise BadCase(f"{case.source.path}: growth of the outer ring: {problem}") from problem
