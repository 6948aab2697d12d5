"""A second row of the same balls or rollers on the same rings, as a case."""

from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case.quantity import Force, Length, Section, impossible, in_mm, key, needed

PRELOADED = {"arrangement": ("back_to_back", "face_to_face")}


class Pair(Section):
    """A second row: of a pair of bearings, or of a double-row bearing."""

    arrangement: Literal["back_to_back", "face_to_face", "tandem"] = key(
        "contact lines of both rows: towards the shaft apart from each other (O, DB), towards each other (X, "
        "DF), or parallel (DT)"
    )
    distance: Length = key(
        "between the planes of the balls, or of the roller centres, of both rows; moments of operation.load "
        "act about their middle; 0 of crossed rollers, which alternate on one circle",
        example="20 mm",
        ge=0,
    )
    preload: Force | None = key(
        "axial force by which the rows press each other at rest, before mounting and without a load; it "
        "changes in operation",
        None,
        example="140 N",
        gt=0,
        only=PRELOADED,
    )
    offset: Length | None = key(
        "by how much the raceways of each row are closer, axially, than where all balls or rollers just "
        "touch, instead of preload; negative is play, half that of the pair",
        None,
        example="5 um",
        only=PRELOADED,
    )

    @property
    def opposed(self) -> bool:
        """Whether the rows press each other."""
        return self.arrangement != "tandem"

    def require_apart(self, least: float, what: str) -> None:
        """Raise unless rows are as far apart as the `least` size [m] of what they have."""
        if self.distance < least:
            raise impossible("bearing.pair.distance", f"at least {what}, {in_mm(least)}")

    @model_validator(mode="after")
    def _one_of_both(self) -> Self:
        if self.opposed and self.preload is None and self.offset is None:
            raise needed(["preload"], f'arrangement = "{self.arrangement}" without offset')
        if self.preload is not None and self.offset is not None:
            raise impossible("offset", "left out beside preload; give one of the two")
        return self
