"""Thickness of the lubricant film in a line contact."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.parts.lubricant import Lubricant


def dowson_minimum_film(
    line_load: NDArray, entrainment: NDArray, radius: float, modulus: float, oil: Lubricant
) -> NDArray:
    r"""Isothermal minimum film of a line contact.

    .. math:: h/R = 2.65\, G^{0.54} U^{0.7} W^{-0.13},\quad
              U = \eta_0 u/(E' R),\; G = \alpha E',\; W = q/(E' R)

    Parameters
    ----------
    line_load : array (...)
        q, load per length [N/m], > 0
    entrainment : array (...)
        u, half of the sum of the surface speeds [m/s], >= 0
    radius, modulus : float
        R reduced radius [m], E' [Pa]
    oil : Lubricant
        eta0 and alpha at the inlet

    Returns
    -------
    array (...)
        h [m]

    Source
    ------
    Dowson, Proc. IMechE 182 (1968), the later form of Dowson and Higginson (1961).

    Valid
    -----
    Flooded, isothermal, elastic and piezoviscous.
    """
    speed = oil.viscosity * entrainment / (modulus * radius)
    material = oil.pressure_viscosity * modulus
    load = line_load / (modulus * radius)
    return 2.65 * radius * material**0.54 * speed**0.7 * load**-0.13


def inlet_heating_factor(entrainment: NDArray, sliding: NDArray, oil: Lubricant) -> NDArray:
    r"""Reduction of the film by shear heating of the inlet.

    .. math:: \varphi_T = 1/[1 + 0.1 (1 + 14.8\, S^{0.83}) L^{0.64}],\quad L = \eta_0 \beta u^2/k

    Parameters
    ----------
    entrainment, sliding : array (...)
        u and |u1 - u2| [m/s]; S is their ratio
    oil : Lubricant
        eta0, beta, k at the inlet

    Returns
    -------
    array (...)
        factor in (0, 1] [-]

    Source
    ------
    Murch and Wilson (1975), extended for slip.

    Valid
    -----
    S below about 1; beyond it the trend only.
    """
    loading = oil.viscosity * oil.temperature_viscosity * entrainment**2 / oil.conductivity
    slip = np.abs(sliding) / entrainment
    return 1.0 / (1.0 + 0.1 * (1.0 + 14.8 * slip**0.83) * loading**0.64)
