"""The section [bearing] with its rollers, cage and surfaces."""

from math import pi
from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case.cage_land import CageOnLand
from flexbearing.case.quantity import (
    Angle,
    Length,
    Mass,
    Section,
    Stiffness,
    impossible,
    in_mm,
    key,
    needed,
    require,
)
from flexbearing.case.raceway_waves import FormErrors
from flexbearing.case.roller.fits import Fits
from flexbearing.case.roller.profile import Generatrix
from flexbearing.case.tolerances import ClearanceClass

ROUNDING = 1e-9  # of a diameter
MOST_ROLLERS = 1000  # whose diameters a case may list


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


class Ribs(Section):
    """Ribs of both rings at opposite ends of the rollers, which carry operation.axial_load: NJ, NUP, NF."""

    inner_height: Length = key(
        "height above the inner raceway of the point where a roller's end touches the rib of the inner ring, "
        "about the middle between its chamfer and the edge of the rib",
        example="1.5 mm",
        gt=0,
    )
    outer_height: Length = key(
        "the same above the outer raceway, of the rib of the outer ring", example="1.5 mm", gt=0
    )
    end_radius: Length = key(
        "radius of a sphere on a flat that is curved as roller end and rib are together where they touch",
        example="500 mm",
        ge=1e-4,
        le=1e3,
    )
    friction: float = key("Coulomb friction of the ends on the ribs", example=0.05, ge=0, le=1)
    outside_diameter: Length | None = key(
        "outside diameter of the bearing, for the axial loads that a maker permits; left out where "
        "[bearing.fits] or outer.thickness gives it",
        None,
        example="85 mm",
        gt=0,
    )
    bore: Length | None = key(
        "bore of the bearing, for the same; left out where [bearing.fits] or inner.bore gives it",
        None,
        example="45 mm",
        gt=0,
    )


class FormError(FormErrors):
    """Raceways that are not round, and rollers that are not alike."""

    roller_diameters: tuple[Length, ...] = key(
        "by how much the diameter of each roller is above bearing.roller.diameter, one after the other "
        "from bearing.first_roller_azimuth on; rollers are alike where left out",
        (),
        example=["0.5 um", "-0.2 um", "0 um"],
        strict=False,
        max_length=MOST_ROLLERS,
    )


class Cylinder(Section):
    """Size of a roller."""

    diameter: Length = key("diameter of the rollers", ge=1e-4, le=10)
    length: Length = key("effective length, without end chamfers", ge=1e-4, le=10)


class Roller(Generatrix, Cylinder):  # the keys of the last one stand first
    """One roller."""

    @model_validator(mode="after")
    def _profile_fits(self) -> Self:
        if wrong := self.beyond(self.length):
            raise impossible(*wrong)
        return self


class GuidedCage(CageOnLand):
    """What guides a cage, and its pockets."""

    guidance: Literal["outer", "inner", "rollers"] = key(
        "what the cage runs on: a ring's land or the rollers"
    )
    pocket_friction: float = key("Coulomb friction between roller and pocket", example=0.05, ge=0, le=1)
    thickness: Length = key(
        "radial thickness; the cage shields that part of each roller from the mixture", ge=0
    )


class Cage(GuidedCage):
    """The cage."""

    mass: Mass | None = key(
        "mass: the weight of a free cage and its unbalance; elsewhere it only slows the cage where a start "
        "from rest is followed in time, and that of the rollers will do",
        None,
        gt=0,
    )
    centre: Literal["held", "free"] = key(
        "held: the cage stays concentric with its land; free: it floats where the oil film of the land "
        "carries the push of its pockets",
        "held",
    )
    unbalance: Length = key(
        "distance of the mass centre of a free cage from its axis", "0 um", ge=0, only={"centre": ("free",)}
    )
    unbalance_azimuth: Angle = key(
        "where that mass centre is, from z towards y", "0 deg", only={"centre": ("free",)}
    )
    pocket_clearance: Length | None = key(
        "from a centred roller to either wall of its pocket; shows how far rollers run ahead or lag",
        None,
        example="0.1 mm",
        gt=0,
    )

    @model_validator(mode="after")
    def _centre(self) -> Self:
        if self.guidance == "rollers" and self.centre == "free":
            raise impossible("centre", '"held" where rollers guide the cage: only a land carries a free one')
        if self.centre == "free":
            require(self, ("mass",), 'centre = "free"')
        return self


class SecondRow(Section):
    """A second row of the same rollers between the same rings; one cage spaces both rows."""

    distance: Length = key(
        "between the middles of the rollers of both rows; operation.radial_load acts half-way between them",
        example="22 mm",
        gt=0,
    )
    clearance: Length = key(
        "by how much the clearance of this row, cold and in operation, is above that of the other; may be "
        "negative",
        "0 um",
    )
    azimuth: Angle = key("by how much its rollers are ahead of those of the other row", "0 deg")


