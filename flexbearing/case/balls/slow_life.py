"""What the life of slow balls with two or four contacts is rated with."""

from typing import Literal

from flexbearing.case.quantity import GIVEN, Force, Section, Time, key
from flexbearing.case.ratings import FOLLOWS, RELIABILITY, REQUIRED

OSCILLATES = {"operation.oscillation": GIVEN}
OF_AXIAL_LOAD = (
    "radial: by C_r of ISO 281 for radial bearings; thrust: by C_a, of its thrust bearings; without it "
    "thrust from a contact angle of 45 deg on, as the NREL guideline DG03 rates pitch bearings"
)


class SlowLife(Section):
    """What the life of all arcs is rated with."""

    rating: Literal["radial", "thrust"] | None = key(OF_AXIAL_LOAD, None)
    dynamic_rating: Force | None = key(
        "basic dynamic load rating of a catalogue, C_r or C_a by life.rating, of one diagonal, instead of "
        f"the formula of ISO 281; {FOLLOWS}",
        None,
        example="710 kN",
        gt=0,
    )
    oscillation: Literal["raceways", "DG03"] = key(
        "raceways: damage of each arc by the loads that its places meet, and by how much of it is rolled "
        "over; DG03: life of a turning bearing times the factors of the NREL guideline, as printed",
        "raceways",
        only=OSCILLATES,
    )
    reliability: float | None = key(RELIABILITY, None, example=0.99, ge=0.9, le=0.9995)
    required: Time | None = key(REQUIRED, None, example="20000 h", gt=0)

    @property
    def is_basic(self) -> bool:
        """Whether nothing modifies the basic life."""
        return self.reliability is None

    @property
    def loads(self) -> Literal["balls"]:
        """What the life comes from."""
        return "balls"
