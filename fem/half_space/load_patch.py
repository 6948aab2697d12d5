r"""Deflection of an elastic half-space under the load patch of one roller.

A contact law already holds the indentation of the raceway under the roller's own load, as that of
a half-space. The flexible ring must not count it twice, so it is subtracted from the self term:

.. math:: H_{mm'} = \frac{1-\nu^2}{\pi E} \iint \frac{p_m(s,x)\,p_{m'}(s',x')}{r}\,dA\,dA'

with the patterns p_m of `fem.assembly.roller_loads` on a plane. The difference of two Gaussian arcs is
Gaussian with sqrt(2) of the width, that of two axial modes is a polynomial, so that two integrals remain.

Source
------
Johnson, Contact Mechanics (1985), sec. 3.2: u = (1 - nu^2)/(pi E) times the integral of p/r.
"""

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from fem.parts.rings import Elastic, Patches


def half_space(patches: Patches, elastic: Elastic) -> NDArray:
    """Generalised indentation of a half-space under the unit patterns of one roller.

    Parameters
    ----------
    patches : Patches
        length l, width and number M of axial modes are used
    elastic : Elastic
        material of the ring that carries the raceway

    Returns
    -------
    array (M, M)
        H [m/N], symmetric, into the surface per force on it, relative to infinity

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 3.2: u = (1 - nu^2)/(pi E) times the integral of p/r.

    Valid
    -----
    Patch small against the ring's radius and thickness.
    """
    s, ds = _half_line(np.sqrt(2) * patches.width)
    gauss = np.exp(-((s / patches.width) ** 2) / 4) / (2 * patches.width * np.sqrt(np.pi))
    H = np.einsum("s,smn->mn", gauss * ds, kernel(s, patches.length, patches.axial_modes))
    return (1 - elastic.poisson_ratio**2) / (np.pi * elastic.youngs_modulus) * H


def kernel(arc, length: float, axial_modes: int) -> NDArray:
    r"""Axial double integral of 1/r between two parallel lines, for every pair of axial modes.

    .. math:: k_{mm'}(s) = \iint \frac{a_m(x)\,a_{m'}(x')}{\sqrt{s^2+(x-x')^2}}\,dx\,dx',
              \quad a_m = \frac{2m+1}{l} L_m(2x/l)

    Parameters
    ----------
    arc : array (...)
        s, distance of the lines [m], > 0; logarithmically singular at 0
    length : float
        l [m]
    axial_modes : int
        M

    Returns
    -------
    array (..., M, M)
        [1/m]; for m = m' = 0 it is 2 (l asinh(l/s) - sqrt(l^2 + s^2) + s) / l^2
    """
    coefficients = autocorrelation(axial_modes)
    powers = _moments(2 * np.asarray(arc) / length, coefficients.shape[-1])
    return np.einsum("...k,mnk->...mn", powers, coefficients) * 2 / length


def autocorrelation(axial_modes: int) -> NDArray:
    r"""How often two points of two axial modes lie a distance apart.

    .. math:: A_{mm'}(\rho) = \int a_m(\xi)\,[a_{m'}(\xi+\rho) + a_{m'}(\xi-\rho)]\,d\xi,
              \quad a_m = \tfrac{2m+1}{2} L_m

    An array (M, M, 2 M) of coefficients of A in powers of rho = 2 r/l in [0, 2], symmetric.
    """
    # a polynomial of degree m + m' + 1, so it is known from its values at 2 M points
    rho = 1 + np.cos(np.pi * (np.arange(2 * axial_modes) + 0.5) / (2 * axial_modes))
    nodes, weights = legendre.leggauss(axial_modes + 1)
    half = 1 - rho / 2  # half length of the overlap, whose middle is -rho/2
    start = -rho[:, None] / 2 + half[:, None] * nodes
    a = legendre.legvander(start, axial_modes - 1) * (np.arange(axial_modes) + 0.5)
    b = legendre.legvander(start + rho[:, None], axial_modes - 1) * (np.arange(axial_modes) + 0.5)
    values = np.einsum("r,q,rqm,rqn->rmn", half, weights, a, b)
    values = values + values.swapaxes(1, 2)
    powers = np.linalg.inv(np.vander(rho, increasing=True))
    return np.einsum("kr,rmn->mnk", powers, values)


def _moments(s: NDArray, count: int) -> NDArray:
    r"""Integrals of rho^k / sqrt(rho^2 + s^2) over 0 .. 2 by their recurrence, (..., count)."""
    root = np.hypot(2.0, s)
    moments = [np.arcsinh(2 / s), root - s]
    for k in range(2, count):
        moments.append((2.0 ** (k - 1) * root - (k - 1) * s**2 * moments[k - 2]) / k)
    return np.stack(moments, axis=-1)


def _half_line(scale: float) -> tuple[NDArray, NDArray]:
    """Nodes and weights for both sides of s = 0 of an even function with a logarithm at 0.

    The trapezoidal rule in t, s = scale exp(t), converges exponentially: both ends decay.
    """
    t, step = np.linspace(-40.0, 3.0, 861, retstep=True)
    s = scale * np.exp(t)
    return s, 2 * s * step
