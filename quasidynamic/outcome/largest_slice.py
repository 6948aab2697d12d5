"""The slice with the largest pressure."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line import peak_pressure
from quasidynamic.outcome.equilibrium import Equilibrium

END = 1 / 60  # of the length from an end, where its pressure is taken: the middle of the last of 30 slices
PRESSED_END = 0.85  # of the largest pressure; calibrated: of 210 contacts none above is known within 5 %


@dataclass(frozen=True)
class LargestSlice:
    """The slice with the largest pressure, and how much its roller is pressed near an end."""

    race: int  # 0 the inner, 1 the outer raceway
    roller: int  # from 0
    pressure: float  # [Pa]
    end_share: float  # [-] see `end_share`
    edge_stress: bool  # whether the pressure has the edge stress factor of ISO/TS 16281

    @property
    def pressed_end(self) -> bool:
        """Whether the end is pressed so much that the largest pressure of slices is not the peak."""
        return self.end_share > PRESSED_END


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
        of both raceways; the share of the end is that without the factor

    Source
    ------
    Hertz's pressure of each slice, `peak_pressure`.
    """
    raceways, factor = state.balance.roller.raceways, 1.0 if edge_stress is None else edge_stress
    along = peak_pressure(state.slice_loads, raceways.radius, raceways.modulus)
    pressure = (along * np.sqrt(factor)).max(axis=-1)
    race, roller = (int(place) for place in np.unravel_index(np.argmax(pressure), pressure.shape))
    share = end_share(along[race, roller])
    return LargestSlice(race, roller, float(pressure[race, roller]), share, edge_stress is not None)


def end_share(along: NDArray) -> float:
    """Pressure near an end of a roller over the largest one [-], of the end that is pressed more.

    Parameters
    ----------
    along : array (K)
        largest pressure of equal slices along the roller [Pa]

    Returns
    -------
    float
        on the line through the last two slices, `END` of the length from the end

    Source
    ------
    None: an indicator.
    """
    if len(along) == 1:
        return 1.0
    beyond = 0.5 - END * len(along)  # slices from the middle of the last one outwards
    ends = [along[-1] + beyond * (along[-1] - along[-2]), along[0] + beyond * (along[0] - along[1])]
    return float(max(ends) / along.max())
