"""Load of a roller slice from its approach."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quasidynamic.parts.material import Material

if TYPE_CHECKING:  # balls load no rollers
    from quasidynamic.parts.roller_bearing import CylindricalRollerBearing
    from quasidynamic.parts.tapered_bearing import TaperedRollerBearing

    RollersOnRaceways = CylindricalRollerBearing | TaperedRollerBearing

# q/(E' R) [-], a peak pressure of 28 MPa between steel: laws in powers of the load keep their value below it
SMALLEST_LOAD = 1e-7
EXPONENT = 10 / 9  # of both laws, load ~ approach^(10/9)
GAP_ROUNDING = 2e-8  # of the roller's diameter: width over which contact begins smoothly


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


@dataclass(frozen=True)
class LoadLaw:
    """q = coefficient * approach^(10/9), load per length [N/m] from the approach at one raceway [m]."""

    coefficient: NDArray | float  # broadcasts against the approaches
    rounding: float  # [m] width over which contact begins smoothly

    def __call__(self, approach: NDArray) -> tuple[NDArray, NDArray]:
        """Load per length [N/m] and its derivative [N/m2]; both tend smoothly to zero in a gap."""
        closed, root = smooth_positive(approach, self.rounding)
        # The last bits of a ninth of the logarithm matter less than those of all of it.
        load = self.coefficient * np.exp((EXPONENT - 1) * np.log(closed)) * closed
        return load, EXPONENT * load / root

    def approach(self, line_load: NDArray) -> NDArray:
        """Approach [m] that carries a load per length [N/m]: the inverse, contact assumed closed."""
        return (line_load / self.coefficient) ** (1 / EXPONENT)


def smooth_positive(gap: NDArray, rounding: float) -> tuple[NDArray, NDArray]:
    r"""Positive part rounded at zero without cancellation, and over its derivative.

    .. math:: p = (g + \sqrt{g^2 + \varepsilon^2})/2
              = \max(g, 0) + \tfrac12 \varepsilon^2/(|g| + \sqrt{g^2 + \varepsilon^2}),\quad
              p/p' = \sqrt{g^2 + \varepsilon^2}

    g [m] is positive for an approach, negative for an open gap; epsilon, the rounding, is in metres and above
    zero.

    Source
    ------
    Derived here: the hyperbola with the asymptotes of max(g, 0).

    Valid
    -----
    p exceeds max(g, 0) by epsilon/2 at g = 0 and by epsilon^2/(4 |g|) far from it.
    """
    root = np.sqrt(gap * gap + rounding**2)
    return np.maximum(gap, 0.0) + rounding**2 / 2 / (root + np.abs(gap)), root


def palmgren(roller: Material, raceway: Material, length: float) -> float:
    r"""Palmgren's line contact, one raceway.

    .. math:: \delta = 3.81\, B^{0.9} Q^{0.9} / l^{0.8}, \quad
              B = (1-\nu_1^2)/(\pi E_1) + (1-\nu_2^2)/(\pi E_2)

    Parameters
    ----------
    roller, raceway : Material
        the touching pair
    length : float
        l, effective length [m]

    Returns
    -------
    float
        load per length over approach^(10/9), Q spread evenly over l [N/m over m^(10/9)]

    Source
    ------
    Palmgren, Ball and Roller Bearing Engineering (1959); Mao, Wang and Zhang (2016), Eq. (1).

    Valid
    -----
    Rollers about as long as thick on solid rings; an empirical law.
    """
    B = (roller.plane_compliance + raceway.plane_compliance) / np.pi
    return (length**0.8 / 3.81) ** EXPONENT / B / length


def iso16281(length: float) -> float:
    r"""Line contact of steel as the reference life standard takes it.

    .. math:: Q = 35948\, l^{8/9} \delta^{10/9} \quad \text{(N, mm, both raceways together)}

    Parameters
    ----------
    length : float
        l, effective length [m]

    Returns
    -------
    float
        load per length over approach^(10/9) of one raceway, half of the approach belongs to it
        [N/m over m^(10/9)]

    Source
    ------
    ISO/TS 16281 (2008), cylindrical rollers.

    Valid
    -----
    Steel on steel.
    """
    millimetre = 1e-3
    roller = 35948 * (length / millimetre) ** (8 / 9) * (2 / millimetre) ** EXPONENT
    return roller / length


def raceway_coefficients(bearing: "RollersOnRaceways") -> tuple[float, float]:
    """Load per length over approach^(10/9) at both raceways, inner first [N/m over m^(10/9)].

    Source
    ------
    `iso16281`, `palmgren`.
    """
    length, roller = bearing.roller.length, bearing.roller.material
    if bearing.contact_law == "iso16281":
        return iso16281(length), iso16281(length)
    return palmgren(roller, bearing.inner_ring, length), palmgren(roller, bearing.outer_ring, length)


def gap_rounding(bearing: "RollersOnRaceways") -> float:
    """Width over which contact begins smoothly in a bearing [m]: `GAP_ROUNDING` of a roller's diameter."""
    return GAP_ROUNDING * bearing.roller.diameter
