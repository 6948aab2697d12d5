"""The cage of a ball bearing."""

from dataclasses import dataclass
from typing import Literal

from quasidynamic.errors import ImpossiblePart, require_positive


@dataclass(frozen=True, kw_only=True)
class BallCage:
    """A concentric cage with round pockets, guided by the land of a ring or by the balls."""

    guidance: Literal["outer", "inner", "balls"]
    pocket_clearance: float  # [m] from a centred ball to the wall
    pocket_friction: float  # [-] Coulomb coefficient between ball and pocket
    land_diameter: float = 0.0  # [m] unused when the balls guide
    land_width: float = 0.0  # [m] total over both lands
    land_clearance: float = 0.0  # [m] diametral
    land_flow: Literal["laminar", "vortices"] = "laminar"  # of the oil that fills the land

    def __post_init__(self):
        require_positive("cage.pocket_clearance", self.pocket_clearance)
        if not 0.0 <= self.pocket_friction < float("inf"):
            raise ImpossiblePart(
                f"cage.pocket_friction = {self.pocket_friction!r} must be finite and not negative"
            )
        if self.guidance != "balls":
            for name in ("land_diameter", "land_width", "land_clearance"):
                require_positive(f"cage.{name}", getattr(self, name))
