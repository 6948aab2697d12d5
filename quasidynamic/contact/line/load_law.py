"""Load of a roller slice from its approach."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.parts.material import Material
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing

EXPONENT = 10 / 9  # of both laws, load ~ approach^(10/9)
GAP_ROUNDING = 1e-9  # [m] width over which contact begins smoothly; bias below 0.02 N


@dataclass(frozen=True)
class LoadLaw:
    """q = coefficient * approach^(10/9), load per length [N/m] from the approach at one raceway [m]."""

    coefficient: NDArray | float  # broadcasts against the approaches

    def __call__(self, approach: NDArray) -> tuple[NDArray, NDArray]:
        """Load per length [N/m] and its derivative [N/m2]; both tend smoothly to zero in a gap."""
        closed, root = smooth_positive(approach)
        # The last bits of a ninth of the logarithm matter less than those of all of it.
        load = self.coefficient * np.exp((EXPONENT - 1) * np.log(closed)) * closed
        return load, EXPONENT * load / root

    def approach(self, line_load: NDArray) -> NDArray:
        """Approach [m] that carries a load per length [N/m]: the inverse, contact assumed closed."""
        return (line_load / self.coefficient) ** (1 / EXPONENT)


def smooth_positive(gap: NDArray) -> tuple[NDArray, NDArray]:
    r"""Positive part rounded over `GAP_ROUNDING` without cancellation, and over its derivative.

    .. math:: p = (g + \sqrt{g^2 + \varepsilon^2})/2
              = \max(g, 0) + \tfrac12 \varepsilon^2/(|g| + \sqrt{g^2 + \varepsilon^2}),\quad
              p/p' = \sqrt{g^2 + \varepsilon^2}

    Parameters
    ----------
    gap : array (...)
        g [m], positive is an approach, negative an open gap; epsilon is `GAP_ROUNDING` [m]

    Returns
    -------
    tuple of array (...)
        p and p over its derivative [m], both > 0

    Source
    ------
    Derived here: the hyperbola with the asymptotes of max(g, 0).

    Valid
    -----
    p exceeds max(g, 0) by epsilon/2 at g = 0 and by epsilon^2/(4 |g|) far from it.
    """
    root = np.sqrt(gap * gap + GAP_ROUNDING**2)
    return np.maximum(gap, 0.0) + GAP_ROUNDING**2 / 2 / (root + np.abs(gap)), root


def palmgren(roller: Material, raceway: Material, length: float) -> LoadLaw:
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
    LoadLaw
        with Q spread evenly over l

    Source
    ------
    Palmgren, Ball and Roller Bearing Engineering (1959); Mao, Wang and Zhang (2016), Eq. (1).

    Valid
    -----
    Rollers about as long as thick on solid rings; an empirical law.
    """
    B = (roller.plane_compliance + raceway.plane_compliance) / np.pi
    return LoadLaw((length**0.8 / 3.81) ** EXPONENT / B / length)


def iso16281(length: float) -> LoadLaw:
    r"""Line contact of steel as the reference life standard takes it.

    .. math:: Q = 35948\, l^{8/9} \delta^{10/9} \quad \text{(N, mm, both raceways together)}

    Parameters
    ----------
    length : float
        l, effective length [m]

    Returns
    -------
    LoadLaw
        for one raceway: half of the approach belongs to it

    Source
    ------
    ISO/TS 16281 (2008), cylindrical rollers.

    Valid
    -----
    Steel on steel.
    """
    millimetre = 1e-3
    roller = 35948 * (length / millimetre) ** (8 / 9) * (2 / millimetre) ** EXPONENT
    return LoadLaw(roller / length)


def raceway_laws(bearing: CylindricalRollerBearing) -> tuple[LoadLaw, LoadLaw]:
    """Load laws [N/m over m^(10/9)] of the inner and the outer raceway that a bearing asks for.

    Source
    ------
    `iso16281`, `palmgren`.
    """
    length, roller = bearing.roller.length, bearing.roller.material
    if bearing.contact_law == "iso16281":
        return iso16281(length), iso16281(length)
    return palmgren(roller, bearing.inner_ring, length), palmgren(roller, bearing.outer_ring, length)
