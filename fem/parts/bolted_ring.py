"""A ring with a gothic groove for balls, bolted on one face, as frozen data.

Lengths, azimuths and directions as in `fem.parts.rings`; x starts in the plane of the ball centres.
"""

from dataclasses import dataclass
from math import asin, cos, inf, isinf, pi, sin
from typing import Literal

from fem.parts.material import Elastic, in_mm, require, require_positive


@dataclass(frozen=True, kw_only=True)
class BoltedGrooveRing:
    """A ring of rectangular section with two arches, one to each side of the balls.

    Its whole bolted face rests on something rigid, or on springs per area. The groove is two arcs that
    meet at its bottom, see `fem.mesh.bolted_ring_section`.
    """

    race: Literal["outer", "inner"]  # outside or inside of the balls
    pitch_diameter: float  # [m] of the ball centres
    ball_diameter: float  # [m]
    groove_radius: float  # [m] of both arches, more than half a ball
    contact_angle: float  # [rad] at which both arches touch the ball, from the radial plane
    groove_end: float  # [rad] contact angle at which the shoulders cut the arches
    far_diameter: float  # [m] outside of an outer ring, bore of an inner one
    width: float  # [m] axial
    face_distance: float  # [m] from the plane of the ball centres to the bolted face
    face_side: Literal[1, -1]  # the bolted face is the end face at +x or at -x
    elastic: Elastic
    normal_stiffness: float = inf  # [N/m^3] of springs along x under the bolted face; inf is rigid
    shear_stiffness: float = inf  # [N/m^3] of springs along the bolted face, both ways; inf is rigid

    def __post_init__(self):
        require_positive(
            self, "pitch_diameter", "ball_diameter", "far_diameter", "width", "face_distance",
        )  # fmt: skip
        require(0 < self.contact_angle < pi / 2, "contact_angle", self.contact_angle, "between 0 and pi/2")
        require(
            self.groove_radius > self.ball_diameter / 2, "groove_radius", in_mm(self.groove_radius),
            f"more than half of the ball_diameter, {in_mm(self.ball_diameter / 2)}",
        )  # fmt: skip
        require(
            self.contact_angle < self.groove_end < pi / 2, "groove_end", self.groove_end,
            f"between the contact_angle, {self.contact_angle:.6g} rad, and pi/2",
        )  # fmt: skip
        for name in ("normal_stiffness", "shear_stiffness"):
            require(getattr(self, name) > 0, name, getattr(self, name), "above zero, infinite if rigid")
        require(
            isinf(self.normal_stiffness) == isinf(self.shear_stiffness),
            "shear_stiffness", self.shear_stiffness, "infinite with normal_stiffness, finite with it",
        )  # fmt: skip
        self._require_room()

    def _require_room(self):
        half = self.at(self.groove_end)[0]
        require(
            self.face_distance > half, "face_distance", in_mm(self.face_distance),
            f"more than half of the groove's width, {in_mm(half)}",
        )  # fmt: skip
        require(
            self.width > self.face_distance + half, "width", in_mm(self.width),
            f"more than face_distance and half of the groove, {in_mm(self.face_distance + half)}",
        )  # fmt: skip
        bottom = self.pitch_diameter + 2 * self.outward * self.bottom
        far = "above" if self.race == "outer" else "below"
        require(
            self.outward * (self.far_diameter - bottom) > 0, "far_diameter", in_mm(self.far_diameter),
            f"{far} the diameter of the groove's bottom, {in_mm(bottom)}",
        )  # fmt: skip

    @property
    def outward(self) -> int:
        """Sign of the radial direction from the balls into the ring."""
        return 1 if self.race == "outer" else -1

    @property
    def offset(self) -> float:
        """Distance of a groove centre from the centre of a ball that touches the arch [m]."""
        return self.groove_radius - self.ball_diameter / 2

    @property
    def bottom_angle(self) -> float:
        """Contact angle at which both arches meet [rad]."""
        return asin(self.offset * sin(self.contact_angle) / self.groove_radius)

    @property
    def bottom(self) -> float:
        """Distance from the ball centre into the ring to where both arches meet [m]."""
        return self.at(self.bottom_angle)[1]

    def at(self, angle: float) -> tuple[float, float]:
        """Place on the arch at +x at a contact angle: along x, into the ring, from the ball centre [m]."""
        r, c = self.groove_radius, self.offset
        return (
            r * sin(angle) - c * sin(self.contact_angle),
            r * cos(angle) - c * cos(self.contact_angle),
        )

    @property
    def contact_radius(self) -> float:
        """Distance of the contacts from the axis [m]."""
        return self.pitch_diameter / 2 + self.outward * self.ball_diameter / 2 * cos(self.contact_angle)
