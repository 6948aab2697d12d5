"""A fast angular-contact ball bearing, as a case."""

from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case.balls.parts import (
    CELLS,
    INTERFACE,
    MODEL,
    RIGHT_ANGLE,
    SPIN,
    STICKING,
    USUAL_CELLS,
    BallBearing,
    EndingGroove,
    FrictionModel,
    RingLoad,
    Whole,
    require_quarters,
)
from flexbearing.case.balls.renamed import DISPLACEMENT, LOAD, NO_CLASSES, ONE_FRICTION
from flexbearing.case.head import KIND, Head
from flexbearing.case.materials import Elastic, HeavyElastic
from flexbearing.case.quantity import Angle, Length, Moment, Section, Speed, impossible, key

PLANE = "about the point of the bearing axis in the plane of the inner groove centres"
DIRECTIONS = {  # name of a load, and of the displacement that may be held instead
    "axial": "axial",
    "radial_y": "radial_y",
    "radial_z": "radial_z",
    "moment_y": "tilt_y",
    "moment_z": "tilt_z",
}


class AngularBearing(BallBearing):
    """The bearing."""

    inner: EndingGroove = key("groove of the inner ring")
    outer: EndingGroove = key("groove of the outer ring")
    balls: int = key("number of balls", example=18, ge=3, le=1000)
    contact_angle: Angle = key(
        "contact angle without load, from the radial plane", example="15 deg", ge=0, lt=RIGHT_ANGLE
    )
    first_ball_azimuth: Angle = key("azimuth of a ball, from z towards y", "0 deg")

    @model_validator(mode="after")
    def _balls_fit(self) -> Self:
        self.require_room(self.balls)
        return self

    @model_validator(mode="after")
    def _shoulders_end_on_the_grooves(self) -> Self:
        diameter = self.ball.diameter
        for name, groove in (("inner", self.inner), ("outer", self.outer)):
            radius = groove.over(diameter) * diameter
            if groove.shoulder is not None and groove.shoulder > radius:
                raise impossible(f"{name}.shoulder", f"at most the groove radius, {1e3 * radius:.4g} mm")
        return self


class FastMaterials(Section):
    """Materials of the parts."""

    ball: HeavyElastic = key("of the balls")
    inner_ring: Elastic | None = key("of the inner ring; without it as the balls", None)
    outer_ring: Elastic | None = key("of the outer ring; without it as the balls", None)


class FastLoad(RingLoad):
    """Load on the inner ring, moments about a point in the plane of the inner groove centres."""

    moment_y: Moment = key(f"moment about y, by the right hand, {PLANE}", "0 N m")
    moment_z: Moment = key(f"moment about z, by the right hand, {PLANE}", "0 N m")


class Displacement(Section):
    """Where the inner ring is held; it is free in every direction that is left out."""

    axial: Length | None = key("displacement along x, instead of a load", None, example="20 um")
    radial_y: Length | None = key("displacement along y, instead of a load", None, example="0 um")
    radial_z: Length | None = key("displacement along z, instead of a load", None, example="0 um")
    tilt_y: Angle | None = key(
        f"turn about y by the right hand, {PLANE}, instead of a moment", None, example="0 deg"
    )
    tilt_z: Angle | None = key(
        f"turn about z by the right hand, {PLANE}, instead of a moment", None, example="0 deg"
    )

    @property
    def values(self) -> tuple[float | None, ...]:
        """Displacements x, y, z [m] and turns about y, z [rad]; None where the ring is free."""
        return tuple(getattr(self, name) for name in DIRECTIONS.values())


class FastOperation(Section):
    """Load and speed."""

    inner_speed: Speed = key("speed of the inner ring", example="15000 rpm")
    outer_speed: Speed = key("speed of the outer ring", "0 rpm")
    control: Literal["outer", "inner", "equal", "coulomb"] = key(
        "race on which the balls do not spin; equal: the spin axis halves the angle between both contacts; "
        "coulomb: no assumption, friction in both contacts decides"
    )
    load: FastLoad = key("load on the inner ring; axial pushes the balls against their shoulders", {})
    displacement: Displacement = key("where the inner ring is held instead of loaded", {})

    @model_validator(mode="after")
    def _load_or_displacement(self) -> Self:
        for load, place in DIRECTIONS.items():
            if getattr(self.load, load) and getattr(self.displacement, place) is not None:
                raise impossible(
                    f"displacement.{place}", f"left out beside operation.load.{load}; give one of the two"
                )
        return self


class FastFriction(Section):
    """Coulomb friction of the contacts."""

    coefficient: float = key(
        "coefficient of the contacts: for the friction torque, for the spin torque of the rolling lines, and "
        "with control coulomb for the motion of the balls",
        example=0.1,
        ge=1e-6,
        le=1,
    )
    spin: Literal["centre", "local"] = key(SPIN, "centre")
    model: FrictionModel = key(
        f"for the friction torque, after the balance: {MODEL}; with control coulomb either of these puts "
        "fastsim, on half the cells, into the balance itself",
        "full_sliding",
    )
    cells: tuple[Whole, ...] = key(CELLS, USUAL_CELLS, strict=False, only=STICKING)
    interface_compliance: Length | None = key(INTERFACE, None, example="2 um", gt=0, only=STICKING)

    @model_validator(mode="after")
    def _cells_can_be_halved(self) -> Self:
        require_quarters(self.cells)
        return self


class RollingLines(Section):
    """Lines of the contacts on which balls roll without slip."""

    spin: Literal["slip field", "contact angle"] = key(
        "spin over roll: of the whole motion of the ball; or by the contact angle alone, as Eq. (15) of "
        "Rivera, Tong and Hong (2021)",
        "slip field",
    )
    net_force: Literal["none", "balanced"] = key(
        "net friction in the rolling direction: none; or what balances the moments about the spin axis",
        "none",
    )
    points: int = key("points of the slip profile across each contact", 101, ge=3, le=2001)


class AngularCase(Head):
    """A fast angular-contact ball bearing."""

    former = LOAD | DISPLACEMENT | ONE_FRICTION
    hints = NO_CLASSES

    kind: Literal["angular_contact_ball"] = key(KIND)
    bearing: AngularBearing = key("the bearing")
    materials: FastMaterials = key("the materials")
    operation: FastOperation = key("load and speed")
    friction: FastFriction = key("friction of the contacts")
    rolling_lines: RollingLines = key("lines on which the balls roll without slip", {})
