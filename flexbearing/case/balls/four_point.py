"""A slow ball bearing of two or four contact points, as a case."""

from math import acos, cos, pi, sin, sqrt
from typing import TYPE_CHECKING, Literal, NamedTuple, Self

from pydantic import model_validator

from flexbearing.case.balls import bolted_rings
from flexbearing.case.balls.mounting import MountedBearing, MountedCase, MountedMaterials
from flexbearing.case.balls.parts import (
    AS_CLEARANCE,
    CELLS,
    INTERFACE,
    LOAD,
    MODEL,
    NO_CLASSES,
    RIGHT_ANGLE,
    SPIN,
    STICKING,
    USUAL_CELLS,
    EndingGroove,
    FrictionModel,
    Number,
    RingLoad,
    Whole,
    require_quarters,
)
from flexbearing.case.balls.ring_room import OUTWARD, Race
from flexbearing.case.balls.slow_life import SlowLife
from flexbearing.case.head import KIND
from flexbearing.case.outputs import BoltedOutputs
from flexbearing.case.quantity import (
    Angle,
    Force,
    Length,
    Moment,
    Pressure,
    Section,
    Speed,
    impossible,
    in_mm,
    key,
    needed,
    require,
)

if TYPE_CHECKING:
    from fem.parts.groove import Groove

PRESSURE = (
    "hertz: ellipses; offset: computed on the true arcs of ball and groove, which come closer by as much "
    "along all normals, as an interference in finite elements; translation: the same where the ring is "
    "displaced as a rigid body, which presses the ends of the arcs less; computed pressure ends at shoulders "
    "that are given"
)
PLANE = "about the point of the bearing axis in the plane of the ball centres"


class FourPointBearing(MountedBearing):
    """The bearing."""

    inner: EndingGroove = key("groove of the inner ring, of both its arches")
    outer: EndingGroove = key("groove of the outer ring, of both its arches")
    balls: int | None = key(
        'number of balls; without it one ball, for operation.mode = "contact_loads"',
        None,
        example=60,
        ge=3,
        le=1000,
    )
    contact_angle: Angle = key(
        "contact angle of both diagonals without load, from the radial plane; before mounting where there "
        "are fits",
        example="45 deg",
        gt=0,
        lt=RIGHT_ANGLE,
    )
    clearance: Length = key(
        "free travel of a ball along a diagonal, both contacts together; negative is an interference; before "
        "mounting where there are fits",
        "0 um",
        example="-15 um",
    )

    outer_arches: Literal[1, 2] = key(
        "arches of the outer groove: two; or one arc, as around the halves of a split inner ring: "
        "bearing.contact_angle is then that of the line of the groove centres with the rings in the middle",
        2,
        example=1,
    )

    @property
    def stated_clearance(self) -> float:
        """Radial clearance of the diagonals, P_d = 2 (A - (A - clearance) cos(alpha)) [m]."""
        distance = self.centre_distance
        return 2 * (distance - (distance - self.clearance) * cos(self.contact_angle))

    @model_validator(mode="after")
    def _balls_fit(self) -> Self:
        if self.balls is not None:
            self.require_room(self.balls)
        if abs(self.clearance) >= self.centre_distance:
            most = f"{self.centre_distance * 1e6:.4g} um"
            raise impossible(
                "clearance",
                f"between -{most} and {most}, the distance of opposite groove centres; is the unit right?",
            )
        inner = (self.inner.over(self.ball.diameter) - 0.5) * self.ball.diameter
        if self.outer_arches == 1 and self.aside > inner:
            raise impossible(
                "outer_arches",
                f"2, or a smaller contact angle or more clearance: the centres of the inner arches would be "
                f"{in_mm(self.aside)} aside, more than {in_mm(inner)}, their distance from a ball",
            )
        return self

    @property
    def aside(self) -> float:
        """Axial distance of opposite groove centres, rings in the middle [m]."""
        return (self.centre_distance - self.clearance) * sin(self.contact_angle)


