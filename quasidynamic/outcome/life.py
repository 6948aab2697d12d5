"""Fatigue life of raceways under roller loads."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.parts.bearing import CylindricalRollerBearing

MATERIAL_FACTOR = 1.1  # b_m of modern cylindrical roller bearings
WEIBULL = 9 / 8  # dispersion exponent of line contact


def raceway_capacity(bearing: CylindricalRollerBearing) -> tuple[float, float]:
    r"""Roller load that a raceway survives for a million revolutions with 90 % probability.

    .. math:: Q_c = 552\, b_m \frac{(1 \mp \gamma)^{29/27}}{(1 \pm \gamma)^{1/4}}
              \gamma^{2/9} D^{29/27} l^{7/9} Z^{-1/4} \quad \text{(N, mm; upper sign inner)}

    Parameters
    ----------
    bearing : CylindricalRollerBearing
        gamma, D, l, Z

    Returns
    -------
    tuple of float
        inner and outer capacity [N]

    Source
    ------
    Lundberg and Palmgren (1952), line contact; b_m of ISO 281.

    Valid
    -----
    Bearing steel, full film, evenly loaded rollers.
    """
    millimetre = 1e-3
    g = bearing.diameter_ratio
    size = (
        552
        * MATERIAL_FACTOR
        * g ** (2 / 9)
        * (bearing.roller.diameter / millimetre) ** (29 / 27)
        * (bearing.roller.length / millimetre) ** (7 / 9)
        * bearing.rollers ** (-1 / 4)
    )
    inner = (1 - g) ** (29 / 27) / (1 + g) ** (1 / 4)
    outer = (1 + g) ** (29 / 27) / (1 - g) ** (1 / 4)
    return size * inner, size * outer


def basic_life(
    inner: NDArray, outer: NDArray, bearing: CylindricalRollerBearing, turning: tuple[bool, bool]
) -> float:
    r"""Basic reference life from the loads of the slices.

    .. math:: L_{10} = \Big\{ \sum_k (q_{ei,k}/q_{ci})^{4.5} + (q_{eo,k}/q_{co})^{4.5} \Big\}^{-8/9},\quad
              q_e = \Big( \frac1Z \sum_j q_j^p \Big)^{1/p},\; q_c = Q_c K^{-7/9}

    with p = 4 for a ring that turns against the load and 4.5 for one that stands still under it.

    Parameters
    ----------
    inner, outer : array (Z, K)
        load of each slice [N]
    bearing : CylindricalRollerBearing
        for the capacities
    turning : tuple of bool
        whether the inner and the outer ring turn against the load

    Returns
    -------
    float
        L10 [10^6 revolutions]; infinite without load

    Source
    ------
    Lundberg and Palmgren (1952); ISO/TS 16281 (2008), without its edge stress factor.

    Valid
    -----
    Raceway fatigue from below the surface, reliability 90 %, no lubrication factor.
    """
    slices = inner.shape[1]
    damage = 0.0
    for loads, capacity, turns in zip((inner, outer), raceway_capacity(bearing), turning, strict=True):
        p = 4.0 if turns else 4.5
        equivalent = np.mean(loads**p, axis=0) ** (1 / p)
        damage += float(np.sum((equivalent / (capacity * slices ** (-7 / 9))) ** (4 * WEIBULL)))
    return damage ** (-1 / WEIBULL) if damage else float("inf")
