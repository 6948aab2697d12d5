"""Room of the cage of a roller bearing between its rings, by the dimensions of a case."""

from typing import Any

_MILLIMETRES = 1e3


def cage_radii(case: Any) -> tuple[float, float]:
    """Inside and outside radius of the cage [m]: at its land, or about the pitch circle."""
    bearing: Any = case.bearing
    cage: Any = bearing.cage
    if cage.guidance == "outer":
        high = (cage.land_diameter - cage.land_clearance) / 2
        return high - cage.thickness, high
    if cage.guidance == "inner":
        low = (cage.land_diameter + cage.land_clearance) / 2
        return low, low + cage.thickness
    pitch = (bearing.outer_raceway_diameter - bearing.roller.diameter) / 2
    return pitch - cage.thickness / 2, pitch + cage.thickness / 2


def overlap(case: Any) -> str:
    """Where the cage lies within the ribs of the inner ring, in words; empty where it does not."""
    ring: Any = case.inner
    if ring.kind == "rigid" or not ring.ribbed or not case.bearing.cage.thickness:
        return ""
    inside, rib = cage_radii(case)[0], ring.bore / 2 + ring.thickness
    end = case.bearing.roller.length / 2 + (case.bearing.cage.land_width or 0.0) / 2
    if inside >= rib or end <= ring.track_width / 2:
        return ""
    return f"cage inside Ø {2 * _MILLIMETRES * inside:.6g} mm, inner ribs Ø {2 * _MILLIMETRES * rib:.6g} mm"
