"""The section [bearing.fits]: how the rings are mounted, for the operating clearance and the contact."""

from typing import Any, Self

from pydantic import model_validator

from flexbearing.case.quantity import GIVEN, Length, Section, impossible, key, needed
from flexbearing.case.tolerances import HousingClass, Place, ShaftClass

MOUNTED: tuple[dict[str, Any], ...] = (  # the operating clearance follows from the fits
    {"bearing.fits.cold_clearance": GIVEN}, {"bearing.clearance_class": GIVEN}
)  # fmt: skip
IN_HOUSING: dict[str, Any] = {"outer.kind": ("ring",), "outer.support": ("housing",)}
LIFTING_OFF: tuple[dict[str, Any], ...] = (
    {**IN_HOUSING, "bearing.fits.housing": GIVEN}, {**IN_HOUSING, "outer.housing_clearance": GIVEN}
)  # fmt: skip
FITTED: dict[str, Any] = {"inner.kind": ("ring_on_shaft",), "inner.fit": ("frictionless", "friction")}


class Housing(Section):
    """The housing around the outer ring."""

    diameter: Length | None = key(
        "outside diameter of the housing; only with a rigid outer part, else by outer.housing_thickness",
        None,
        example="120 mm",
        gt=0,
    )
    interference: Length | None = key(
        "diametral interference of outer ring and housing, cold; negative is a loose fit; a flexible ring "
        "touches its housing where it is pressed on it, without friction; or by tolerance_class",
        None,
        example="-10 um",
    )
    tolerance_class: HousingClass | None = key(
        "tolerance class of the housing's bore by ISO 286, instead of its interference, which follows with a "
        "bearing of the Normal tolerance class, over 6 mm up to 400 mm outside",
        None,
        example="H7",
    )

    @model_validator(mode="after")
    def _one_interference(self) -> Self:
        if self.interference is None and self.tolerance_class is None:
            raise needed(["interference"], "[bearing.fits.housing] without tolerance_class")
        if self.interference is not None and self.tolerance_class is not None:
            raise impossible("tolerance_class", "left out beside interference; give one of the two")
        return self


class Fits(Section):
    """How the rings are mounted; heat and speed come from [operation]."""

    cold_clearance: Length | None = key(
        "diametral clearance before mounting, at operation.temperatures.reference; instead of "
        "bearing.clearance, which then follows, and of bearing.clearance_class",
        None,
        example="60 um",
    )
    shaft_interference: Length | None = key(
        "diametral interference of shaft and inner ring, cold; negative is a loose fit; this or shaft is "
        "needed for the operating clearance, else 0 for a ring that inner.fit does not bond",
        None,
        example="15 um",
        only=(*MOUNTED, FITTED),
    )
    shaft: ShaftClass | None = key(
        "tolerance class of the shaft by ISO 286, instead of shaft_interference, which follows with a "
        "bearing of the Normal tolerance class; bores over 6 mm up to 250 mm, p7 over 50 mm, r7 over 80 mm",
        None,
        example="k5",
        only=(*MOUNTED, FITTED),
    )
    at: Place = key(
        "where the classes of fits and clearance are taken: in the middle of their tolerances, or at the "
        "ends that leave most or least clearance",
        "mean",
        only=(
            {"bearing.clearance_class": GIVEN},
            {"bearing.fits.shaft": GIVEN},
            {"bearing.fits.housing.tolerance_class": GIVEN},
        ),
    )
    bore: Length | None = key(
        "bore of the inner ring; only with a rigid inner part, else inner.bore",
        None,
        example="45 mm",
        gt=0,
        only=MOUNTED,
    )
    shaft_bore: Length | None = key(
        "bore of the shaft; only with a rigid inner part, without it the shaft is solid",
        None,
        example="20 mm",
        gt=0,
        only=MOUNTED,
    )
    outer_diameter: Length | None = key(
        "outside diameter of the outer ring; only with a rigid outer part, else by outer.thickness",
        None,
        example="85 mm",
        gt=0,
        only=MOUNTED,
    )
    housing: Housing | None = key(
        "the housing; without it a rigid outer ring is free, and a flexible one bonded to its housing",
        None,
        only=(*MOUNTED, IN_HOUSING),
    )

    @model_validator(mode="after")
    def _one_interference(self) -> Self:
        if self.shaft is not None and self.shaft_interference is not None:
            raise impossible("shaft", "left out beside shaft_interference; give one of the two")
        return self
