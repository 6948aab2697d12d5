"""The shape along the roller that heat, speed and pressing give the raceway of a bonded inner ring."""

from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING

import fem
from fem.errors import NotSolved
from flexbearing.build.expansion import hot_over_cold, material, roller_length
from flexbearing.build.growth import pressed_inner_ring
from flexbearing.build.mesh_sizes import ON_A_SECTION, mesh_size, nodes_of
from flexbearing.build.ring_parts import inner_part
from flexbearing.cache import configured
from flexbearing.case import BadCase
from flexbearing.case.roller import Case

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from fem.raceway.growth import BondedGrowth


def bonded_shape(case: Case, note: Callable[[str], None] = lambda text: None) -> "NDArray | None":
    """Growth (M,) [m] of the inner raceway by Legendre modes, its mean included; None where nothing grows.

    Beside a stated clearance ring and shaft are one piece from the start; where fits are given, they are
    pressed without friction and then bonded, as the operating clearance has it.

    Raises `BadCase` if it cannot be computed.
    """
    part = inner_part(case)
    assert part  # or the ring would be rigid
    if case.bearing.mounting is not None:
        return pressed_inner_ring(case)
    strains = hot_over_cold(case, "inner_ring") - 1, hot_over_cold(case, "shaft") - 1
    densities = material(case, "inner_ring").density, material(case, "shaft").density
    speed = case.operation.inner_speed
    resolution = fem.Resolution(
        length=roller_length(case),
        axial_modes=case.accuracy.axial_shapes,
        mesh_size=mesh_size(case, ON_A_SECTION),
        nodes_of=nodes_of(case, "inner"),
    )

    try:
        growth, messages = _growth(part, resolution)
    except fem.ImpossiblePart as problem:
        raise BadCase(f"{case.source.path}: inner ring: {problem}") from problem
    except NotSolved as problem:
        raise BadCase(f"{case.source.path}: growth of the inner ring: {problem}") from problem
    for text in messages:
        note(text)
    return growth.under(strains, densities, speed)


@lru_cache(maxsize=4)
def _growth(part: "fem.RingOnShaft", resolution: "fem.Resolution") -> "tuple[BondedGrowth, tuple[str, ...]]":
    """Growth by unit loads, kept for cases one after the other, and what was noted when it was looked up."""

    def computed() -> "BondedGrowth":
        from fem.section.bonded_growth import bonded_growth

        return bonded_growth(part, resolution)

    messages: list[str] = []
    growth = configured().cached("BondedGrowth", ("bonded", part, resolution), computed, messages.append)
    return growth, tuple(messages)
