"""Load of an elliptic contact that the shoulder of a groove cuts off."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

CUTS = np.linspace(-1.0, 1.0, 11)
RATIOS = np.array([1.5, 2.5, 4.0, 7.0, 12.0, 20.0, 30.0])
ERROR = 0.006  # of the table: 0.001 of its digits and of the grid, the rest by interpolation
# By `contact_pressure` on 112 x 224 cells, where the cut is the border of the grid.
SHARES = np.array(
    [
        [0.130, 0.251, 0.384, 0.516, 0.642, 0.753, 0.847, 0.919, 0.968, 0.994, 1.0],
        [0.091, 0.206, 0.337, 0.473, 0.604, 0.724, 0.826, 0.907, 0.962, 0.992, 1.0],
        [0.065, 0.171, 0.299, 0.437, 0.572, 0.698, 0.807, 0.895, 0.957, 0.991, 1.0],
        [0.044, 0.139, 0.263, 0.400, 0.538, 0.670, 0.786, 0.881, 0.950, 0.989, 1.0],
        [0.030, 0.117, 0.235, 0.370, 0.511, 0.646, 0.768, 0.869, 0.944, 0.987, 1.0],
        [0.022, 0.101, 0.214, 0.348, 0.489, 0.627, 0.753, 0.859, 0.939, 0.986, 1.0],
        [0.017, 0.091, 0.201, 0.333, 0.475, 0.614, 0.743, 0.852, 0.935, 0.985, 1.0],
    ]
)


def carried_share(cut: ArrayLike, ratio: ArrayLike) -> NDArray:
    r"""Load of a contact cut off across the rolling direction over that of the whole one, same approach.

    .. math:: \varphi(c, k) = \frac{Q(\delta, c)}{K \delta^{3/2}},\quad c = \frac{s}{a(\delta)},\quad
              k = \frac ab

    More than the share of the pressure of Hertz on that side of the cut, 1/2 + 3 c/4 - c^3/4: what is left
    sinks in less.

    Parameters
    ----------
    cut : array (...)
        c, distance s of the cut from the middle of the contact over its semi-axis a [-]; negative where the
        middle is cut off
    ratio : array (...)
        k, semi-axis across over that along the rolling direction [-]

    Returns
    -------
    array (...)
        phi [-], one where nothing is cut; not a number outside the table, of c below -1, k not in 1.5 to 30

    Source
    ------
    Table by `contact_pressure` of half-spaces, one of which ends; linear in c and in ln k between.

    Valid
    -----
    Within `ERROR`. A shoulder as stiff as the middle; no contact of its edge.

    >>> float(carried_share(0.0, 7.0))
    0.67
    """
    cut, ratio = np.broadcast_arrays(np.asarray(cut, float), np.asarray(ratio, float))
    at = np.interp(np.log(ratio), np.log(RATIOS), np.arange(len(RATIOS)))
    low = np.minimum(at.astype(int), len(RATIOS) - 2)
    column = np.interp(cut, CUTS, np.arange(len(CUTS)))
    left = np.minimum(column.astype(int), len(CUTS) - 2)
    part, along = at - low, column - left
    rows = [SHARES[low + k, left] * (1 - along) + SHARES[low + k, left + 1] * along for k in (0, 1)]
    share = (1 - part) * rows[0] + part * rows[1]
    inside = (cut >= CUTS[0]) & (ratio >= RATIOS[0]) & (ratio <= RATIOS[-1])
    return np.where(cut >= 1.0, 1.0, np.where(inside, share, np.nan))
