"""Parts at their temperature: how much they expand, and what they are made of."""

from flexbearing.case.materials import Material
from flexbearing.case.roller import Case


def hot_over_cold(case: Case, part: str) -> float:
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


def expansion_coefficient(case: Case, part: str) -> float:
    """Coefficient of linear thermal expansion of a part [1/K]; 0 where the case needs none and gives none."""
    return material(case, part).expansion or 0.0


def material(case: Case, part: str) -> Material:
    """Material of a part; that of the outer ring where a housing has none of its own."""
    return getattr(case.materials, part) or case.materials.outer_ring


def outer_raceway_diameter(case: Case) -> float:
    """Hot outer raceway diameter [m]."""
    return case.bearing.outer_raceway_diameter * hot_over_cold(case, "outer_ring")


def roller_length(case: Case) -> float:
    """Hot roller length [m]."""
    return case.bearing.roller.length * hot_over_cold(case, "roller")
