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
        land = self.raceway_diameter / 2
        half = self.groove.width(land, self.outward) / 2
        lengths = self.far_diameter, self.width, self.face_distance
        if wrong := misfit(self.groove, half, self.outward, *lengths):
            require(False, wrong[0], in_mm(getattr(self, wrong[0])), wrong[1])

    @property
    def outward(self) -> int:
        """Sign of the radial direction from the balls into the ring."""
        return 1 if self.race == "outer" else -1

    @property
    def bars(self) -> None:
        """No bars: a body of revolution."""

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


def misfit(
    groove: Groove, half: float, outward: int, far_diameter: float, width: float, face_distance: float
) -> tuple[str, str] | None:
    """Dimension [m] that leaves no room for a groove of half a width, and what is allowed; None with room."""
    if face_distance <= half:
        return "face_distance", f"above {in_mm(half)}, half the width of the groove"
    if width <= face_distance + half:
        return "width", f"above {in_mm(face_distance + half)}, or the groove reaches the other face"
    bottom = 2 * groove.bottom(outward)
    if outward * (far_diameter - bottom) <= 0:
        return "far_diameter", f"{'above' if outward > 0 else 'below'} {in_mm(bottom)}, the groove's bottom"
    return None
