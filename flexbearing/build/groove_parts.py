"""Elastic rings of a bearing with fast balls, with their grooves, as finite elements take them."""

from math import cos, inf
from typing import TYPE_CHECKING

import fem
from fem.parts.bolted_ring import BoltedRing
from flexbearing.build import held_ring
from flexbearing.case import BadCase
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.case.balls.ring_room import OUTWARD, Race, elastic_groove, low_land
from flexbearing.case.held_ring import BARS, require_bars
from flexbearing.case.materials import Elastic
from flexbearing.case.quantity import require

if TYPE_CHECKING:
    from fem.parts.part import Part
    from fem.parts.step_solid import StepSolid

BallCase = FastCase | FourPointCase


def groove_part(case: BallCase, race: Race) -> "Part | StepSolid | None":
    """Part that carries a groove; None where it is rigid, or on a cam.

    Raises `BadCase` when no such part can exist.
    """
    four = isinstance(case, FourPointCase)
    if getattr(case.rings if four else case, race).kind in ("rigid", "cam"):
        return None
    try:
        if four:
            return _bolted(case, race)
        return _outer(case) if race == "outer" else _inner(case)
    except fem.ImpossiblePart as problem:
        section = f"rings.{race}" if four else race
        raise BadCase(f"{case.source.path}: [{section}] {problem}") from problem


def why_no_solid(case: BallCase, race: Race) -> str:
    """Why stress and strain of a part are not known; empty where they are."""
    if isinstance(case, FourPointCase):
        return ""
    outer = case.outer
    if case.bearing.second_row is not None:
        return "bearing.pair has no solid, only one row has one"
    if race == "outer" and outer.kind == "matrix":
        return 'outer.kind = "matrix" has no solid: its body is known by a matrix alone'
    if race == "outer" and outer.kind == "ring" and outer.support in ("lines", "planet"):
        known = '"side", "seat", "foundation" and "housing" have one'
        return f'outer.support = "{outer.support}" has no solid; {known}'
    if race == "outer" and outer.lifts_off:
        return "outer.bilateral = false has no solid: allowed are springs that pull as well"
    if race == "outer" and case.in_fit:
        return "outer.housing_clearance has no solid, only a bonded ring has one"
    on_bars = race == "outer" and outer.kind == "squirrel_cage"  # which are taken at rest
    turning = getattr(case.operation, f"{race}_speed") and not on_bars
    if turning and getattr(case.materials.ring(race), "density", None) is None:
        return f"strain of a ring that turns needs materials.{race}_ring.density"
    return ""


def _bolted(case: FourPointCase, race: Race) -> BoltedRing:
    ring, groove = getattr(case.rings, race), case.groove(race)
    return BoltedRing(
        race=race,
        groove=groove,
        raceway_diameter=2 * (groove.centre_radius + OUTWARD[race] * groove.radius * cos(ring.groove_end)),
        far_diameter=getattr(ring, ring.far),
        width=ring.width,
        face_distance=ring.face_distance,
        face_side=1 if ring.face == "+x" else -1,
        elastic=_elastic(case.materials.ring(race)),
        normal_stiffness=ring.face_stiffness or inf,
        shear_stiffness=ring.face_shear_stiffness or inf,
    )


def _outer(case: FastCase) -> "fem.OuterRing | fem.SquirrelCage | StepSolid":
    outer, (groove, land) = case.outer, elastic_groove(case, "outer")
    if outer.kind == "step":
        elastic = _elastic(case.materials.ring("outer"))
        lands = {"raceway_diameter": 2 * land, "low_land": low_land(case.bearing)}
        return held_ring.drawn(case, **lands, elastic=elastic, groove=groove)
    thickness, width = require(outer, ("thickness", "width"), f'outer.kind = "{outer.kind}"')
    ring = {
        "raceway_diameter": 2 * land,
        "thickness": groove.bottom(1) + thickness - land,
        "width": width,
        "elastic": _elastic(case.materials.ring("outer")),
        "offset": outer.groove_offset,
        "groove": groove,
    }
    if outer.kind == "matrix":
        from flexbearing.build.reduced_bodies import reduced_body  # with readers of other programs' files

        return fem.OuterRing(**ring, support=reduced_body(case))
    if outer.kind == "ring":
        housing = case.materials.housing and _elastic(case.materials.housing)
        return fem.OuterRing(**ring, support=held_ring.support(outer, housing, pushing=outer.lifts_off))
    bars = dict(zip(BARS, require_bars(outer), strict=True))
    return fem.SquirrelCage(**ring, **bars, two_sided=outer.bar_ends == "both")


def _inner(case: FastCase) -> fem.RingOnShaft:
    inner, (groove, land), shaft = case.inner, elastic_groove(case, "inner"), case.materials.shaft
    bore, width, length = require(inner, ("bore", "width", "shaft_length"), 'inner.kind = "ring_on_shaft"')
    assert shaft  # checked on reading
    return fem.RingOnShaft(
        raceway_diameter=2 * land,
        track_width=width,
        rib_diameter=None,
        bore=bore,
        width=width,
        shaft_bore=inner.shaft_bore,
        shaft_length=length,
        ring=_elastic(case.materials.ring("inner")),
        shaft=_elastic(shaft),
        groove=groove,
    )


def _elastic(material: Elastic) -> fem.Elastic:
    return fem.Elastic(youngs_modulus=material.youngs_modulus, poisson_ratio=material.poisson_ratio)
