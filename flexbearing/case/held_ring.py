"""Keys of a plain outer ring and of what holds it, the same in every family of bearings."""

from typing import Any

from flexbearing.case.quantity import at_least, at_most, impossible, in_mm, key, require

RING = {"kind": ("ring",)}
CAGE = {"kind": ("squirrel_cage",)}
ON_SHAFT = {"kind": ("ring_on_shaft",)}
BARS = ("bars", "bar_width", "bar_thickness", "bar_length", "flange_length")


def _held(support: str) -> dict[str, tuple[str, ...]]:
    return {**RING, "support": (support,)}


def foundation_radial() -> Any:
    """Radial springs."""
    return key("springs per area on the outer surface, radial", "0 N/mm^3", ge=0, only=_held("foundation"))


def foundation(direction: str) -> Any:
    """Springs in another direction."""
    return key(f"the same, {direction}", "0 N/mm^3", ge=0, only=_held("foundation"))


def housing_thickness() -> Any:
    """Radial thickness."""
    return key("radial thickness of the housing", None, gt=0, only=_held("housing"))


def housing_width() -> Any:
    """Axial width."""
    return key("axial width of the housing", None, gt=0, only=_held("housing"))


def housing_support() -> Any:
    """Seat or side."""
    return key(
        "what holds the housing: a rigid seat on its outer surface, or its side face",
        "seat",
        only=_held("housing"),
    )


def shaft_thickness() -> Any:
    """Radial thickness."""
    return key("radial thickness of a hollow shaft; without it the shaft is solid", None, gt=0, only=ON_SHAFT)


def shaft_length() -> Any:
    """Length between the clamps."""
    return key("length of the shaft between its clamped ends", None, example="40 mm", gt=0, only=ON_SHAFT)


def bars() -> Any:
    """How many there are."""
    return key("number of bars", None, example=24, ge=1, le=200, only=CAGE)


def bar_thickness(place: str) -> Any:
    """Radial thickness of bars, centred on a place."""
    return of_cage(f"radial thickness of a bar, centred {place}")


def of_cage(words: str) -> Any:
    """A length of bars or flange."""
    return key(words, None, gt=0, only=CAGE)


def bar_ends() -> Any:
    """One or both."""
    return key(
        "ends of the ring at which there are bars, with their flange: that at +x, or both alike",
        "one",
        only=CAGE,
    )


def require_bars(ring: Any) -> list[Any]:
    """Return the values of `BARS`; raises when some are not given."""
    return require(ring, BARS, 'outer.kind = "squirrel_cage"')


def require_room_for_bars(ring: Any, inner_diameter: float, thickness: float, keys: str) -> None:
    """Raise unless bars fit into a ring of an inner diameter and a thickness [m], which `keys` give."""
    from fem.parts.rings import SLENDEREST_SLOT, most_bars, thickest_bar, widest_bar  # only a cage needs them

    bars, bar_width, bar_thickness, *_ = require_bars(ring)
    thickest = thickest_bar(thickness)
    if thickest <= 0:
        raise impossible("thickness", f"above {in_mm(thickness - thickest)}, or the bars end the ring")
    if bar_thickness > thickest:
        allowed = f"{at_most(thickest)}: bars are inside the {in_mm(thickness)} of {keys}"
        raise impossible("bar_thickness", allowed)
    inside = (inner_diameter + thickness - bar_thickness) / 2
    if bars > (most := most_bars(inside)):
        raise impossible("bars", f"at most {most}, with slots of {in_mm(SLENDEREST_SLOT)} between them")
    if bar_width > (widest := widest_bar(bars, inside)):
        slots = f"which leaves {bars} slots of {in_mm(SLENDEREST_SLOT)}"
        raise impossible("bar_width", f"{at_most(widest)}, {slots}")


def require_support(ring: Any) -> None:
    """Raise unless springs or a housing are described where they hold a ring."""
    if ring.support == "foundation" and not (ring.foundation_radial or ring.foundation_tangential):
        raise impossible("foundation_radial", "above zero, or nothing holds the ring")
    if ring.support == "housing":
        require(ring, ("housing_thickness", "housing_width"), 'outer.support = "housing"')


def require_shaft(ring: Any) -> None:
    """Raise unless a shaft below a ring has a wall, and reaches beyond the ring."""
    from fem.parts.rings import ROUNDING, SLENDEREST_SLOT  # only a shaft needs them

    bore, width, length = require(ring, ("bore", "width", "shaft_length"), 'inner.kind = "ring_on_shaft"')
    wall = ring.shaft_thickness
    if bore < 2 * SLENDEREST_SLOT:
        raise impossible("bore", at_least(2 * SLENDEREST_SLOT))
    if wall is not None and not SLENDEREST_SLOT <= wall <= bore / 2:
        allowed = f"{at_least(SLENDEREST_SLOT)} and {at_most(bore / 2)}, half of inner.bore: a solid shaft"
        raise impossible("shaft_thickness", allowed)
    shortest = width + 2 * SLENDEREST_SLOT - ROUNDING
    if length < shortest:
        beside = f"inner.width and {in_mm(SLENDEREST_SLOT)} at each end"
        raise impossible("shaft_length", f"{at_least(shortest)}, {beside}")
