"""The most pressed point contact of each raceway: its ellipse, what it does below the surface, its safety."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.ellipse.subsurface import orthogonal_shear
from quasidynamic.outcome.rating_life import BALLS, POINT, pressure_safety


@dataclass(frozen=True)
class WorstPointContact:
    """Most pressed ellipse of each raceway, inner first (2)."""

    pressure: NDArray  # (2) [Pa]
    half_width: NDArray  # (2) [m] b, along the rolling direction
    axis_ratio: NDArray  # (2) [-] b over the semi-axis across the rolling direction; 0 without load

    @classmethod
    def of(cls, pressure: NDArray, across: NDArray, along: NDArray) -> "WorstPointContact":
        """The most pressed ones of all contacts: pressures [Pa] and semi-axes [m], (n, 2)."""
        worst = pressure.argmax(axis=0), np.arange(2)
        wide, narrow = across[worst], along[worst]
        ratio = np.divide(narrow, wide, out=np.zeros(2), where=wide > 0)
        return cls(pressure[worst], narrow, ratio)

    @property
    def orthogonal_shear(self) -> NDArray:
        """Amplitude of the orthogonal shear stress (2) [Pa]."""
        return orthogonal_shear(self.pressure, self.half_width, self.axis_ratio)[0]

    @property
    def orthogonal_depth(self) -> NDArray:
        """Its depth (2) [m]."""
        return orthogonal_shear(self.pressure, self.half_width, self.axis_ratio)[1]

    @property
    def safety(self) -> NDArray:
        """Static safety by pressure (2) [-]."""
        return np.asarray(pressure_safety(self.pressure, BALLS, POINT))
