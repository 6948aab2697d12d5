"""Elastic rings of a bearing with fast balls, with their grooves, as finite elements take them."""

from math import cos, inf, sin
from typing import Literal

import fem
from fem.parts.bolted_ring import BoltedRing
from fem.parts.material import in_mm
from fem.parts.rings import SLENDEREST_SLOT
from flexbearing.build import held_ring
from flexbearing.case import BadCase
from flexbearing.case.balls.angular_contact import AngularBearing, FastCase
from flexbearing.case.balls.elastic_rings import groove_end
from flexbearing.case.balls.four_point import FourPointBearing, FourPointCase
from flexbearing.case.materials import Elastic
from flexbearing.case.quantity import require

Race = Literal["inner", "outer"]
GroovePart = fem.OuterRing | fem.RingOnShaft | fem.SquirrelCage | BoltedRing
BallCase = FastCase | FourPointCase
OUTWARD: dict[Race, int] = {"inner": -1, "outer": 1}


def groove_part(case: BallCase, race: Race) -> GroovePart | None:
    """Part that carries a groove; None where it is rigid.

    Raises
    ------
    BadCase
        when no such part can exist
    """
    four = isinstance(case, FourPointCase)
    if getattr(case.rings if four else case, race).kind == "rigid":
        return None
    try:
        if four:
            return _bolted(case, race)
        return _outer(case) if race == "outer" else _inner(case)
    except fem.ImpossiblePart as problem:
        section = f"rings.{race}" if four else race
        raise BadCase(f"{case.source.path}: [{section}] {problem}") from problem


def _groove(case: BallCase, race: Race) -> fem.Groove:
    """Groove of a race; clearance and growth, which are far smaller than its radius, do not move it."""
    bearing, diameter = case.bearing, case.bearing.ball.diameter
    conformity = getattr(bearing, race).over(diameter)
    angle = bearing.contact_angle if isinstance(bearing, AngularBearing | FourPointBearing) else 0.0
    offset = (conformity - 0.5) * diameter
    return fem.Groove(
        radius=conformity * diameter,
        centre_radius=bearing.pitch_diameter / 2 - OUTWARD[race] * offset * cos(angle),
        aside=offset * sin(angle) if isinstance(bearing, FourPointBearing) else 0.0,
    )


def _bolted(case: FourPointCase, race: Race) -> BoltedRing:
    ring, groove = getattr(case.rings, race), _groove(case, race)
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


def _land(case: FastCase, race: Race, groove: fem.Groove) -> float:
    """Radius of the shoulders [m]."""
    end = groove_end(getattr(case.bearing, race), case.bearing.ball.diameter)
    return groove.centre_radius + OUTWARD[race] * groove.radius * cos(end)


def _outer(case: FastCase) -> fem.OuterRing | fem.SquirrelCage:
    outer, groove = case.outer, _groove(case, "outer")
    thickness, width = require(outer, ("thickness", "width"), f'outer.kind = "{outer.kind}"')
    _require(thickness > SLENDEREST_SLOT, "thickness", thickness, f"above {in_mm(SLENDEREST_SLOT)}")
    land = _land(case, "outer", groove)
    ring = {
        "raceway_diameter": 2 * land,
        "thickness": groove.bottom(1) + thickness - land,
        "width": width,
        "elastic": _elastic(case.materials.ring("outer")),
        "offset": outer.groove_offset,
        "groove": groove,
    }
    if outer.kind == "ring":
        housing = case.materials.housing and _elastic(case.materials.housing)
        return fem.OuterRing(**ring, support=held_ring.support(outer, housing))
    names = ("bars", "bar_width", "bar_thickness", "bar_length", "flange_length")
    bars = dict(zip(names, require(outer, names, 'outer.kind = "squirrel_cage"'), strict=True))
    return fem.SquirrelCage(**ring, **bars, two_sided=outer.bar_ends == "both")


def _inner(case: FastCase) -> fem.RingOnShaft:
    inner, groove, shaft = case.inner, _groove(case, "inner"), case.materials.shaft
    bore, width, length = require(inner, ("bore", "width", "shaft_length"), 'inner.kind = "ring_on_shaft"')
    assert shaft  # checked on reading
    largest = 2 * (groove.bottom(-1) - SLENDEREST_SLOT)
    _require(bore < largest, "bore", bore, f"below {in_mm(largest)}, under the bottom of the groove")
    return fem.RingOnShaft(
        raceway_diameter=2 * _land(case, "inner", groove),
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


def _require(possible: bool, name: str, length: float, allowed: str) -> None:
    """Refuse a length [m] of a ring in the words of the case."""
    if not possible:
        raise fem.ImpossiblePart(f"{name} = {in_mm(length)} is impossible; allowed is {allowed}")


def _elastic(material: Elastic) -> fem.Elastic:
    return fem.Elastic(youngs_modulus=material.youngs_modulus, poisson_ratio=material.poisson_ratio)
