"""A fast angular-contact ball bearing, as a case; what it shares with that of a deep groove bearing."""

from math import cos, hypot, sin
from pathlib import Path
from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case import held_ring
from flexbearing.case.balls.cage import BallCage
from flexbearing.case.balls.elastic_rings import (
    AngularOuter,
    BallInner,
    BallOuter,
    GrooveAccuracy,
    require_shoulder,
)
from flexbearing.case.balls.mounting import (
    BallTemperatures,
    FastMaterials,
    MountedBearing,
    MountedCase,
)
from flexbearing.case.balls.pair import Pair
from flexbearing.case.balls.parts import (
    CELLS,
    DISPLACEMENT,
    INTERFACE,
    LOAD,
    MODEL,
    NO_CLASSES,
    ONE_FRICTION,
    PLACES,
    RIGHT_ANGLE,
    SPIN,
    STICKING,
    USUAL_CELLS,
    EndingGroove,
    FrictionModel,
    RingLoad,
    Whole,
    require_quarters,
)
from flexbearing.case.balls.ring_room import Race, elastic_groove, require_room
from flexbearing.case.coupling import MethodsOfCoupling
from flexbearing.case.film_oil import FilmOil, require_contacts_in_oil
from flexbearing.case.fits import FITTED
from flexbearing.case.head import KIND
from flexbearing.case.mounted import require_growing
from flexbearing.case.outputs import RingOutputs
from flexbearing.case.quantity import (
    Angle,
    Force,
    Length,
    Moment,
    Section,
    Speed,
    at_most,
    impossible,
    key,
    needed,
    require,
    require_one,
)
from flexbearing.case.raceway_waves import FormErrors, Waves
from flexbearing.case.ratings import BallLife, require_ratable

PLANE = "about the point of the bearing axis in the plane of the inner groove centres"
HIGHEST = 0.03  # of the pitch radius: cam whose largest load is still known to some 10 %, assumed
OILED = {"operation.control": ("oil",)}  # contacts of balls in oil
PRELOAD = "operation.preload; give operation.displacement.axial instead"
DIRECTIONS = {  # name of a load, and of the displacement that may be held instead
    "axial": "axial",
    "radial_y": "radial_y",
    "radial_z": "radial_z",
    "moment_y": "tilt_y",
    "moment_z": "tilt_z",
}


class BallRoughness(Section):
    """Root-mean-square roughness of the surfaces, about 1.25 Ra."""

    ball: Length = key("Rq of the balls", example="0.02 um", gt=0)
    inner_raceway: Length = key("Rq of the inner raceway", example="0.05 um", gt=0)
    outer_raceway: Length = key("Rq of the outer raceway", example="0.05 um", gt=0)


class BallOil(FilmOil):
    """The oil: by name, by its data sheet, or by its data at the inlet temperature; and its laws."""

    film: Literal["hamrock_dowson", "hamrock_dowson_minimum"] = key(
        "regression of the film thickness: central, or minimum", "hamrock_dowson"
    )


class AngularGroove(EndingGroove):
    """A groove whose shoulders may differ."""

    open_shoulder: Length | None = key(
        "height of the low shoulder, over which reversed thrust presses the balls; without the key that of "
        "the other one",
        None,
        example="1 mm",
        ge=0,
    )

    @property
    def shoulders(self) -> tuple[float | None, float | None]:
        """Heights of the shoulder that thrust presses and of the other one [m]; None of a groove without."""
        return self.shoulder, self.shoulder if self.open_shoulder is None else self.open_shoulder


