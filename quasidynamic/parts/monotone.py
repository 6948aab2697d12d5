"""Curves through points that are monotone where the points are."""

import numpy as np
from numpy.typing import NDArray


def monotone_slopes(places: NDArray, values: NDArray) -> NDArray:
    r"""Slopes at points, for a piecewise cubic that does not overshoot them.

    .. math:: d_i = \frac{w_1 + w_2}{w_1/\delta_{i-1} + w_2/\delta_i},\quad
              w_1 = 2h_i + h_{i-1},\; w_2 = h_i + 2h_{i-1}

    with widths h and secants delta, and zero where the secants differ in sign. At both ends the parabola
    through three points, limited to three times the secant.

    Places (n), n >= 2, grow; slopes are value over place.

    Source
    ------
    Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984), 300-304; ends as in Fritsch and Carlson's PCHIM.
    """
    widths, secants = np.diff(places), np.diff(values) / np.diff(places)
    if len(secants) == 1:
        return np.repeat(secants, 2)
    before, after = secants[:-1], secants[1:]
    first, second = 2 * widths[1:] + widths[:-1], widths[1:] + 2 * widths[:-1]
    slopes, alike = np.zeros(len(places)), before * after > 0
    with np.errstate(divide="ignore", invalid="ignore"):
        means = (first + second) / (first / before + second / after)
    slopes[1:-1][alike] = means[alike]
    slopes[0] = _end_slope(*widths[:2], *secants[:2])
    slopes[-1] = _end_slope(*widths[:-3:-1], *secants[:-3:-1])
    return slopes


def _end_slope(width: float, next_width: float, secant: float, next_secant: float) -> float:
    """Slope at an end, next to the first secant."""
    slope = ((2 * width + next_width) * secant - width * next_secant) / (width + next_width)
    if slope * secant <= 0:
        return 0.0
    if secant * next_secant <= 0 and abs(slope) > 3 * abs(secant):
        return 3 * secant
    return slope


def piecewise_cubic(places: NDArray, values: NDArray, slopes: NDArray, at: NDArray) -> NDArray:
    r"""Cubic of Hermite between points with slopes.

    .. math:: f = v_i + t h [d_i + t (3\delta - 2 d_i - d_{i+1} + t (d_i + d_{i+1} - 2\delta))]

    Places x (n) grow, values v and slopes d are there; t = (at - x_i)/h with h = x_{i+1} - x_i, delta =
    (v_{i+1} - v_i)/h, and `at` (...) is within the places.

    Source
    ------
    Hermite's interpolation of third degree.
    """
    i = np.clip(np.searchsorted(places, at, side="right") - 1, 0, len(places) - 2)
    width = places[i + 1] - places[i]
    t, secant = (at - places[i]) / width, (values[i + 1] - values[i]) / width
    left, right = slopes[i], slopes[i + 1]
    curved = 3 * secant - 2 * left - right + t * (left + right - 2 * secant)
    return values[i] + t * width * (left + t * curved)
