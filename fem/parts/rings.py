"""Rings, their seats, rollers' load patches and mesh sizes, as frozen data.

Everything is in SI units. The axial coordinate x starts in the middle of the raceway, the azimuth
phi turns from z towards y, so that the outward normal of a raceway is (0, sin phi, cos phi).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, isfinite, pi, sin

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

SLENDEREST_SLOT = 0.3e-3  # [m] the mesher may abort on narrower gaps and thinner walls
SMALLEST_FILLET = 0.1e-3  # [m] smaller ones need too many elements to matter
ROUNDING = 1e-12  # [m] of sums of lengths: a length at its limit is allowed


@dataclass(frozen=True, kw_only=True)
class OuterRing:
    """A plain outer ring with what holds it."""

    raceway_diameter: float  # [m] inner surface
    thickness: float  # [m] radial
    width: float  # [m] axial
    elastic: Elastic
    support: Support
    offset: float = 0.0  # [m] axial, of the raceway's middle from the ring's, towards the clamped face
    groove: Groove | None = None  # for balls, cut into the inner surface; None: a cylinder for rollers

    def __post_init__(self):
        require_positive(self, "raceway_diameter", "thickness", "width")
        if self.groove is not None:
            land = self.raceway_diameter / 2
            _require_room(self.groove, land, land + self.thickness, 1, self.width, self.offset)
        require(
            self.thickness > SLENDEREST_SLOT, "thickness", in_mm(self.thickness),
            f"above {in_mm(SLENDEREST_SLOT)}",
        )  # fmt: skip
        _require_inside(self.offset, self.width)
        if self.offset and isinstance(self.support, LineSupports | PlanetGear):
            raise ImpossiblePart(
                f"raceway_offset = {in_mm(self.offset)}: a ring on lines or tooth forces is known with its "
                "raceway in its middle only; allowed is zero"
            )

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


def most_bars(inner_radius: float) -> int:
    """Largest number of narrow bars that leave slots of `SLENDEREST_SLOT` along their inner radius [m]."""
    return ceil(2 * pi * inner_radius / SLENDEREST_SLOT) - 1


def thickest_bar(thickness: float) -> float:
    """Radially thickest bar in a ring of a thickness [m], which leaves its inner surface whole."""
    return thickness - 2 * SLENDEREST_SLOT / 3 + ROUNDING


def narrowest_ring(groove: Groove, land: float, outward: int, offset: float) -> float:
    """Axially narrowest ring [m] around a groove between lands of a radius, off the ring's middle [m]."""
    return groove.width(land, outward) + 2 * SLENDEREST_SLOT + 2 * abs(offset) - ROUNDING


def widest_bar(bars: int, inner_radius: float) -> float:
    r"""Widest bar with parallel sides that leaves slots of `SLENDEREST_SLOT` along the inner radius.

    .. math:: b = 2 r \sin\left(\frac{\pi}{N} - \frac{s}{2 r}\right)

    Parameters
    ----------
    bars : int
        N, equally spaced
    inner_radius : float
        r of the bars [m]

    Returns
    -------
    float
        b, tangential [m]; negative if there are too many bars

    Source
    ------
    Chord of a circle.
    """
    return 2 * inner_radius * sin(min(pi / bars - SLENDEREST_SLOT / 2 / inner_radius, pi / 2))


