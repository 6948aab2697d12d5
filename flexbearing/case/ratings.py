"""What lives of any bearing are rated with: ratings of a catalogue, reliability, cleanliness of the oil."""

from typing import Any, Literal, Self

from pydantic import model_validator

from flexbearing.case.quantity import Force, Section, Time, impossible, key, needed, require

CleanlinessName = Literal[
    "oil, in-line filter, -/13/10",
    "oil, in-line filter, -/15/12",
    "oil, in-line filter, -/17/14",
    "oil, in-line filter, -/19/16",
    "oil, no or off-line filter, -/13/10",
    "oil, no or off-line filter, -/15/12",
    "oil, no or off-line filter, -/17/14",
    "oil, no or off-line filter, -/19/16",
    "oil, no or off-line filter, -/21/18",
    "grease, high cleanliness",
    "grease, normal cleanliness",
    "grease, slight to typical contamination",
    "grease, severe contamination",
    "grease, very severe contamination",
]
OF_CATALOGUE = ("dynamic_rating", "static_rating", "fatigue_limit_load")
MODIFYING_NOTHING = {*OF_CATALOGUE, "required"}
FOLLOWS = "it follows the formula where settings change sizes of the bearing in the file"
RELIABILITY = "probability of survival"
REQUIRED = (
    "required life, by which the most detailed life of the case is judged: the modified one where it has "
    "factors of oil, steel or reliability. For one of ISO 281 (L10h) see the catalogue's life"
)
FEWEST_SLICES = 30  # of ISO/TS 16281, for the edge stress
BY_RATING = {"loads": ("rating",)}
BY_OIL = {"lubrication": ("a_ISO",)}
OF_PARTS = (
    "whether a_ISO is that of the reference load of the bearing, or of each {} by its own, as a public "
    "program states ISO 16281:2025"
)


class Ratings(Section):
    """Ratings of a catalogue, and factors of ISO 281."""

    dynamic_rating: Force | None = key(
        f"basic dynamic load rating of a catalogue, C_r or C_a of thrust bearings, instead of the formula of "
        f"ISO 281; {FOLLOWS}",
        None,
        example="44 kN",
        gt=0,
    )
    static_rating: Force | None = key(
        f"basic static load rating C_0 of a catalogue, instead of the formula of ISO 76; {FOLLOWS}",
        None,
        example="45 kN",
        gt=0,
    )
    fatigue_limit_load: Force | None = key(
        f"fatigue load limit C_u of a catalogue, instead of that of ISO 281 from C_0; {FOLLOWS}",
        None,
        example="5.5 kN",
        gt=0,
    )
    reliability: float | None = key(RELIABILITY, None, example=0.99, ge=0.9, le=0.9995)
    lubrication: Literal["a_ISO"] | None = key("a_ISO: factor of ISO 281 by viscosity and cleanliness", None)
    cleanliness: CleanlinessName | None = key('cleanliness by ISO 281, lubrication = "a_ISO"', None)
    required: Time | None = key(REQUIRED, None, example="20000 h", gt=0)

    @property
    def is_basic(self) -> bool:
        """Whether nothing modifies the basic life."""
        return not self.model_dump(exclude_defaults=True, exclude=MODIFYING_NOTHING)

    @model_validator(mode="after")
    def _clean_enough_to_rate(self) -> Self:
        if self.lubrication == "a_ISO":
            require(self, ("cleanliness",), 'lubrication = "a_ISO"')
        elif self.cleanliness:
            raise impossible("cleanliness", 'left out without life.lubrication = "a_ISO"')
        return self


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
    modification: Literal["bearing", "slices"] = key(OF_PARTS.format("slice"), "slices", only=BY_OIL)

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if self.steel:
            require(self, ("melting",), "life.steel")
        if self.melting:
            require(self, ("steel",), "life.melting")
        return self


class BallLife(Ratings):
    """What the life is rated with, and what modifies it; nothing does unless it is given."""

    loads: Literal["balls", "rating"] = key(
        "balls: life under the loads of all balls, by ISO/TS 16281; rating: as a catalogue has it, from C_r "
        "and the equivalent load P of the radial and the axial load, (C_r/P)^3 of ISO 281",
        "balls",
    )
    modification: Literal["bearing", "rows"] = key(OF_PARTS.format("row"), "bearing", only=BY_OIL)


class RollerLife(Ratings):
    """What the life is rated with, and what modifies it; nothing does unless it is given."""

    loads: Literal["rollers", "rating"] = key(
        "rollers: life under the loads of all slices, by ISO/TS 16281; rating: as a catalogue has it, from "
        "C_r and the equivalent load P of the radial and the axial load, (C_r/P)^(10/3) of ISO 281; of "
        "thrust bearings from C_a and the axial load",
        "rollers",
    )


class TaperedLife(RollerLife):
    """What the life is rated with, and what modifies it; nothing does unless it is given."""

    modification: Literal["bearing", "slices"] = key(OF_PARTS.format("slice"), "slices", only=BY_OIL)


def require_ratable(life: Any, operation: Any, lubricant: Section | None) -> None:
    """Raise unless oil, speeds and forces are known that a life of balls or tapered rollers needs."""
    if life.lubrication and lubricant is None:
        raise needed(["lubricant"], 'life.lubrication = "a_ISO"')
    timed = life.required is not None or not life.is_basic
    if timed and operation.inner_speed == operation.outer_speed:
        raise impossible("operation.inner_speed", "another one than operation.outer_speed for a life")
    if life.loads == "rating":
        for name in operation.held:
            raise impossible(f"operation.{name}", 'left out for life.loads = "rating"; give a force')
        if not any(operation.forces):
            raise impossible("operation.load", 'some force for life.loads = "rating"')
