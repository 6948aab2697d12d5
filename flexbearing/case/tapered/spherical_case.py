"""A spherical roller bearing, as a case: two rows of barrels whose contact normals meet in its centre."""

from math import cos, pi, sin, tan
from typing import Any, ClassVar, Literal, Self

from pydantic import model_validator

from flexbearing.case.balls.pair import Pair
from flexbearing.case.balls.parts import RingLoad
from flexbearing.case.head import KIND, Head
from flexbearing.case.materials import Oil
from flexbearing.case.outputs import LifeOutputs
from flexbearing.case.quantity import Angle, Force, Length, Section, impossible, key
from flexbearing.case.ratings import TaperedLife, require_ratable
from flexbearing.case.roller.bearing import Cylinder
from flexbearing.case.tapered.tapered_case import RingOperation, RollersOnCircle
from flexbearing.case.tapered.thrust_case import ThrustAccuracy, ThrustMaterials

STEEPEST = pi / 6  # [rad] of a contact angle


class SphericalBearing(RollersOnCircle):
    """The bearing."""

    inner_raceway: ClassVar[None] = None
    outer_raceway: ClassVar[None] = None
    roughness: ClassVar[None] = None
    cage: ClassVar[None] = None
    rib: ClassVar[None] = None  # symmetric barrels press no rib
    fits: ClassVar[None] = None
    opposed: ClassVar[bool] = True

    rollers: int = key("number of rollers in each of both rows", example=19, ge=3, le=1000)
    contact_angle: Angle = key(
        "angle of the contact normals from the radial plane: its tangent is e/1.5 of a catalogue. All meet "
        "in the centre of the bearing, so that the rows are the pitch diameter times the tangent apart",
        example="9.1 deg",
        gt=0,
        le=STEEPEST,
    )
    roller: Cylinder = key("the rollers; largest diameter, in the middle")
    outer_osculation: float = key(
        "radius of the rollers along their axes over that of the outer raceway, which is a sphere about the "
        "centre of the bearing that the rollers touch",
        example=0.97,
        ge=0.5,
        lt=1,
    )
    inner_osculation: float = key(
        "radius of the rollers along their axes over that of the inner raceway there",
        example=0.97,
        ge=0.5,
        lt=1,
    )
    clearance: Length = key("operating radial clearance, on the diameter; below zero: preload", "0 um")

    @property
    def cup_angle(self) -> float:
        """Angle of the outer raceway in mid-contact from the axis [rad]."""
        return self.contact_angle

    @property
    def angles(self) -> tuple[float, float]:
        """Angles of the rollers' axes and of the inner raceway in mid-contact [rad]."""
        return self.contact_angle, self.contact_angle

    @property
    def radial_clearance(self) -> float:
        """Clearance on the diameter [m]."""
        return self.clearance

    @property
    def pair(self) -> Any:
        """Both rows, contact lines towards each other."""
        distance = self.pitch_diameter * tan(self.contact_angle)
        return Pair.model_construct(arrangement="face_to_face", distance=distance, preload=None, offset=0.0)

    @property
    def profile_radius(self) -> float:
        """Radius of the rollers along their axes [m]."""
        return self.outer_osculation * self.raceway_profile_radius("outer")

    def raceway_profile_radius(self, race: Literal["inner", "outer"]) -> float:
        """Radius of a raceway along the rollers [m]; of the outer one in any direction."""
        if race == "inner":
            return self.profile_radius / self.inner_osculation
        return (self.pitch_diameter / cos(self.contact_angle) + self.roller.diameter) / 2

    @model_validator(mode="after")
    def _rows_part(self) -> Self:
        length, angle = self.roller.length, self.contact_angle
        end = self.roller.diameter - length**2 / (4 * self.profile_radius)  # diameter, nearly
        if length * cos(angle) + end * sin(angle) > self.pair.distance:
            raise impossible(
                "roller.length", "shorter, or a larger contact_angle, or rollers of both rows meet"
            )
        return self


class SphericalLoad(RingLoad):
    """Load on the inner ring."""

    moment_y: ClassVar[float] = 0.0
    moment_z: ClassVar[float] = 0.0

    axial: Force = key("axial force along x, of any sign", "0 N")


class SphericalDisplacement(Section):
    """Where the inner ring is held instead of loaded, 0 in the middle of its clearance."""

    tilt_y: ClassVar[float] = 0.0
    tilt_z: ClassVar[float] = 0.0

    axial: Length | None = key("displacement along x", None, example="20 um")
    radial_y: Length | None = key("displacement along y", None, example="0 um")
    radial_z: Length | None = key("displacement along z", None, example="0 um")


class SphericalOperation(RingOperation):
    """Load and speed."""

    tilt: ClassVar[str] = "fixed"  # of any angle: it changes no load

    load: SphericalLoad = key("load on the inner ring", {})
    displacement: SphericalDisplacement = key("where the inner ring is held instead of loaded", {})


class SphericalOutputs(LifeOutputs):
    """What is computed beside the solution."""

    friction: ClassVar[bool] = False


class SphericalCase(Head):
    """A spherical roller bearing between rigid rings."""

    rigid: ClassVar[bool] = True

    kind: Literal["spherical_roller"] = key(KIND)
    bearing: SphericalBearing = key("the bearing")
    materials: ThrustMaterials = key("the materials")
    lubricant: Oil | None = key("the oil, for the viscosity ratio of ISO 281", None)
    operation: SphericalOperation = key("load and speed")
    life: TaperedLife = key("what the life is rated with, and what modifies it", {})
    accuracy: ThrustAccuracy = key("numerical resolution", {})
    outputs: SphericalOutputs = key("further results to compute", {})

    @model_validator(mode="after")
    def _life_can_be_rated(self) -> Self:
        require_ratable(self.life, self.operation, self.lubricant)
        return self