@dataclass(frozen=True, kw_only=True)
class SquirrelCage:
    """An outer ring on axial bars, the bars on a flange whose far end face is clamped.

    The bars lie between two radii and have parallel sides, as slots milled from a tube leave them.
    The flange has the section of the ring radially. The first bar is centred at azimuth 0. A collar makes the
    end of the ring thicker outwards; the bars on it stay where they are.
    """

    raceway_diameter: float  # [m] inner surface of the ring
    thickness: float  # [m] radial, of ring and flange
    width: float  # [m] axial, of the ring
    bars: int  # number of bars, equally spaced
    bar_width: float  # [m] tangential
    bar_thickness: float  # [m] radial, centred on the mean radius of the ring
    bar_length: float  # [m] axial, between ring and flange
    flange_length: float  # [m] axial
    elastic: Elastic
    fillet: float = 0.0  # [m] radius where bars meet ring and flange; 0 is a sharp edge
    collar_length: float = 0.0  # [m] axial, part of the ring's width; 0 is a ring without a collar
    collar_thickness: float = 0.0  # [m] radial, of the ring with its collar
    two_sided: bool = False  # bars and flange, and the collar, at both ends of the ring, else at +x only
    offset: float = 0.0  # [m] axial, of the raceway's middle from the ring's, towards +x
    groove: Groove | None = None  # for balls, cut into the inner surface; None: a cylinder for rollers

    def __post_init__(self):
        if self.groove is not None:
            land = self.raceway_diameter / 2
            _require_room(self.groove, land, land + self.thickness, 1, self.width, self.offset)
        require_positive(
            self, "raceway_diameter", "thickness", "width", "bar_width", "bar_thickness", "bar_length",
            "flange_length",
        )  # fmt: skip
        require(self.bars >= 1, "bars", self.bars, "1 or more")
        thickest = thickest_bar(self.thickness)
        require(
            self.bar_thickness <= thickest, "bar_thickness", in_mm(self.bar_thickness),
            f"at most {in_mm(thickest)}, less than the thickness of the ring, which leaves the raceway whole",
        )  # fmt: skip
        widest = widest_bar(self.bars, self.bar_radii[0])
        require(
            self.bar_width <= widest, "bar_width", in_mm(self.bar_width),
            f"{_at_most(widest, 'fewer bars')}: {self.bars} bars leave slots of {in_mm(SLENDEREST_SLOT)} or "
            "more",
        )  # fmt: skip
        _require_inside(self.offset, self.width)
        if self.collar_length != 0:
            self._require_room_for_collars()
        if self.fillet != 0:
            self._require_room_for_fillets()

    def _require_room_for_collars(self):
        longest = self.width / len(self.ends)
        least = longest - SLENDEREST_SLOT
        require(
            SLENDEREST_SLOT <= self.collar_length <= least or self.collar_length == longest,
            "collar_length", in_mm(self.collar_length),
            f"zero, {in_mm(SLENDEREST_SLOT)} to {in_mm(least)}, or {in_mm(longest)}, which is the whole ring",
        )  # fmt: skip
        thicker = self.thickness + SMALLEST_FILLET
        require(
            self.collar_thickness >= thicker or self.collar_thickness == self.thickness,
            "collar_thickness", in_mm(self.collar_thickness),
            f"that of the ring, {in_mm(self.thickness)}, or {in_mm(thicker)} and more",
        )  # fmt: skip

    def _require_room_for_fillets(self):
        step, gap = (self.thickness - self.bar_thickness) / 2, self.bar_length / 2
        largest = min(step - SMALLEST_FILLET / 2, gap - SLENDEREST_SLOT / 2)
        require(
            SMALLEST_FILLET <= self.fillet <= largest, "fillet", in_mm(self.fillet),
            ("zero" if largest < SMALLEST_FILLET
             else f"zero, or {in_mm(SMALLEST_FILLET)} to {in_mm(largest)}")
            + ": inside the faces that the bars rest on, "
            f"{in_mm(step)} wide beside the bars, and short of half the bars, {in_mm(gap)}",
        )  # fmt: skip
        widest = widest_bar(self.bars, self.bar_radii[0] - self.fillet) - self.bar_width
        require(
            2 * self.fillet <= widest, "fillet", in_mm(self.fillet),
            f"{_at_most(widest / 2, 'zero')}, which leaves slots of {in_mm(SLENDEREST_SLOT)} between the "
            f"feet of {self.bars} bars",
        )  # fmt: skip

    @property
    def bar_radii(self) -> tuple[float, float]:
        """Inner and outer radius of the bars [m]."""
        middle, half = (self.raceway_diameter + self.thickness) / 2, self.bar_thickness / 2
        return middle - half, middle + half

    @property
    def track(self) -> float:
        """Axial length on which rollers can run, as long to either side of their middle [m]."""
        return self.width - 2 * abs(self.offset)

    @property
    def sides(self) -> tuple[float, float]:
        """Axial places of both end faces of the ring [m]."""
        return -self.width / 2 - self.offset, self.width / 2 - self.offset

    @property
    def ends(self) -> tuple[int, ...]:
        """Ends of the ring that bars rest on, as the sign of their x."""
        return (1, -1) if self.two_sided else (1,)

    def end_distance(self, end: int) -> float:
        """From the middle of the raceway to the end face on which the bars of an end stand [m]."""
        return self.width / 2 - end * self.offset

    @property
    def has_collar(self) -> bool:
        """Whether a part of the ring is thicker than the rest."""
        return self.collar_length > 0 and self.collar_thickness > self.thickness

    @property
    def outline(self) -> tuple[tuple[float, float], ...]:
        """Corners (x, r) of the ring's outer surface, collars included, from +x to -x [m]."""
        (left, right), inner = self.sides, self.raceway_diameter / 2
        outer, top = inner + self.thickness, inner + self.collar_thickness
        if not self.has_collar:
            return (right, outer), (left, outer)
        if self.collar_length == self.width / len(self.ends):
            return (right, top), (left, top)
        first, last = right - self.collar_length, left + self.collar_length
        at_left = ((last, outer), (last, top), (left, top)) if self.two_sided else ((left, outer),)
        return (right, top), (first, top), (first, outer), *at_left

    @property
    def materials(self) -> dict[str, Elastic]:
        """Material of every named body; "ring" carries the raceway."""
        return {"ring": self.elastic, "bars": self.elastic, "flange": self.elastic}


