"""The section [life] of ball bearings: what their life is rated with, and what modifies it."""

from typing import Literal

from flexbearing.case.quantity import key
from flexbearing.case.ratings import Ratings


class BallLife(Ratings):
    """What the life is rated with, and what modifies it; nothing does unless it is given."""

    loads: Literal["balls", "rating"] = key(
        "balls: life under the loads of all balls, by ISO/TS 16281; rating: as a catalogue has it, from C_r "
        "and the equivalent load P of the radial and the axial load, (C_r/P)^3 of ISO 281",
        "balls",
    )
