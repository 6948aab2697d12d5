"""Bearings whose plain rings may sit on a shaft and in a housing, as cases: fits, materials that grow."""

from abc import abstractmethod
from typing import Any, Self

from pydantic import model_validator

from flexbearing.case.fits import FITTED, HOUSED, Fits
from flexbearing.case.head import Head
from flexbearing.case.materials import EXPANSION, Elastic, HeavyElastic
from flexbearing.case.quantity import Density, PerTemperature, Section, key, needed
from flexbearing.case.tolerances import Band, Place

STEEL = "11.9e-6 1/K"


def _expansion() -> Any:
    """The key of a thermal expansion."""
    return key(EXPANSION, None, example=STEEL, ge=-1e-3, le=1e-3)


def shaft_material() -> Any:
    """The key of a shaft below an inner ring that may be elastic."""
    needs = "of the shaft; needed for [bearing.fits] and for an elastic inner ring"
    return key(needs, None, only=(FITTED, {"inner.kind": ("ring_on_shaft",)}))


def housing_material() -> Any:
    """The key of a housing around an outer ring that may be elastic."""
    needs = "of the housing; needed for [bearing.fits.housing] and for an elastic housing"
    return key(needs, None, only=(HOUSED, {"outer.kind": ("ring",), "outer.support": ("housing",)}))


class WarmMaterial(HeavyElastic):
    """A material of a part that may be warm."""

    expansion: PerTemperature | None = _expansion()


class GrowingElastic(Elastic):
    """A material of a part that fits and heat may widen."""

    density: Density | None = key("density; needed with [bearing.fits]", None, gt=0)
    expansion: PerTemperature | None = _expansion()


class FittedBearing(Section):
    """A bearing that may sit on a shaft and in a housing."""

    fits: Fits | None = key(
        "how the rings are mounted, which changes the clearance and with it the contact angle", None
    )

    @property
    def bands(self) -> dict[str, Band]:
        """Key of each class that is given, to what it allows [m]."""
        return {} if self.fits is None else self.fits.bands

    @property
    def mounting(self) -> Fits | None:
        """The fits from which the operating clearance follows; None where there are none."""
        return self.fits

    @property
    @abstractmethod
    def stated_clearance(self) -> float:
        """Radial clearance before mounting, or in operation where no fits are given [m]."""

    @abstractmethod
    def require_walls(self, fits: Fits) -> None:
        """Raise unless both rings have a wall at their raceways."""


class FittedCase(Head):
    """A bearing whose operating clearance may follow from its fits."""

    bearing: FittedBearing = key("the bearing")
    materials: Section = key("the materials")

    @property
    def bands(self) -> dict[str, Band]:
        """Key of each class of clearance and fits that the case names, to what it allows [m]."""
        return self.bearing.bands

    @property
    def place(self) -> Place:
        """Where the classes are taken within their tolerances."""
        return self.bearing.fits.at if self.bearing.fits else "mean"

    @property
    def stated_clearance(self) -> float:
        """Radial clearance before mounting, or in operation where no fits are given [m]."""
        return self.bearing.stated_clearance

    @property
    def shaft_interference(self) -> float:
        """Diametral interference of shaft and inner ring, cold [m]."""
        assert self.bearing.fits  # or nobody asks
        return self.bearing.fits.interferences[0]

    @property
    def housing_interference(self) -> float | None:
        """Diametral interference of outer ring and housing, cold [m]; None without a housing."""
        return self.bearing.fits.interferences[1] if self.bearing.fits else None

    def require_ring_materials(self, housing: bool, shaft: bool) -> None:
        """Raise unless the elastic housing and the elastic shaft of a case are of known materials."""
        materials = dict(self.materials)
        if housing and materials["housing"] is None:
            raise needed(["materials.housing"], 'outer.support = "housing"')
        if shaft and materials["shaft"] is None:
            raise needed(["materials.shaft"], 'inner.kind = "ring_on_shaft"')

    def within_tolerances(self, place: Place) -> Self:
        """The same case with its classes taken at another place within their tolerances."""
        fits = self.bearing.fits and self.bearing.fits.model_copy(update={"at": place})
        return self.model_copy(update={"bearing": self.bearing.model_copy(update={"fits": fits})})

    @model_validator(mode="after")
    def _mounting_is_complete(self) -> Self:
        _ = self.bands  # which are all tabulated
        fits, materials = self.bearing.fits, dict(self.materials)
        if fits is None:
            return self
        if materials["shaft"] is None:
            raise needed(["materials.shaft"], "[bearing.fits]")
        if fits.housing and materials["housing"] is None:
            raise needed(["materials.housing"], "[bearing.fits.housing]")
        self.bearing.require_walls(fits)
        return self


def require_growing(fits: Fits, materials: Section, temperatures: Any, element: str) -> None:
    """Raise unless what makes parts grow by speed and heat is given; `element` names balls or rollers."""
    parts = dict(materials)
    given = {name: each for name in ("inner_ring", "outer_ring", "shaft", "housing") if (each := parts[name])}
    if lacking := [f"materials.{name}.density" for name, each in given.items() if each.density is None]:
        raise needed(lacking, "[bearing.fits]")
    if temperatures is None:
        return
    if fits.housing and temperatures.housing is None:
        raise needed(["operation.temperatures.housing"], "[bearing.fits.housing]")
    given = {element: parts[element], **given}
    if lacking := [f"materials.{name}.expansion" for name, each in given.items() if each.expansion is None]:
        raise needed(lacking, "[operation.temperatures]")
