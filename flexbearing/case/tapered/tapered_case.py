"""A tapered roller bearing between rigid or elastic rings, as a case."""

from math import asin, cos, hypot, pi, sin
from typing import Any, ClassVar, Literal, Self

from pydantic import model_validator

from flexbearing.case.balls.pair import Pair
from flexbearing.case.balls.parts import RingLoad
from flexbearing.case.film_oil import FilmOil, require_contacts_in_oil
from flexbearing.case.fits import FITTED, Fits, PartTemperatures
from flexbearing.case.head import KIND, Head
from flexbearing.case.mounted import (
    FittedBearing,
    FittedCase,
    GrowingElastic,
    WarmMaterial,
    housing_material,
    require_growing,
    shaft_material,
)
from flexbearing.case.outputs import ContactOutputs, LifeOutputs
from flexbearing.case.quantity import (
    Angle,
    Force,
    Length,
    Moment,
    Section,
    Speed,
    Temperature,
    impossible,
    in_mm,
    key,
    located,
    needed,
)
from flexbearing.case.ratings import Ratings, TaperedLife, require_ratable
from flexbearing.case.roller.bearing import GuidedCage, Roller, Roughness
from flexbearing.case.roller.lubricant import FilmName
from flexbearing.case.roller.profile import Generatrix
from flexbearing.case.tapered.rings import TaperedAccuracy, TaperedInner, TaperedOuter

PLANE = "about the point of the bearing axis in the plane of the roller centres"
STEEPEST = pi / 4  # [rad] of a cup
FRICTION = {"outputs.friction": (True,)}
HELD = {"operation.tilt": ("fixed",)}
FREE = {"operation.tilt": ("free",)}


class Rib(Section):
    """The rib of the inner ring, and the spherical ends of the rollers that touch it."""

    angle: Angle = key(
        "angle of the rib face from the radial plane where the rollers touch it, which is that of its normal "
        "from the axis; below that of the rollers' axes, or the ends touch above them",
        example="12.2 deg",
        ge=0,
        lt=STEEPEST,
    )
    end_radius: Length = key(
        "radius of the large ends of the rollers; usual are 0.90 to 0.98 of the distance to the apex",
        example="150 mm",
        gt=0,
    )
    friction: float = key("Coulomb friction of the ends on the rib", example=0.05, ge=0, le=1)


class RollersOnCircle(Section):
    """Rollers between two raceways."""

    rollers: int = key("number of rollers", example=19, ge=3, le=1000)
    pitch_diameter: Length = key("diameter of the circle of the roller centres", ge=1e-3, le=100)
    contact_law: Literal["palmgren", "iso16281"] = key("load law of a roller on a raceway", "palmgren")
    first_roller_azimuth: Angle = key("azimuth of a roller, from z towards y", "0 deg")
    roller: Roller = key("the rollers; diameter in the middle of the contact, length along it")
    inner_raceway: Generatrix | None = key(
        "profile of the inner raceway along the rollers, which is straight without it", None
    )
    outer_raceway: Generatrix | None = key(
        "profile of the outer raceway along the rollers, which is straight without it", None
    )
    roughness: Roughness | None = key(
        "roughness of rollers and raceways, for film ratios", None, only=FRICTION
    )
    cage: GuidedCage | None = key(
        "the cage, of every row; without it the rollers guide one with pockets without friction",
        None,
        only=FRICTION,
    )

    @property
    def on_circle(self) -> int:
        """Number of rollers on one circle."""
        return self.rollers

    @property
    def radial_clearance(self) -> float:
        """Clearance on the diameter [m], 0 of rings that touch the rollers where they are at zero."""
        return 0.0

    @property
    def narrowest(self) -> float:
        """Diameter of the circle on which neighbouring rollers are closest [m]."""
        return self.pitch_diameter

    @model_validator(mode="after")
    def _rollers_have_room(self) -> Self:
        diameter, circle = self.roller.diameter, self.narrowest
        if diameter >= circle / 2:
            raise impossible("roller.diameter", f"below {in_mm(circle / 2)}, half the circle of the rollers")
        most = int(pi / asin(diameter / circle) * (1 - 1e-12))
        if self.on_circle > most:
            most //= self.on_circle // self.rollers
            raise impossible("rollers", f"at most {most}, or they touch")
        if self.cage is not None and self.cage.thickness >= diameter:
            raise impossible("cage.thickness", f"below {in_mm(diameter)}, bearing.roller.diameter")
        return self

    @model_validator(mode="after")
    def _profiles_fit(self) -> Self:
        for name in ("inner_raceway", "outer_raceway"):
            table = getattr(self, name)
            if table and (wrong := table.beyond(self.roller.length)):
                raise impossible(f"{name}.{wrong[0]}", wrong[1])
        return self


