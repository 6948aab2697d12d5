"""What holds a plain outer ring, the same in every family of bearings."""

import math
from typing import Any

import fem
from fem.parts.boundary_conditions import Support

PARALLEL = 1e-9  # [rad] between directions that are taken as one


def support(outer: Any, housing: fem.Elastic | None, *, hot: float = 1.0, pushing: bool = False) -> Support:
    """Support of a section with the keys of `flexbearing.case.held_ring`.

    Lengths of a housing and of teeth grow by `hot` with the ring; springs may only be `pushing`.
    """
    match outer.support:
        case "seat":
            return fem.RigidSeat()
        case "foundation":
            return fem.Foundation(
                axial=outer.foundation_axial,
                radial=outer.foundation_radial,
                tangential=outer.foundation_tangential,
                pushing=pushing,
            )
        case "housing":
            assert housing  # checked on reading
            return fem.Housing(
                thickness=outer.housing_thickness * hot,
                width=outer.housing_width * hot,
                elastic=housing,
                support=fem.RigidSeat() if outer.housing_support == "seat" else fem.ClampedFace(),
            )
        case "lines":
            return fem.LineSupports(azimuths=outer.line_azimuths, pushing=not outer.bilateral)
        case "planet":
            axial = getattr(outer, "tooth_axial", ()) or (0.0,) * len(outer.tooth_azimuths)
            parts = outer.tooth_azimuths, outer.tooth_radial, outer.tooth_tangential, axial
            return fem.PlanetGear(
                forces=tuple(
                    fem.LineForce(azimuth=a, radial=r, tangential=t, axial=x)
                    for a, r, t, x in zip(*parts, strict=True)
                ),
                radius=outer.tooth_radius and outer.tooth_radius * hot,
            )
        case _:
            return fem.ClampedFace()


def require_held_on_lines(outer: Any, load: complex) -> None:
    """Refuse lines that would have to pull to hold a load [N] along z + i y.

    Raises `ImpossiblePart` when no pushes of the lines add up to the load.
    """
    on_lines = outer.kind == "ring" and outer.support == "lines" and not outer.bilateral
    if not on_lines or load == 0:
        return
    direction = math.atan2(load.imag, load.real) % (2 * math.pi)
    ahead = [(azimuth - direction) % (2 * math.pi) for azimuth in outer.line_azimuths]
    behind = [-angle % (2 * math.pi) for angle in ahead]
    if min(ahead) + min(behind) < math.pi - PARALLEL or min(min(ahead), min(behind)) < PARALLEL:
        return
    lines = ", ".join(f"{math.degrees(azimuth):.4g}" for azimuth in outer.line_azimuths)
    raise fem.ImpossiblePart(
        f"outer.line_azimuths = {lines} deg: lines that only push do not hold a load towards "
        f"{math.degrees(direction):.4g} deg; allowed are lines on both sides of it, less than "
        "180 deg apart, or outer.bilateral = true where they can pull"
    )
