"""From a case to the cage between rollers of any shape."""

import quasidynamic as qd
from flexbearing.case.roller.bearing import GuidedCage


def guided_cage(cage: GuidedCage) -> qd.Cage:
    """Cage with its pockets and its land, concentric with it."""
    land = ("land_diameter", "land_width", "land_clearance")
    return qd.Cage(
        guidance=cage.guidance,
        pocket_friction=cage.pocket_friction,
        thickness=cage.thickness,
        land_flow=cage.land_flow,
        **{name: getattr(cage, name) for name in land if getattr(cage, name) is not None},
    )
