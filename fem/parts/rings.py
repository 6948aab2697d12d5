"""Rings, their seats, rollers' load patches and mesh sizes, as frozen data.

Everything is in SI units. The axial coordinate x starts in the middle of the raceway, the azimuth
phi turns from z towards y, so that the outward normal of a raceway is (0, sin phi, cos phi).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite, pi, tan
from typing import ClassVar

from fem.parts.boundary_conditions import (
    FreeMotions,
    Housing,
    LineSupports,
    PlanetGear,
    Support,
    free_motions,
)
from fem.parts.groove import Groove
from fem.parts.material import (
    Elastic,
    ImpossiblePart as ImpossiblePart,  # parts are where one expects it
    in_mm,
    require,
    require_positive,
)
from fem.parts.reduced_body import ReducedBody
from fem.parts.room import ROUNDING, SLENDEREST_SLOT, places_on_cones, require_inside, require_room

MIDDLE = (0.0,)  # [m] axial place of the only row of rollers


@dataclass(frozen=True, kw_only=True)
class OuterRing:
    """A plain outer ring with what holds it."""

    outward: ClassVar[int] = 1  # sign of the radial direction from rollers or balls into the part

    raceway_diameter: float  # [m] inner surface
    thickness: float  # [m] radial
    width: float  # [m] axial
    elastic: Elastic
    support: Support
    offset: float = 0.0  # [m] axial, of the raceway's middle from the ring's, towards the clamped face
    groove: Groove | None = None  # for balls, cut into the inner surface; None: a raceway for rollers
    taper: float = 0.0  # [rad] angle of the raceway from the axis, > 0 where it widens towards +x
    row_distance: float = 0.0  # [m] of two conical raceways, the other one its mirror image; 0: one, or none

    def __post_init__(self):
        require_positive(self, "raceway_diameter", "thickness", "width")
        if self.taper:
            self._require_cone()
        if self.groove is not None:
            land = self.raceway_diameter / 2
            require_room(self.groove, land, land + self.thickness, 1, self.width, self.offset)
            if self.groove.place and (self._loose or isinstance(self.support, ReducedBody)):
                raise ImpossiblePart(
                    "two grooves are impossible on lines, between teeth, on springs that only push, on the "
                    "body of a matrix, and without anything that holds the ring along its axis"
                )
        require(
            self.thickness > SLENDEREST_SLOT, "thickness", in_mm(self.thickness),
            f"above {in_mm(SLENDEREST_SLOT)}",
        )  # fmt: skip
        require_inside(self.offset, self.width)
        if self.offset and isinstance(self.support, LineSupports | PlanetGear):
            raise ImpossiblePart(
                f"raceway_offset = {in_mm(self.offset)}: a ring on lines or tooth forces is known with its "
                "raceway in its middle only; allowed is zero"
            )

    def _require_cone(self) -> None:
        """Refuse a cone without a wall, or in a support that does not hold it along its axis."""
        walls = [
            self.thickness - x * tan(self.taper)
            for x in places_on_cones(self.width, self.row_distance, self.offset)
        ]
        require_conical(self, min(walls), self.raceway_diameter / 2 + self.thickness - max(walls))
        if self._loose:
            raise ImpossiblePart(
                "a conical raceway is impossible on lines, between teeth, on springs that only push, and "
                "without anything that holds the ring along its axis"
            )

    @property
    def _loose(self) -> bool:
        """Whether nothing holds the ring along its axis, or its support only pushes."""
        return self.free_motions.axial or getattr(self.support, "pushing", False)

    @property
    def track(self) -> float:
        """Axial length on which rollers can run, as long to either side of their middle [m]."""
        return self.width - 2 * abs(self.offset)

    @property
    def sides(self) -> tuple[float, float]:
        """Axial places of both end faces [m]."""
        return -self.width / 2 - self.offset, self.width / 2 - self.offset

    @property
    def bars(self) -> None:
        """No bars: a body of revolution."""

    @property
    def materials(self) -> dict[str, Elastic]:
        """Material of every named body; "ring" carries the raceway."""
        if isinstance(self.support, Housing):
            return {"ring": self.elastic, "housing": self.support.elastic}
        return {"ring": self.elastic}

    @property
    def free_motions(self) -> FreeMotions:
        """Rigid motions that nothing holds."""
        return free_motions(self.support)


@dataclass(frozen=True, kw_only=True)
class RingOnShaft:
    """An inner ring with two ribs or none, bonded on a shaft that is clamped at both ends."""

    outward: ClassVar[int] = -1  # sign of the radial direction from rollers or balls into the part

    raceway_diameter: float  # [m] outer surface between the ribs
    track_width: float  # [m] axial, between the ribs; the whole width of a ring without ribs
    rib_diameter: float | None  # [m] outside of the ribs; None: there are none
    bore: float  # [m] of the ring, also the outside of the shaft
    width: float  # [m] axial, of the ring with its ribs
    shaft_bore: float  # [m] 0 is a solid shaft
    shaft_length: float  # [m] axial, centred on the ring
    ring: Elastic
    shaft: Elastic
    groove: Groove | None = None  # for balls, cut into the outer surface; None: a raceway for rollers
    taper: float = 0.0  # [rad] angle of the raceway of a ring without ribs, > 0 where it widens towards +x
    row_distance: float = 0.0  # [m] of two conical raceways, the other one its mirror image; 0: one, or none

    def __post_init__(self):
        if self.groove is not None:
            require_room(self.groove, self.raceway_diameter / 2, self.bore / 2, -1, self.track_width, 0.0)
        require_positive(self, "raceway_diameter", "track_width", "shaft_length")
        require(self.shaft_bore >= 0, "shaft_bore", self.shaft_bore, "zero for a solid shaft, or above")
        wall, ribs = 2 * SLENDEREST_SLOT, self.rib_diameter is not None
        if not ribs:
            require(self.track_width == self.width, "track_width", self.track_width, "width, without ribs")
        for inside, outside in (
            ("shaft_bore", "bore"),
            ("bore", "raceway_diameter"),
            *((("raceway_diameter", "rib_diameter"), ("track_width", "width")) if ribs else ()),
            ("width", "shaft_length"),
        ):
            limit, value = getattr(self, outside) - wall, getattr(self, inside)
            allowed = f"at most {in_mm(limit)}, inside {outside}"
            require(value <= limit + ROUNDING, inside, in_mm(value), allowed)
        if self.taper:
            require(not ribs, "rib_diameter", self.rib_diameter, "None: a cone is known without ribs")
            thinnest = self.raceway_diameter / 2 - max(places_on_cones(self.width, self.row_distance)) * tan(
                abs(self.taper)
            )
            require_conical(self, thinnest - self.bore / 2, thinnest)

    @property
    def track(self) -> float:
        """Axial length on which rollers can run [m]."""
        return self.track_width

    @property
    def bars(self) -> None:
        """No bars: a body of revolution."""

    @property
    def outside_diameter(self) -> float:
        """Of the ribs, or of the raceway of a ring without any [m]."""
        return self.raceway_diameter if self.rib_diameter is None else self.rib_diameter

    @property
    def materials(self) -> dict[str, Elastic]:
        """Material of every named body; "ring" carries the raceway."""
        return {"ring": self.ring, "shaft": self.shaft}

    @property
    def free_motions(self) -> FreeMotions:
        """Rigid motions that nothing holds: none."""
        return FreeMotions()

    def require_shoulder(self, diameter: float) -> None:
        """Refuse a shoulder of the shaft [m] that does not end on the side of the ring."""
        wall = 2 * SLENDEREST_SLOT
        low, high = self.bore + wall, self.outside_diameter - wall
        require(
            low <= diameter <= high, "shoulder_diameter", in_mm(diameter),
            f"{in_mm(low)} to {in_mm(high)}, between bore and outside",
        )  # fmt: skip


def require_conical(part: OuterRing | RingOnShaft, wall: float, radius: float) -> None:
    """Refuse a conical raceway with a thinnest wall and a least radius [m] that cannot be, or for balls."""
    require(abs(part.taper) < pi / 4, "taper", part.taper, "an angle below pi/4")
    require(part.groove is None, "groove", part.groove, "None in a conical raceway")
    require(
        wall > SLENDEREST_SLOT and radius > 0, "width", in_mm(part.width),
        f"a width in which the cone leaves a wall of {in_mm(SLENDEREST_SLOT)}; it leaves {in_mm(wall)}",
    )  # fmt: skip


def require_on_track(length: float, track: float, rows: Sequence[float] = MIDDLE) -> None:
    """Refuse loaded bands [m] of rows at some places [m] that reach beyond the track.

    Raises `ImpossiblePart` if rollers would run beyond it.
    """
    whole = length + 2 * max(map(abs, rows))
    if whole > track * (1 + 1e-9):
        raise ImpossiblePart(f"rollers of {in_mm(whole)} run beyond the track of {in_mm(track)}")


@dataclass(frozen=True, kw_only=True)
class MeshSize:
    """Wishes for the finite elements; geometry wins where a feature is finer than the size."""

    order: int  # polynomial order of displacement and of curved geometry
    size: float  # [m] largest element edge
    raceway_size: float  # [m] largest element edge on the loaded band

    def __post_init__(self):
        require_positive(self, "size", "raceway_size")
        require(self.order in range(1, 9), "order", self.order, "1 to 8")


@dataclass(frozen=True, kw_only=True)
class Patches:
    """Where and how rollers load a raceway, and in which shapes their forces are resolved.

    Every roller presses on |x| <= length/2 with a Gaussian along the arc; along its length the
    pressure is a sum of Legendre polynomials L_m(2 x / length), m = 0 .. axial_modes - 1.
    """

    azimuths: Sequence[float]  # (Z,) [rad] of the rollers
    length: float  # [m] of the loaded band
    axial_modes: int  # M, number of axial modes; 2 are load and moment
    width: float  # [m] standard deviation of the Gaussian along the arc

    def __post_init__(self):
        object.__setattr__(self, "azimuths", tuple(float(phi) for phi in self.azimuths))
        require_positive(self, "length", "width")
        require(all(map(isfinite, self.azimuths)) and len(self.azimuths) > 0,
                 "azimuths", self.azimuths, "one or more finite angles")  # fmt: skip
        require(2 <= self.axial_modes <= 8, "axial_modes", self.axial_modes, "2 to 8")
