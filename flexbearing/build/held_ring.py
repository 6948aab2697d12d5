"""What holds a plain outer ring, the same in every family of bearings."""

from typing import Any

import fem


def support(
    outer: Any, housing: fem.Elastic | None, *, hot: float = 1.0, pushing: bool = False
) -> fem.RigidSeat | fem.Foundation | fem.Housing | fem.ClampedFace:
    """Support of a section with the keys of `flexbearing.case.held_ring`.

    Lengths of a housing grow by `hot` with the ring that it is bonded to; springs may only be `pushing`.
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
        case _:
            return fem.ClampedFace()
