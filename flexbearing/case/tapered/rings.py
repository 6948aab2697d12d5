"""The sections [outer], [inner] and [accuracy] of a tapered roller bearing: what carries its raceways."""

from math import cos, tan
from typing import Any, Literal, Self

from pydantic import model_validator

from flexbearing.case import held_ring
from flexbearing.case.held_ring import ON_SHAFT, RING
from flexbearing.case.quantity import GIVEN, Foundation, Length, Section, impossible, in_mm, key, require

ELASTIC = ({"outer.kind": ("ring",)}, {"inner.kind": ("ring_on_shaft",)})


class TaperedOuter(Section):
    """What carries the outer raceway."""

    kind: Literal["rigid", "ring"] = key("rigid; or a ring whose inner surface is the raceway", "rigid")
    thickness: Length | None = key(
        "radial thickness of the ring in the middle of its raceway", None, example="5 mm", gt=0, only=RING
    )
    width: Length | None = key("axial width of the ring", None, example="19 mm", gt=0, only=RING)
    raceway_offset: Length = key(
        "axial distance from the middle of the ring's width to the middle of the contacts, positive towards "
        "+x, the thick end, where the side face is held",
        "0 mm",
        example="1 mm",
        only=RING,
    )
    support: Literal["side", "seat", "foundation", "housing"] = key(
        "what holds the ring: its side face at the end of x; a rigid seat or springs per area on its outer "
        "surface, which push and pull; or a housing bonded to it",
        "side",
        only=RING,
    )
    common: bool = key(
        "whether both rows of bearing.pair are in this one ring, a double-row cup, whose middle is between "
        "them; without it each row has a ring of its own, held alike",
        False,
        only={**RING, "bearing.pair": GIVEN},
    )
    foundation_radial: Foundation = held_ring.foundation_radial()
    foundation_axial: Foundation = held_ring.foundation("axial")
    foundation_tangential: Foundation = held_ring.foundation("tangential")
    housing_thickness: Length | None = held_ring.housing_thickness()
    housing_width: Length | None = held_ring.housing_width()
    housing_support: Literal["seat", "side"] = held_ring.housing_support()

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if self.kind == "rigid":
            return self
        require(self, ("thickness", "width"), 'outer.kind = "ring"')
        held_ring.require_support(self)
        if self.support == "foundation" and not self.foundation_axial:
            raise impossible("foundation_axial", "above zero, or nothing holds the ring against the thrust")
        return self

    def require_room(self, bearing: Any) -> None:
        """Raise unless the contacts are on the ring, and the ring has a wall at its wide end."""
        if self.kind == "rigid":
            return
        from fem.parts.room import SLENDEREST_SLOT, places_on_cones

        width, thickness = require(self, ("width", "thickness"), self.kind)
        apart = bearing.row_distance("outer") if self.common else 0.0
        band = bearing.roller.length * cos(bearing.cup_angle)
        if self.common and apart < band + SLENDEREST_SLOT:
            raise impossible("common", "false, or bearing.pair.distance larger: rows touch each other")
        band += apart
        if width < band:
            raise impossible("width", f"at least {in_mm(band)}, what the rollers touch of it")
        if width < band + 2 * abs(self.raceway_offset):
            most = (width - band) / 2
            raise impossible("raceway_offset", f"{in_mm(-most)} to {in_mm(most)}, or rollers leave the ring")
        first, last = places_on_cones(width, apart, self.raceway_offset)
        least = -first * tan(bearing.cup_angle) + SLENDEREST_SLOT
        if thickness <= least:
            raise impossible("thickness", f"above {in_mm(least)}, or the wide end of the raceway has no wall")
        if bearing.raceway_middle("outer") <= last * tan(bearing.cup_angle):
            raise impossible("width", "less: the raceway reaches the axis")


class TaperedInner(held_ring.OnShaft):
    """What carries the inner raceway."""

    kind: Literal["rigid", "ring_on_shaft"] = key(
        "rigid; or a ring bonded on a shaft with both ends clamped, which move with the ring; both rows of "
        "bearing.pair are on it. The rib at the large ends moves with the section under the raceway, "
        "which carries its load",
        "rigid",
    )
    bore: Length | None = key(
        "bore of the ring, outside of the shaft", None, example="35 mm", gt=0, only=ON_SHAFT
    )
    width: Length | None = key(
        "axial width of the ring between its ribs, its middle under that of the contacts of all rows",
        None,
        example="18 mm",
        gt=0,
        only=ON_SHAFT,
    )
    shaft_thickness: Length | None = held_ring.shaft_thickness()
    shaft_length: Length | None = held_ring.shaft_length()

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if self.kind == "ring_on_shaft":
            held_ring.require_shaft(self)
        return self

    def require_room(self, bearing: Any) -> None:
        """Raise unless the contacts are on the ring, and the ring has a wall at its narrow end."""
        if self.kind == "rigid":
            return
        from fem.parts.room import SLENDEREST_SLOT, places_on_cones

        bore, width = require(self, ("bore", "width"), self.kind)
        cone, apart = bearing.angles[1], bearing.row_distance("inner")
        band = bearing.roller.length * cos(cone)
        if apart and apart < band + SLENDEREST_SLOT:
            raise impossible("kind", '"rigid", or bearing.pair.distance larger: rows touch each other')
        band += apart
        if width < band:
            raise impossible("width", f"at least {in_mm(band)}, what the rollers touch of it")
        last = places_on_cones(width, apart)[1]
        most = 2 * (bearing.raceway_middle("inner") - last * tan(cone) - SLENDEREST_SLOT)
        if bore >= most:
            raise impossible("bore", f"below {in_mm(most)}, or the narrow end of the raceway has no wall")


class TaperedAccuracy(Section):
    """Numerical resolution."""

    slices: int = key("slices of each roller", 40, ge=4, le=1000)
    axial_shapes: int = key(
        "Legendre shapes along a roller that carry loads to elastic rings and deviations back",
        4,
        ge=2,
        le=6,
        only=ELASTIC,
    )
    element_order: int = key("polynomial order of the finite elements", 5, ge=2, le=8, only=ELASTIC)
    mesh_size: Length | None = key(
        "largest size of the elements; by default 1.2 roller lengths",
        None,
        example="3 mm",
        gt=0,
        only=ELASTIC,
    )
    raceway_mesh_size: Length | None = key(
        "largest size of the elements on a raceway; by default a quarter of the roller length",
        None,
        example="2 mm",
        gt=0,
        only=ELASTIC,
    )
