"""The section [bearing.flange]: what guides the rollers axially."""

from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case.quantity import Length, Section, Stiffness, impossible, key


class Flange(Section):
    """Guide flanges at both ends of the rollers; the skew of the rollers follows from them."""

    ring: Literal["inner", "outer"] = key("ring that carries the flanges")
    clearance: Length = key(
        "operating axial clearance of a roller between the flanges, both ends together",
        example="30 um",
        gt=0,
    )
    height: Length = key("height of the flanges above the raceway", example="2 mm", gt=0)
    roller_chamfer: Length = key("radial size of the chamfer at a roller's ends", example="0.4 mm", ge=0)
    stiffness: Stiffness = key("of a corner of a roller's end against a flange", gt=0)
    friction: float = key("Coulomb friction of a roller's end on a flange", example=0.05, ge=0, le=1)

    @model_validator(mode="after")
    def _meets_the_ends(self) -> Self:
        if self.height <= self.roller_chamfer:
            raise impossible("height", "above bearing.flange.roller_chamfer")
        return self