class FastBearing(MountedBearing):
    """Balls between one groove in each ring."""

    inner: EndingGroove = key("groove of the inner ring")
    outer: EndingGroove = key("groove of the outer ring")
    balls: int = key("number of balls", example=18, ge=3, le=1000)
    form_error: FormErrors | None = key("form errors: raceways that are not round", None)
    roughness: BallRoughness | None = key(
        "roughness of balls and raceways, for film ratios", None, only=OILED
    )
    cage: BallCage | None = key(
        "the cage; without it nothing carries balls on that the races hardly press", None, only=OILED
    )

    @property
    def groove_angle(self) -> float:
        """Contact angle to whose shape elastic rings are cut [rad]: radial, where none is given."""
        return 0.0

    @property
    def second_row(self) -> Pair | None:
        """What a second row of balls is; None of one row."""
        return None

    @property
    def waves(self) -> dict[Race, Waves]:
        """Form errors of the raceways that are not round."""
        form = self.form_error
        both: dict[Race, Waves | None] = {"inner": form and form.inner, "outer": form and form.outer}
        return {race: waves for race, waves in both.items() if waves}

    def groove_bottom(self, race: Race) -> float:
        """Radius of the bottom of a groove [m]; clearance and growth are far smaller and left out."""
        conformity = getattr(self, race).over(self.ball.diameter)
        depth = conformity - (conformity - 0.5) * cos(self.groove_angle)
        return self.pitch_diameter / 2 + (1 if race == "outer" else -1) * depth * self.ball.diameter

    def row_place(self, race: Race) -> float:
        """Axial place of the groove of the row that is not mirrored, from the middle of both rows [m].

        Zero of one row.
        """
        if self.second_row is None:
            return 0.0
        reach = (getattr(self, race).over(self.ball.diameter) - 0.5) * self.ball.diameter
        beside = reach * sin(self.groove_angle) * (1 if race == "inner" else -1)
        return beside + self.second_row.distance / (
            -2 if self.second_row.arrangement == "back_to_back" else 2
        )

    @model_validator(mode="after")
    def _balls_fit(self) -> Self:
        self.require_room(self.balls)
        if self.cage is not None:
            self.cage.require_room(self.pitch_diameter, self.ball.diameter, self.balls)
        return self

    @model_validator(mode="after")
    def _shoulders_end_on_the_grooves(self) -> Self:
        diameter = self.ball.diameter
        for name, groove in (("inner", self.inner), ("outer", self.outer)):
            radius = groove.over(diameter) * diameter
            for key_of_it, height in zip(("shoulder", "open_shoulder"), groove.shoulders, strict=True):
                if height is not None and height > radius:
                    most = f"at most the groove radius, {1e3 * radius:.4g} mm"
                    raise impossible(f"{name}.{key_of_it}", most)
        return self


class AngularBearing(FastBearing):
    """The bearing."""

    inner: AngularGroove = key("groove of the inner ring")
    outer: AngularGroove = key("groove of the outer ring")
    contact_angle: Angle = key(
        "contact angle without load, from the radial plane; before mounting where there are fits",
        example="15 deg",
        ge=0,
        lt=RIGHT_ANGLE,
    )
    pair: Pair | None = key(
        "a second row of the same balls: a pair of bearings, or a double-row one. Inner rings are in common; "
        "elastic outer rings are two, or one (outer.common); ratings in [life] are those of one row",
        None,
    )

    @property
    def groove_angle(self) -> float:
        """Contact angle to whose shape elastic rings are cut [rad]."""
        return self.contact_angle

    @property
    def second_row(self) -> Pair | None:
        """What a second row of balls is; None of one row."""
        return self.pair

    @property
    def stated_clearance(self) -> float:
        """Radial clearance of the contact angle, P_d = 2 A (1 - cos(alpha)) [m]."""
        return 2 * self.centre_distance * (1 - cos(self.contact_angle))


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


class Preload(Section):
    """Axial preload of a ring that shaft and housing hold: by its force at rest, or by a displacement."""

    force: Force | None = key(
        "axial force that displaces the inner ring at rest, without any other load, to where it is then held",
        None,
        example="250 N",
        gt=0,
    )
    displacement: Length | None = key(
        "axial displacement at which the inner ring is held, beyond that at which all balls just touch",
        None,
        example="5 um",
        gt=0,
    )

    @model_validator(mode="after")
    def _one_of_both(self) -> Self:
        require_one(self, "force", "displacement", "a preload without displacement")
        return self


