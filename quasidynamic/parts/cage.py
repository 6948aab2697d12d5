"""The cage."""

from dataclasses import dataclass
from typing import Literal

from quasidynamic.errors import ImpossiblePart, require_positive


@dataclass(frozen=True, kw_only=True)
class Cage:
    """A cage that keeps its rollers in step and is carried by a land or by the rollers."""

    guidance: Literal["outer", "inner", "rollers"]
    pocket_friction: float  # [-] Coulomb coefficient between roller and pocket
    thickness: float  # [m] radial; the part of a roller that it hides from the oil-air mixture
    mass: float  # [kg]
    land_diameter: float = 0.0  # [m] unused when the rollers guide
    land_width: float = 0.0  # [m] total over both lands
    land_clearance: float = 0.0  # [m] diametral
    land_flow: Literal["laminar", "vortices"] = "laminar"  # of the oil that fills the land

    def __post_init__(self):
        require_positive("cage.mass", self.mass)
        if self.pocket_friction < 0 or self.thickness < 0:
            raise ImpossiblePart("cage.pocket_friction and cage.thickness must not be negative")
        if self.guidance != "rollers":
            for name in ("land_diameter", "land_width", "land_clearance"):
                require_positive(f"cage.{name}", getattr(self, name))
