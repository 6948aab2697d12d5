"""The cage."""

from dataclasses import dataclass
from typing import Literal

from quasidynamic.errors import ImpossiblePart, require_positive


@dataclass(frozen=True, kw_only=True)
class Cage:
    """A cage that spaces the rollers and is guided by the land of a ring or by the rollers."""

    guidance: Literal["outer", "inner", "rollers"]
    pocket_friction: float  # [-] Coulomb coefficient between roller and pocket
    thickness: float  # [m] radial; the part of a roller that it shields from the oil-air mixture
    mass: float = 0.0  # [kg] above zero where the centre is free; else only its inertia in settling
    land_diameter: float = 0.0  # [m] unused when the rollers guide
    land_width: float = 0.0  # [m] total over both lands
    land_clearance: float = 0.0  # [m] diametral
    land_flow: Literal["laminar", "vortices"] = "laminar"  # of the oil that fills the land
    free: bool = False  # whether the cage finds its centre in the land by itself
    unbalance: float = 0.0  # [m] distance of the mass centre from the cage's axis
    unbalance_azimuth: float = 0.0  # [rad] where the mass centre is at this moment
    pocket_clearance: float | None = None  # [m] from a centred roller to either wall

    def __post_init__(self):
        if self.pocket_friction < 0 or self.thickness < 0:
            raise ImpossiblePart("cage.pocket_friction and cage.thickness must not be negative")
        if self.mass < 0 or self.unbalance < 0:
            raise ImpossiblePart("cage.mass and cage.unbalance must not be negative")
        if self.pocket_clearance is not None:
            require_positive("cage.pocket_clearance", self.pocket_clearance)
        if self.free and self.guidance == "rollers":
            raise ImpossiblePart("a cage with a free centre needs a land that carries it")
        if self.free:
            require_positive("cage.mass", self.mass)
        if self.guidance != "rollers":
            for name in ("land_diameter", "land_width", "land_clearance"):
                require_positive(f"cage.{name}", getattr(self, name))
