"""Fatigue that loads do to a raceway in a revolution."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class ContactFatigue:
    """How life goes with load, and how lives of several places make one; of one kind of contact."""

    load_exponent: float  # p, of the damage that loads do at one place of a raceway [-]
    weibull: float  # e, dispersion exponent [-]
    capacity_by_length: float = 0.0  # power of the length with which the capacity of a slice goes [-]


LINE = ContactFatigue(load_exponent=4.0, weibull=9 / 8, capacity_by_length=7 / 9)
POINT = ContactFatigue(load_exponent=3.0, weibull=10 / 9)


def raceway_damage(
    loads: NDArray, capacity: Any, share: NDArray | float, fatigue: ContactFatigue = LINE, rows: int = 1
) -> Any:
    r"""Damage of a raceway that turns by a share under the loads of its rolling elements.

    .. math:: \sum_k \frac1Z \sum_j \Big[ (1 - s_t)\, q_{j,k}^p + \frac{s_t}{Z} \sum_i q_{i,k}^p \Big]^e
              \big/ q_c^{p e},\quad q_c = Q_c K^{-c}

    which is L^-e: the damages of raceways add up.

    Parameters
    ----------
    loads : array (..., Z, K)
        q of each of K slices [N], >= 0; one for balls; rows of Z one after the other
    capacity : float or array (...)
        Q_c of the whole raceway [N]
    share : float or array (...)
        s_t, how far the ring turns against the load, 0 standing to 1 [-]
    fatigue : ContactFatigue
        p, e, and c
    rows : int
        rows of rolling elements, all on raceways of their own, whose damages add up

    Returns
    -------
    float or array (...)
        damage [10^6 revolutions to the power -e]

    Source
    ------
    Lundberg and Palmgren (1947, 1952); ISO/TS 16281 (2008).

    Valid
    -----
    Fatigue from below the surface, full film.
    """
    if rows > 1:
        of_rows = np.split(loads, rows, axis=-2)
        return sum(raceway_damage(of_row, capacity, share, fatigue) for of_row in of_rows)
    damage = loads**fatigue.load_exponent
    even = np.asarray(share)[..., None, None]
    spread = (1 - even) * damage + even * damage.mean(axis=-2, keepdims=True)
    slice_capacity = capacity * loads.shape[-1] ** -fatigue.capacity_by_length
    by_slices = (spread**fatigue.weibull).mean(axis=-2).sum(axis=-1)
    return by_slices / slice_capacity ** (fatigue.load_exponent * fatigue.weibull)
