"""The most pressed line contact of each raceway: its width, what it does below the surface, its safety."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line import peak_pressure
from quasidynamic.contact.line.slices import orthogonal_shear
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.outcome.rating_life import LINE, ROLLERS, pressure_safety


@dataclass(frozen=True)
class WorstLineContact:
    """Most pressed slice of each raceway; inner and outer are the last axis, cases may stand before."""

    pressure: NDArray  # (..., 2) [Pa]
    half_width: NDArray  # (..., 2) [m]

    @classmethod
    def under(cls, pressure: NDArray, radius: NDArray, modulus: NDArray) -> "WorstLineContact":
        """The strip that has a pressure.

        .. math:: b = 4 R p_0 / E'

        p0 [Pa], reduced radii R [m] and E' [Pa] are those of both raceways (..., 2).

        Source
        ------
        Johnson, Contact Mechanics (1985), sec. 4.2, both formulas of `contact.line.hertz` in one.
        """
        return cls(pressure, 4 * radius * pressure / modulus)

    @property
    def orthogonal_shear(self) -> NDArray:
        """Amplitude of the orthogonal shear stress (..., 2) [Pa]."""
        return orthogonal_shear(self.pressure, self.half_width)[0]

    @property
    def orthogonal_depth(self) -> NDArray:
        """Its depth (..., 2) [m]."""
        return orthogonal_shear(self.pressure, self.half_width)[1]

    @property
    def safety(self) -> NDArray:
        """Static safety by pressure (..., 2) [-]."""
        return np.asarray(pressure_safety(self.pressure, ROLLERS, LINE))


@dataclass(frozen=True)
class LargestSlice:
    """The slice with the largest pressure."""

    race: int  # 0 the inner, 1 the outer raceway
    roller: int  # from 0
    pressure: float  # [Pa]
    edge_stress: bool  # whether the pressure has the edge stress factor of ISO/TS 16281


def largest_slice(state: Equilibrium, edge_stress: NDArray | None = None) -> LargestSlice:
    """Find the slice with the largest pressure at each raceway.

    `edge_stress` (K) is a factor on the load of the slices, `edge_stress_factor` [-].

    Source
    ------
    Hertz's pressure of each slice, `peak_pressure`.
    """
    raceways, factor = state.balance.roller.raceways, 1.0 if edge_stress is None else edge_stress
    along = peak_pressure(state.slice_loads, raceways.radius, raceways.modulus)
    pressure = (along * np.sqrt(factor)).max(axis=-1)
    race, roller = (int(place) for place in np.unravel_index(np.argmax(pressure), pressure.shape))
    return LargestSlice(race, roller, float(pressure[race, roller]), edge_stress is not None)
