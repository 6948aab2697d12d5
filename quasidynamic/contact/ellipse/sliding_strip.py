"""Friction of a strip that slides along and turns under an elliptic pressure."""

from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.special import ellipe, ellipkm1

SERIES = 0.02  # parameter of the elliptic integrals below which their series is used
TERMS = 9  # of that series
SMALLEST = 1e-200  # stands for the square of a slip of zero: a kink of |v|, met by rounding alone


class SlidingStrip(NamedTuple):
    """Derivatives of the heat of a strip."""

    by_along: NDArray  # F_v
    by_across: NDArray  # F_s
    secant_along: NDArray  # F_v / v
    secant_across: NDArray  # F_s / s
    bend: NDArray  # F_vv / s^2 = F_ss / v^2


def sliding_strip(along: NDArray, across: NDArray) -> SlidingStrip:
    r"""Heat of a strip across which the slip grows from its middle.

    .. math:: F(v, s) = \int_{-1}^{1} \sqrt{1 - t^2} \sqrt{v^2 + s^2 t^2}\, dt
              = \tfrac{2}{3} \rho\, [\mathcal{B} + 2 (1-m) \mathcal{D}],\quad
              \rho^2 = v^2 + s^2,\quad m = s^2/\rho^2, \\
              F_v = 2 \frac{v}{\rho} \mathcal{D},\quad
              F_s = \frac{2 s}{3 \rho} (\mathcal{D} - \mathcal{U}),\quad
              F_{vv} = \frac{2 s^2}{\rho^3} \mathcal{U}

    with the complete elliptic integrals D = (K - E)/m, B = K - D and U = (D - B)/m of the parameter m.

    Parameters
    ----------
    along : array (...), of one dimension at least
        v, slip of the whole strip [m/s]
    across : array (...)
        s, slip at right angles at the end of the strip [m/s]

    Returns
    -------
    SlidingStrip
        [-], [-], [s/m], [s/m], [s3/m3]; at v = s = 0, where the heat has a kink, the first two are zero

    Source
    ------
    The integral over t = cos(theta); Jahnke, Emde and Loesch (1960), Tables of Higher Functions, ch. V, for B
    and D.

    >>> strip = sliding_strip(np.array([3.0]), np.array([0.0]))  # F = pi/2 |v|
    >>> round(float(strip.by_along[0]), 6), float(strip.by_across[0])
    (1.570796, 0.0)
    """
    square = np.maximum(along**2 + across**2, SMALLEST)
    size = np.sqrt(square)
    third, bend = _elliptic(across**2 / square, np.maximum(along**2 / square, SMALLEST))
    secant_along, secant_across = 2 * third / size, 2 * (third - bend) / (3 * size)
    return SlidingStrip(
        secant_along * along, secant_across * across, secant_along, secant_across, 2 * bend / (square * size)
    )


def _elliptic(m: NDArray, q: NDArray) -> tuple[NDArray, NDArray]:
    """D = (K - E)/m and U = (2 D - K)/m of the parameter m = 1 - q."""
    first = ellipkm1(q)
    safe = np.maximum(m, SERIES)
    third = (first - ellipe(m)) / safe
    bend = (2 * third - first) / safe
    small = m < SERIES
    if small.any():
        third[small], bend[small] = _SERIES @ np.vander(m[small], TERMS, increasing=True).T
    return third, bend


def _series() -> NDArray:
    """Coefficients (2, TERMS) of D and U in powers of m, from the integrals of sin^2n."""
    n = np.arange(1, TERMS + 3)
    wallis = pi / 2 * np.cumprod(np.concatenate([[1.0], (2 * n - 1) / (2 * n)]))
    binomial = wallis[: TERMS + 1] * 2 / pi
    third = binomial * wallis[1 : TERMS + 2]
    other = binomial * (wallis[: TERMS + 1] - wallis[1 : TERMS + 2])
    return np.stack([third[:TERMS], (third - other)[1:]])


_SERIES = _series()