class FastOperation(Section):
    """Load and speed."""

    inner_speed: Speed = key("speed of the inner ring", example="15000 rpm")
    outer_speed: Speed = key("speed of the outer ring", "0 rpm")
    control: Literal["outer", "inner", "equal", "coulomb", "oil"] = key(
        "race on which the balls do not spin; equal: the spin axis halves the angle between both contacts; "
        "coulomb: no assumption, dry friction in both contacts decides; oil: the same with the tractions of "
        "the oil by [lubricant], its rolling friction and its drag"
    )
    load: FastLoad = key("load on the inner ring; axial pushes the balls against their shoulders", {})
    displacement: Displacement = key("where the inner ring is held instead of loaded", {})
    temperatures: BallTemperatures | None = key(
        "temperatures of the parts, for the operating clearance; without them all have the dimensions given",
        None,
        only=FITTED,
    )
    preload: Preload | None = key(
        "rigid axial preload, in place of operation.load.axial and operation.displacement.axial; that of "
        "springs, whose force stays, is operation.load.axial",
        None,
    )

    @property
    def by_friction(self) -> bool:
        """Whether friction decides what balls do, and no race."""
        return self.control in ("coulomb", "oil")

    @property
    def held(self) -> tuple[str, ...]:
        """Keys that hold the ring in place of a force, which is not known then."""
        places = [f"displacement.{name}" for name in ("axial", "radial_y", "radial_z")]
        held = [place for place in places if getattr(self.displacement, place.partition(".")[2]) is not None]
        by_place = self.preload is not None and self.preload.displacement is not None
        return (*held, *(["preload.displacement"] if by_place else []))

    @property
    def is_pressed(self) -> bool:
        """Whether something beside loads presses the balls."""
        return bool(self.preload or any(self.displacement.values) or self.held)

    @property
    def forces(self) -> tuple[float, float]:
        """Radial and axial force [N], >= 0, that of a preload among them; of a ring that is not `held`."""
        preload = self.preload.force if self.preload and self.preload.force else 0.0
        return hypot(self.load.radial_y, self.load.radial_z), abs(self.load.axial) + preload

    @model_validator(mode="after")
    def _preload_stands_alone(self) -> Self:
        if self.preload and self.load.axial:
            raise impossible("load.axial", '"0 N" beside operation.preload, which holds the ring axially')
        if self.preload and self.displacement.axial is not None:
            raise impossible("displacement.axial", "left out beside operation.preload, which gives it")
        return self

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


