"""A squirrel cage as frozen data: a ring on axial bars with parallel sides.

Lengths, azimuths and directions as in `fem.parts.rings`.
"""

from dataclasses import dataclass
from math import ceil, pi, sin
from typing import ClassVar

from fem.parts.groove import Groove
from fem.parts.material import Elastic, in_mm, require, require_positive
from fem.parts.room import ROUNDING, SLENDEREST_SLOT, SMALLEST_FILLET, require_inside, require_room


def most_bars(inner_radius: float) -> int:
    """Largest number of narrow bars that leave slots of `SLENDEREST_SLOT` along their inner radius [m]."""
    return ceil(2 * pi * inner_radius / SLENDEREST_SLOT) - 1


def thickest_bar(thickness: float) -> float:
    """Radially thickest bar in a ring of a thickness [m], which leaves its inner surface whole."""
    return thickness - 2 * SLENDEREST_SLOT / 3 + ROUNDING


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

    outward: ClassVar[int] = 1  # sign of the radial direction from rollers or balls into the part

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
            require_room(self.groove, land, land + self.thickness, 1, self.width, self.offset)
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
        require_inside(self.offset, self.width)
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


def _at_most(limit: float, instead: str) -> str:
    """A largest length [m], or what is allowed instead where there is none."""
    return f"at most {in_mm(limit)}" if limit > 0 else instead