class SlowFriction(Section):
    """Coulomb friction of the contacts, and how their torque is summed."""

    coefficient: float | None = key("one coefficient at any pressure", None, example=0.1, ge=1e-6, le=1)
    pressures: tuple[Pressure, ...] | None = key(
        "peak pressures at which coefficients were measured, growing; instead of friction.coefficient",
        None,
        example=["1 GPa", "3 GPa"],
        strict=False,
    )
    coefficients: tuple[Number, ...] | None = key(
        "the coefficient at each of friction.pressures, straight lines between them",
        None,
        example=[0.12, 0.1],
        strict=False,
    )
    torque: Literal["exact", "circumferential"] = key(
        "exact: with the moment of the tractions about the contact normal; circumferential: of the tractions "
        "along the rolling direction alone, as Heras et al. (2017)",
        "exact",
    )
    spin: Literal["centre", "local"] = key(SPIN, "centre")
    model: FrictionModel = key(MODEL, "full_sliding")
    cells: tuple[Whole, ...] = key(CELLS, USUAL_CELLS, strict=False, only=STICKING)
    contact_pressure: Literal["hertz", "offset", "translation"] = key(PRESSURE, "hertz", only=STICKING)
    interface_compliance: Length | None = key(INTERFACE, None, example="2 um", gt=0, only=STICKING)
    hysteresis_loss: float = key("part of the elastic work that rolling loses", 0.0, ge=0, lt=1)

    @model_validator(mode="after")
    def _cells_can_be_halved(self) -> Self:
        require_quarters(self.cells)
        return self

    @model_validator(mode="after")
    def _one_of_both(self) -> Self:
        if self.pressures is None and self.coefficients is None:
            if self.coefficient is None:
                raise needed(["coefficient"], "a case without friction.pressures")
            return self
        if self.coefficient is not None:
            raise impossible("coefficient", "left out beside friction.pressures; give one of the two")
        pressures, coefficients = require(self, ("pressures", "coefficients"), "a friction curve")
        if not pressures or any(high <= low for low, high in zip((0.0, *pressures), pressures, strict=False)):
            raise impossible("pressures", "one pressure at least, above zero and growing")
        if len(coefficients) != len(pressures) or not all(1e-6 <= value <= 1 for value in coefficients):
            raise impossible("coefficients", f"{len(pressures)} numbers, at least 1e-6 and at most 1")
        return self


class SlowLoad(RingLoad):
    """Load on the inner ring, moments about a point in the plane of the ball centres."""

    moment_y: Moment = key(f"moment about y, by the right hand, {PLANE}", "0 N m")
    moment_z: Moment = key(f"moment about z, by the right hand, {PLANE}", "0 N m")


class SlowOperation(Section):
    """What is given: the load of the ring, or that of the contacts."""

    mode: Literal["ring_load", "contact_loads"] = key(
        "what is given: the load on the ring, which the balls share at angles that turn with load; or the "
        "loads of the contacts of every ball, at the contact angle without load",
        "ring_load",
    )
    load: SlowLoad = key(
        'load on the inner ring, for operation.mode = "ring_load"', {}, only={"mode": ("ring_load",)}
    )
    contact_loads: tuple[Force, ...] | None = key(
        "load of the first and of the second diagonal of every ball; the first runs outwards to positive x",
        None,
        example=["26 kN", "0 N"],
        strict=False,
        only={"mode": ("contact_loads",)},
    )
    speed: Speed = key(
        "speed of the inner ring, the outer one at rest; slip and power go with it, torque does not; with "
        "a ring load balls have their centrifugal force and gyroscopic moment",
        "1 rad/s",
        gt=0,
    )
    oscillation: Angle | None = key(
        "angle by which the rings turn against each other to and fro, from one end to the other; "
        "operation.speed is then its mean, forwards and backwards: twice this angle for each oscillation",
        None,
        example="10 deg",
        gt=0,
    )

    @property
    def inner_speed(self) -> float:
        """Speed of the inner ring, against the outer one [rad/s]."""
        return self.speed

    @property
    def outer_speed(self) -> float:
        """Speed of the outer ring, by which that of the other is counted [rad/s]."""
        return 0.0

    @property
    def is_pressed(self) -> bool:
        """Whether something beside loads presses the balls."""
        return False

    @model_validator(mode="after")
    def _contact_loads(self) -> Self:
        if self.mode == "ring_load":
            return self
        (loads,) = require(self, ("contact_loads",), 'mode = "contact_loads"')
        if len(loads) not in (1, 2) or not all(load >= 0 for load in loads) or not any(loads):
            raise impossible("contact_loads", "one or two forces, none negative, at least one above zero")
        return self


class Fields(Section):
    """Contacts whose pressure, slip and shear are stored cell by cell."""

    balls: tuple[Whole, ...] | None = key(
        "numbers of the balls, from 0 at azimuth zero; without it the one that carries most",
        None,
        example=[0, 3],
        strict=False,
    )
    points: int = key(
        "cells across and along each contact in full sliding; with stick and slip they are friction.cells",
        21,
        ge=3,
        le=401,
        only={"friction.model": ("full_sliding",)},
    )


