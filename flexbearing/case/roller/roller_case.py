"""A cylindrical roller bearing between its rings, as a case."""

from pathlib import Path
from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case import held_ring
from flexbearing.case.head import KIND, Head
from flexbearing.case.outputs import RingOutputs
from flexbearing.case.quantity import impossible, in_mm, key, located, needed
from flexbearing.case.ratings import FEWEST_SLICES, Life
from flexbearing.case.roller.bearing import Bearing
from flexbearing.case.roller.consistency import (
    bands,
    require_covered,
    require_known,
    require_mounting,
    require_rows,
    require_sizes_once,
    require_solids,
)
from flexbearing.case.roller.lubricant import Lubricant
from flexbearing.case.roller.numerics import Accuracy, Coupling
from flexbearing.case.roller.rings import Inner, Outer
from flexbearing.case.roller.surroundings import Materials, Operation
from flexbearing.case.tolerances import CLEARANCE, HOUSING, SHAFT, Band, Place

FORMER = {  # keys of older versions, and what has taken their place
    "inner.interference": "bearing.fits.shaft_interference, and that of the housing is "
    "bearing.fits.housing.interference",
}


class Case(Head):
    """A cylindrical roller bearing."""

    former = FORMER
    file_keys = (
        "outer.file", "outer.matrix", "outer.nodes", "bearing.roller.points_file",
        "bearing.inner_raceway.points_file", "bearing.outer_raceway.points_file",
    )  # fmt: skip

    kind: Literal["cylindrical_roller"] = key(KIND, "cylindrical_roller")
    bearing: Bearing = key("the bearing")
    materials: Materials = key("the materials")
    lubricant: Lubricant = key("the oil")
    operation: Operation = key("load and speed")
    outer: Outer = key("what carries the outer raceway")
    inner: Inner = key("what carries the inner raceway")
    life: Life = key("what modifies the basic life", {})
    coupling: Coupling = key("how bearing and rings are solved together", {})
    accuracy: Accuracy = key("numerical resolution", {})
    outputs: RingOutputs = key("further results to compute", {})

    @property
    def drawing(self) -> Path | None:
        """STEP file of the outer ring, next to the case file; None for a ring that is not drawn."""
        return held_ring.drawing(self)

    @property
    def seat(self) -> tuple[float, float]:
        """Radius of the outer surface of an elastic outer ring, and offset of its raceway [m]."""
        outside = self.bearing.outer_raceway_diameter / 2 + (self.outer.thickness or 0.0)
        return outside, self.outer.raceway_offset

    @property
    def lifts_off(self) -> bool:
        """Whether a flexible outer ring touches its housing only where it is pressed on it."""
        housed = self.outer.kind == "ring" and self.outer.support == "housing"
        fitted = self.bearing.fits is not None and self.bearing.fits.housing is not None
        return housed and (fitted or self.outer.housing_clearance is not None)

    @property
    def cage_within_ribs(self) -> str:
        """Where the cage lies within the ribs of the inner ring, in words; empty where it does not."""
        ring, cage, length = self.inner, self.bearing.cage, self.bearing.roller.length
        if ring.kind == "rigid" or not ring.ribbed or not cage.thickness:
            return ""
        assert ring.bore  # checked on reading, as the others are
        assert ring.thickness
        assert ring.track_width
        inside, rib = self.bearing.cage_radii[0], ring.bore / 2 + ring.thickness
        if inside >= rib or length / 2 + (cage.land_width or 0.0) / 2 <= ring.track_width / 2:
            return ""
        return f"cage inside Ø {2e3 * inside:.6g} mm, inner ribs Ø {2e3 * rib:.6g} mm"

    @property
    def bands(self) -> dict[str, Band]:
        """Key of each class of clearance and fits that the case names, to what it allows [m]."""
        return bands(self.bearing, self.inner, self.outer)

    @property
    def place(self) -> Place:
        """Where the classes are taken within their tolerances."""
        return self.bearing.fits.at if self.bearing.fits else "mean"

    @property
    def stated_clearance(self) -> float:
        """The clearance that the case gives, operating or before mounting [m]."""
        if self.bearing.clearance is not None:
            return self.bearing.clearance
        if self.bearing.clearance_class is not None:
            return self.bands[CLEARANCE].open(self.place)
        assert self.bearing.fits  # checked on reading, here and below
        assert self.bearing.fits.cold_clearance is not None
        return self.bearing.fits.cold_clearance

    @property
    def shaft_interference(self) -> float:
        """Diametral interference of shaft and inner ring, cold [m]; zero where no fit is given."""
        fits = self.bearing.fits
        if fits and fits.shaft is not None:
            return self.bands[SHAFT].tight(self.place)
        return 0.0 if fits is None or fits.shaft_interference is None else fits.shaft_interference

    @property
    def housing_interference(self) -> float:
        """Diametral interference of outer ring and housing, cold [m]; negative is a clearance."""
        if self.outer.housing_clearance is not None:
            return -self.outer.housing_clearance
        assert self.bearing.fits
        assert self.bearing.fits.housing  # or the ring would be bonded or free
        housing = self.bearing.fits.housing
        if housing.tolerance_class is not None:
            return self.bands[HOUSING].tight(self.place)
        assert housing.interference is not None
        return housing.interference

    def within_tolerances(self, place: Place) -> "Case":
        """The same case with its classes taken at another place within their tolerances."""
        fits = self.bearing.fits and self.bearing.fits.model_copy(update={"at": place})
        return self.model_copy(update={"bearing": self.bearing.model_copy(update={"fits": fits})})

    @model_validator(mode="after")
    def _classes_are_tabulated(self) -> Self:
        bands(self.bearing, self.inner, self.outer)
        return self

    @model_validator(mode="after")
    def _parts_fit(self) -> Self:
        raceway, roller = self.bearing.outer_raceway_diameter, self.bearing.roller
        located("bearing", lambda: self.bearing.require_room(self.stated_clearance))
        rows = self.bearing.rows_width
        located("outer", lambda: self.outer.require_room(raceway, rows))
        inner_raceway = raceway - 2 * roller.diameter - self.stated_clearance
        located("inner", lambda: self.inner.require_room(inner_raceway, rows))
        if self.bearing.cage.thickness >= roller.diameter:
            allowed = f"below {in_mm(roller.diameter)}, bearing.roller.diameter"
            raise impossible("bearing.cage.thickness", allowed)
        if self.inner.kind == "ring_on_shaft" and self.materials.shaft is None:
            raise needed(["materials.shaft"], 'inner.kind = "ring_on_shaft"')
        if self.accuracy.axial_shapes > self.accuracy.slices:
            raise impossible("accuracy.axial_shapes", f"at most {self.accuracy.slices}, accuracy.slices")
        return self

    @model_validator(mode="after")
    def _rings_know_their_rows(self) -> Self:
        rigid = self.outer.kind == self.inner.kind == "rigid"
        if self.bearing.second_row is not None and not rigid:
            structures = self.accuracy.structure, self.coupling.structure
            require_rows(structures, self.operation.temperatures, self.inner, self.outer)
        return self

    @model_validator(mode="after")
    def _tilt_is_stated(self) -> Self:
        if "tilt" in self.operation.model_fields_set:
            return self
        for name, kind in (("outer", self.outer.kind), ("inner", self.inner.kind)):
            if kind != "rigid":
                raise needed(["operation.tilt"], f'{name}.kind = "{kind}"')
        return self

    @model_validator(mode="after")
    def _clamped_rings_stand_still(self) -> Self:
        clamped = {
            "squirrel_cage": "its flange is clamped",
            "step": "outer.clamps do not move",
            "matrix": "its body is held",
        }
        if self.operation.outer_speed and self.outer.kind in clamped:
            allowed = f'"0 rpm" for outer.kind = "{self.outer.kind}": {clamped[self.outer.kind]}'
            raise impossible("operation.outer_speed", allowed)
        return self

    @model_validator(mode="after")
    def _surfaces_are_known(self) -> Self:
        rough = self.bearing.roughness is not None
        self.lubricant.require_rough_surfaces(rough)
        if self.life.lubrication == "film" and not rough:
            raise needed(["bearing.roughness"], 'life.lubrication = "film"')
        return self

    @model_validator(mode="after")
    def _rated_load(self) -> Self:
        if self.life.loads == "rating" and not self.operation.radial_load > 0:
            raise impossible("operation.radial_load", 'above 0 N for life.loads = "rating"')
        return self

    @model_validator(mode="after")
    def _thrust_is_carried(self) -> Self:
        require_sizes_once(self.bearing, self.inner, self.outer)
        if not self.operation.axial_load:
            return self
        choice = "an operation.axial_load other than 0 N"
        if self.bearing.ribs is None:
            raise needed(["bearing.ribs"], choice)
        if not self.operation.radial_load > 0:
            raise impossible("operation.radial_load", f"above 0 N for {choice}: rollers on ribs need one")
        if self.accuracy.axial_shapes < 2:
            raise impossible("accuracy.axial_shapes", f"2 or more for {choice}, which tilts the rollers")
        if self.bearing.contact == "half_space":
            raise impossible("bearing.contact", f'"slices" for {choice}')
        for name in ("second_row", "flange"):
            if getattr(self.bearing, name) is not None:
                raise impossible(f"bearing.{name}", f"left out for {choice}")
        return self

    @model_validator(mode="after")
    def _edge_stress_is_known(self) -> Self:
        if self.life.edge_stress and not self.bearing.relieved:
            allowed = "another profile for life.edge_stress: a straight roller has no known edge"
            raise impossible("bearing.roller.profile", allowed)
        if self.life.edge_stress and self.bearing.contact == "half_space":
            allowed = 'false for bearing.contact = "half_space", whose loads per length hold the ends already'
            raise impossible("life.edge_stress", allowed)
        chosen = self.accuracy.target is not None and "slices" not in self.accuracy.model_fields_set
        if self.life.edge_stress and self.accuracy.slices < FEWEST_SLICES and not chosen:
            raise impossible("accuracy.slices", f"at least {FEWEST_SLICES} for life.edge_stress")
        return self

    @model_validator(mode="after")
    def _structures_know_the_parts(self) -> Self:
        if self.coupling.structure == "full":
            require_solids(self.accuracy, self.inner, self.outer, lifts_off=self.lifts_off)
            if self.operation.temperatures and self.operation.temperatures.outer_seat is not None:
                allowed = 'left out for coupling.structure = "full", whose solids do not expand'
                raise impossible("operation.temperatures.outer_seat", allowed)
        else:
            require_known(self.accuracy, self.inner, self.outer, lifts_off=self.lifts_off)
        return self

    @model_validator(mode="after")
    def _expansions_are_known_of_what_is_warm(self) -> Self:
        if self.operation.temperatures:
            given = ((name, getattr(self.materials, name)) for name in type(self.materials).model_fields)
            lacking = [name for name, each in given if each and each.expansion is None]
            if lacking:
                raise needed([f"materials.{name}.expansion" for name in lacking], "[operation.temperatures]")
        return self

    @model_validator(mode="after")
    def _mounting_is_complete(self) -> Self:
        clearance, temperatures = self.stated_clearance, self.operation.temperatures
        require_mounting(self.bearing, clearance, self.materials, temperatures, self.inner, self.outer)
        require_covered(temperatures, self.inner, self.outer)
        return self
