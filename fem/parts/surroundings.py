"""Heat and rotation of a body of revolution, as frozen data."""

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True, kw_only=True)
class Surroundings:
    """What loads bodies all around; clamps follow what it makes of them."""

    thermal_strains: Mapping[str, float] = field(default_factory=dict)  # alpha (T - T0) of every body [-]
    densities: Mapping[str, float] = field(default_factory=dict)  # of every body [kg/m^3]
    speed: float = 0.0  # [rad/s] about the axis
