"""The cage of fast balls in oil."""

from math import pi
from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case.quantity import Length, Section, impossible, key, require

LAND = {"guidance": ("outer", "inner")}


class BallCage(Section):
    """The cage: concentric, with round pockets."""

    guidance: Literal["outer", "inner", "balls"] = key("what the cage runs on: a ring's land or the balls")
    pocket_clearance: Length = key(
        "from a centred ball to the wall of its pocket, half the difference of the diameters",
        example="0.15 mm",
        gt=0,
    )
    pocket_friction: float = key("Coulomb friction between ball and pocket", example=0.05, ge=0, le=1)
    land_diameter: Length | None = key(
        "diameter of the guiding land, between the pitch circle and the groove of the ring that guides",
        None,
        example="60 mm",
        gt=0,
        only=LAND,
    )
    land_width: Length | None = key("width of the guiding land, both sides together", None, gt=0, only=LAND)
    land_clearance: Length | None = key(
        "diametral clearance at the guiding land", None, example="0.4 mm", gt=0, only=LAND
    )
    land_flow: Literal["laminar", "vortices"] = key(
        "flow of the oil in the land: laminar, or with Taylor vortices and turbulence", "laminar", only=LAND
    )

    @model_validator(mode="after")
    def _land(self) -> Self:
        if self.guidance != "balls":
            names = ("land_diameter", "land_width", "land_clearance")
            require(self, names, f'guidance = "{self.guidance}"')
        return self

    def require_room(self, pitch: float, diameter: float, balls: int) -> None:
        """Raise where pockets are wider than the place between balls, or a land is not beside them [m]."""
        gap = pi * pitch / balls - diameter
        if 2 * self.pocket_clearance >= gap:
            allowed = f"below {5e2 * gap:.4g} mm, half the gap between balls"
            raise impossible("cage.pocket_clearance", allowed)
        if self.land_diameter is None or self.land_clearance is None:
            return
        if self.land_clearance >= diameter:
            most = f"below {1e3 * diameter:.4g} mm, bearing.ball.diameter; is the unit right?"
            raise impossible("cage.land_clearance", most)
        ends = {"outer": (pitch, pitch + diameter), "inner": (pitch - diameter, pitch)}[self.guidance]
        if not ends[0] <= self.land_diameter <= ends[1]:
            allowed = f"between {1e3 * ends[0]:.4g} and {1e3 * ends[1]:.4g} mm, beside the balls"
            raise impossible("cage.land_diameter", allowed)
