"""Balls, grooves, oil and fits of a case, as the bearing physics takes them."""

import quasidynamic as qd
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.mounting import MountedCase, RingElastic
from flexbearing.case.balls.parts import BallBearing
from flexbearing.case.materials import Elastic, HeavyElastic, Oil
from quasidynamic.clearance import (
    Annulus,
    Mounting,
    OperatingClearance,
    OperatingConditions,
    PressFit,
    operating_clearance,
)
from quasidynamic.note import Note
from quasidynamic.parts.oil_properties import kinematic_viscosity_at

STEEL_DENSITY = 7850.0  # [kg/m3] where a case has none: of rings at rest, and of what slow balls neglect
ROOM = 293.15  # [K] of every part when a case gives no temperatures; only differences matter


def ball(bearing: BallBearing, material: Elastic) -> qd.Ball:
    """The balls."""
    return qd.Ball(diameter=bearing.ball.diameter, material=solid(material))


def groove(bearing: BallBearing, ring: str, material: Elastic) -> qd.Groove:
    """Groove of a ring, "inner" or "outer"."""
    conformity = getattr(bearing, ring).over(bearing.ball.diameter)
    return qd.Groove(conformity=conformity, material=solid(material))


def solid(material: Elastic) -> qd.Material:
    """The material; rings and slow balls have no density of their own."""
    density = material.density if isinstance(material, HeavyElastic) else STEEL_DENSITY
    return qd.Material(
        youngs_modulus=material.youngs_modulus, poisson_ratio=material.poisson_ratio, density=density
    )


def kinematic_viscosity(lubricant: Oil) -> tuple[float, tuple[Note, ...]]:
    """Viscosity of an oil at its inlet temperature."""
    temperature, sheet = lubricant.inlet_temperature, lubricant.data_sheet
    if lubricant.oil is not None:
        oil = qd.oil_at(lubricant.oil, temperature)
        return oil.viscosity / oil.density, oil.notes
    if sheet is not None:
        cold, hot = (
            (sheet.cold_temperature, sheet.cold_viscosity),
            (sheet.hot_temperature, sheet.hot_viscosity),
        )
        return kinematic_viscosity_at(sheet.name, (cold, hot), temperature)
    assert lubricant.viscosity is not None  # checked on reading
    assert lubricant.density is not None
    return lubricant.viscosity / lubricant.density, ()


def from_fits(case: MountedCase) -> OperatingClearance:
    """Steps from the cold to the operating clearance of a case that gives its fits.

    Rings are plain ones that end at the bottoms of their grooves, d_m - D - s_i P_d and d_m + D + s_o P_d
    with s = (f - 1/2)/(f_i + f_o - 1): an assumption, shoulders make them stiffer.
    """
    own, fits, materials = case.bearing, case.bearing.fits, case.materials
    assert fits  # or nothing is computed
    assert materials.shaft  # checked on reading, as that of the housing
    shares = [(groove.over(own.ball.diameter) - 0.5) * own.ball.diameter for groove in (own.inner, own.outer)]
    inner, outer = (
        own.pitch_diameter + side * (own.ball.diameter + case.stated_clearance * share / own.centre_distance)
        for side, share in zip((-1, 1), shares, strict=True)
    )
    ring = _annulus(materials.ring("outer"), outer, fits.outer_diameter)
    around: PressFit | Annulus = ring
    if fits.housing and materials.housing and case.housing_interference is not None:
        housing = _annulus(materials.housing, fits.outer_diameter, fits.housing.diameter)
        around = PressFit(inside=ring, outside=housing, interference=case.housing_interference)
    mounting = Mounting(
        cold_clearance=case.stated_clearance,
        shaft_fit=PressFit(
            inside=_annulus(materials.shaft, fits.shaft_bore or 0.0, fits.bore),
            outside=_annulus(materials.ring("inner"), fits.bore, inner),
            interference=case.shaft_interference,
        ),
        outer=around,
        rolling_element=_annulus(materials.ball, 0.0, own.ball.diameter),
        element="ball",
    )
    return operating_clearance(mounting, _running(case))


def _running(case: MountedCase) -> OperatingConditions:
    """Temperatures and speeds; slow balls have neither."""
    fast = case.operation if isinstance(case, FastCase) else None
    given, housed = fast and fast.temperatures, case.bearing.fits and case.bearing.fits.housing
    parts = ("reference", "shaft", "inner_ring", "ball", "outer_ring", "housing")
    kelvin = {name: getattr(given, name) if given else ROOM for name in parts}
    return OperatingConditions(
        reference=kelvin["reference"],
        shaft=kelvin["shaft"],
        inner_ring=kelvin["inner_ring"],
        rolling_elements=kelvin["ball"],
        outer_ring=kelvin["outer_ring"],
        housing=kelvin["housing"] if housed else None,
        inner_speed=fast.inner_speed if fast else 0.0,
        outer_speed=fast.outer_speed if fast else 0.0,
    )


def _annulus(material: Elastic, inside: float, outside: float) -> Annulus:
    """A plain ring; density and expansion are known of parts that grow by them, checked on reading."""
    density = material.density if isinstance(material, HeavyElastic | RingElastic) else STEEL_DENSITY
    assert density is not None  # checked on reading
    return Annulus(
        inner_radius=inside / 2,
        outer_radius=outside / 2,
        youngs_modulus=material.youngs_modulus,
        poisson_ratio=material.poisson_ratio,
        density=density,
        expansion=getattr(material, "expansion", None) or 0.0,
    )
