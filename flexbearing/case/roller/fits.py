"""The section [bearing.fits]: how the rings are mounted, for the operating clearance and the contact."""

from typing import Any, Self

from pydantic import model_validator

from flexbearing.case.fits import HousingFit, shaft_class
from flexbearing.case.quantity import GIVEN, Length, Section, key, require_one
from flexbearing.case.tolerances import Place, ShaftClass

MOUNTED: tuple[dict[str, Any], ...] = (  # the operating clearance follows from the fits
    {"bearing.fits.cold_clearance": GIVEN}, {"bearing.clearance_class": GIVEN}
)  # fmt: skip
IN_HOUSING: dict[str, Any] = {"outer.kind": ("ring",), "outer.support": ("housing",)}
LIFTING_OFF: tuple[dict[str, Any], ...] = (
    {**IN_HOUSING, "bearing.fits.housing": GIVEN}, {**IN_HOUSING, "outer.housing_clearance": GIVEN}
)  # fmt: skip
FITTED: dict[str, Any] = {"inner.kind": ("ring_on_shaft",), "inner.fit": ("frictionless", "friction")}


class Housing(HousingFit):
    """The housing around the outer ring."""

    diameter: Length | None = key(
        "outside diameter of the housing; only with a rigid outer part, else by outer.housing_thickness",
        None,
        example="120 mm",
        gt=0,
    )


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
    shaft: ShaftClass | None = shaft_class((*MOUNTED, FITTED))
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
        "the housing, which a flexible ring touches where it is pressed on it, without friction; without it "
        "a rigid outer ring is free, and a flexible one bonded to its housing",
        None,
        only=(*MOUNTED, IN_HOUSING),
    )

    @model_validator(mode="after")
    def _one_interference(self) -> Self:
        require_one(self, "shaft_interference", "shaft", "")
        return self
