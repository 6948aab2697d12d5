"""Where the power goes."""

from dataclasses import dataclass, fields


@dataclass(frozen=True, kw_only=True)
class Losses:
    """Power turned into heat, by cause [W]."""

    sliding: float  # of the raceways on the rollers
    rolling: float  # shear of the inlets
    drag: float  # of the mixture on the orbiting rollers
    pocket: float  # friction of the rollers in the pockets
    land: float  # of the cage on its guide
    churning: float  # of the mixture between the spinning rollers and the cage
    transport: float  # of spin from azimuth to azimuth: not heat but discretisation residual

    @property
    def total(self) -> float:
        """All of it [W], equal to the power that the rings put in."""
        return sum(getattr(self, field.name) for field in fields(self))
