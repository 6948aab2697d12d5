"""Where the power goes."""

from dataclasses import dataclass, fields
from typing import Any


@dataclass(frozen=True, kw_only=True)
class Losses:
    """Power turned into heat, by cause [W]: floats of one case, arrays (C) of many."""

    sliding: Any  # of the raceways on the rollers
    rolling: Any  # shear of the inlets
    drag: Any  # of the mixture on the orbiting rollers
    pocket: Any  # friction of the rollers in the pockets
    land: Any  # of the cage on its guide
    churning: Any  # of the mixture between the spinning rollers and the cage
    transport: Any  # of spin from azimuth to azimuth: not heat but discretisation residual

    @property
    def total(self) -> Any:
        """All of it [W], equal to the power that the rings put in."""
        return sum(getattr(self, field.name) for field in fields(self))

    def __getitem__(self, case: int) -> "Losses":
        return Losses(**{field.name: float(getattr(self, field.name)[case]) for field in fields(self)})
