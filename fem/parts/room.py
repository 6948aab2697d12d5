"""Room that a mesh takes in a part: the least walls, slots and lands of rings, alike for all of them."""

from fem.parts.groove import Groove
from fem.parts.material import in_mm, require

SLENDEREST_SLOT = 0.3e-3  # [m] the mesher may abort on narrower gaps and thinner walls
SMALLEST_FILLET = 0.1e-3  # [m] smaller ones need too many elements to matter
ROUNDING = 1e-12  # [m] of sums of lengths: a length at its limit is allowed


def narrowest_ring(groove: Groove, land: float, outward: int, offset: float) -> float:
    """Axially narrowest ring [m] around all grooves between lands of a radius, off the ring's middle [m]."""
    return groove.width(land, outward) + 2 * (SLENDEREST_SLOT + abs(groove.place) + abs(offset)) - ROUNDING


def closest_rows(groove: Groove, land: float, outward: int) -> float:
    """Axially closest place of a groove to the middle between two rows that leaves a land there [m]."""
    return (groove.width(land, outward) + SLENDEREST_SLOT) / 2


def places_on_cones(width: float, row_distance: float, offset: float = 0.0) -> tuple[float, float]:
    """Ends of a ring along x from the middle of its conical raceway, or of both mirror images [m]."""
    if not row_distance:
        return -width / 2 - offset, width / 2 - offset
    beyond = (width - row_distance) / 2 + abs(offset)
    return -beyond, beyond


def require_room(groove: Groove, land: float, far: float, outward: int, width: float, offset: float) -> None:
    """Refuse a groove without a wall below its bottom, or without lands at its sides [m]."""
    wall, least = outward * (far - groove.bottom(outward)), narrowest_ring(groove, land, outward, offset)
    require(
        wall > SLENDEREST_SLOT - ROUNDING, "groove.radius", in_mm(groove.radius),
        f"one that leaves a wall above {in_mm(SLENDEREST_SLOT)}",
    )  # fmt: skip
    closest = closest_rows(groove, land, outward)
    require(
        not groove.place or abs(groove.place) >= closest - ROUNDING, "groove.place", in_mm(groove.place),
        f"{in_mm(closest)} from the middle between both rows, or more, for a land between their grooves",
    )  # fmt: skip
    aside = f" {in_mm(abs(offset))} off its middle" if offset else ""
    require(
        width >= least, "width", in_mm(width),
        f"at least {in_mm(least)}, with the lands of its groove{aside}",
    )  # fmt: skip


def require_inside(offset: float, width: float) -> None:
    """Refuse a raceway whose middle lies beyond an end face; `require_on_track` sees to its length."""
    require(
        abs(offset) < width / 2,
        "raceway_offset",
        in_mm(offset),
        f"below half of the width, {in_mm(width / 2)}",
    )
