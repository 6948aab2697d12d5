"""From the fits of plain rings to the operating clearance."""

from typing import Any, Literal

from flexbearing.case.materials import Elastic, HeavyElastic
from flexbearing.case.mounted import FittedCase, GrowingElastic
from quasidynamic.clearance import (
    Annulus,
    Mounting,
    OperatingClearance,
    OperatingConditions,
    PressFit,
    operating_clearance,
)

STEEL_DENSITY = 7850.0  # [kg/m3] where a case has none: of rings at rest, and of what slow balls neglect
ROOM = 293.15  # [K] of every part when a case gives no temperatures; only differences matter
Ring = tuple[Elastic, float]  # material, and diameter of the raceway [m]


def from_fits(
    case: FittedCase,
    inner: Ring,
    outer: Ring,
    element: tuple[Literal["ball", "roller"], Elastic, float],
    operation: Any,
) -> OperatingClearance:
    """Steps from the cold to the operating clearance of a case that gives its fits.

    The element has a name, a material and a diameter [m]; without `operation` nothing is warm or turns.
    """
    fits, materials = case.bearing.fits, dict(case.materials)  # shaft and housing were checked on reading
    assert fits  # or nothing is computed
    name, material, diameter = element
    ring = _annulus(*outer, fits.outer_diameter)
    around: PressFit | Annulus = ring
    if fits.housing and case.housing_interference is not None:
        housing = _annulus(materials["housing"], fits.outer_diameter, fits.housing.diameter)
        around = PressFit(inside=ring, outside=housing, interference=case.housing_interference)
    mounting = Mounting(
        cold_clearance=case.stated_clearance,
        shaft_fit=PressFit(
            inside=_annulus(materials["shaft"], fits.shaft_bore or 0.0, fits.bore),
            outside=_annulus(inner[0], fits.bore, inner[1]),
            interference=case.shaft_interference,
        ),
        outer=around,
        rolling_element=_annulus(material, 0.0, diameter),
        element=name,
    )
    return operating_clearance(mounting, _running(case, name, operation))


def _running(case: FittedCase, element: str, operation: Any) -> OperatingConditions:
    """Temperatures and speeds."""
    given, housed = operation and operation.temperatures, case.bearing.fits and case.bearing.fits.housing
    parts = ("reference", "shaft", "inner_ring", element, "outer_ring", "housing")
    kelvin = {name: getattr(given, name) if given else ROOM for name in parts}
    return OperatingConditions(
        reference=kelvin["reference"],
        shaft=kelvin["shaft"],
        inner_ring=kelvin["inner_ring"],
        rolling_elements=kelvin[element],
        outer_ring=kelvin["outer_ring"],
        housing=kelvin["housing"] if housed else None,
        inner_speed=operation.inner_speed if operation else 0.0,
        outer_speed=operation.outer_speed if operation else 0.0,
    )


def _annulus(material: Elastic, inside: float, outside: float) -> Annulus:
    """A plain ring; density and expansion are known of parts that grow by them, checked on reading."""
    density = material.density if isinstance(material, HeavyElastic | GrowingElastic) else STEEL_DENSITY
    assert density is not None  # checked on reading
    return Annulus(
        inner_radius=inside / 2,
        outer_radius=outside / 2,
        youngs_modulus=material.youngs_modulus,
        poisson_ratio=material.poisson_ratio,
        density=density,
        expansion=getattr(material, "expansion", None) or 0.0,
    )
