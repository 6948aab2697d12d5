"""Traction of a fluid film from the rheology of the oil."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line import SMALLEST_LOAD
from quasidynamic.contact.traction.film_strip import film_traction, limited_stress, loaded_strip
from quasidynamic.contact.traction.thermal_shear import (
    BAIR_WINER,
    EYRING,
    STEEL_WALLS,
    ColdFilm,
    WallProperties,
    roelands,
    self_heated_stress,
    thermal_thinning,
)
from quasidynamic.contact.traction.traction_law import Traction
from quasidynamic.parts.oil_properties import Lubricant


@dataclass(frozen=True, kw_only=True)
class Eyring:
    r"""Eyring film with a limiting shear stress, isothermal or with its own heating.

    .. math:: \tau = \min[\tau_E \sinh^{-1}(\eta u_s/(\tau_E h)),\; \Lambda \bar p],\quad
              \bar p = \tfrac{\pi}{4} p_0

    acting on the strip of width 2b; Roelands viscosity at the mean pressure. The cap is a kink.
    With `film_heating` the viscosity is that of the film temperature, see `thermal_thinning`; the
    stress then falls with the sliding once the heating outruns the shearing.

    Source
    ------
    Evans and Johnson (1986); Arana, Larranaga and Ulacia (2019), Eqs (7), (13) and (26) to (28);
    there tau_E = 2 Lambda/alpha.

    Valid
    -----
    Isothermal: slide-to-roll ratio below about 1 %, above it overestimates. Entrainment >= 0, film > 0.
    """

    radius: NDArray | float  # [m] R
    modulus: NDArray | float  # [Pa] E'
    length: float  # [m] l, of no influence
    oil: Lubricant
    limiting_ratio: float  # [-] Lambda
    eyring_stress: float  # [Pa] tau_E
    film_heating: bool = False
    walls: WallProperties = STEEL_WALLS
    smallest_load: float = SMALLEST_LOAD  # [-] q/(E' R) below which strip width over load keeps its value

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> Traction:
        """Traction; without film heating the entrainment speed enters through the film alone."""
        strip = loaded_strip(line_load, self)
        cold = ColdFilm(np.abs(sliding), film, *roelands(strip.pressure, self.oil))
        warm = thermal_thinning(strip, entrainment, film, self.oil, self.walls) if self.film_heating else None
        shear = self_heated_stress(EYRING, (self.eyring_stress, 0.0), strip, cold, warm)
        return film_traction(
            limited_stress(shear, self.limiting_ratio * strip.pressure), strip, line_load, sliding
        )


@dataclass(frozen=True, kw_only=True)
class BairWiner:
    r"""Film whose stress approaches its limit exponentially, isothermal or with its own heating.

    .. math:: \tau = \tau_L [1 - \exp(-\eta u_s/(\tau_L h))],\quad \tau_L = \Lambda \bar p,\quad
              \bar p = \tfrac{\pi}{4} p_0

    acting on the strip of width 2b; Roelands viscosity at the mean pressure. Smooth everywhere.

    Source
    ------
    Bair and Winer (1979); Wingertszahn et al. (2023), Eq (6), solved for the stress.
    Heating: see `Eyring`.

    Valid
    -----
    As `Eyring`; no elastic part of the shear.
    """

    radius: NDArray | float  # [m] R
    modulus: NDArray | float  # [Pa] E'
    length: float  # [m] l, of no influence
    oil: Lubricant
    limiting_ratio: float  # [-] Lambda
    film_heating: bool = False
    walls: WallProperties = STEEL_WALLS
    smallest_load: float = SMALLEST_LOAD  # [-] q/(E' R) below which strip width over load keeps its value

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> Traction:
        """Traction; without film heating the entrainment speed enters through the film alone."""
        strip = loaded_strip(line_load, self)
        cold = ColdFilm(np.abs(sliding), film, *roelands(strip.pressure, self.oil))
        warm = thermal_thinning(strip, entrainment, film, self.oil, self.walls) if self.film_heating else None
        limit = self.limiting_ratio * strip.pressure
        shear = self_heated_stress(BAIR_WINER, (limit, 0.5), strip, cold, warm)  # limit ~ load^(1/2)
        return film_traction(shear, strip, line_load, sliding)
