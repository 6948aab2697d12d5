"""Keys of the land that guides a cage, the same in every family of bearings."""

from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case.quantity import Length, Section, key, require

_LAND = {"guidance": ("outer", "inner")}


class CageOnLand(Section):
    """What guides a cage."""

    guidance: str = key("what the cage runs on")
    land_diameter: Length | None = key(
        "diameter of the guiding land, between the pitch circle and the raceway of the ring that guides",
        None,
        example="60 mm",
        gt=0,
        only=_LAND,
    )
    land_width: Length | None = key("width of the guiding land, both sides together", None, gt=0, only=_LAND)
    land_clearance: Length | None = key(
        "diametral clearance at the guiding land", None, example="0.4 mm", gt=0, only=_LAND
    )
    land_flow: Literal["laminar", "vortices"] = key(
        "flow of the oil in the land: laminar, or with Taylor vortices and turbulence", "laminar", only=_LAND
    )

    @model_validator(mode="after")
    def _land(self) -> Self:
        if self.guidance in _LAND["guidance"]:
            names = ("land_diameter", "land_width", "land_clearance")
            require(self, names, f'guidance = "{self.guidance}"')
        return self
