"""The section [bearing.fits], its parts that all families share, and how warm the parts are."""

from typing import Any, Self

from pydantic import model_validator

from flexbearing.case.quantity import (
    GIVEN,
    Length,
    Section,
    Temperature,
    impossible,
    in_mm,
    key,
    require_one,
)
from flexbearing.case.tolerances import (
    HOUSING,
    SHAFT,
    Band,
    HousingClass,
    Place,
    ShaftClass,
    housing_interference,
    shaft_interference,
    tabulated,
)

FITTED: dict[str, Any] = {"bearing.fits": GIVEN}
HOUSED: dict[str, Any] = {"bearing.fits.housing": GIVEN}
BY_CLASS: tuple[dict[str, Any], ...] = ({SHAFT: GIVEN}, {HOUSING: GIVEN})


class PartTemperatures(Section):
    """Temperatures of the parts; dimensions are given at the reference and grow with the rest."""

    shaft: Temperature = key("of the shaft", gt=0)
    inner_ring: Temperature = key("of the inner ring", gt=0)
    outer_ring: Temperature = key("of the outer ring", gt=0)
    housing: Temperature | None = key(
        "of the housing; needed for [bearing.fits.housing]", None, gt=0, only=HOUSED
    )
    reference: Temperature = key("at which the dimensions are given", gt=0)


class HousingFit(Section):
    """How tight the outer ring is in its housing."""

    interference: Length | None = key(
        "diametral interference of outer ring and housing, cold; negative is a loose fit; an elastic ring of "
        "fast balls touches its housing where it is pressed on it, without friction; or by tolerance_class",
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
        require_one(self, "interference", "tolerance_class", "[bearing.fits.housing] without tolerance_class")
        return self


def shaft_class(only: Any = ()) -> Any:
    """The key of a class of the shaft."""
    return key(
        "tolerance class of the shaft by ISO 286, instead of shaft_interference, which follows with a "
        "bearing of the Normal tolerance class; bores over 6 mm up to 250 mm, p7 over 50 mm, r7 over 80 mm",
        None,
        example="k5",
        only=only,
    )


class Housing(HousingFit):
    """The housing around the outer ring."""

    diameter: Length = key("outside diameter of the housing", example="120 mm", gt=0)


class Fits(Section):
    """How the rings are mounted; they count as plain rings up to their raceways."""

    bore: Length = key("bore of the inner ring", example="40 mm", gt=0)
    outer_diameter: Length = key("outside diameter of the outer ring", example="80 mm", gt=0)
    shaft_bore: Length | None = key(
        "bore of the shaft; without it the shaft is solid", None, example="20 mm", gt=0
    )
    shaft_interference: Length | None = key(
        "diametral interference of shaft and inner ring, cold; negative is a loose fit; or by shaft",
        None,
        example="15 um",
    )
    shaft: ShaftClass | None = shaft_class()
    at: Place = key(
        "where the classes of fits are taken: in the middle of their tolerances, or at the ends that leave "
        "most or least clearance",
        "mean",
        only=BY_CLASS,
    )
    housing: Housing | None = key("the housing; without it the outer ring is free", None)

    @model_validator(mode="after")
    def _one_interference(self) -> Self:
        require_one(self, "shaft_interference", "shaft", "[bearing.fits] without shaft")
        return self

    @model_validator(mode="after")
    def _parts_lie_in_each_other(self) -> Self:
        if self.shaft_bore is not None and self.shaft_bore >= self.bore:
            raise impossible("shaft_bore", f"below {in_mm(self.bore)}, bearing.fits.bore")
        if self.housing and self.housing.diameter <= self.outer_diameter:
            allowed = f"above {in_mm(self.outer_diameter)}, bearing.fits.outer_diameter"
            raise impossible("housing.diameter", allowed)
        return self

    @property
    def bands(self) -> dict[str, Band]:
        """Key of each tolerance class that is given, to the interference it allows [m]."""
        found = {}
        if (shaft := self.shaft) is not None:
            size, owner = self.bore, "bearing.fits.bore"
            found[SHAFT] = tabulated(SHAFT, shaft, lambda bore: shaft_interference(shaft, bore), size, owner)
        if self.housing and (name := self.housing.tolerance_class) is not None:
            size, owner = self.outer_diameter, "bearing.fits.outer_diameter"
            found[HOUSING] = tabulated(
                HOUSING, name, lambda outside: housing_interference(name, outside), size, owner
            )
        return found

    @property
    def interferences(self) -> tuple[float, float | None]:
        """Diametral interferences of the shaft and of the housing, None without one, cold [m]."""
        bands, shaft, housing = self.bands, self.shaft_interference, None
        if self.housing:
            housing = self.housing.interference
        if SHAFT in bands:
            shaft = bands[SHAFT].tight(self.at)
        if HOUSING in bands:
            housing = bands[HOUSING].tight(self.at)
        assert shaft is not None  # checked on reading
        return shaft, housing
