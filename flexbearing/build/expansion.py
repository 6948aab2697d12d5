"""Parts at their temperature: how much they expand, and what they are made of."""

from typing import TYPE_CHECKING, overload

from flexbearing.case.materials import Elastic, Material
from flexbearing.case.roller import Case

if TYPE_CHECKING:
    from flexbearing.build.groove_parts import BallCase
    from flexbearing.case.balls.angular_contact import FastCase


def hot_over_cold(case: "Case | FastCase", part: str) -> float:
    """Dimension of a part at its temperature over that at the reference temperature [-].

    A housing whose temperature is not given follows the outer ring.
    """
    temperatures = case.operation.temperatures
    if temperatures is None:
        return 1.0
    temperature = getattr(temperatures, part)
    if temperature is None:
        return hot_over_cold(case, "outer_ring")
    return 1.0 + expansion_coefficient(case, part) * (temperature - temperatures.reference)


def expansion_coefficient(case: "Case | FastCase", part: str) -> float:
    """Coefficient of linear thermal expansion of a part [1/K]; 0 where the case needs none and gives none."""
    return getattr(material(case, part), "expansion", None) or 0.0


@overload
def material(case: Case, part: str) -> Material: ...
@overload
def material(case: "BallCase", part: str) -> Elastic: ...
def material(case: "Case | BallCase", part: str) -> Elastic:
    """Material of a part; where it has none of its own that of the outer ring, or of a ring by the balls."""
    if isinstance(case, Case):
        return getattr(case.materials, part) or case.materials.outer_ring
    return getattr(case.materials, part) or case.materials.ring("inner" if part == "inner_ring" else "outer")


def outer_raceway_diameter(case: Case) -> float:
    """Hot outer raceway diameter [m]."""
    return case.bearing.outer_raceway_diameter * hot_over_cold(case, "outer_ring")


def roller_length(case: Case) -> float:
    """Hot roller length [m]."""
    return case.bearing.roller.length * hot_over_cold(case, "roller")
