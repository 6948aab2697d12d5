"""Thickness of the lubricant film in a line contact."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.parts.lubricant import Lubricant

TINY = 1e-300  # lets the logarithm of nothing pass
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
    """A film formula at given contacts, thinned by shear heating of the inlet when asked."""

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
        by_load = -f.load * thickness / line_load
        by_entrainment = f.speed * thickness / entrainment
        if not self.inlet_heating:
            return Film(thickness, by_load, np.zeros_like(thickness), by_entrainment)
        factor, by_slide, by_speed = inlet_heating_factor(entrainment, sliding, oil)
        return Film(
            factor * thickness,
            factor * by_load,
            by_slide * thickness,
            factor * by_entrainment + by_speed * thickness,
        )


def inlet_heating_factor(
    entrainment: NDArray, sliding: NDArray, oil: Lubricant
) -> tuple[NDArray, NDArray, NDArray]:
    r"""Reduction of the film by shear heating of the inlet, and its derivatives.

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
        factor in (0, 1] [-], its derivatives by sliding and by entrainment [s/m]

    Source
    ------
    Murch and Wilson (1975), extended for slip.

    Valid
    -----
    S below about 1; beyond it the trend only. S^0.83 is infinitely steep at zero: S is rounded over
    `SLIP_ROUNDING`, which thins the film of pure rolling by less than 0.5 %.
    """
    loading = oil.viscosity * oil.temperature_viscosity * entrainment**2 / oil.conductivity
    slip = np.hypot(sliding / entrainment, SLIP_ROUNDING)
    thermal = 0.1 * np.exp(0.64 * np.log(loading + TINY))
    sheared = 14.8 * np.exp(0.83 * np.log(slip))
    factor = 1.0 / (1.0 + thermal * (1.0 + sheared))
    by_slip = -(factor**2) * thermal * 0.83 * sheared / slip**2 * (sliding / entrainment)
    by_sliding = by_slip / entrainment
    by_entrainment = (
        -(factor**2) * thermal * 1.28 * (1.0 + sheared) - by_slip * sliding / entrainment
    ) / entrainment
    return factor, by_sliding, by_entrainment
