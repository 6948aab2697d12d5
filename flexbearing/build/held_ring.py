"""What holds a plain outer ring, the same in every family of bearings."""

from typing import Any

import fem
from fem.parts.boundary_conditions import Support


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
            teeth = zip(outer.tooth_azimuths, outer.tooth_radial, outer.tooth_tangential, strict=True)
            return fem.PlanetGear(
                forces=tuple(fem.LineForce(azimuth=a, radial=r, tangential=t) for a, r, t in teeth),
                radius=outer.tooth_radius and outer.tooth_radius * hot,
            )
        case _:
            return fem.ClampedFace()
