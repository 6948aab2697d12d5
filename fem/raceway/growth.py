"""Growth of a raceway that its seat or shaft widens or narrows, by unit loads."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class RacewayGrowth:
    """Outward displacement of a raceway per free expansion of what its part is clamped to, beyond its own."""

    coefficients: NDArray  # (K, M) [m] of cos(k bars phi) L_m(2x/l); outward per strain
    bars: int | None  # of a squirrel cage, the first at azimuth 0; None: alike all around, K = 1

    @property
    def mean(self) -> float:
        """Mean over the loaded band [m], which belongs to the clearance."""
        return float(self.coefficients[0, 0])

    def at(self, azimuths: NDArray) -> NDArray:
        """Displacement (Z, M) [m] beyond the mean, per strain, at the azimuths (Z) [rad] of rollers."""
        waves = (self.bars or 0) * np.arange(len(self.coefficients))
        beyond = self.coefficients.copy()
        beyond[0, 0] = 0.0
        return np.cos(np.outer(azimuths, waves)) @ beyond


@dataclass(frozen=True)
class BondedGrowth:
    """Outward displacement of a raceway by unit loads on ring and shaft, Legendre modes along the roller."""

    by_heat: NDArray  # (2, M) [m] per free expansion of ring, shaft
    by_rotation: NDArray  # (2, M) [m] per density of ring, shaft times speed squared [kg/m^3 rad^2/s^2]

    def under(
        self, thermal_strains: tuple[float, float], densities: tuple[float, float], speed: float
    ) -> NDArray:
        """Growth (M,) [m] by heat [-] and rotation [kg/m^3], [rad/s] of ring and shaft."""
        return np.array(thermal_strains) @ self.by_heat + speed**2 * np.array(densities) @ self.by_rotation
