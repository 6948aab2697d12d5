r"""How a half-space answers a normal Gaussian patch, at itself and at others along a line.

A contact law already holds the indentation under the own load, so it is taken from the own answers of a
raceway.
"""

import numpy as np
from numpy.typing import NDArray

from fem.parts.material import Elastic


def patch_answers(distance: NDArray, width: float, elastic: Elastic) -> NDArray:
    r"""Mean normal displacement of one Gaussian patch per normal force on another one.

    .. math:: h(d) = \frac{1-\nu^2}{\pi E}\,\frac{\sqrt\pi}{2\sigma}\,e^{-q} I_0(q), \quad
              q = \frac{d^2}{8\sigma^2}

    Parameters
    ----------
    distance : array (...)
        d between the middles of both patches [m]
    width : float
        sigma, standard deviation of both patches [m]
    elastic : Elastic
        E [Pa] and nu of the half-space

    Returns
    -------
    array (...)
        h [m/N], into the surface per force on it

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 3.2: u = (1 - nu^2)/(pi E) times the mean of 1/r. The difference
    of points of both patches is Gaussian with the standard deviation sqrt(2) sigma about d, and the mean of
    its inverse length that of a Rice distribution.

    Valid
    -----
    Patch small against the radii of the surface.
    """
    q = np.square(distance) / (8 * width**2)
    unit = (1 - elastic.poisson_ratio**2) / (np.pi * elastic.youngs_modulus)
    from scipy.special import ive  # sections under rollers are condensed without

    return unit * np.sqrt(np.pi) / (2 * width) * ive(0, q)