class TaperedBearing(RollersOnCircle, FittedBearing):
    """The bearing."""

    cup_angle: Angle = key(
        "angle of the outer raceway from the axis, the contact angle of ISO 281: its tangent is e/1.5 of a "
        "catalogue",
        example="15.64 deg",
        gt=0,
        le=STEEPEST,
    )
    cone_angle: Angle | None = key(
        "angle of the inner raceway from the axis, of cylinders that of the outer one; without it rollers "
        "and raceways have one apex on the axis",
        None,
        example="11.65 deg",
        gt=0,
        le=STEEPEST,
    )
    rib: Rib | None = key(
        "the rib of the inner ring, which holds the large ends of the rollers; left out of cylinders, whose "
        "cage or rings hold them without a load along their axes",
        None,
    )
    pair: Pair | None = key(
        "a second row of the same rollers: a pair of bearings, or a double-row one. Elastic outer rings are "
        "two, or one (outer.common); ratings in [life] are those of both rows",
        None,
    )

    fits: Fits | None = key(
        "how the rings are mounted, which brings cone and cup closer; bearing.pair and "
        "operation.displacement then count from before mounting",
        None,
    )

    @property
    def stated_clearance(self) -> float:
        """Clearance before mounting, where rollers and raceways just touch [m]."""
        return 0.0

    def require_walls(self, fits: Fits) -> None:
        """Raise unless both rings have a wall at the ends of their raceways."""
        half, (_, cone) = self.roller.length / 2, self.angles
        inside = 2 * (self.raceway_middle("inner") - half * sin(cone))
        outside = 2 * (self.raceway_middle("outer") + half * sin(self.cup_angle))
        if fits.bore >= inside:
            raise impossible(
                "bearing.fits.bore", f"below the narrow end of the inner raceway, {in_mm(inside)}"
            )
        if fits.outer_diameter <= outside:
            allowed = f"above the wide end of the outer raceway, {in_mm(outside)}"
            raise impossible("bearing.fits.outer_diameter", allowed)

    @property
    def crossed(self) -> bool:
        """Whether the rollers of two rows alternate on one circle."""
        return self.pair is not None and not self.pair.distance

    @property
    def on_circle(self) -> int:
        """Number of rollers on one circle."""
        return self.rollers * (2 if self.crossed else 1)

    @property
    def opposed(self) -> bool:
        """Whether two rows press each other."""
        return self.pair is not None and self.pair.opposed

    @property
    def angles(self) -> tuple[float, float]:
        """Angles of the rollers' axes and of the inner raceway [rad]."""
        from quasidynamic.parts.tapered_bearing import apex_angles

        if self.cone_angle is None:
            return apex_angles(self.cup_angle, self.roller.diameter / self.pitch_diameter)
        return (self.cup_angle + self.cone_angle) / 2, self.cone_angle

    def raceway_radius(self, race: Literal["inner", "outer"]) -> float:
        """Radius of curvature of a raceway at mid-contact [m], negative of the hollow outer one."""
        pitch, radius = self.pitch_diameter / 2, self.roller.diameter / 2
        if race == "outer":
            return -(pitch / cos(self.cup_angle) + radius)
        return pitch / cos(self.cone_angle or self.cup_angle) - radius

    def raceway_middle(self, race: Literal["inner", "outer"]) -> float:
        """Distance of the middle of the contacts on a raceway from the axis [m]."""
        axis, cone = self.angles
        reach = self.roller.diameter / 2 / cos(self.cup_angle - axis)
        if race == "outer":
            return self.pitch_diameter / 2 + reach * cos(self.cup_angle)
        return self.pitch_diameter / 2 - reach * cos(cone)

    def row_distance(self, race: Literal["inner", "outer"]) -> float:
        """Axial distance of the contacts of both rows on a raceway, in their middles [m]; 0 of one row.

        Contacts are off the plane of the roller centres, on the cone towards the large ends.
        """
        if self.pair is None:
            return 0.0
        axis, cone = self.angles
        reach = self.roller.diameter / 2 / cos(self.cup_angle - axis)
        towards = reach * sin(cone) if race == "inner" else -reach * sin(self.cup_angle)
        return self.pair.distance + 2 * towards * (1 if self.pair.arrangement == "back_to_back" else -1)

    @model_validator(mode="after")
    def _fits(self) -> Self:
        if self.cage is not None and self.cage.land_diameter is not None:
            reach = self.roller.diameter + self.roller.length * sin(self.cup_angle)  # of rollers' outlines
            low, high = self.pitch_diameter - reach, self.pitch_diameter + reach
            if not low <= self.cage.land_diameter <= high:
                raise impossible("cage.land_diameter", f"{in_mm(low)} to {in_mm(high)}, beside the rollers")
        cylinders = self.cone_angle == self.cup_angle
        if self.rib is None and not cylinders:
            raise needed(["rib"], "rollers that taper")
        if self.cone_angle is not None and (self.cone_angle > self.cup_angle or (cylinders and self.rib)):
            allowed = (
                "below bearing.cup_angle: rollers taper towards the apex; of cylinders leave out the rib"
            )
            raise impossible("cone_angle", allowed)
        return self


