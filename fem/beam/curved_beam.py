r"""A ring as a closed curved beam with a rigid rectangular section, in closed form per azimuthal harmonic.

A section at the mean radius R moves by :math:`u_x = U - \rho\theta`, :math:`u_r = W + x\theta`,
:math:`u_t = V + \rho\psi + x\chi` with :math:`\rho = r - R`; U, W, theta go with cos(n phi), V, chi, psi
with sin(n phi). Arrays hold them in the order of `MOTIONS`.
"""

from dataclasses import dataclass
from math import log

import numpy as np
from numpy.typing import NDArray

from fem.parts.rings import Elastic

MOTIONS = ("U", "W", "V", "theta", "chi", "psi")
SHEAR = 5 / 6  # of the section of a rectangle that carries shear (Reissner)
TWIST_TERMS = 8  # odd ones of the series: the next is below 1e-6 of the sum


@dataclass(frozen=True, kw_only=True)
class CurvedBeam:
    """A closed ring of rectangular section."""

    inside: float  # [m] radius
    outside: float  # [m] radius
    width: float  # [m] axial
    elastic: Elastic

    @property
    def radius(self) -> float:
        """R of the middle of the section [m]."""
        return (self.inside + self.outside) / 2

    @property
    def thickness(self) -> float:
        """Radial [m]."""
        return self.outside - self.inside

    def stiffness(self, harmonics) -> NDArray:
        r"""Stiffness of the free ring against motions of each harmonic, per radian.

        .. math:: a_n = E J_0 s^2 + 2 E J_1 s\,n\psi + E J_2 (n\psi)^2
                  + E J_0 \tfrac{b^2}{12} (\theta + n\chi)^2
                  + \kappa G A R \left[(\psi - \tfrac{V + nW}{R})^2 + (\chi - \tfrac{nU}{R})^2\right]
                  + \tfrac{G J}{R} (\chi + n\theta)^2

        with :math:`s = W + nV` and :math:`J_k = \int \rho^k/r\,dA`: hoop strain and both curvatures, both
        shears, twist.

        Parameters
        ----------
        harmonics : array (K,)
            n

        Returns
        -------
        array (K, 6, 6)
            symmetric; its parts for U, W, V are in N/m

        Source
        ------
        Timoshenko, Strength of Materials, part II, curved bars and circular rings; torsion of a rectangle by
        Timoshenko, Goodier, Theory of Elasticity, sec. 109.

        Valid
        -----
        Section small against the radius and against R/n; it keeps its shape.
        """
        n = np.asarray(harmonics, dtype=float)
        one, none = np.ones_like(n), np.zeros_like(n)
        R, b = self.radius, self.width
        strains = np.array([
            # U, W, V, theta, chi, psi
            [none, one, n, none, none, none],
            [none, none, none, none, none, n],
            [none, none, none, one, n, none],
            [none, -n / R, -one / R, none, none, one],
            [-n / R, none, none, none, one, none],
            [none, none, none, n, one, none],
        ]).transpose(2, 0, 1)  # fmt: skip
        E, G = self.elastic.youngs_modulus, shear_modulus(self.elastic)
        area = b * self.thickness
        J0 = b * log(self.outside / self.inside)
        J1 = area - R * J0
        shear = SHEAR * G * area * R
        twist = G * twist_constant(b, self.thickness) / R
        law = np.diag([E * J0, -E * R * J1, E * J0 * b**2 / 12, shear, shear, twist])
        law[0, 1] = law[1, 0] = E * J1
        return strains.transpose(0, 2, 1) @ law @ strains


def shear_modulus(elastic: Elastic) -> float:
    """G [Pa]."""
    return elastic.youngs_modulus / (2 * (1 + elastic.poisson_ratio))


def twist_constant(width: float, height: float) -> float:
    r"""Torsion constant of a rectangle.

    .. math:: J = a\,c^3 \left[\frac13 - \frac{64}{\pi^5} \frac{c}{a}
              \sum_{k\,\mathrm{odd}} \frac{\tanh(k\pi a/2c)}{k^5}\right], \quad a \ge c

    Parameters
    ----------
    width, height : float
        sides, in any order [m]

    Returns
    -------
    float
        J [m^4]

    Source
    ------
    Timoshenko, Goodier, Theory of Elasticity, sec. 109.
    """
    c, a = sorted((width, height))
    k = np.arange(1, 2 * TWIST_TERMS, 2)
    series = np.sum(np.tanh(k * np.pi * a / (2 * c)) / k**5)
    return float(a * c**3 * (1 / 3 - 64 / np.pi**5 * c / a * series))
