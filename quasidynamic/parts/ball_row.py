"""A row of balls as the standards of load ratings see it."""

from dataclasses import dataclass
from math import cos, pi

from quasidynamic.errors import ImpossiblePart, require_positive


@dataclass(frozen=True, kw_only=True)
class BallRow:
    """One row of balls with its nominal geometry."""

    balls: int
    ball_diameter: float  # [m]
    pitch_diameter: float  # [m] of the ball centres
    contact_angle: float  # [rad] nominal: without clearance and load
    inner_conformity: float  # [-] groove radius over ball diameter
    outer_conformity: float  # [-]

    def __post_init__(self):
        for name in ("balls", "ball_diameter", "pitch_diameter"):
            require_positive(f"ball row: {name}", getattr(self, name))
        if not 0.0 <= self.contact_angle < pi / 2:
            raise ImpossiblePart(f"ball row: contact_angle = {self.contact_angle!r} rad must be in [0, pi/2)")
        for name in ("inner_conformity", "outer_conformity"):
            if not getattr(self, name) > 0.5:
                raise ImpossiblePart(f"ball row: {name} = {getattr(self, name)!r} must be above 0.5")

    @property
    def diameter_ratio(self) -> float:
        """D cos(alpha) over the pitch diameter, gamma [-]."""
        return self.ball_diameter * cos(self.contact_angle) / self.pitch_diameter
