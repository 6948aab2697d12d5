"""The sections [outer], [inner] and [accuracy] of a bearing with fast balls: what carries its grooves."""

from typing import Literal, Self

from pydantic import model_validator

from flexbearing.case import accuracy, held_ring
from flexbearing.case.balls import groove_accuracy
from flexbearing.case.balls.parts import EndingGroove
from flexbearing.case.held_ring import CAGE, MATRIX, ON_SHAFT, RING, STEP, Direction
from flexbearing.case.quantity import (
    GIVEN,
    Angle,
    Force,
    Foundation,
    Fraction,
    Length,
    Section,
    impossible,
    key,
    needed,
    require,
)

ELASTIC = ({"outer.kind": ("ring", "squirrel_cage", "step", "matrix")}, {"inner.kind": ("ring_on_shaft",)})
ON_CAM = {"kind": ("cam",)}
OF_RING = {"kind": ("ring", "squirrel_cage", "matrix")}
HELD = {**RING, "support": ("side", "seat", "foundation", "housing")}  # along the axis, too


class BallOuter(Section):
    """What carries the outer groove."""

    kind: Literal["rigid", "ring", "squirrel_cage", "step", "matrix"] = key(
        "rigid; a ring with its groove cut in; such a ring on bars, spread evenly around "
        "it, whose flange is clamped; a solid drawn in a STEP file, with its groove; or a ring bonded to a "
        "body whose stiffness another finite element program wrote",
        "rigid",
    )
    thickness: Length | None = key(
        "radial thickness of the ring at the bottom of its groove", None, example="4 mm", gt=0, only=OF_RING
    )
    width: Length | None = key("axial width of the ring", None, example="19 mm", gt=0, only=OF_RING)
    groove_offset: Length = key(
        "axial distance from the middle of the ring's width to the centre of the groove, or to the middle "
        "between two of them, positive towards +x, where the side face is held or the bars are",
        "0 mm",
        example="1 mm",
        only=(HELD, CAGE, MATRIX),
    )
    support: Literal["side", "seat", "foundation", "housing", "lines", "planet"] = key(
        "what holds the ring: its side face at the end of x; a rigid seat or springs per area on its outer "
        "surface, which push and pull; a housing; frictionless lines on that surface; or "
        "nothing, as rim of a planet gear between its tooth forces. Lines, teeth and a housing that is not "
        "bonded leave the ring free along its axis: it stays where its groove does in the mean",
        "side",
        only=RING,
    )
    foundation_radial: Foundation = held_ring.foundation_radial()
    foundation_axial: Foundation = held_ring.foundation("axial")
    foundation_tangential: Foundation = held_ring.foundation("tangential")
    housing_thickness: Length | None = held_ring.housing_thickness()
    housing_width: Length | None = held_ring.housing_width()
    housing_support: Literal["seat", "side"] = held_ring.housing_support()
    housing_clearance: Length | None = held_ring.housing_clearance(" (negative: an interference)")
    bilateral: bool | None = key(
        "whether lines or springs also pull; without it springs do and lines do not. The ring lifts off what "
        "only pushes",
        None,
        example=False,
        only={**RING, "support": ("lines", "foundation")},
    )
    line_azimuths: tuple[Angle, ...] = held_ring.line_azimuths()
    tooth_azimuths: tuple[Angle, ...] = held_ring.tooth_azimuths()
    tooth_radial: tuple[Force, ...] = held_ring.tooth_forces("radial parts, outward", ["-2 kN", "-2 kN"])
    tooth_tangential: tuple[Force, ...] = held_ring.tooth_forces(
        "tangential parts, towards growing azimuth", ["5 kN", "-5 kN"]
    )
    tooth_radius: Length | None = held_ring.tooth_radius()
    bars: int | None = held_ring.bars()
    bar_width: Length | None = held_ring.of_cage("tangential width of a bar")
    bar_thickness: Length | None = held_ring.bar_thickness(
        "between the shoulder of the groove and the outside of the ring"
    )
    bar_length: Length | None = held_ring.of_cage("axial length of the bars")
    flange_length: Length | None = held_ring.of_cage("axial length of the flange behind the bars")
    bar_ends: Literal["one", "both"] = held_ring.bar_ends()
    file: str | None = held_ring.file()
    clamps: tuple[str, ...] = held_ring.clamps()
    matrix: str | None = held_ring.matrix()
    nodes: str | None = held_ring.nodes()
    length_unit: Length = held_ring.length_unit()
    force_unit: Force = held_ring.force_unit()
    axis: Direction = held_ring.axis((STEP, MATRIX))
    zenith: Direction = held_ring.zenith((STEP, MATRIX))
    centre_x: Length = held_ring.centre(
        "centre of the groove in the drawing or mesh, along its x", (STEP, MATRIX)
    )
    centre_y: Length = held_ring.centre("the same along y", (STEP, MATRIX))
    centre_z: Length = held_ring.centre("the same along z", (STEP, MATRIX))

    @property
    def lifts_off(self) -> bool:
        """Whether what holds the ring only pushes, so that its raceway is not linear."""
        pulls = self.support != "lines" if self.bilateral is None else self.bilateral
        return self.kind == "ring" and self.support in ("lines", "foundation") and not pulls

    def require_held_along_the_axis(self) -> None:
        """Raise unless what holds a ring does so along the axis, and pulls as well as pushes."""
        if self.support in ("lines", "planet"):
            raise impossible("outer.support", '"side", "seat", "foundation" or "housing" beside bearing.pair')
        if self.lifts_off:
            raise impossible("outer.bilateral", "true beside bearing.pair")
        if self.support == "foundation" and not self.foundation_axial:
            raise impossible("outer.foundation_axial", "above zero beside bearing.pair")

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if self.kind == "rigid":
            return self
        if self.kind == "step":
            held_ring.require_drawn(self)
            return self
        require(self, ("thickness", "width"), f'outer.kind = "{self.kind}"')
        if self.kind == "ring":
            held_ring.require_support(self)
        elif self.kind == "matrix":
            require(self, ("matrix", "nodes"), 'outer.kind = "matrix"')
            held_ring.require_directions(self)
        else:
            held_ring.require_bars(self)
        return self