class TaperedMaterials(Section):
    """Materials of the parts."""

    roller: WarmMaterial = key("of the rollers")
    inner_ring: WarmMaterial = key("of the inner ring")
    outer_ring: WarmMaterial = key("of the outer ring")
    shaft: GrowingElastic | None = shaft_material()
    housing: GrowingElastic | None = housing_material()


class TaperedOil(FilmOil):
    """The oil: by name, by its data sheet, or by its data at the inlet temperature; and its laws."""

    film: FilmName = key("regression of the film thickness", "dowson")


class RollerOutputs(ContactOutputs):
    """What is computed beside the solution."""

    friction: bool = key(
        "whether films, tractions, torque, heat, slip of rollers and cage are computed, by the laws of "
        "[lubricant]",
        False,
    )


class TaperedOutputs(RollerOutputs, LifeOutputs):
    """What is computed beside the solution."""


class TaperedLoad(RingLoad):
    """Load on the inner ring."""

    axial: Force = key(
        "axial force along x, above zero: it presses the inner ring into the cup; of any sign on rows "
        "against each other",
        "0 N",
    )
    moment_y: Moment = key(f"moment about y, by the right hand, {PLANE}", "0 N m", only=FREE)
    moment_z: Moment = key(f"moment about z, by the right hand, {PLANE}", "0 N m", only=FREE)


class TaperedDisplacement(Section):
    """Where the inner ring is held instead of loaded, 0 where rollers and raceways just touch."""

    axial: Length | None = key("displacement along x, into the cup", None, example="20 um")
    radial_y: Length | None = key("displacement along y", None, example="0 um")
    radial_z: Length | None = key("displacement along z", None, example="0 um")
    tilt_y: Angle = key(f"turn about y by the right hand, {PLANE}", "0 deg", only=HELD)
    tilt_z: Angle = key(f"turn about z by the right hand, {PLANE}", "0 deg", only=HELD)


class TaperedTemperatures(PartTemperatures):
    """Temperatures of the parts."""

    roller: Temperature = key("of the rollers", gt=0)


class RingOperation(Section):
    """Load and speed."""

    inner_speed: Speed = key("speed of the inner ring", example="1500 rpm")
    outer_speed: Speed = key("speed of the outer ring", "0 rpm")
    tilt: Literal["fixed", "free"] = key(
        "fixed: shaft and housing hold the rings at the turns of operation.displacement; free: the inner "
        "ring turns until the moments balance, of cones under a radial load by milliradians"
    )
    load: Any = key("load on the inner ring", {})
    displacement: Any = key("where the inner ring is held instead of loaded", {})
    directions: ClassVar[tuple[str, ...]] = ("axial", "radial_y", "radial_z")  # with either of both

    @property
    def held(self) -> tuple[str, ...]:
        """Keys that hold the ring in place of a force, which is not known then."""
        held = self.displacement
        return tuple(f"displacement.{name}" for name in self.directions if getattr(held, name) is not None)

    @property
    def is_pressed(self) -> bool:
        """Whether something beside loads presses the rollers."""
        return bool(self.held) or (self.tilt == "fixed" and any(self.places[3:]))

    @property
    def forces(self) -> tuple[float, float]:
        """Radial and axial force [N], >= 0, of a ring that is not `held`."""
        return hypot(self.load.radial_y, self.load.radial_z), abs(self.load.axial)

    @property
    def places(self) -> tuple[float | None, ...]:
        """Displacements x, y, z [m] and turns about y, z [rad]; None where the ring is free."""
        held = self.displacement
        tilts = (held.tilt_y, held.tilt_z) if self.tilt == "fixed" else (None, None)
        return held.axial, held.radial_y, held.radial_z, *tilts

    @model_validator(mode="after")
    def _load_or_displacement(self) -> Self:
        for name in self.directions:
            if getattr(self.load, name) and getattr(self.displacement, name) is not None:
                allowed = f"left out beside operation.load.{name}; give one of the two"
                raise impossible(f"displacement.{name}", allowed)
        return self


