"""The section [rings] of a four-point bearing: rings that are on a bolted face."""

from math import acos, asin, cos, pi, sin, sqrt
from typing import ClassVar, Literal, NamedTuple, Self

from pydantic import field_validator, model_validator
from pydantic_core import PydanticCustomError

from flexbearing.case.balls import groove_accuracy
from flexbearing.case.balls.parts import AXES_CHANGED
from flexbearing.case.quantity import (
    Angle,
    Foundation,
    Length,
    Section,
    at_most,
    impossible,
    key,
    needed,
    require,
)

_BOLTED = {"kind": ("bolted",)}
_ANY_BOLTED = ({"rings.outer.kind": ("bolted",)}, {"rings.inner.kind": ("bolted",)})


class Groove(NamedTuple):
    """A groove of two arches."""

    pitch_diameter: float  # [m]
    ball_diameter: float  # [m]
    radius: float  # [m] of the arches
    angle: float  # [rad] contact angle without load

    def half_width(self, end: float) -> float:
        """From the plane of the ball centres to where arches end at a contact angle [m]."""
        return self.radius * sin(end) - self.aside

    @property
    def aside(self) -> float:
        """Of the centres of the arches from the plane of the ball centres [m]."""
        return self._offset * sin(self.angle)

    @property
    def inward(self) -> float:
        """Of the centres of the arches from the pitch circle, to the axis from the outer race [m]."""
        return self._offset * cos(self.angle)

    def arc(self, end: float) -> float:
        """Length of an arch that ends at a contact angle [m]."""
        return self.radius * (end - asin(self.aside / self.radius))

    @property
    def depth(self) -> float:
        """From the centres of the arches to where both arches meet, along the radius [m]."""
        return sqrt(self.radius**2 - self.aside**2)

    def bottom_diameter(self, outward: int) -> float:
        """Diameter where both arches meet [m]."""
        return self.pitch_diameter + 2 * outward * (self.depth - self.inward)

    def end_at(self, shoulder: float) -> float:
        """Contact angle at which arches end on a shoulder of a height above where they meet [rad]."""
        return acos((self.depth - shoulder) / self.radius)

    @property
    def _offset(self) -> float:
        return self.radius - self.ball_diameter / 2


class BoltedRing(Section):
    """A ring, rigid or of rectangular section."""

    far: ClassVar[str]  # key of the diameter opposite the groove
    outward: ClassVar[int]  # sign of the radial direction from the balls into the ring

    kind: Literal["rigid", "bolted"] = key(
        "rigid; or a ring of rectangular section with the groove cut out, one end face of which is held as a "
        "whole on something rigid or on springs",
        "rigid",
    )
    width: Length | None = key("axial width of the ring", None, example="80 mm", gt=0, only=_BOLTED)
    face_distance: Length | None = key(
        "distance of the bolted face from the plane of the ball centres",
        None,
        example="45 mm",
        gt=0,
        only=_BOLTED,
    )
    face: Literal["+x", "-x"] | None = key("end face that is bolted", None, only=_BOLTED)
    face_stiffness: Foundation | None = key(
        "springs per area under the bolted face, along x; without this key the face is rigid",
        None,
        example="500 N/mm^3",
        gt=0,
        only=_BOLTED,
    )
    face_shear_stiffness: Foundation | None = key(
        "the same along the face, both ways", None, example="200 N/mm^3", gt=0, only=_BOLTED
    )
    groove_end: Angle = key(
        "contact angle at which the shoulders cut the arches", "75 deg", gt=0, lt=pi / 2, only=_BOLTED
    )

    @field_validator("face", mode="before")
    @classmethod
    def _axes_of_today(cls, face: object) -> object:
        if face in ("+z", "-z"):
            new = str(face).replace("z", "x")
            raise PydanticCustomError("quantity", "{why}", {"why": f'is now "{new}" ({AXES_CHANGED})'})
        return face

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if self.kind == "rigid":
            return self
        require(self, ("width", "face_distance", "face", self.far), 'kind = "bolted"')
        if (self.face_stiffness is None) != (self.face_shear_stiffness is None):
            names = ("face_stiffness", "face_shear_stiffness")
            require(self, names, "a face on springs")
        return self

    def misfit(self, groove: Groove) -> tuple[str, str] | None:
        """Key that leaves no room for the groove, and what it must be; None when there is room."""
        width, distance, far = require(self, ("width", "face_distance", self.far), self.kind)
        if self.groove_end <= groove.angle:
            return "groove_end", "above bearing.contact_angle"
        half = groove.half_width(self.groove_end)
        if distance <= half:
            return "face_distance", f"above {half * 1e3:.4g} mm, half the width of the groove"
        if width <= distance + half:
            return "width", f"above {(distance + half) * 1e3:.4g} mm, or the groove reaches the other face"
        if self.outward * (far - groove.bottom_diameter(self.outward)) <= 0:
            side = "above" if self.outward > 0 else "below"
            return (
                self.far,
                f"{side} {groove.bottom_diameter(self.outward) * 1e3:.5g} mm, the groove's bottom",
            )
        return None


class BoltedOuter(BoltedRing):
    """The ring around the balls."""

    far = "outside_diameter"
    outward = 1

    outside_diameter: Length | None = key(
        "outside diameter of the ring", None, example="2060 mm", gt=0, only=_BOLTED
    )


class BoltedInner(BoltedRing):
    """The ring inside the balls."""

    far = "bore"
    outward = -1

    bore: Length | None = key("bore of the ring", None, example="1740 mm", gt=0, only=_BOLTED)


class Rings(Section):
    """The rings, rigid unless they are described, and how finely they are resolved."""

    outer: BoltedOuter = key("the ring around the balls, its bolted face at rest", {})
    inner: BoltedInner = key(
        "the ring inside the balls; its bolted face moves as a rigid body and takes operation.load", {}
    )
    patch_width: Length | None = groove_accuracy.patch_width(_ANY_BOLTED)
    stations: groove_accuracy.Odd = groove_accuracy.stations(5, _ANY_BOLTED)
    element_order: int = groove_accuracy.element_order(_ANY_BOLTED)
    mesh_size: Length | None = groove_accuracy.mesh_size(_ANY_BOLTED)

    def patch(self, ball_diameter: float) -> float:
        """Standard deviation of the patches [m]."""
        return self.patch_width or groove_accuracy.PATCH * ball_diameter

    def require_room(self, inner: Groove, outer: Groove) -> None:
        """Raise unless the grooves of the bearing fit into the rings, and patches on their arches."""
        for name, ring, groove in (("outer", self.outer, outer), ("inner", self.inner, inner)):
            if ring.kind == "rigid":
                continue
            if misfit := ring.misfit(groove):
                raise impossible(f"rings.{name}.{misfit[0]}", misfit[1])
            widest = groove.arc(ring.groove_end) / (2 * groove_accuracy.SHORTEST)
            if self.patch(groove.ball_diameter) <= widest:
                continue
            if self.patch_width is not None:
                part = f"{1 / (2 * groove_accuracy.SHORTEST):g} of an arch of the {name} groove"
                raise impossible("rings.patch_width", f"{at_most(widest)}, {part}")
            raise needed(
                ["rings.patch_width"], f"arches of the {name} ring as short as rings.{name}.groove_end"
            )
