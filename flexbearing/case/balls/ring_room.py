"""Room for grooves, bars and patches of balls in the elastic rings of a case."""

from math import cos
from typing import TYPE_CHECKING, Any, Literal

from flexbearing.case import held_ring
from flexbearing.case.balls.groove_accuracy import require_patches
from flexbearing.case.quantity import at_least, at_most, impossible, in_mm, located, require

if TYPE_CHECKING:
    from fem.parts.groove import Groove

Race = Literal["inner", "outer"]
OUTWARD: dict[Race, int] = {"inner": -1, "outer": 1}
MARGIN = 2.0  # widths of a patch from the outermost station to the end of the groove


def elastic_groove(case: Any, race: Race) -> "tuple[Groove, float]":
    """Groove in an elastic ring, or grooves of both rows in one, and radius of their shoulders [m]."""
    from fem.parts.groove import Groove  # not described between rigid rings

    bearing = case.bearing
    groove, outward, bottom = getattr(bearing, race), OUTWARD[race], bearing.groove_bottom(race)
    radius = groove.over(bearing.ball.diameter) * bearing.ball.diameter
    place = bearing.row_place(race) if case.one_ring(race) else 0.0
    arc = Groove(radius=radius, centre_radius=bottom - outward * radius, place=place)
    return arc, bottom - outward * groove.shoulder


def low_land(bearing: Any) -> float:
    """Radius of the low shoulder of an outer groove [m], at -x; drawn rings alone have another one there."""
    return bearing.groove_bottom("outer") - bearing.outer.shoulders[1]


def require_room(case: Any) -> None:
    """Raise unless the elastic rings of fast balls can have their grooves; names are dotted keys."""
    races: tuple[Race, Race] = ("inner", "outer")
    for race in races:
        if getattr(case, race).kind not in ("rigid", "cam"):
            _require_arc(case.bearing, race)
            _require_apart(case, race)
            if race == "inner":
                _require_inner(case)
            elif case.outer.kind != "step":  # only the opened drawing can tell
                _require_outer(case)
            _require_patches(case, race)


def _require_arc(bearing: Any, race: Race) -> None:
    """Raise where a groove reaches the axis, or the centre of its arc lies beyond."""
    from fem.parts.room import SLENDEREST_SLOT

    diameter, pitch, slope = bearing.ball.diameter, bearing.pitch_diameter, cos(bearing.groove_angle)
    groove: Any = getattr(bearing, race)
    if race == "outer":
        largest = diameter / 2 + (pitch / 2 - SLENDEREST_SLOT) / slope
    else:  # with a shaft below
        room = pitch / 2 - diameter / 2 * slope - 3 * SLENDEREST_SLOT
        largest = room / (1 - slope) if slope < 1 else float("inf")
    if groove.over(diameter) * diameter <= largest:
        return
    if groove.conformity is not None:
        raise impossible(f"bearing.{race}.conformity", f"at most {largest / diameter:.3f} around the axis")
    raise impossible(f"bearing.{race}.radius", f"{at_most(largest)} around the axis")


def _require_apart(case: Any, race: Race) -> None:
    """Raise where grooves of two rows in one ring leave no land between them, or two rings overlap."""
    from fem.parts.room import ROUNDING, closest_rows

    pair = case.bearing.second_row
    if pair is None:
        return
    if case.one_ring(race):
        groove, land = elastic_groove(case, race)
        more = 2 * (closest_rows(groove, land, OUTWARD[race]) - abs(groove.place))
        if more > ROUNDING:
            least = at_least(pair.distance + more)
            raise impossible(
                "bearing.pair.distance", f"{least}, for a land between grooves of one {race} ring"
            )
        return
    outer = case.outer
    room = (
        pair.distance
        + {"back_to_back": 2, "face_to_face": -2, "tandem": 0}[pair.arrangement] * outer.groove_offset
    )
    for name in ("width", "housing_width"):
        if (getattr(outer, name) or 0.0) > room + ROUNDING:
            raise impossible(f"outer.{name}", f"{at_most(room)}, or parts of both rows overlap")


def _require_outer(case: Any) -> None:
    from fem.parts.room import SLENDEREST_SLOT, narrowest_ring

    outer, (groove, land) = case.outer, elastic_groove(case, "outer")
    thickness, width = require(outer, ("thickness", "width"), f'outer.kind = "{outer.kind}"')
    if thickness <= SLENDEREST_SLOT:
        raise impossible("outer.thickness", f"above {in_mm(SLENDEREST_SLOT)}")
    _require_wide("outer", width, narrowest_ring(groove, land, 1, 0.0))
    located("outer", lambda: held_ring.require_teeth_outside(outer, groove.bottom(1) + thickness))
    least = narrowest_ring(groove, land, 1, outer.groove_offset)
    if width < least:
        most = max(abs(outer.groove_offset) - (least - width) / 2, 0.0)
        raise impossible(
            "outer.groove_offset", f"{at_most(most)} to either side, or the groove leaves outer.width"
        )
    if outer.kind == "squirrel_cage":
        height, keys = groove.bottom(1) + thickness - land, "bearing.outer.shoulder and outer.thickness"
        located("outer", lambda: held_ring.require_room_for_bars(outer, 2 * land, height, keys))


def _require_inner(case: Any) -> None:
    from fem.parts.room import SLENDEREST_SLOT, narrowest_ring

    inner, (groove, land) = case.inner, elastic_groove(case, "inner")
    bore, width = require(inner, ("bore", "width"), 'inner.kind = "ring_on_shaft"')
    largest = 2 * (groove.bottom(-1) - SLENDEREST_SLOT)
    if bore > largest:
        raise impossible("inner.bore", f"{at_most(largest)}, under the bottom of the groove")
    _require_wide("inner", width, narrowest_ring(groove, land, -1, 0.0))


def _require_wide(race: Race, width: float, least: float) -> None:
    if width < least:
        raise impossible(f"{race}.width", f"{at_least(least)}: its grooves with a land at each side")


def _require_patches(case: Any, race: Race) -> None:
    """Raise unless patches fit between the bottom of a groove and its shoulder."""
    groove, land = elastic_groove(case, race)
    drawn = race == "outer" and case.outer.kind == "step"
    if drawn and case.bearing.outer.shoulders[1] == 0:
        raise impossible("bearing.outer.open_shoulder", 'above 0 mm for outer.kind = "step"')
    ends = [groove.end(each, OUTWARD[race]) for each in (land, low_land(case.bearing) if drawn else land)]
    require_patches(
        case.accuracy, case.bearing.ball.diameter, groove.radius * sum(ends) / 2,
        ("accuracy", f"bearing.{race}.shoulder"),
        lambda half: at_least(groove.radius * (1 - cos(half / groove.radius))),
    )  # fmt: skip
