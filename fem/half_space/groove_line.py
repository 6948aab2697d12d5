r"""Deflection of a half-space along a short line across a groove, by forces across and along its surface.

A force along the line moves it along itself by

.. math:: H_t(\varphi) = \frac{1+\nu}{\pi E}\,\left[(1-\nu)\,k + \nu\,k_t\right](2R\,|\sin(\varphi/2)|)

while the answer to a force into the surface is that of `fem.half_space.line_load`. By symmetry, neither force
moves the line, on average, in the direction of the other.

Source
------
Johnson, Contact Mechanics (1985), sec. 3.2 and 3.6, averaged along lines.
"""

import numpy as np
from numpy.typing import NDArray

from fem.half_space.line_load import fourier, indentation
from fem.parts.rings import Elastic


def line_answers(azimuth: NDArray, radius: float, length: float, elastic: Elastic) -> NDArray:
    r"""Mean displacement of a line per force on another one, normal and along the line.

    Parameters
    ----------
    azimuth : array (...)
        phi between both [rad], not a multiple of 2 pi
    radius : float
        R of the circle around the axis that carries the middles of the lines [m]
    length : float
        l of the lines [m]
    elastic : Elastic
        material below them

    Returns
    -------
    array (..., 2)
        H_n, H_t [m/N], each in the direction of its force

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 3.2 (normal) and 3.6 (tangential point force): the mean over
    both lines of (1 - nu)/r + nu x^2/r^3 in place of (1 - nu)/r.
    """
    phi = np.asarray(azimuth, dtype=float)
    normal = indentation(phi, radius, length, 1, elastic)[..., 0, 0]
    nu = elastic.poisson_ratio
    unit = nu * (1 + nu) / (np.pi * elastic.youngs_modulus)
    difference = unit * _along(2 * radius * np.abs(np.sin(phi / 2)), length)
    return np.stack([normal, normal + difference], axis=-1)


def line_harmonics(harmonics: NDArray, radius: float, length: float, elastic: Elastic) -> NDArray:
    """Fourier coefficients of `line_answers`.

    Parameters
    ----------
    harmonics : array (K,) of int
        n
    radius, length, elastic
        as for `line_answers`

    Returns
    -------
    array (K, 2)
        h_n, h_t [m/N]
    """
    return fourier(harmonics, lambda phi: line_answers(phi, radius, length, elastic))


def _along(distance: NDArray, length: float) -> NDArray:
    r"""Mean of (x - x')^2/r^3 over two parallel lines [1/m].

    .. math:: k_t = \frac{2}{l^2} \int_0^l \frac{(l - t)\,t^2}{(t^2 + s^2)^{3/2}}\,dt
    """
    s, far = distance, np.hypot(distance, length)
    return 2 / length**2 * (length * np.arcsinh(length / s) - (far - s) ** 2 / far - length**2 / far)
