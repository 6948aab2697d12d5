"""The sections [outer] and [inner]: what carries the raceways."""

from typing import ClassVar, Literal, Self

from pydantic import model_validator

from flexbearing.case import held_ring
from flexbearing.case.held_ring import (
    CAGE as _CAGE,
    MATRIX,
    ON_SHAFT as _ON_SHAFT,
    RING as _RING,
    STEP as _STEP,
    Direction,
)
from flexbearing.case.quantity import (
    Angle,
    Force,
    Foundation,
    Length,
    Section,
    impossible,
    in_mm,
    key,
    require,
)

_HELD = {**_RING, "support": ("side", "seat", "foundation", "housing")}


class Outer(Section):
    """What carries the outer raceway."""

    kind: Literal["rigid", "ring", "squirrel_cage", "step", "matrix"] = key(
        "rigid; a plain ring; a ring on bars whose flange is clamped; a solid drawn in a STEP file; or a "
        "plain ring bonded to a body whose stiffness another finite element program wrote"
    )
    thickness: Length | None = key(
        "radial thickness of the ring", None, gt=0, only={"kind": ("ring", "squirrel_cage", "matrix")}
    )
    width: Length | None = key(
        "axial width of the ring", None, gt=0, only={"kind": ("ring", "squirrel_cage", "matrix")}
    )
    raceway_offset: Length = key(
        "axial distance from the middle of the ring's width to the middle of the rollers, positive towards "
        "+x, where the bars are or the side face is held",
        "0 mm",
        example="1 mm",
        only=(_HELD, _CAGE, MATRIX),
    )
    support: Literal["side", "seat", "foundation", "housing", "lines", "planet"] = key(
        "what holds a plain ring: its side face at the end of x; a rigid seat or springs per area on its "
        "outer surface; a housing; frictionless lines on that surface; or nothing, as rim of "
        "a planet gear between its tooth forces",
        "side",
        only=_RING,
    )
    foundation_radial: Foundation = held_ring.foundation_radial()
    foundation_axial: Foundation = held_ring.foundation("axial")
    foundation_tangential: Foundation = held_ring.foundation("tangential")
    housing_thickness: Length | None = held_ring.housing_thickness()
    housing_width: Length | None = held_ring.housing_width()
    housing_support: Literal["seat", "side"] = held_ring.housing_support()
    housing_clearance: Length | None = held_ring.housing_clearance(ge=0)
    bilateral: bool = key(
        "whether lines or radial springs of the foundation also pull; without it they only push, and the "
        "ring lifts off them",
        False,
        only={**_RING, "support": ("lines", "foundation")},
    )
    line_azimuths: tuple[Angle, ...] = held_ring.line_azimuths()
    tooth_azimuths: tuple[Angle, ...] = held_ring.tooth_azimuths()
    tooth_radial: tuple[Force, ...] = held_ring.tooth_forces("radial parts, outward", ["-2 kN", "-2 kN"])
    tooth_tangential: tuple[Force, ...] = held_ring.tooth_forces(
        "tangential parts, towards growing azimuth", ["5 kN", "-5 kN"]
    )
    tooth_axial: tuple[Force, ...] = held_ring.tooth_forces(
        "axial parts, towards +x, of helical teeth; zero without them", ["1 kN", "-1 kN"]
    )
    tooth_radius: Length | None = held_ring.tooth_radius()
    bars: int | None = held_ring.bars()
    bar_width: Length | None = held_ring.of_cage("tangential width of a bar")
    bar_thickness: Length | None = held_ring.bar_thickness("in the thickness of the ring, a collar left out")
    bar_length: Length | None = held_ring.of_cage("axial length of the bars")
    fillet: Length = key("fillet radius where bars meet ring and flange", "0 mm", ge=0, only=_CAGE)
    flange_length: Length | None = held_ring.of_cage("axial length of the flange behind the bars")
    bar_ends: Literal["one", "both"] = held_ring.bar_ends()
    collar_length: Length = key(
        "axial length of a thicker end of the ring under the bars, part of outer.width; 0 is a ring without",
        "0 mm",
        ge=0,
        only=_CAGE,
    )
    collar_thickness: Length | None = key(
        "radial thickness of the ring there: it grows outwards, bars and flange stay where they are",
        None,
        example="6 mm",
        gt=0,
        only=_CAGE,
    )

    file: str | None = held_ring.file()
    clamps: tuple[str, ...] = held_ring.clamps()
    raceway: str | None = key(
        "name or colour of the raceway, where two cylinders of about its diameter are drawn",
        None,
        example="race",
        only=_STEP,
    )
    matrix: str | None = held_ring.matrix()
    nodes: str | None = held_ring.nodes()
    length_unit: Length = held_ring.length_unit()
    force_unit: Force = held_ring.force_unit()
    axis: Direction = held_ring.axis((_STEP, MATRIX))
    zenith: Direction = held_ring.zenith((_STEP, MATRIX))
    centre_x: Length = held_ring.centre(
        "middle of the rollers in the drawing or mesh, along its x", (_STEP, MATRIX)
    )
    centre_y: Length = held_ring.centre("the same along y", (_STEP, MATRIX))
    centre_z: Length = held_ring.centre("the same along z", (_STEP, MATRIX))

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if self.kind == "rigid":
            return self
        if self.kind == "step":
            held_ring.require_drawn(self)
            return self
        require(self, ("thickness", "width"), f'outer.kind = "{self.kind}"')
        if self.kind == "matrix":
            require(self, ("matrix", "nodes"), 'outer.kind = "matrix"')
            held_ring.require_directions(self)
        if self.kind == "ring":
            held_ring.require_support(self)
            if len(self.tooth_axial) not in (0, len(self.tooth_azimuths)):
                raise impossible("tooth_axial", "as many numbers as tooth_azimuths, or left out")
        if self.kind == "squirrel_cage":
            held_ring.require_bars(self)
            self._require_collar()
        return self

    def _require_collar(self) -> None:
        """Raise unless a collar is a thicker part of the ring."""
        if not self.collar_length:
            return
        width, thickness, collar = require(
            self, ("width", "thickness", "collar_thickness"), "outer.collar_length"
        )
        if collar < thickness:
            raise impossible("collar_thickness", f"at least {in_mm(thickness)}, outer.thickness")
        ends = {"one": 1, "both": 2}[self.bar_ends]
        if self.collar_length > width / ends:
            part = "half of outer.width, as there are two" if ends == 2 else "outer.width"
            raise impossible("collar_length", f"at most {part}: the collar is a part of the ring")

    def require_room(self, raceway_diameter: float, roller_length: float) -> None:
        """Raise unless the ring is as wide as the rollers and its bars do not touch."""
        if self.kind in ("rigid", "step"):
            return
        width, thickness = require(self, ("width", "thickness"), self.kind)
        if width < roller_length:
            raise impossible("width", "at least bearing.roller.length")
        if width < roller_length + 2 * abs(self.raceway_offset):
            most = (width - roller_length) / 2
            allowed = f"{-most * 1e3:.4g} to {most * 1e3:.4g} mm, or the rollers leave the ring"
            raise impossible("raceway_offset", allowed)
        if self.kind == "squirrel_cage":
            held_ring.require_room_for_bars(self, raceway_diameter, thickness, "outer.thickness")
        outside = raceway_diameter / 2 + thickness
        held_ring.require_teeth_outside(self, outside)


