"""Thickness of the lubricant film in a line contact."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.parts.lubricant import Lubricant

SLIP_ROUNDING = 1e-3  # of the slide-to-roll ratio in the heating of the inlet


class Film(NamedTuple):
    """Film thickness [m] with its derivatives."""

    thickness: NDArray
    by_line_load: NDArray  # [m2/N]
    by_sliding: NDArray  # [s]
    by_entrainment: NDArray  # [s]


@dataclass(frozen=True, kw_only=True)
class FilmFormula:
    r"""A regression of film thickness in the groups of line contact.

    .. math:: h/R = c\, G^{g} U^{s} W^{-w},\quad
              U = \eta_0 u/(E' R),\; G = \alpha E',\; W = q/(E' R)

    with q load per length, u mean surface speed, E' = 2/[(1-nu1^2)/E1 + (1-nu2^2)/E2].

    Source
    ------
    Groups of Dowson and Higginson; the coefficients of each formula name their own in `FORMULAS`.

    Valid
    -----
    Flooded, isothermal, elastic and piezoviscous contacts.
    """

    source: str
    factor: float  # c
    material: float  # exponent g
    speed: float  # exponent s
    load: float  # exponent w, counted positive


FORMULAS = {
    "dowson_higginson": FilmFormula(
        source="minimum; Dowson and Higginson (1961, 1966)", factor=1.6, material=0.6, speed=0.7, load=0.13
    ),
    "dowson": FilmFormula(
        source="minimum; Dowson, Proc. IMechE 182 (1968)", factor=2.65, material=0.54, speed=0.7, load=0.13
    ),
    "dowson_toyoda": FilmFormula(
        source="central; Dowson and Toyoda (1978)", factor=3.06, material=0.56, speed=0.69, load=0.10
    ),
    "pan_hamrock": FilmFormula(
        source="minimum; Pan and Hamrock (1989)", factor=1.714, material=0.568, speed=0.694, load=0.128
    ),
    "pan_hamrock_central": FilmFormula(
        source="central; Pan and Hamrock (1989)", factor=2.922, material=0.470, speed=0.692, load=0.166
    ),
}


@dataclass(frozen=True, kw_only=True)
class FilmLaw:
    """A film formula at the contacts of a bearing, thinned by inlet shear heating if wanted."""

    formula: FilmFormula
    radius: NDArray | float  # [m] reduced radius R, broadcasts against the loads
    modulus: NDArray | float  # [Pa] E'
    oil: Lubricant
    inlet_heating: bool = True

    @cached_property
    def _scale(self) -> NDArray | float:
        """Film at unit speed and load per length [SI]."""
        f, oil = self.formula, self.oil
        elastic = self.modulus * self.radius
        material = (oil.pressure_viscosity * self.modulus) ** f.material
        return f.factor * self.radius * material * (oil.viscosity / elastic) ** f.speed * elastic**f.load

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray) -> Film:
        """Film of loads per length q > 0 [N/m], sliding [m/s] of any sign, entrainment u > 0 [m/s]."""
        f, oil = self.formula, self.oil
        thickness = self._scale * np.exp(f.speed * np.log(entrainment) - f.load * np.log(line_load))
        by_slip, by_log_speed = 0.0, f.speed
        if self.inlet_heating:
            factor, by_slip, by_log_speed = inlet_heating_factor(entrainment, sliding, oil)
            thickness, by_log_speed = factor * thickness, f.speed + by_log_speed
        per_speed = thickness / entrainment
        return Film(thickness, -f.load * thickness / line_load, by_slip * per_speed, by_log_speed * per_speed)


def inlet_heating_factor(
    entrainment: NDArray, sliding: NDArray, oil: Lubricant
) -> tuple[NDArray, NDArray, NDArray]:
    r"""Reduction of the film by inlet shear heating, and its derivatives.

    .. math:: \varphi_T = 1/[1 + 0.1 (1 + 14.8\, S^{0.83}) L^{0.64}],\quad L = \eta_0 \beta u^2/k

    Parameters
    ----------
    entrainment, sliding : array (...)
        u and u1 - u2 [m/s]; S is their ratio without its sign
    oil : Lubricant
        eta0, beta, k at the inlet

    Returns
    -------
    tuple of array (...)
        factor in (0, 1] [-], d ln(factor) by the signed ratio (u1 - u2)/u and by ln u at constant sliding [-]

    Source
    ------
    Murch and Wilson (1975), extended for slip.

    Valid
    -----
    S below about 1; beyond it the trend only. S^0.83 is infinitely steep at zero: S is rounded over
    `SLIP_ROUNDING`, which thins the film of pure rolling by less than 0.5 %.
    """
    thermal_unit = 0.1 * np.power(oil.viscosity * oil.temperature_viscosity / oil.conductivity, 0.64)
    ratio = sliding / entrainment
    squared = ratio * ratio + SLIP_ROUNDING**2
    rolling = thermal_unit * np.exp(1.28 * np.log(entrainment))
    sliding_part = rolling * (14.8 * np.exp(0.83 / 2 * np.log(squared)))
    heating = rolling + sliding_part
    factor = 1.0 / (1.0 + heating)
    by_slip = -0.83 * factor * sliding_part * ratio / squared
    return factor, by_slip, -1.28 * factor * heating - by_slip * ratio
