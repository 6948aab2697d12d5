"""The oil at the inlet of the contacts."""

from dataclasses import dataclass, field

from quasidynamic.errors import require_positive
from quasidynamic.note import Note


@dataclass(frozen=True, kw_only=True)
class Lubricant:
    """An oil at its inlet temperature."""

    temperature: float  # [K] at the inlet
    viscosity: float  # [Pa s] dynamic, at ambient pressure
    pressure_viscosity: float  # [1/Pa] alpha
    temperature_viscosity: float  # [1/K] beta = -d ln(viscosity)/dT
    conductivity: float  # [W/(m K)]
    density: float  # [kg/m3]
    # what a user must know, such as an extrapolation
    notes: tuple[Note, ...] = field(default=(), compare=False)

    def __post_init__(self):
        for name in ("temperature", "viscosity", "pressure_viscosity", "conductivity", "density"):
            require_positive(f"lubricant.{name}", getattr(self, name))
