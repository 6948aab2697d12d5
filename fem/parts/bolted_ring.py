"""A ring with a groove for balls, bolted on one face, as frozen data.

Lengths, azimuths and directions as in `fem.parts.rings`; x starts in the plane of the ball centres.
"""

from dataclasses import dataclass
from math import inf, isinf
from typing import Literal

from fem.parts.boundary_conditions import FreeMotions
from fem.parts.groove import Groove
from fem.parts.material import Elastic, in_mm, require, require_positive


@dataclass(frozen=True, kw_only=True)
class BoltedRing:
    """A ring of rectangular section; its whole bolted face is on something rigid, or on springs per area."""

    race: Literal["outer", "inner"]  # outside or inside of the balls
    groove: Groove
    raceway_diameter: float  # [m] of the lands beside the groove
    far_diameter: float  # [m] outside of an outer ring, bore of an inner one
    width: float  # [m] axial
    face_distance: float  # [m] from the plane of the ball centres to the bolted face
    face_side: Literal[1, -1]  # the bolted face is the end face at +x or at -x
    elastic: Elastic
    normal_stiffness: float = inf  # [N/m^3] of springs along x under the bolted face; inf is rigid
    shear_stiffness: float = inf  # [N/m^3] of springs along the bolted face, both ways; inf is rigid

    def __post_init__(self):
        require_positive(self, "raceway_diameter", "far_diameter", "width", "face_distance")
        for name in ("normal_stiffness", "shear_stiffness"):
            require(getattr(self, name) > 0, name, getattr(self, name), "above zero, infinite if rigid")
        require(
            isinf(self.normal_stiffness) == isinf(self.shear_stiffness),
            "shear_stiffness", self.shear_stiffness, "infinite with normal_stiffness, finite with it",
        )  # fmt: skip
        half = self.groove.width(self.raceway_diameter / 2, self.outward) / 2
        require(
            self.face_distance > half, "face_distance", in_mm(self.face_distance),
            f"more than half of the groove's width, {in_mm(half)}",
        )  # fmt: skip
        require(
            self.width > self.face_distance + half, "width", in_mm(self.width),
            f"more than face_distance and half of the groove, {in_mm(self.face_distance + half)}",
        )  # fmt: skip
        bottom = 2 * self.groove.bottom(self.outward)
        require(
            self.outward * (self.far_diameter - bottom) > 0, "far_diameter", in_mm(self.far_diameter),
            f"{'above' if self.race == 'outer' else 'below'} the groove's bottom, {in_mm(bottom)}",
        )  # fmt: skip

    @property
    def outward(self) -> int:
        """Sign of the radial direction from the balls into the ring."""
        return 1 if self.race == "outer" else -1

    @property
    def materials(self) -> dict[str, Elastic]:
        """Material of the one body."""
        return {"ring": self.elastic}

    @property
    def free_motions(self) -> FreeMotions:
        """Rigid motions that nothing holds: none."""
        return FreeMotions()

    @property
    def ends(self) -> tuple[float, float]:
        """Places of the end faces along x [m]."""
        face, other = self.face_distance, self.face_distance - self.width
        return (other, face) if self.face_side == 1 else (-face, -other)
