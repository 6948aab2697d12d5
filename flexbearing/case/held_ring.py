"""Keys of a plain outer ring and of what holds it, the same in every family of bearings."""

from typing import Any

from flexbearing.case.quantity import impossible, in_mm, key, require

RING = {"kind": ("ring",)}
CAGE = {"kind": ("squirrel_cage",)}
ON_SHAFT = {"kind": ("ring_on_shaft",)}


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


def require_bars(ring: Any, thickness: float) -> None:
    """Raise unless a cage on a ring of some thickness [m] is described."""
    names = ("bars", "bar_width", "bar_thickness", "bar_length", "flange_length")
    _, _, bar_thickness, _, _ = require(ring, names, 'outer.kind = "squirrel_cage"')
    if bar_thickness >= thickness:
        allowed = f"below {in_mm(thickness)}, outer.thickness: the raceway ends before the bars"
        raise impossible("bar_thickness", allowed)


def require_slots(ring: Any, raceway_diameter: float, thickness: float) -> None:
    """Raise unless the bars of a cage do not touch."""
    from fem.parts.rings import widest_bar  # only a cage needs them

    bars, bar_width, bar_thickness = require(ring, ("bars", "bar_width", "bar_thickness"), ring.kind)
    widest = widest_bar(bars, (raceway_diameter + thickness - bar_thickness) / 2)
    if bar_width > widest:
        raise impossible("bar_width", f"at most {widest * 1e3:.4g} mm, or the bars touch")


def require_support(ring: Any) -> None:
    """Raise unless springs or a housing are described where they hold a ring."""
    if ring.support == "foundation" and not (ring.foundation_radial or ring.foundation_tangential):
        raise impossible("foundation_radial", "above zero, or nothing holds the ring")
    if ring.support == "housing":
        require(ring, ("housing_thickness", "housing_width"), 'outer.support = "housing"')
