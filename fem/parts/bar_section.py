"""Section of a bar of a squirrel cage: between two radii, with parallel sides."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray

from fem.parts.squirrel_cage import SquirrelCage

POINTS = 6  # of the Gauss rule along each side


@dataclass(frozen=True, kw_only=True)
class BarSection:
    """What beam theory needs of a section; n is the radius, t tangential from the middle of the bar."""

    area: float  # [m^2]
    centre: float  # n_0, radius of the centroid [m]
    inertia: NDArray  # (2,) integrals of (n - n_0)^2 and of t^2 [m^4]
    corners: NDArray  # (6, 2) places (n - n_0, t) where bending is largest [m]
    torsion_modulus: float  # torque over the largest shear stress that it makes [m^3]


@lru_cache(maxsize=8)  # cases side by side mostly have the same cage
def bar_section(cage: SquirrelCage) -> BarSection:
    r"""Section of the bars of a cage, without fillets.

    .. math:: W_T = \frac{a c^2}{3 + 1.8\,c/a}

    a >= c are the sides of a bar.

    Source
    ------
    Young, Roark's Formulas for Stress and Strain, torsion of rectangles: W_T within 4 %; integrals by the
    rule of Gauss.
    """
    t, n, weight = _points(cage)
    area = weight.sum()
    centre = float(n @ weight / area)
    side = cage.bar_width / 2 * np.array([-1.0, 0.0, 1.0])
    corners = np.stack([np.concatenate(_sides(cage, side)) - centre, np.tile(side, 2)], axis=1)
    short, long = sorted((cage.bar_width, cage.bar_thickness))
    return BarSection(
        area=float(area),
        centre=centre,
        inertia=np.array([(n - centre) ** 2 @ weight, t**2 @ weight]),
        corners=corners,
        torsion_modulus=long * short**2 / (3 + 1.8 * short / long),
    )


def _points(cage: SquirrelCage) -> tuple[NDArray, NDArray, NDArray]:
    """Gauss points t, n (points,) [m] of a bar at azimuth 0, tangential and radial, and weights [m^2]."""
    node, weight = leggauss(POINTS)
    t = cage.bar_width / 2 * node
    low, high = _sides(cage, t)
    half = (high - low) / 2
    n = (low + high)[:, None] / 2 + half[:, None] * node
    area = cage.bar_width / 2 * weight[:, None] * half[:, None] * weight
    return np.repeat(t, POINTS), n.ravel(), area.ravel()


def _sides(cage: SquirrelCage, t) -> tuple[NDArray, NDArray]:
    """Where a bar begins and ends radially [m], beside its middle by t [m]."""
    inner, outer = cage.bar_radii
    return np.sqrt(inner**2 - t**2), np.sqrt(outer**2 - t**2)
