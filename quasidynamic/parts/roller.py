"""A cylindrical roller."""

from dataclasses import dataclass
from functools import cached_property
from math import pi

from quasidynamic.errors import ImpossiblePart, require_positive
from quasidynamic.parts.material import Material
from quasidynamic.parts.profile import STRAIGHT, Profile

SLENDEREST = 50  # length over diameter of a roller, or diameter over length


@dataclass(frozen=True, kw_only=True)
class Roller:
    """A cylindrical roller."""

    diameter: float  # [m]
    length: float  # [m] effective, without end chamfers
    material: Material
    profile: Profile = STRAIGHT

    def __post_init__(self):
        for name in ("diameter", "length"):
            require_positive(f"roller.{name}", getattr(self, name))
        if not 1 / SLENDEREST <= self.length / self.diameter <= SLENDEREST:
            raise ImpossiblePart(
                f"roller.length = {1e3 * self.length:.6g} mm with roller.diameter = "
                f"{1e3 * self.diameter:.6g} mm: "
                f"neither a roller nor a needle; allowed is a length of 1/{SLENDEREST} to {SLENDEREST} "
                "diameters"
            )

    @cached_property
    def mass(self) -> float:
        """Mass of the full cylinder [kg]."""
        return self.material.density * pi / 4 * self.diameter**2 * self.length

    @cached_property
    def inertia(self) -> float:
        """Moment of inertia about the roller's own axis [kg m2]."""
        return self.mass * self.diameter**2 / 8
