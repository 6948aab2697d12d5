"""The section [bearing.fits]: how the rings are mounted, for the operating clearance and the contact."""

from typing import Any

from flexbearing.case.quantity import GIVEN, Length, Section, key

COLD = {"bearing.fits.cold_clearance": GIVEN}
IN_HOUSING: dict[str, Any] = {"outer.kind": ("ring",), "outer.support": ("housing",)}
LIFTING_OFF: tuple[dict[str, Any], ...] = (
    {**IN_HOUSING, "bearing.fits.housing": GIVEN}, {**IN_HOUSING, "outer.housing_clearance": GIVEN}
)  # fmt: skip
FITTED: dict[str, Any] = {"inner.kind": ("ring_on_shaft",), "inner.fit": ("frictionless", "friction")}


class Housing(Section):
    """The housing around the outer ring."""

    diameter: Length | None = key(
        "outside diameter of the housing; only beside a rigid outer part, else by outer.housing_thickness",
        None,
        example="120 mm",
        gt=0,
    )
    interference: Length = key(
        "diametral interference of outer ring and housing, cold; negative is a loose fit; a flexible ring "
        "touches its housing where it is pressed on it, without friction",
        example="-10 um",
    )


class Fits(Section):
    """How the rings are mounted; heat and speed come from [operation]."""

    cold_clearance: Length | None = key(
        "diametral clearance before mounting, at operation.temperatures.reference; instead of "
        "bearing.clearance, which then follows",
        None,
        example="60 um",
    )
    shaft_interference: Length | None = key(
        "diametral interference of shaft and inner ring, cold; negative is a loose fit; needed with "
        "cold_clearance, else 0 for a ring that inner.fit does not bond",
        None,
        example="15 um",
        only=(COLD, FITTED),
    )
    bore: Length | None = key(
        "bore of the inner ring; only beside a rigid inner part, else inner.bore",
        None,
        example="45 mm",
        gt=0,
        only=COLD,
    )
    shaft_bore: Length | None = key(
        "bore of the shaft; only beside a rigid inner part, without it the shaft is solid",
        None,
        example="20 mm",
        gt=0,
        only=COLD,
    )
    outer_diameter: Length | None = key(
        "outside diameter of the outer ring; only beside a rigid outer part, else by outer.thickness",
        None,
        example="85 mm",
        gt=0,
        only=COLD,
    )
    housing: Housing | None = key(
        "the housing; without it a rigid outer ring is free, and a flexible one bonded to its housing",
        None,
        only=(COLD, IN_HOUSING),
    )
