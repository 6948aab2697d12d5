"""Fatigue life under the loads of the rollers."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import OutOfRange, require_positive
from quasidynamic.outcome.capacity import raceway_capacity, reference_raceway_capacity
from quasidynamic.parts.roller import Straight
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing

WEIBULL = 9 / 8  # dispersion exponent of line contact
TURNING, STANDING = 4.0, 4.5  # load exponents of a ring against the load
FEWEST_SLICES = 30  # of ISO/TS 16281


@dataclass(frozen=True, kw_only=True)
class RollerBody:
    """Fatigue of the rollers themselves, next to that of the raceways."""

    capacity: tuple[float, float]  # [N] inner and outer contact, for 10^6 turns of the roller
    speed_ratio: float  # [-] turns of the roller against the cage per turn of the ring; see `slice_life`

    def __post_init__(self):
        for side, capacity in zip(("inner", "outer"), self.capacity, strict=True):
            require_positive(f"roller body capacity, {side}", capacity)
        require_positive("roller body speed_ratio", self.speed_ratio)


def basic_life(
    inner: NDArray, outer: NDArray, bearing: CylindricalRollerBearing, turning: tuple[bool, bool]
) -> Any:  # a float for one load case, an array for many
    r"""Basic life of the raceways from the loads of the slices, with capacities of the 552 form.

    `slice_life` with `raceway_capacity`, no edge stress and no fatigue of the rollers.

    Parameters
    ----------
    inner, outer : array (..., Z, K)
        load of each slice [N], >= 0
    bearing : CylindricalRollerBearing
        for the capacities
    turning : tuple of bool
        whether the inner and the outer ring turn against the load

    Returns
    -------
    float or array (...)
        L10 [10^6 revolutions]; infinite without load

    Source
    ------
    Lundberg and Palmgren (1952); ISO/TS 16281 (2008), without its edge stress factor.

    Valid
    -----
    Raceway fatigue from below the surface, reliability 90 %, no lubrication factor.
    """
    return slice_life(inner, outer, raceway_capacity(bearing), turning)


def reference_life(
    inner: NDArray,
    outer: NDArray,
    bearing: CylindricalRollerBearing,
    turning: tuple[bool, bool],
    *,
    edge_stress: bool = False,
    rating: float | None = None,
) -> Any:
    r"""Basic reference life L10r with the capacities of ISO/TS 16281.

    Parameters
    ----------
    inner, outer : array (..., Z, K)
        load of each slice, over the whole length of the roller [N], >= 0
    bearing : CylindricalRollerBearing
        for the capacities and the profile
    turning : tuple of bool
        whether the inner and the outer ring turn against the load
    edge_stress : bool
        multiply the slices by `edge_stress_factor`
    rating : float, optional
        C_r [N]; that of ISO 281 if left out

    Returns
    -------
    float or array (...)
        L10r [10^6 revolutions]; infinite without load

    Raises
    ------
    OutOfRange
        when the edge stress is asked of straight rollers, whose end slices do not contain the edge

    Source
    ------
    ISO/TS 16281 (2008), roller bearings.

    Valid
    -----
    Reliability 90 %. The edge stress belongs to profiled rollers with at least 30 slices.
    """
    if edge_stress and isinstance(bearing.roller.profile, Straight):
        raise OutOfRange("the edge stress factor holds for profiled rollers; this roller is straight")
    edge = edge_stress_factor(np.shape(inner)[-1]) if edge_stress else None
    return slice_life(inner, outer, reference_raceway_capacity(bearing, rating), turning, edge=edge)


def slice_life(
    inner: NDArray,
    outer: NDArray,
    capacity: tuple[float, float],
    turning: tuple[bool, bool],
    *,
    edge: NDArray | None = None,
    rollers: RollerBody | None = None,
) -> Any:
    r"""Life that both raceways, and if wanted all rollers, survive with 90 % probability.

    .. math:: L_{10} = \Big\{ \sum_k (q_{ei,k}/q_{ci})^{4.5} + (q_{eo,k}/q_{co})^{4.5}
              + Z s^{9/8} [(q_{ri,k}/q_{cri})^{4.5} + (q_{ro,k}/q_{cro})^{4.5}] \Big\}^{-8/9},

    .. math:: q_e = \Big( \frac1Z \sum_j (f_k q_{j,k})^p \Big)^{1/p},\; q_c = Q_c K^{-7/9}

    with p = 4 for a ring that turns against the load and 4.5 for one that stands still under it. A
    roller meets all loads of the circle in turn (p = 4), lives (q_cr/q_r)^4 of its own turns, s of
    them in a turn of the ring, (1 - gamma^2)/(2 gamma) where it rolls, and all Z rollers must survive.

    Parameters
    ----------
    inner, outer : array (..., Z, K)
        load of each slice [N], >= 0
    capacity : tuple of float
        Q_c of the inner and outer raceway [N]
    turning : tuple of bool
        whether the inner and the outer ring turn against the load
    edge : array (K), optional
        f_k, edge stress factor [-]; 1 if left out
    rollers : RollerBody, optional
        capacity Q_cr and speed ratio s; only the raceways fail if left out

    Returns
    -------
    float or array (...)
        L10 [10^6 revolutions of the ring]; infinite without load

    Source
    ------
    Lundberg and Palmgren (1952); ISO/TS 16281 (2008). The term of the rollers: the same theory in
    Harris, Rolling Bearing Analysis; its sum over rollers is derived here.

    Valid
    -----
    Fatigue from below the surface, full film, equal slices over the whole length of the roller.
    """
    loads = [np.asarray(side) * (1.0 if edge is None else edge) for side in (inner, outer)]
    exponents = [TURNING if turns else STANDING for turns in turning]
    damage = sum(_damage(q, c, p) for q, c, p in zip(loads, capacity, exponents, strict=True))
    if rollers:
        roller_damage = sum(_damage(q, c, TURNING) for q, c in zip(loads, rollers.capacity, strict=True))
        damage = damage + loads[0].shape[-2] * rollers.speed_ratio**WEIBULL * roller_damage
    with np.errstate(divide="ignore"):  # no load, no damage: for ever
        return damage ** (-1 / WEIBULL)


def edge_stress_factor(slices: int) -> NDArray:
    r"""Rise of the load of a slice that stands for the stress at the end of the roller.

    .. math:: f_k = 1 - 0.01 / \ln \big( 1.985\, |2k - n_s - 1| / (2 n_s - 2) \big),\quad k = 1 \dots n_s

    Parameters
    ----------
    slices : int
        n_s, number of slices over the whole length [-], >= 30

    Returns
    -------
    array (n_s)
        f [-], 1 in the middle

    Raises
    ------
    OutOfRange
        for fewer than 30 slices

    Source
    ------
    ISO/TS 16281 (2008), approximation of the stress riser.

    Valid
    -----
    Rollers with the logarithmic profile 0.00035 D ln 1/(1 - (2x/l)^2) or one like it, misalignment below
    4 minutes of arc, medium load.
    """
    if slices < FEWEST_SLICES:
        raise OutOfRange(f"{slices} slices; the edge stress factor needs at least {FEWEST_SLICES}")
    k = np.arange(1, slices + 1)
    with np.errstate(divide="ignore"):  # ln 0 in the middle slice of an odd number: f = 1
        return 1 - 0.01 / np.log(1.985 * np.abs(2 * k - slices - 1) / (2 * slices - 2))


def reference_load(life: Any, rating: float) -> Any:
    r"""Radial load that gives the bearing the same life under ordinary conditions.

    .. math:: P_{ref} = C_r / L_{10r}^{3/10}

    Parameters
    ----------
    life : float or array (...)
        L10r [10^6 revolutions], > 0
    rating : float
        C_r, dynamic load rating [N]

    Returns
    -------
    float or array (...)
        P_ref [N]; zero for an endless life

    Source
    ------
    ISO/TS 16281 (2008), roller bearings.

    Valid
    -----
    As the life it comes from.
    """
    return rating * np.asarray(life) ** (-3 / 10)


def _damage(loads: NDArray, capacity: float, p: float) -> Any:
    """Sum over slices of (q_e/q_c)^4.5, with q_e the mean of power p over the rollers."""
    equivalent = np.mean(loads**p, axis=-2) ** (1 / p)
    slice_capacity = capacity * loads.shape[-1] ** (-7 / 9)
    return np.sum((equivalent / slice_capacity) ** (4 * WEIBULL), axis=-1)
