"""The section [rings] of a four-point bearing: rings that are on a bolted face."""

from collections.abc import Mapping
from math import degrees, pi
from typing import TYPE_CHECKING, ClassVar, Literal, Self

from pydantic import field_validator, model_validator
from pydantic_core import PydanticCustomError

from flexbearing.case.balls import groove_accuracy
from flexbearing.case.balls.parts import AXES_CHANGED
from flexbearing.case.quantity import (
    Angle,
    Foundation,
    Length,
    Section,
    impossible,
    key,
    require,
)

if TYPE_CHECKING:
    from fem.parts.groove import Groove

_BOLTED = {"kind": ("bolted",)}
_ANY_BOLTED = ({"rings.outer.kind": ("bolted",)}, {"rings.inner.kind": ("bolted",)})


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

    def require_room(self, groove: "Groove", where: str) -> None:
        """Raise unless a groove of the bearing fits into the ring of a section."""
        from fem.parts.bolted_ring import misfit  # not described between rigid rings

        lengths = require(self, (self.far, "width", "face_distance"), self.kind)
        if wrong := misfit(groove, groove.half_width(self.groove_end), self.outward, *lengths):
            name, allowed = wrong
            raise impossible(f"{where}.{self.far if name == 'far_diameter' else name}", allowed)


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
    element_order: int | None = groove_accuracy.element_order(_ANY_BOLTED)
    mesh_size: Length | None = groove_accuracy.mesh_size(_ANY_BOLTED)

    def require_room(self, races: "Mapping[str, Groove]", contact_angle: float, ball_diameter: float) -> None:
        """Raise unless the grooves of the bearing fit into the rings, and patches on their arches."""
        for name, groove in races.items():
            ring, where = getattr(self, name), f"rings.{name}"
            if ring.groove_end <= contact_angle:
                raise impossible(f"{where}.groove_end", "above bearing.contact_angle")
            ring.require_room(groove, where)
            radius, first = groove.radius, groove.bottom_angle

            def least(half: float, radius: float = radius, first: float = first) -> str:
                return f"at least {degrees(2 * half / radius + first):.4g} deg"

            half = radius * (ring.groove_end - first) / 2
            keys = "rings", f"{where}.groove_end"
            groove_accuracy.require_patches(self, ball_diameter, half, keys, least)
