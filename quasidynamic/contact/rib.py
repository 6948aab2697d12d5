"""Ends of rollers on ribs: a sphere on a flat face, and how fast it slides."""

import numpy as np
from numpy.typing import NDArray

EXPONENT = 1.5  # of the approach in the load


def rib_stiffness(radius: float, modulus: float) -> float:
    r"""Load over approach^1.5 of a roller's end on a rib.

    .. math:: K = \tfrac43 E^* \sqrt{R_s}

    Parameters
    ----------
    radius : float
        R_s of the sphere on a flat that is curved as end and rib together [m]
    modulus : float
        E*, with 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 [Pa]

    Returns
    -------
    float
        K [N/m^1.5]

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 4.2: a sphere on a flat face.

    Valid
    -----
    Contact small against end and rib, and not cut by an edge.
    """
    return 4 / 3 * modulus * radius**0.5


def rib_pressure(load: NDArray, curvature: float, modulus: float) -> NDArray:
    r"""Peak pressure of a roller's end on a rib.

    .. math:: p_f = \frac{1}{\pi} \Big( \frac{6 Q_f E^{*2}}{R_s^2} \Big)^{1/3}

    p_f [Pa] of the load Q_f (...) [N] >= 0; curvature 1/R_s [1/m] and modulus E* [Pa] as of `rib_stiffness`.

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 4.2: a sphere on a flat face.
    """
    return np.cbrt(6 * load * (modulus * curvature) ** 2) / np.pi


def in_series(first: float, second: float) -> float:
    r"""Stiffness of two contacts that one load presses, their approaches added.

    .. math:: K = (K_1^{-2/3} + K_2^{-2/3})^{-3/2}

    all in [N/m^1.5].

    Source
    ------
    Sum of the approaches (P/K)^(2/3).
    """
    return (first ** (-1 / EXPONENT) + second ** (-1 / EXPONENT)) ** -EXPONENT
