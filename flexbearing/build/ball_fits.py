"""Balls, grooves, oil and fits of a case, as the bearing physics takes them."""

import quasidynamic as qd
from flexbearing.build import plain_rings
from flexbearing.build.plain_rings import STEEL_DENSITY
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.mounting import MountedCase
from flexbearing.case.balls.parts import BallBearing
from flexbearing.case.materials import Elastic, HeavyElastic, Oil
from quasidynamic.clearance import OperatingClearance
from quasidynamic.note import Note
from quasidynamic.parts.oil_properties import kinematic_viscosity_at


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
    own, materials = case.bearing, case.materials
    shares = [(groove.over(own.ball.diameter) - 0.5) * own.ball.diameter for groove in (own.inner, own.outer)]
    inner, outer = (
        own.pitch_diameter + side * (own.ball.diameter + case.stated_clearance * share / own.centre_distance)
        for side, share in zip((-1, 1), shares, strict=True)
    )
    return plain_rings.from_fits(
        case,
        (materials.ring("inner"), inner),
        (materials.ring("outer"), outer),
        ("ball", materials.ball, own.ball.diameter),
        case.operation if isinstance(case, FastCase) else None,
    )
