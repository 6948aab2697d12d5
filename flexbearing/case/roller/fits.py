"""The section [bearing.fits]: from the cold clearance to the operating one."""

from flexbearing.case.quantity import Length, Section, key


class Housing(Section):
    """The housing around the outer ring."""

    diameter: Length = key("outside diameter of the housing", example="120 mm", gt=0)
    interference: Length = key(
        "diametral interference of outer ring and housing, cold; negative is a loose fit", example="-10 um"
    )


class Fits(Section):
    """How the rings are mounted; heat and speed come from [operation]."""

    cold_clearance: Length = key(
        "diametral clearance before mounting, at operation.temperatures.reference", example="60 um"
    )
    shaft_interference: Length = key(
        "diametral interference of shaft and inner ring, cold; negative is a loose fit", example="15 um"
    )
    bore: Length | None = key(
        "bore of the inner ring; only beside a rigid inner part, else inner.bore", None, example="45 mm", gt=0
    )
    shaft_bore: Length | None = key(
        "bore of the shaft; only beside a rigid inner part, without it the shaft is solid",
        None,
        example="20 mm",
        gt=0,
    )
    outer_diameter: Length | None = key(
        "outside diameter of the outer ring; only beside a rigid outer part, else by outer.thickness",
        None,
        example="85 mm",
        gt=0,
    )
    housing: Housing | None = key("the housing; without it the outer ring is free", None)
