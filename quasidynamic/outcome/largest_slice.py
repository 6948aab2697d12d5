"""The slice with the largest pressure."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line import peak_pressure
from quasidynamic.outcome.equilibrium import Equilibrium


@dataclass(frozen=True)
class LargestSlice:
    """The slice with the largest pressure."""

    race: int  # 0 the inner, 1 the outer raceway
    roller: int  # from 0
    pressure: float  # [Pa]
    edge_stress: bool  # whether the pressure has the edge stress factor of ISO/TS 16281


def largest_slice(state: Equilibrium, edge_stress: NDArray | None = None) -> LargestSlice:
    """Find the slice with the largest pressure.

    Parameters
    ----------
    state : Equilibrium
        solved
    edge_stress : array (K), optional
        factor on the load of the slices, `edge_stress_factor` [-]

    Returns
    -------
    LargestSlice
        of both raceways

    Source
    ------
    Hertz's pressure of each slice, `peak_pressure`.
    """
    raceways, factor = state.balance.roller.raceways, 1.0 if edge_stress is None else edge_stress
    along = peak_pressure(state.slice_loads, raceways.radius, raceways.modulus)
    pressure = (along * np.sqrt(factor)).max(axis=-1)
    race, roller = (int(place) for place in np.unravel_index(np.argmax(pressure), pressure.shape))
    return LargestSlice(race, roller, float(pressure[race, roller]), edge_stress is not None)
