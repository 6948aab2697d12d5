"""The section [life]: what modifies the basic life."""

from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case.quantity import Force, key, require
from flexbearing.case.ratings import FOLLOWS, Ratings

FEWEST_SLICES = 30  # of ISO/TS 16281, for the edge stress
BY_RATING = {"loads": ("rating",)}


class Life(Ratings):
    """What modifies the basic life; nothing does unless it is given."""

    capacity: Literal["lundberg-palmgren", "iso281"] = key(
        "capacity of the raceways: of Lundberg and Palmgren, or from C_r of ISO 281 as in ISO/TS 16281",
        "lundberg-palmgren",
    )
    loads: Literal["rollers", "rating"] = key(
        "rollers: life under the loads of all rollers, as in ISO/TS 16281; rating: as a catalogue has it, "
        "from the radial load P and C_r, (C_r/P)^(10/3) of ISO 281",
        "rollers",
    )
    load_exponent: Literal["10/3", "4"] = key(
        "10/3 of ISO 281, or 4, for line contacts along the whole roller", "10/3", only=BY_RATING
    )
    stress_reduction: bool = key(
        "whether C_r keeps the factor lambda nu = 0.83 of ISO 281 for uneven load along the rollers; ISO/TS "
        "16281 removes it, as it computes the load of each slice",
        True,
        only=BY_RATING,
    )
    dynamic_rating: Force | None = key(
        f"basic dynamic radial load rating C_r of a catalogue, instead of the formula of ISO 281; {FOLLOWS}; "
        'for capacity = "iso281", loads = "rating", lubrication = "a_ISO" and `flexbearing life`',
        None,
        example="44 kN",
        gt=0,
    )
    edge_stress: bool = key(
        "whether the ends of profiled rollers carry the edge stress of ISO/TS 16281", False
    )
    roller_body: bool = key("whether rollers fail as well as raceways", False)
    steel: Literal["52100", "M50", "M50NiL"] | None = key("steel of the bearing, with life.melting", None)
    melting: Literal["air", "CVD", "VAR", "VAR-VAR", "VIM-VAR"] | None = key(
        "how the steel was molten, with life.steel", None
    )
    lubrication: Literal["film", "a_ISO"] | None = key(
        "film: factor of the film over the roughness; a_ISO: factor of ISO 281 by viscosity and cleanliness",
        None,
    )

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if self.steel:
            require(self, ("melting",), "life.steel")
        if self.melting:
            require(self, ("steel",), "life.melting")
        return self