class TaperedOperation(RingOperation):
    """Load and speed."""

    load: TaperedLoad = key("load on the inner ring", {})
    displacement: TaperedDisplacement = key("where the inner ring is held instead of loaded", {})
    temperatures: TaperedTemperatures | None = key(
        "temperatures of the parts, for the fits; without them all have the dimensions given",
        None,
        only=FITTED,
    )


class InclinedCase(Head):
    """A bearing whose rollers may have films and friction, and a life by their slices."""

    bearing: RollersOnCircle = key("the bearing")
    lubricant: TaperedOil | None = key(
        "the oil, for the viscosity ratio of ISO 281, and for films and friction", None
    )
    operation: RingOperation = key("load and speed")
    life: Ratings = key("what the life is rated with, and what modifies it", {})
    outputs: RollerOutputs = key("further results to compute", {})

    @model_validator(mode="after")
    def _oil_has_films(self) -> Self:
        friction, choice = self.outputs.friction, "outputs.friction = true"
        require_contacts_in_oil(self.lubricant, friction, choice, self.bearing.roughness is not None)
        if friction and self.operation.inner_speed == self.operation.outer_speed:
            raise impossible("operation.inner_speed", f"another one than operation.outer_speed with {choice}")
        return self

    @model_validator(mode="after")
    def _life_can_be_rated(self) -> Self:
        require_ratable(self.life, self.operation, self.lubricant)
        return self


class TaperedCase(InclinedCase, FittedCase):
    """A tapered roller bearing: loads with inertia, rigid or elastic rings, friction in speeds alone."""

    file_keys = (
        "bearing.roller.points_file", "bearing.inner_raceway.points_file", "bearing.outer_raceway.points_file"
    )  # fmt: skip

    kind: Literal["tapered_roller"] = key(KIND)
    bearing: TaperedBearing = key("the bearing")
    materials: TaperedMaterials = key("the materials")
    operation: TaperedOperation = key("load and speed")
    life: TaperedLife = key("what the life is rated with, and what modifies it", {})
    outer: TaperedOuter = key("what carries the outer raceway", {})
    inner: TaperedInner = key("what carries the inner raceway", {})
    accuracy: TaperedAccuracy = key("numerical resolution", {})
    outputs: TaperedOutputs = key("further results to compute", {})

    @property
    def rigid(self) -> bool:
        """Whether both rings are rigid."""
        return self.outer.kind == self.inner.kind == "rigid"

    @model_validator(mode="after")
    def _thrust(self) -> Self:
        held, axial = self.operation.displacement.axial is not None, self.operation.load.axial
        if not (self.bearing.opposed or held or axial > 0):
            allowed = "above 0 N, or operation.displacement.axial: without either the cone leaves the cup"
            raise impossible("operation.load.axial", allowed)
        return self

    @model_validator(mode="after")
    def _pair(self) -> Self:
        pair = self.bearing.pair
        if pair is None:
            return self
        if not self.bearing.crossed:
            pair.require_apart(self.bearing.roller.length, "the length of the rollers")
        elif self.bearing.rib or not pair.opposed or not self.rigid:
            allowed = (
                "above 0 mm with a rib, elastic rings or rows in tandem, which are not of crossed rollers"
            )
            raise impossible("bearing.pair.distance", allowed)
        if not pair.opposed and (self.inner.kind != "rigid" or self.outer.common):
            raise impossible("bearing.pair.arrangement", "another one of two rows in one elastic ring")
        return self

    @model_validator(mode="after")
    def _elastic_rings_are_known(self) -> Self:
        outer, inner = self.outer, self.inner
        housed = outer.kind == "ring" and outer.support == "housing"
        self.require_ring_materials(housed, inner.kind == "ring_on_shaft")
        located("outer", lambda: outer.require_room(self.bearing))
        located("inner", lambda: inner.require_room(self.bearing))
        return self

    @model_validator(mode="after")
    def _warm_parts_are_known(self) -> Self:
        if self.bearing.fits:
            require_growing(self.bearing.fits, self.materials, self.operation.temperatures, "roller")
        return self