class Roughness(Section):
    """Root-mean-square roughness of the surfaces, about 1.25 Ra."""

    roller: Length = key("Rq of the rollers", example="0.05 um", gt=0)
    inner_raceway: Length = key("Rq of the inner raceway", example="0.1 um", gt=0)
    outer_raceway: Length = key("Rq of the outer raceway", example="0.1 um", gt=0)


class Bearing(Section):
    """The bearing."""

    kind: Literal["cylindrical_roller"] = key(
        "kind of bearing, the same as kind above the sections; needed in cases of roller bearings alone"
    )
    rollers: int = key("number of rollers", example=30, ge=3, le=1000)
    outer_raceway_diameter: Length = key("diameter of the outer raceway", example="75 mm", ge=1e-3, le=100)
    clearance: Length | None = key(
        "operating diametral clearance, warm and running; negative is a preload; instead of "
        "bearing.fits.cold_clearance or bearing.clearance_class",
        None,
        example="50 um",
    )
    clearance_class: ClearanceClass | None = key(
        "class of the clearance before mounting by ISO 5753, bores over 6 mm up to 250 mm; the operating "
        "clearance then follows from [bearing.fits]",
        None,
        example="C3",
    )
    fits: Fits | None = key(
        "how the rings are mounted; with cold_clearance or a clearance_class the operating one follows", None
    )
    contact_law: Literal["palmgren", "iso16281"] = key("load law of a roller on a raceway", "palmgren")
    contact: Literal["slices", "half_space"] = key(
        "model of the most loaded roller for peak pressure and life: slices, independent line contacts; "
        "half_space: both contacts on elastic half-spaces, with their ends, under the load of the slices, at "
        "their tilt or, where the ring tilts freely, under their moment; equilibrium, and all other rollers, "
        "are those of the slices with either",
        "slices",
    )
    first_roller_azimuth: Angle = key("azimuth of a roller, from z towards y", "0 deg")
    roller: Roller = key("the rollers")
    inner_raceway: Generatrix | None = key(
        "profile of the inner raceway along the rollers, which is straight without it", None
    )
    outer_raceway: Generatrix | None = key(
        "profile of the outer raceway along the rollers, which is straight without it", None
    )
    cage: Cage = key("the cage")
    roughness: Roughness | None = key("roughness of rollers and raceways, for film ratios", None)
    flange: Flange | None = key("guide flanges of one ring, for the skew of the rollers", None)
    ribs: Ribs | None = key("ribs that carry an axial load, one of each ring", None)
    form_error: FormError | None = key(
        "form errors: raceways that are not round, rollers that are not alike", None
    )
    second_row: SecondRow | None = key(
        "a second row of the same rollers between the same rings: a double-row bearing, or two bearings in a "
        'planet; elastic rings are those of outer.support = "side", "seat" or "planet" and of inner.fit = '
        '"bonded"; ratings in [life] are those of both rows; there is one row without it',
        None,
    )

    @property
    def all_rollers(self) -> int:
        """Number of the rollers of all rows."""
        return self.rollers if self.second_row is None else 2 * self.rollers

    @property
    def rows_width(self) -> float:
        """From end to end of the rollers of all rows, along the axis [m]."""
        return self.roller.length + (0.0 if self.second_row is None else self.second_row.distance)

    @property
    def mounting(self) -> Fits | None:
        """The fits from which the operating clearance follows; None where the case states it."""
        cold = self.fits is not None and self.fits.cold_clearance is not None
        return self.fits if cold or self.clearance_class is not None else None

    @property
    def cage_radii(self) -> tuple[float, float]:
        """Inside and outside radius of the cage [m]: at its land, or about the pitch circle."""
        cage = self.cage
        if cage.guidance in ("inner", "outer"):
            assert cage.land_diameter is not None  # checked on reading
            assert cage.land_clearance is not None
            if cage.guidance == "outer":
                high = (cage.land_diameter - cage.land_clearance) / 2
                return high - cage.thickness, high
            low = (cage.land_diameter + cage.land_clearance) / 2
            return low, low + cage.thickness
        pitch = self.pitch_diameter / 2
        return pitch - cage.thickness / 2, pitch + cage.thickness / 2

    @property
    def pitch_diameter(self) -> float:
        """Of the roller centres, rollers lying on the outer raceway [m]."""
        return self.outer_raceway_diameter - self.roller.diameter

    def raceway_radius(self, race: Literal["inner", "outer"]) -> float:
        """Radius of curvature of a raceway [m], negative of the hollow outer one."""
        outer = self.outer_raceway_diameter / 2
        return -outer if race == "outer" else outer - self.roller.diameter

    @property
    def relieved(self) -> bool:
        """Whether roller or raceway has a profile at both contacts."""
        raceways = (self.inner_raceway, self.outer_raceway)
        on_raceways = all(each is not None and each.profile != "straight" for each in raceways)
        return self.roller.profile != "straight" or on_raceways

    @model_validator(mode="after")
    def _one_clearance(self) -> Self:
        cold = None if self.fits is None else self.fits.cold_clearance
        ways = {
            "clearance": self.clearance,
            "clearance_class": self.clearance_class,
            "fits.cold_clearance": cold,
        }
        given = [name for name, value in ways.items() if value is not None]
        if not given:
            choice = "a bearing without [bearing.fits] cold_clearance or clearance_class"
            raise needed(["clearance"], choice)
        if len(given) > 1:
            other = "[bearing.fits] cold_clearance" if given[1] != "clearance_class" else "clearance_class"
            raise impossible(given[0], f"left out where {other} is given; give one of the two")
        if self.clearance is None:
            fits, shaft = self.fits, "shaft" if given[0] == "clearance_class" else "shaft_interference"
            if fits is None or (fits.shaft is None and fits.shaft_interference is None):
                raise needed([f"fits.{shaft}"], f"bearing.{given[0]}")
        return self

    @model_validator(mode="after")
    def _profiles_fit(self) -> Self:
        for name in ("inner_raceway", "outer_raceway"):
            table = getattr(self, name)
            if table and (wrong := table.beyond(self.roller.length)):
                raise impossible(f"{name}.{wrong[0]}", wrong[1])
        return self

    @model_validator(mode="after")
    def _fits(self) -> Self:
        pitch = self.pitch_diameter
        if pitch <= self.roller.diameter:
            least = in_mm(2 * self.roller.diameter)
            raise impossible("outer_raceway_diameter", f"above {least}, twice bearing.roller.diameter")
        if self.rollers * self.roller.diameter >= pi * pitch:
            most = int(pi * pitch / self.roller.diameter)
            raise impossible("rollers", f"at most {most}, or they touch on the pitch circle")
        if self.flange and self.flange.height >= self.roller.diameter / 2:
            most = in_mm(self.roller.diameter / 2)
            raise impossible("flange.height", f"below {most}, half of bearing.roller.diameter")
        if self.ribs and self.ribs.inner_height + self.ribs.outer_height >= self.roller.diameter:
            most = in_mm(self.roller.diameter - self.ribs.inner_height)
            raise impossible(
                "ribs.outer_height", f"below {most}: contacts on both ribs within bearing.roller.diameter"
            )
        gap = pi * pitch / self.rollers - self.roller.diameter
        if self.cage.pocket_clearance is not None and 2 * self.cage.pocket_clearance >= gap:
            allowed = f"below {in_mm(gap / 2)}, or no bar is left between neighbouring pockets"
            raise impossible("cage.pocket_clearance", allowed)
        return self

    @model_validator(mode="after")
    def _a_diameter_of_each_roller(self) -> Self:
        deviations = self.form_error.roller_diameters if self.form_error else ()
        if len(deviations) not in (0, self.all_rollers):
            of_rows = "" if self.second_row is None else " in each of both rows"
            raise impossible(
                "form_error.roller_diameters",
                f"as many numbers as bearing.rollers, {self.rollers}{of_rows}, or left out",
            )
        return self

    @model_validator(mode="after")
    def _rows_stand_apart(self) -> Self:
        second, length = self.second_row, self.roller.length
        if second is None:
            return self
        if second.distance <= length:
            raise impossible("second_row.distance", f"above {in_mm(length)}, bearing.roller.length")
        if abs(second.clearance) > self.roller.diameter / 2:
            most = in_mm(self.roller.diameter / 2)
            raise impossible(
                "second_row.clearance", f"below {most}, half of bearing.roller.diameter; is the unit right?"
            )
        if self.cage.centre == "free":
            raise impossible("cage.centre", '"held" beside bearing.second_row: a free cage would tilt')
        return self

    def require_room(self, clearance: float) -> None:
        """Raise unless the clearance is small, and the guiding land between pitch circle and its raceway."""
        if abs(clearance) > self.roller.diameter / 2:
            name = "fits.cold_clearance" if self.mounting else "clearance"
            most = in_mm(self.roller.diameter / 2)
            raise impossible(name, f"below {most}, half of bearing.roller.diameter; is the unit right?")
        play = self.cage.land_clearance
        if play is not None and play >= self.roller.diameter:
            most = in_mm(self.roller.diameter)
            raise impossible(
                "cage.land_clearance", f"below {most}, bearing.roller.diameter; is the unit right?"
            )
        land, guidance = self.cage.land_diameter, self.cage.guidance
        if land is None:
            return
        outer, pitch = self.outer_raceway_diameter, self.pitch_diameter
        inner = outer - 2 * self.roller.diameter - clearance
        low, high = (pitch, outer) if guidance == "outer" else (inner, pitch)
        if not (1 - ROUNDING) * low <= land <= (1 + ROUNDING) * high:
            where = (
                "pitch circle and the outer raceway"
                if guidance == "outer"
                else "inner raceway and the pitch circle"
            )
            raise impossible(
                "cage.land_diameter",
                f'{low * 1e3:.4g} to {high * 1e3:.4g} mm for guidance = "{guidance}": between the {where}',
            )