class Arches(NamedTuple):
    """Two arches of a groove."""

    radius: float  # [m]
    aside: float  # [m] of their centres from the plane of the ball centres
    inward: float  # [m] of their centres from the pitch circle, to the axis from the outer race

    @property
    def depth(self) -> float:
        """From the centres of the arches to where both meet, along the radius [m]."""
        return sqrt(self.radius**2 - self.aside**2)

    def end_at(self, shoulder: float) -> float:
        """Contact angle at which arches end on a shoulder of a height above where they meet [rad]."""
        return acos((self.depth - shoulder) / self.radius)


class FourPointCase(MountedCase):
    """A slow ball bearing of two or four contact points."""

    former = LOAD
    hints = NO_CLASSES | AS_CLEARANCE

    kind: Literal["four_point_ball"] = key(KIND)
    bearing: FourPointBearing = key("the bearing")
    materials: MountedMaterials = key("the materials")
    friction: SlowFriction = key("friction of the contacts")
    operation: SlowOperation = key("load and speed", {})
    life: SlowLife = key("what the life is rated with, and what modifies it", {})
    rings: bolted_rings.Rings = key("elastic rings; rigid without it", {})
    fields: Fields = key("contacts whose pressure, slip and shear are stored cell by cell", {})
    outputs: BoltedOutputs = key("further results to compute", {})

    @model_validator(mode="after")
    def _fits_are_those_of_rigid_rings(self) -> Self:
        if self.bearing.fits and not self.rigid:
            raise impossible("bearing.fits", "left out beside elastic rings, which are bolted")
        return self

    @model_validator(mode="after")
    def _one_arc_is_rigid(self) -> Self:
        if self.bearing.outer_arches == 1 and not self.rigid:
            raise impossible(
                "bearing.outer_arches", "2 beside elastic rings, which are meshed with two arches"
            )
        return self

    @property
    def rigid(self) -> bool:
        """Whether both rings are rigid."""
        return self.rings.outer.kind == self.rings.inner.kind == "rigid"

    @property
    def balls(self) -> int:
        """Balls that are computed."""
        return self.bearing.balls or 1

    @property
    def azimuths(self) -> tuple[float, ...]:
        """Of these balls, from z towards y [rad]."""
        first = self.bearing.first_ball_azimuth
        return tuple(first + 2 * pi * ball / self.balls for ball in range(self.balls))

    @model_validator(mode="after")
    def _balls_are_known(self) -> Self:
        if self.operation.mode == "ring_load" and self.bearing.balls is None:
            raise needed(["bearing.balls"], 'operation.mode = "ring_load"')
        if self.operation.mode == "contact_loads" and not self.rigid:
            raise impossible(
                "operation.mode", '"ring_load" beside elastic rings, which change how balls share it'
            )
        chosen = self.fields.balls
        if chosen is None:
            return self
        if not chosen or not all(0 <= ball < self.balls for ball in chosen) or len({*chosen}) < len(chosen):
            raise impossible("fields.balls", f"different numbers of balls, from 0 to {self.balls - 1}")
        return self

    def arches(self, race: str) -> Arches:
        """Of the groove of the "inner" or the "outer" ring, their centres on the lines of contact."""
        own, ball = self.bearing, self.bearing.ball.diameter
        radius = getattr(own, race).over(ball) * ball
        offset = radius - ball / 2
        if own.outer_arches == 1:
            aside = own.aside if race == "inner" else 0.0
            return Arches(radius, aside, sqrt(offset**2 - aside**2))
        return Arches(radius, offset * sin(own.contact_angle), offset * cos(own.contact_angle))

    def groove(self, race: Race) -> "Groove":
        """The same in an elastic ring."""
        from fem.parts.groove import Groove  # not described between rigid rings

        radius, aside, inward = self.arches(race)
        centre = self.bearing.pitch_diameter / 2 - OUTWARD[race] * inward
        return Groove(radius=radius, centre_radius=centre, aside=aside)

    @model_validator(mode="after")
    def _grooves_fit_into_the_rings(self) -> Self:
        grooves = {race: self.groove(race) for race in OUTWARD if getattr(self.rings, race).kind != "rigid"}
        self.rings.require_room(grooves, self.bearing.contact_angle, self.bearing.ball.diameter)
        return self

    @model_validator(mode="after")
    def _shoulders_end_the_arches(self) -> Self:
        for name in ("inner", "outer"):
            shoulder, arches = getattr(self.bearing, name).shoulder, self.arches(name)
            if shoulder is None:
                continue
            if getattr(self.rings, name).kind != "rigid":
                raise impossible(
                    f"bearing.{name}.shoulder",
                    f"left out beside rings.{name}.groove_end",
                )
            if shoulder > arches.depth:
                most = f"{1e3 * arches.depth:.4g} mm"
                raise impossible(f"bearing.{name}.shoulder", f"at most the depth of the arches, {most}")
        return self
