"""Hertz line contact."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

# q/(E' R) [-], a peak pressure of 28 MPa between steel: laws in powers of the load keep their value below it
SMALLEST_LOAD = 1e-7


def reduced_radius(roller_radius: float, raceway_radius: float) -> float:
    r"""Radius of the cylinder on a plane that stands for two cylinders.

    .. math:: 1/R = 1/R_1 + 1/R_2

    Parameters
    ----------
    roller_radius : float
        [m], > 0
    raceway_radius : float
        [m], negative for the concave outer raceway

    Returns
    -------
    float
        R [m]

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 4.2.

    >>> round(reduced_radius(2.5, -37.5), 4)
    2.6786
    """
    return 1.0 / (1.0 / roller_radius + 1.0 / raceway_radius)


def peak_pressure(line_load: ArrayLike, radius: ArrayLike, modulus: ArrayLike) -> NDArray:
    r"""Peak pressure under a long roller.

    .. math:: p_0 = \sqrt{q E' / (2 \pi R)}

    Parameters
    ----------
    line_load : array (...)
        q, load per length [N/m], >= 0
    radius : float
        R, reduced radius [m]
    modulus : float
        E' = 2/[(1-nu1^2)/E1 + (1-nu2^2)/E2] [Pa]

    Returns
    -------
    array (...)
        p0 [Pa]

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 4.2 (there E* = E'/2).

    Valid
    -----
    Elastic, half-width far below R and below the length.

    >>> round(float(peak_pressure(4800 / 16e-3, 6.4e-3, 228.0e9)) / 1e9, 2)
    1.3
    """
    return np.sqrt(np.asarray(line_load) * np.asarray(modulus) / (2 * np.pi * np.asarray(radius)))


def half_width(line_load: ArrayLike, radius: ArrayLike, modulus: ArrayLike) -> NDArray:
    r"""Half of the width of the contact strip.

    .. math:: b = \sqrt{8 q R / (\pi E')}

    Parameters
    ----------
    line_load : array (...)
        q, load per length [N/m], >= 0
    radius : float
        R, reduced radius [m]
    modulus : float
        E' [Pa], see `peak_pressure`

    Returns
    -------
    array (...)
        b [m]

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 4.2.
    """
    return np.sqrt(8 * np.asarray(line_load) * np.asarray(radius) / (np.pi * np.asarray(modulus)))