class FastCase(MountedCase):
    """Balls between one groove in each ring, at rest or at speed."""

    former = LOAD | DISPLACEMENT | ONE_FRICTION
    hints = NO_CLASSES | PLACES
    file_keys = "outer.file", "outer.matrix", "outer.nodes"

    bearing: FastBearing = key("the bearing")
    materials: FastMaterials = key("the materials")
    operation: FastOperation = key("load and speed")
    friction: FastFriction = key("friction of the contacts")
    rolling_lines: RollingLines = key("lines on which the balls roll without slip", {})
    lubricant: BallOil | None = key(
        'the oil, for the viscosity ratio of ISO 281, and for the balls with operation.control = "oil"', None
    )
    life: BallLife = key("what the life is rated with, and what modifies it", {})
    outputs: RingOutputs = key("further results to compute", {})
    outer: BallOuter = key("what carries the outer groove", {})
    inner: BallInner = key("what carries the inner groove", {})
    accuracy: GrooveAccuracy = key("how finely elastic rings are resolved", {})
    coupling: MethodsOfCoupling = key("how balls and elastic rings are solved together", {})

    @property
    def drawing(self) -> Path | None:
        """STEP file of the outer ring, next to the case file; None for a ring that is not drawn."""
        return held_ring.drawing(self)

    @property
    def seat(self) -> tuple[float, float]:
        """Radius of the outer surface of an elastic outer ring, and offset of its groove [m]."""
        groove, _ = elastic_groove(self, "outer")
        return groove.bottom(1) + (self.outer.thickness or 0.0), self.outer.groove_offset

    def one_ring(self, race: Race) -> bool:
        """Whether two rows of balls are in one elastic ring."""
        return False

    @property
    def rigid(self) -> bool:
        """Whether both rings are rigid."""
        return self.outer.kind == self.inner.kind == "rigid"

    @property
    def in_fit(self) -> bool:
        """Whether an elastic outer ring touches its housing only where it is pressed on it."""
        housed = self.outer.kind == "ring" and self.outer.support == "housing"
        return housed and self.housing_interference is not None

    @property
    def lifts_off(self) -> bool:
        """Whether what holds the outer ring only pushes, so that its raceway is not linear."""
        return self.outer.lifts_off or self.in_fit

    @property
    def housing_interference(self) -> float | None:
        """Diametral interference of outer ring and housing, cold [m]; None where none is given."""
        if self.outer.housing_clearance is not None:
            return -self.outer.housing_clearance
        return super().housing_interference

    @model_validator(mode="after")
    def _elastic_rings_are_known(self) -> Self:
        if self.outer.kind != "rigid":
            require_shoulder("outer", self.bearing.outer)
            if self.outer.kind == "step" and self.operation.outer_speed:
                allowed = '"0 rpm" for outer.kind = "step": outer.clamps do not move'
                raise impossible("operation.outer_speed", allowed)
            if self.outer.kind == "step" and self.accuracy.target is not None:
                allowed = 'left out for outer.kind = "step", whose elements have no levels'
                raise impossible("accuracy.target", allowed)
            self._require_fit()
        if self.inner.kind == "ring_on_shaft":
            require_shoulder("inner", self.bearing.inner)
        housed = self.outer.kind != "rigid" and self.outer.support == "housing"
        self.require_ring_materials(housed, self.inner.kind == "ring_on_shaft")
        require_room(self)
        return self

    def _require_fit(self) -> None:
        """Raise unless the fit in an elastic housing is given once, with what widens it."""
        clearance, fits, operation = self.outer.housing_clearance, self.bearing.fits, self.operation
        if clearance is not None and fits:
            if fits.housing:
                allowed = "left out: bearing.fits.housing.interference says the same with the opposite sign"
                raise impossible("outer.housing_clearance", allowed)
            if clearance < 0:
                allowed = "zero or more: beside [bearing.fits] bearing.fits.housing.interference is needed"
                raise impossible("outer.housing_clearance", allowed)
            if operation.temperatures and operation.temperatures.housing is None:
                raise needed(["operation.temperatures.housing"], "outer.housing_clearance")
        ring = self.materials.ring("outer")
        if self.in_fit and operation.outer_speed and getattr(ring, "density", None) is None:
            raise needed(["materials.outer_ring.density"], "an outer ring that turns in its housing")

    @model_validator(mode="after")
    def _oil_moves_the_balls(self) -> Self:
        oiled, choice = self.operation.control == "oil", 'operation.control = "oil"'
        require_contacts_in_oil(self.lubricant, oiled, choice, self.bearing.roughness is not None)
        if oiled and self.friction.model != "full_sliding":
            raise impossible("friction.model", f'"full_sliding" with {choice}')
        return self

    @model_validator(mode="after")
    def _out_of_round(self) -> Self:
        on_cam = self.inner.kind == "cam"
        if on_cam and self.outer.kind == "rigid":
            raise impossible("outer.kind", 'another one than "rigid" around a cam, which it follows')
        if self.operation.preload and self.bearing.waves:
            raise impossible("bearing.form_error", f"left out beside {PRELOAD}")
        if not on_cam:
            return self
        if self.operation.preload:
            raise impossible("inner.kind", f'another one than "cam" beside {PRELOAD}')
        if require(self.inner, ("cam_amplitude",), "a cam")[0] > HIGHEST * self.bearing.pitch_diameter / 2:
            most = at_most(HIGHEST * self.bearing.pitch_diameter / 2)
            raise impossible("inner.cam_amplitude", f"{most}, {HIGHEST:.0%} of the pitch radius")
        return self

    @model_validator(mode="after")
    def _second_row(self) -> Self:
        pair = self.bearing.second_row
        if pair is None:
            return self
        pair.require_apart(self.bearing.ball.diameter, "the ball diameter")
        self._require_rings_of_pairs(pair)
        if self.operation.preload:
            raise impossible("operation.preload", "left out beside bearing.pair, which has a preload")
        if self.bearing.cage is not None:
            raise impossible("bearing.cage", "left out beside bearing.pair: only one row has a cage here")
        return self

    def _require_rings_of_pairs(self, pair: Pair) -> None:
        """Raise unless two rows of balls may be between such rings."""
        for name, kinds in (("outer", ("rigid", "ring")), ("inner", ("rigid", "ring_on_shaft"))):
            if getattr(self, name).kind not in kinds:
                raise impossible(f"{name}.kind", f'"{kinds[0]}" or "{kinds[1]}" beside bearing.pair')
        if self.outer.kind == "ring":
            self.outer.require_held_along_the_axis()
        if self.in_fit:
            name = "outer.housing_clearance" if self.bearing.fits is None else "bearing.fits.housing"
            raise impossible(name, "left out beside bearing.pair, whose rings are bonded to a housing")
        if not pair.opposed and (self.inner.kind != "rigid" or self.one_ring("outer")):
            raise impossible("bearing.pair.arrangement", "another one of two rows in one elastic ring")

    @model_validator(mode="after")
    def _life_can_be_rated(self) -> Self:
        require_ratable(self.life, self.operation, self.lubricant)
        return self

    @model_validator(mode="after")
    def _warm_parts_are_known(self) -> Self:
        if self.bearing.fits:
            require_growing(self.bearing.fits, self.materials, self.operation.temperatures, "ball")
        return self


class AngularCase(FastCase):
    """A fast angular-contact ball bearing."""

    kind: Literal["angular_contact_ball"] = key(KIND)
    bearing: AngularBearing = key("the bearing")
    outer: AngularOuter = key("what carries the outer groove", {})

    def one_ring(self, race: Race) -> bool:
        """Whether two rows of balls are in one elastic ring."""
        return self.bearing.pair is not None and (race == "inner" or self.outer.common)