class AngularOuter(BallOuter):
    """The same of a bearing that may have two rows."""

    common: bool = key(
        "whether both rows of bearing.pair are in this one ring, whose middle is between them; without it "
        "each row has a ring of its own, held alike, the mirror image of the other but in tandem",
        False,
        only={**RING, "bearing.pair": GIVEN},
    )


class BallInner(held_ring.OnShaft):
    """What carries the inner groove."""

    kind: Literal["rigid", "ring_on_shaft", "cam"] = key(
        "rigid; a ring bonded on a shaft with both ends clamped, which move with the ring, both rows of "
        "bearing.pair in it; or a thin ring "
        "that a rigid cam shapes, as in a strain-wave gear, to which an elastic outer ring gives way",
        "rigid",
    )
    bore: Length | None = key(
        "bore of the ring, outside of the shaft", None, example="45 mm", gt=0, only=ON_SHAFT
    )
    width: Length | None = key("axial width of the ring", None, example="19 mm", gt=0, only=ON_SHAFT)
    shaft_thickness: Length | None = held_ring.shaft_thickness()
    shaft_length: Length | None = held_ring.shaft_length()

    cam_amplitude: Length | None = key(
        "by how much the cam raises the raceway on its major axis", None, example="0.2 mm", gt=0, only=ON_CAM
    )
    cam_curve: Literal["ellipse", "cosine", "length_kept"] = key(
        "curve of the raceway on the cam: an ellipse, radii like cos 2 phi, or these on a curve as long as "
        "the circle",
        "ellipse",
        only=ON_CAM,
    )
    cam_crest: Angle = key(
        "azimuth of the major axis, from z towards y, at the moment that is solved", "0 deg", only=ON_CAM
    )

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if self.kind == "ring_on_shaft":
            held_ring.require_shaft(self)
        if self.kind == "cam":
            require(self, ("cam_amplitude",), 'inner.kind = "cam"')
        return self


class GrooveAccuracy(Section):
    """How finely elastic rings with grooves are resolved: as given, or as a target requires."""

    target: Fraction | None = accuracy.target("ball", ELASTIC)
    patch_width: Length | None = groove_accuracy.patch_width(ELASTIC)
    stations: groove_accuracy.Odd = groove_accuracy.stations(7, ELASTIC)
    element_order: int | None = groove_accuracy.element_order(ELASTIC)
    mesh_size: Length | None = groove_accuracy.mesh_size(ELASTIC)


def require_shoulder(name: str, groove: EndingGroove) -> None:
    """Raise unless the shoulder of a groove in an elastic ring is known."""
    if groove.shoulder is None:
        raise needed([f"bearing.{name}.shoulder"], f"an elastic {name} ring, whose section it is part of")
