"""Elliptic contacts that the shoulder of a groove cuts off: what they carry, and how they push aside."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import ellipe, ellipkm1

# Fitted to `contact_pressure` on 64 x 128 cells whose border is the cut (`python -m
# benchmarks.truncated_contacts`). Rows by powers of 1 - u, columns by those of ln k.
FIT = np.array([[3.911, -0.924, -0.011], [-3.362, -0.456, 0.086]])
ERROR = 0.004  # of the load of the whole contact, with that of the grid
ROUNDEST = 1.02  # least k of the fit


class EnergyShare(NamedTuple):
    """Elastic energy of a cut contact over that of the whole one, same approach, and derivatives by c."""

    value: NDArray
    slope: NDArray
    curvature: NDArray

    def load(self, cut: NDArray) -> NDArray:
        """Load over that of the whole contact, phi = psi - c psi'/5 [-]."""
        return self.value - cut * self.slope / 5


def energy_share(cut: ArrayLike, ratio: ArrayLike) -> EnergyShare:
    r"""Elastic energy of a contact cut off across the rolling direction over that of the whole one.

    .. math:: \psi(c, k) = u^{5/2} \Big[1 + \tfrac52 v + \tfrac{35}{8} v^2 +
              v^3 \sum_{ij} A_{ij} v^i \ln^j k\Big],\quad v = 1 - u = \frac{1 - c}{1 - c_0},\quad
              c_0 = -\sqrt{\frac{m\,\mathcal K}{\mathcal K - \mathcal E}},\quad m = 1 - k^{-2}

    From c_0, where undeformed surfaces no longer overlap on this side of the cut, to one, where nothing is
    cut and two derivatives vanish. The energy at the approach delta is psi (2/5) K delta^(5/2); at a cut at
    the distance s, c = s/a(delta), its derivative by delta is the load, see `EnergyShare.load`, and that by s
    minus the moment of the pressure over the radius of relative curvature.

    Parameters
    ----------
    cut : array (...)
        c, distance s of the cut from the middle of the contact over its semi-axis a [-]; negative where the
        middle is cut off
    ratio : array (...)
        k, semi-axis across over that along the rolling direction [-]

    Returns
    -------
    EnergyShare
        psi and its derivatives by c [-]

    Source
    ------
    A fitted to half-spaces one of which ends, by energy, load and moment together; c_0 by Hertz.

    Valid
    -----
    k from 1.02 to 60: loads within `ERROR`, 0.012 at 200; rounder ones count as of 1.02. A shoulder as stiff
    as the middle; no contact of its edge.
    """
    cut, ratio = np.broadcast_arrays(np.asarray(cut, float), np.maximum(ratio, ROUNDEST))
    first, second, log = ellipkm1(ratio**-2.0), ellipe(1 - ratio**-2.0), np.log(ratio)
    span = 1 + np.sqrt((1 - ratio**-2.0) * first / (first - second))
    v = np.clip((1 - cut) / span, 0.0, 1.0)
    u = 1 - v
    cube, fourth = (sum(each * log**power for power, each in enumerate(row)) for row in FIT)
    inside = (1.0, 2.5, 4.375, cube, fourth)
    bracket = sum(each * v**power for power, each in enumerate(inside))
    steep = sum(power * each * v ** (power - 1) for power, each in enumerate(inside) if power)
    bent = sum(
        power * (power - 1) * each * v ** (power - 2) for power, each in enumerate(inside) if power > 1
    )
    slope = u**1.5 * (2.5 * bracket - u * steep) / span
    curvature = u**0.5 * (3.75 * bracket - 5 * u * steep + u**2 * bent) / span**2
    whole = v == 0.0  # to the last digit
    return EnergyShare(u**2.5 * bracket, np.where(whole, 0.0, slope), np.where(whole, 0.0, curvature))


def carried_share(cut: ArrayLike, ratio: ArrayLike) -> NDArray:
    """Load of a cut contact over that of the whole one, same approach [-]; arguments as of `energy_share`.

    More than the share of the pressure of Hertz on that side of the cut, 1/2 + 3 c/4 - c^3/4: what is left
    sinks in less.

    >>> round(float(carried_share(0.0, 7.0)), 2)
    0.67
    """
    return energy_share(cut, ratio).load(np.asarray(cut, float))
