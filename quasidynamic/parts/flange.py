"""The guide flanges of a ring."""

from dataclasses import dataclass
from typing import Literal

from quasidynamic.errors import ImpossiblePart, require_positive


@dataclass(frozen=True, kw_only=True)
class Flange:
    """Flanges at both ends of the rollers, on one ring: flat, square to the axis, alike."""

    ring: Literal["inner", "outer"]
    clearance: float  # [m] axial, of a straight roller, both ends together
    height: float  # [m] above the raceway
    roller_chamfer: float  # [m] radial, of the roller's end
    stiffness: float  # [N/m] of a roller's corner against a flange
    friction: float  # [-] Coulomb, of the roller's corner on the flange

    def __post_init__(self):
        for name in ("clearance", "height", "stiffness"):
            require_positive(f"flange.{name}", getattr(self, name))
        for name in ("roller_chamfer", "friction"):
            if not 0.0 <= getattr(self, name) < float("inf"):
                raise ImpossiblePart(f"flange.{name} = {getattr(self, name)!r} must be finite and >= 0")
        if self.height <= self.roller_chamfer:
            raise ImpossiblePart(
                f"flange.height = {1e3 * self.height:.4g} mm must be above the chamfer of the roller, "
                f"{1e3 * self.roller_chamfer:.4g} mm, or the end of the roller touches nothing"
            )
