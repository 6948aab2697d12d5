"""The fits of a case: from the cold clearance to that in operation."""

from typing import Any

from flexbearing.build import expansion
from flexbearing.build.growth import expansions, mean_seat_growth
from flexbearing.case.roller import Case
from quasidynamic.clearance import (
    Annulus,
    FitConditions,
    Mounting,
    OperatingClearance,
    OperatingConditions,
    PressFit,
    RacewayExpansion,
    operating_clearance,
)
from quasidynamic.clearance.operating_clearance import Expansion
from quasidynamic.clearance.press_fit import free_displacement

ROOM = 293.15  # [K] of every part when a case gives no temperatures; only differences matter


def from_fits(case: Case) -> OperatingClearance:
    """Steps from the cold to the operating clearance of a case that gives its fits."""
    mounting, (inner, outer) = _mounting(case), expansions(case)
    return operating_clearance(mounting, _running(case), inner, outer or _on_seat(case, mounting.outer_ring))


def _on_seat(case: Case, ring: Annulus) -> Expansion | None:
    """Expansion of a ring without housing on a seat of another temperature; None without such a seat."""
    by_seat = mean_seat_growth(case)
    if not by_seat:
        return None

    def expansion(conditions: FitConditions) -> RacewayExpansion:
        free = free_displacement(ring, ring.inner_radius, conditions.inside_rise, conditions.speed)
        return RacewayExpansion(free + (by_seat if conditions.inside_rise else 0.0))

    return expansion


def _mounting(case: Case) -> Mounting:
    fits: Any = case.bearing.mounting  # its companions were checked on reading
    bore, shaft_bore = _bores(case)
    raceway = case.bearing.outer_raceway_diameter
    inner_raceway = raceway - 2 * case.bearing.roller.diameter - case.stated_clearance
    outside = fits.outer_diameter or raceway + 2 * (case.outer.thickness or 0.0)
    ring = _annulus(case, "outer_ring", raceway, outside)
    outer: PressFit | Annulus = ring
    if fits.housing:
        outer = PressFit(
            inside=ring,
            outside=_annulus(case, "housing", outside, _housing_diameter(case, outside)),
            interference=case.housing_interference,
        )
    return Mounting(
        cold_clearance=case.stated_clearance,
        shaft_fit=PressFit(
            inside=_annulus(case, "shaft", shaft_bore, bore),
            outside=_annulus(case, "inner_ring", bore, inner_raceway),
            interference=case.shaft_interference,
        ),
        outer=outer,
        rolling_element=_annulus(case, "roller", 0.0, case.bearing.roller.diameter),
    )


def _housing_diameter(case: Case, bore: float) -> float:
    """Outside diameter of a housing [m]."""
    housing: Any = case.bearing.fits and case.bearing.fits.housing  # requested only where there is one
    if case.outer.kind == "rigid":
        return housing.diameter
    return bore + 2 * (case.outer.housing_thickness or 0.0)


def _bores(case: Case) -> tuple[float, float]:
    """Bores of inner ring and shaft [m]; zero is a solid shaft."""
    fits: Any = case.bearing.mounting
    inner: Any = case.inner
    if inner.kind == "rigid":
        return fits.bore, fits.shaft_bore or 0.0
    return inner.bore, inner.shaft_bore


def _running(case: Case) -> OperatingConditions:
    temperatures, housed = case.operation.temperatures, case.bearing.fits and case.bearing.fits.housing
    parts = ("reference", "shaft", "inner_ring", "roller", "outer_ring", "housing")
    kelvin = {name: getattr(temperatures, name) if temperatures else ROOM for name in parts}
    return OperatingConditions(
        reference=kelvin["reference"],
        shaft=kelvin["shaft"],
        inner_ring=kelvin["inner_ring"],
        rolling_elements=kelvin["roller"],
        outer_ring=kelvin["outer_ring"],
        housing=kelvin["housing"] if housed else None,
        inner_speed=case.operation.inner_speed,
        outer_speed=case.operation.outer_speed,
    )


def _annulus(case: Case, part: str, inside: float, outside: float) -> Annulus:
    material = expansion.material(case, part)
    return Annulus(
        inner_radius=inside / 2,
        outer_radius=outside / 2,
        youngs_modulus=material.youngs_modulus,
        poisson_ratio=material.poisson_ratio,
        density=material.density,
        expansion=expansion.expansion_coefficient(case, part),
    )