class Inner(held_ring.OnShaft):
    """What carries the inner raceway."""

    kind: Literal["rigid", "ring_on_shaft"] = key("rigid; or a ring on a shaft with both ends clamped")
    bore: Length | None = key(
        "bore of the ring, outside of the shaft", None, example="60 mm", gt=0, only=_ON_SHAFT
    )
    thickness: Length | None = key(
        "radial thickness of the ring over its ribs; a ring without ribs ends at its raceway",
        None,
        gt=0,
        only=_ON_SHAFT,
    )
    width: Length | None = key("axial width of the ring", None, gt=0, only=_ON_SHAFT)
    track_width: Length | None = key(
        "axial width of the raceway between the ribs; inner.width for a ring without ribs, as of NU bearings",
        None,
        gt=0,
        only=_ON_SHAFT,
    )
    shaft_thickness: Length | None = held_ring.shaft_thickness()
    shaft_length: Length | None = held_ring.shaft_length()

    fit: Literal["bonded", "frictionless", "friction"] = key(
        "how ring and shaft hold each other: as one piece; by pressure alone; or by pressure and friction",
        "bonded",
        only=_ON_SHAFT,
    )
    fit_friction: float = key(
        'Coulomb friction in the fit, fit = "friction"',
        0.1,
        ge=0,
        le=10,
        only={**_ON_SHAFT, "fit": ("friction",)},
    )
    shoulder_diameter: Length | None = key(
        "diameter of the shaft's shoulder beyond the ring; without it there is none",
        None,
        gt=0,
        only={**_ON_SHAFT, "fit": ("frictionless", "friction")},
    )
    clamping: Force = key(
        "force with which a nut presses the ring on the shoulder",
        "0 N",
        ge=0,
        only={**_ON_SHAFT, "fit": ("frictionless", "friction")},
    )

    _dimensions: ClassVar = ("bore", "width", "track_width", "shaft_length")

    @property
    def ribbed(self) -> bool:
        """Whether the ring has ribs beside the track of its rollers."""
        return self.track_width != self.width

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if self.kind == "rigid":
            return self
        _, width, track_width, _ = require(self, self._dimensions, 'inner.kind = "ring_on_shaft"')
        held_ring.require_shaft(self)
        if track_width > width:
            raise impossible("track_width", "at most inner.width, which is a ring without ribs")
        if self.ribbed:
            require(self, ("thickness",), "a ring with ribs")
        if self.clamping:
            require(self, ("shoulder_diameter",), "inner.clamping")
        return self

    def require_room(self, raceway_diameter: float, roller_length: float) -> None:
        """Raise unless the raceway lies between bore and ribs, and the rollers between the ribs."""
        if self.kind == "rigid":
            return
        bore, _, track_width, _ = require(self, self._dimensions, self.kind)
        if track_width < roller_length:
            raise impossible("track_width", "at least bearing.roller.length")
        if raceway_diameter <= bore:
            raise impossible("bore", f"below the inner raceway diameter {raceway_diameter * 1e3:.4g} mm")
        if self.ribbed and raceway_diameter >= bore + 2 * (self.thickness or 0.0):
            least = (raceway_diameter - bore) / 2
            raise impossible("thickness", f"more than {least * 1e3:.4g} mm: ribs are above the raceway")
