"""What lives of any bearing are rated with: ratings of a catalogue, reliability, cleanliness of the oil."""

from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case.quantity import Force, Section, Time, impossible, key, require

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


class Ratings(Section):
    """Ratings of a catalogue, and factors of ISO 281."""

    dynamic_rating: Force | None = key(
        f"basic dynamic radial load rating C_r of a catalogue, instead of the formula of ISO 281; {FOLLOWS}",
        None,
        example="44 kN",
        gt=0,
    )
    static_rating: Force | None = key(
        f"basic static radial load rating C_0 of a catalogue, instead of the formula of ISO 76; {FOLLOWS}",
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
    reliability: float | None = key("probability of survival", None, example=0.99, ge=0.9, le=0.9995)
    lubrication: Literal["a_ISO"] | None = key("a_ISO: factor of ISO 281 by viscosity and cleanliness", None)
    cleanliness: CleanlinessName | None = key('cleanliness by ISO 281, lubrication = "a_ISO"', None)
    required: Time | None = key(
        "required life, by which the most detailed life of the case is judged: the modified one where it has "
        "factors of oil, steel or reliability. For one of ISO 281 (L10h) see the catalogue's life",
        None,
        example="20000 h",
        gt=0,
    )

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
