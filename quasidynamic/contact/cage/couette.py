"""Friction of a fluid sheared in a gap between turning cylinders."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

SHARPNESS = 8  # of the smooth maximum; the factor is 9 percent above the greater one where two regimes meet


class CouetteFactor(NamedTuple):
    """Friction over its laminar value."""

    factor: NDArray  # [-] >= 1
    slope: NDArray  # d ln(factor) / d ln(speed)


def couette_factor(reynolds: NDArray, gap_ratio: NDArray | float) -> CouetteFactor:
    r"""How much vortices and turbulence raise the friction of a laminar Couette flow.

    .. math:: \frac{f}{f_L} = \max\left[1,\; 1.3 \left(\frac{Ta}{41}\right)^{0.539474},\;
              3.0 \left(\frac{Re}{2500}\right)^{0.85596}\right],\quad
              Ta = Re \sqrt{c/R},\; Re = \rho V c / \eta

    The maximum is smooth, a root of the sum of powers (`SHARPNESS`). As printed, they hold below Ta = 41,
    above it, or from Re = 2500, and jump between; their maximum leaves 1 at Ta = 25 or Re = 693.

    Parameters
    ----------
    reynolds : array (...)
        Re [-] with the full speed difference V of the surfaces and the gap c, >= 0
    gap_ratio : array (...)
        c/R [-], > 0

    Returns
    -------
    CouetteFactor
        1 at rest

    Source
    ------
    Rumbarger, Filetti and Gubernick, J. Lubrication Technology 95 (1973). Its f_L = 16/Re is the friction of
    a tube and eight times that of a Couette flow with this Re, 2/Re: only the ratio is used.

    Valid
    -----
    Gap far below the radius; the faster surface inside. With the faster one outside no vortices form, and the
    Taylor factor overestimates.
    """
    vortex_exponent, turbulent_exponent = SHARPNESS * 0.539474, SHARPNESS * 0.85596
    vortex = 1.3**SHARPNESS * (np.sqrt(gap_ratio) / 41 * reynolds) ** vortex_exponent
    turbulent = 3.0**SHARPNESS * (reynolds / 2500) ** turbulent_exponent
    total = 1 + vortex + turbulent
    slope = (0.539474 * vortex + 0.85596 * turbulent) / total
    return CouetteFactor(total ** (1 / SHARPNESS), slope)
