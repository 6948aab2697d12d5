"""A groove for balls in a raceway, as frozen data; lengths and directions as in `fem.parts.rings`."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import acos, asin, pi, sin, sqrt

from fem.parts.material import in_mm, require, require_positive


@dataclass(frozen=True, kw_only=True)
class Groove:
    """An arc of a circle in the axial section, turned about the axis, its centre at x = 0; or a pair of them.

    Two arcs mirror each other at x = 0; each serves the balls that press to its own side. They meet there, or
    are grooves of two rows.
    """

    radius: float  # [m] of an arc
    centre_radius: float  # [m] from the axis to the centre of an arc
    aside: float = 0.0  # [m] of the centres of two arcs from x = 0, where they meet; zero is one arc
    place: float = 0.0  # [m] along x of the row whose contact angles are positive; zero is one row

    def __post_init__(self):
        require_positive(self, "radius", "centre_radius")
        require(
            0 <= self.aside < self.radius, "aside", in_mm(self.aside),
            f"from zero to below the radius of an arc, {in_mm(self.radius)}",
        )  # fmt: skip
        require(not (self.aside and self.place), "place", in_mm(self.place), "zero of two arcs that meet")

    @property
    def sides(self) -> tuple[int, ...]:
        """Sign of the axial direction of the balls' force on each arc: 1 for one; for rows from -x to +x."""
        if self.place > 0:
            return -1, 1
        return (1, -1) if self.aside or self.place else (1,)

    @property
    def places(self) -> tuple[float, ...]:
        """Of rows along x [m], from -x to +x."""
        return (-abs(self.place), abs(self.place)) if self.place else (0.0,)

    @property
    def bottom_angle(self) -> float:
        """Contact angle at which two arcs meet [rad]; zero for one."""
        return asin(self.aside / self.radius)

    @property
    def depth(self) -> float:
        """From the centres of the arcs to the bottom of the groove, along the radius [m]."""
        return sqrt(self.radius**2 - self.aside**2)

    def half_width(self, end: float) -> float:
        """From x = 0 to where an arc ends at a contact angle [rad] along x [m]."""
        return self.radius * sin(end) - self.aside

    def end(self, land: float, outward: int) -> float:
        """Contact angle [rad] at which a land of radius `land` [m] cuts the arc; `outward`: -1 inside balls.

        Raises `ImpossiblePart` if the land does not cut the arc.
        """
        depth = outward * (land - self.centre_radius)
        low, high = sorted((self.centre_radius, self.bottom(outward)))
        require(
            0 <= depth < outward * (self.bottom(outward) - self.centre_radius), "raceway_diameter",
            in_mm(2 * land), f"a land that cuts the groove, between {in_mm(2 * low)} and {in_mm(2 * high)}",
        )  # fmt: skip
        return acos(depth / self.radius)

    def width(self, land: float, outward: int) -> float:
        """Axial width of the groove of a row between its lands [m]."""
        return 2 * self.half_width(self.end(land, outward))

    def bottom(self, outward: int) -> float:
        """Radius of the bottom of the groove [m]."""
        return self.centre_radius + outward * self.depth

    def surface(self, x: float, land: float, outward: int) -> float:
        """Radius of groove and lands at an axial place [m]."""
        along = abs(abs(x) - abs(self.place)) + self.aside
        depth = sqrt(self.radius**2 - along**2) if along < self.radius else 0.0
        return self.centre_radius + outward * max(depth, outward * (land - self.centre_radius))


@dataclass(frozen=True, kw_only=True)
class Stations:
    """Where balls may press on the arcs of a groove, and how: normal Gaussian patches at contact angles."""

    angles: tuple[float, ...]  # (K,) [rad] from the radial plane to the side of an arc; K odd
    width: float  # [m] standard deviation of a patch, along the arc and around the axis

    def __post_init__(self):
        require_positive(self, "width")
        object.__setattr__(self, "angles", tuple(float(angle) for angle in self.angles))
        require(
            len(self.angles) % 2 == 1 and len(set(self.angles)) == len(self.angles),
            "angles", self.angles, "an odd number of different angles",
        )  # fmt: skip
        require(max(map(abs, self.angles)) < pi / 2, "angles", self.angles, "between -pi/2 and pi/2")


@dataclass(frozen=True, kw_only=True)
class BallPatches:
    """Where balls load a groove."""

    azimuths: Sequence[float]  # (Z,) [rad] of the balls
    length: float  # [m] axial width of the groove
    stations: Stations

    @property
    def width(self) -> float:
        """Standard deviation of a patch [m]."""
        return self.stations.width
