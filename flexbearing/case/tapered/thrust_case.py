"""A cylindrical or needle roller thrust bearing, as a case: inclined rollers of 90 degrees without a rib."""

from math import inf, pi
from typing import ClassVar, Literal, Self

from pydantic import model_validator

from flexbearing.case.head import KIND
from flexbearing.case.materials import HeavyElastic
from flexbearing.case.quantity import Angle, Force, Length, Moment, Section, impossible, key
from flexbearing.case.ratings import RollerLife
from flexbearing.case.tapered.tapered_case import (
    FREE,
    HELD,
    PLANE,
    InclinedCase,
    RingOperation,
    RollersOnCircle,
)


class ThrustBearing(RollersOnCircle):
    """The bearing."""

    cup_angle: ClassVar[float] = pi / 2
    angles: ClassVar[tuple[float, float]] = (pi / 2, pi / 2)
    rib: ClassVar[None] = None  # the cage holds the rollers along their axes
    pair: ClassVar[None] = None
    fits: ClassVar[None] = None
    opposed: ClassVar[bool] = False

    @property
    def narrowest(self) -> float:
        """Diameter of the circle of the inner ends, where neighbouring rollers are closest [m]."""
        return self.pitch_diameter - self.roller.length

    def raceway_radius(self, race: Literal["inner", "outer"]) -> float:
        """Radius of curvature of a raceway [m]: it is flat."""
        return inf


class ThrustMaterials(Section):
    """Materials of the parts."""

    roller: HeavyElastic = key("of the rollers")
    inner_ring: HeavyElastic = key("of the shaft washer")
    outer_ring: HeavyElastic = key("of the housing washer")


class ThrustLife(RollerLife):
    """What the life is rated with, and what modifies it; nothing does unless it is given."""

    modification: ClassVar[str] = "bearing"


class ThrustLoad(Section):
    """Load on the shaft washer, the inner ring."""

    radial_y: ClassVar[float] = 0.0
    radial_z: ClassVar[float] = 0.0

    axial: Force = key("axial force along x, above zero: it presses the shaft washer on the rollers", "0 N")
    moment_y: Moment = key(f"moment about y, by the right hand, {PLANE}", "0 N m", only=FREE)
    moment_z: Moment = key(f"moment about z, by the right hand, {PLANE}", "0 N m", only=FREE)

    @property
    def values(self) -> tuple[float, float, float, float, float]:
        """Fx, Fy, Fz [N], My, Mz [N m]."""
        return self.axial, 0.0, 0.0, self.moment_y, self.moment_z


class ThrustDisplacement(Section):
    """Where the shaft washer is held instead of loaded, 0 where rollers and washers just touch."""

    radial_y: ClassVar[float] = 0.0
    radial_z: ClassVar[float] = 0.0

    axial: Length | None = key("displacement along x, on the rollers", None, example="5 um")
    tilt_y: Angle = key(f"turn about y by the right hand, {PLANE}", "0 deg", only=HELD)
    tilt_z: Angle = key(f"turn about z by the right hand, {PLANE}", "0 deg", only=HELD)


class ThrustOperation(RingOperation):
    """Load and speed."""

    directions: ClassVar[tuple[str, ...]] = ("axial",)

    load: ThrustLoad = key("load on the shaft washer", {})
    displacement: ThrustDisplacement = key("where the shaft washer is held instead of loaded", {})


class ThrustAccuracy(Section):
    """Numerical resolution."""

    slices: int = key("slices of each roller", 40, ge=4, le=1000)


class ThrustCase(InclinedCase):
    """A roller thrust bearing between rigid washers that other bearings centre."""

    rigid: ClassVar[bool] = True
    file_keys = (
        "bearing.roller.points_file", "bearing.inner_raceway.points_file", "bearing.outer_raceway.points_file"
    )  # fmt: skip

    kind: Literal["thrust_roller"] = key(KIND)
    bearing: ThrustBearing = key("the bearing")
    materials: ThrustMaterials = key("the materials")
    operation: ThrustOperation = key("load and speed")
    life: ThrustLife = key("what the life is rated with, and what modifies it", {})
    accuracy: ThrustAccuracy = key("numerical resolution", {})

    @model_validator(mode="after")
    def _thrust(self) -> Self:
        if self.operation.displacement.axial is None and self.operation.load.axial <= 0:
            allowed = "above 0 N, or operation.displacement.axial: without either the washers part"
            raise impossible("operation.load.axial", allowed)
        return self