@dataclass(frozen=True, kw_only=True)
class RingOnShaft:
    """An inner ring with two ribs or none, bonded on a shaft that is clamped at both ends."""

    raceway_diameter: float  # [m] outer surface between the ribs
    track_width: float  # [m] axial, between the ribs; the whole width of a ring without ribs
    rib_diameter: float | None  # [m] outside of the ribs; None: there are none
    bore: float  # [m] of the ring, also the outside of the shaft
    width: float  # [m] axial, of the ring with its ribs
    shaft_bore: float  # [m] 0 is a solid shaft
    shaft_length: float  # [m] axial, centred on the ring
    ring: Elastic
    shaft: Elastic
    groove: Groove | None = None  # for balls, cut into the outer surface; None: a cylinder for rollers

    def __post_init__(self):
        if self.groove is not None:
            _require_room(self.groove, self.raceway_diameter / 2, self.bore / 2, -1, self.track_width, 0.0)
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


Part = SquirrelCage | OuterRing | RingOnShaft


def _require_room(groove: Groove, land: float, far: float, outward: int, width: float, offset: float) -> None:
    """Refuse a groove without a wall below its bottom, or without lands at its sides [m]."""
    wall, least = outward * (far - groove.bottom(outward)), narrowest_ring(groove, land, outward, offset)
    require(
        wall > SLENDEREST_SLOT - ROUNDING, "groove.radius", in_mm(groove.radius),
        f"one that leaves a wall above {in_mm(SLENDEREST_SLOT)}",
    )  # fmt: skip
    aside = f" {in_mm(abs(offset))} off its middle" if offset else ""
    require(
        width >= least, "width", in_mm(width),
        f"at least {in_mm(least)}, with the lands of its groove{aside}",
    )  # fmt: skip


def _at_most(limit: float, instead: str) -> str:
    """A largest length [m], or what is allowed instead where there is none."""
    return f"at most {in_mm(limit)}" if limit > 0 else instead


def _require_inside(offset: float, width: float) -> None:
    """Refuse a raceway whose middle lies beyond an end face; `require_on_track` sees to its length."""
    require(
        abs(offset) < width / 2,
        "raceway_offset",
        in_mm(offset),
        f"below half of the width, {in_mm(width / 2)}",
    )


def require_on_track(length: float, track: float) -> None:
    """Refuse a loaded band [m] that is longer than the track.

    Raises `ImpossiblePart` if rollers would run beyond it.
    """
    if length > track * (1 + 1e-9):
        raise ImpossiblePart(f"rollers of {in_mm(length)} run beyond the track of {in_mm(track)}")


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
