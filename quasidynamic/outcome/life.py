"""Fatigue life under the loads of the rollers."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import OutOfRange, require_positive
from quasidynamic.outcome.capacity import raceway_capacity, reference_raceway_capacity
from quasidynamic.outcome.raceway_damage import LINE, raceway_damage
from quasidynamic.outcome.rating_life import ROLLER_EXPONENT
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing

REVOLUTIONS = 1e6  # that a rating life counts in
FEWEST_SLICES = 30  # of ISO/TS 16281
OUTER_LOAD = 1.038  # [-] q_ee over q_ei under a radial load without clearance

Turning = tuple[NDArray | float, NDArray | float]


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
    inner: NDArray, outer: NDArray, bearing: CylindricalRollerBearing, turning: Turning
) -> Any:  # a float for one load case, an array for many
    """Basic life of the raceways from the loads of the slices, with capacities of the 552 form.

    `slice_life` with `raceway_capacity`, no edge stress and no fatigue of the rollers.

    L10 [10^6 revolutions], infinite without load; loads (..., Z, K) [N] and `turning` as of `slice_life`.

    Source
    ------
    Lundberg and Palmgren (1952); ISO/TS 16281 (2008), without its edge stress factor.

    Valid
    -----
    Raceway fatigue from below the surface, reliability 90 %, no lubrication factor.
    """
    inner_capacity, outer_capacity = raceway_capacity(bearing)
    capacity = _of_cases(inner_capacity), _of_cases(outer_capacity)
    return slice_life(inner, outer, capacity, turning, rows=bearing.row_count)


def raceway_lives(
    inner: NDArray, outer: NDArray, bearing: CylindricalRollerBearing, turning: Turning
) -> NDArray:
    r"""Basic life of each raceway on its own.

    .. math:: L_{10,r} = \Big\{ \sum_k (q_{er,k}/q_{cr})^{4.5} \Big\}^{-8/9}

    the terms of `slice_life`, with :math:`L_{10}^{-9/8} = L_{10,i}^{-9/8} + L_{10,o}^{-9/8}`.

    An array (..., 2) [10^6 revolutions of the ring], inner and outer raceway; infinite without load.
    Arguments as of `basic_life`.

    Source
    ------
    Lundberg and Palmgren (1952); ISO/TS 16281 (2008).

    Valid
    -----
    As `basic_life`.
    """
    sides = zip((inner, outer), raceway_capacity(bearing), turning, strict=True)
    damage = [
        raceway_damage(np.asarray(load), _of_cases(capacity), share, rows=bearing.row_count)
        for load, capacity, share in sides
    ]
    with np.errstate(divide="ignore"):  # no load, no damage: for ever
        return np.stack(damage, axis=-1) ** (-1 / LINE.weibull)


def reference_life(
    inner: NDArray,
    outer: NDArray,
    bearing: CylindricalRollerBearing,
    turning: Turning,
    *,
    edge_stress: bool = False,
    rating: float | None = None,
) -> Any:
    """Basic reference life L10r with the capacities of ISO/TS 16281.

    L10r [10^6 revolutions], infinite without load; slices are over the whole length of the roller, loads
    (..., Z, K) [N] and `turning` as of `slice_life`. With `edge_stress` slices are multiplied by
    `edge_stress_factor`; the rating C_r [N] is by default that of ISO 281.
    Raises `OutOfRange` for the edge stress of straight rollers, whose end slices do not contain the edge.

    Source
    ------
    ISO/TS 16281 (2008), roller bearings.

    Valid
    -----
    Reliability 90 %. The edge stress belongs to profiled rollers with at least 30 slices.
    """
    if edge_stress and not bearing.relieved:
        raise OutOfRange("the edge stress factor holds for profiled rollers; this roller is straight")
    edge = edge_stress_factor(np.shape(inner)[-1]) if edge_stress else 1.0
    capacity = reference_raceway_capacity(bearing, rating)
    return slice_life(edge * inner, edge * outer, capacity, turning, rows=bearing.row_count)


def slice_life(
    inner: NDArray,
    outer: NDArray,
    capacity: tuple[float, float],
    turning: Turning,
    *,
    rollers: RollerBody | None = None,
    rows: int = 1,
) -> Any:
    r"""Life that both raceways, and if wanted all rollers, survive with 90 % probability.

    .. math:: L_{10} = \Big\{ \sum_k (q_{ei,k}/q_{ci})^{4.5} + (q_{eo,k}/q_{co})^{4.5}
              + Z s^{9/8} [(q_{ri,k}/q_{cri})^{4.5} + (q_{ro,k}/q_{cro})^{4.5}] \Big\}^{-8/9},

    .. math:: q_e = \Big( \frac1Z \sum_j \big[ (1 - s_t) (f_k q_{j,k})^4
              + \frac{s_t}{Z} \sum_i (f_k q_{i,k})^4 \big]^{9/8} \Big)^{1/4.5},\; q_c = Q_c K^{-7/9}

    with the share s_t of the damage that turning spreads evenly around the ring: the mean of power 4 of a
    ring that turns against the load, s_t = 1, and of power 4.5 of one that is at rest under it, s_t = 0.
    A roller meets all loads of the circle one after the other, lives (q_cr/q_r)^4 of its own turns, s of
    them in a turn of the ring, (1 - gamma^2)/(2 gamma) where it rolls, and all Z rollers must survive.

    Parameters
    ----------
    inner, outer : array (..., Z, K)
        load of each slice [N], >= 0, times its `edge_stress_factor` f_k if wanted
    capacity : tuple of float
        Q_c of the inner and outer raceway [N]
    turning : pair of float or of array (...)
        how far the inner and the outer ring turn against the load, 0 standing to 1, see `turning_share` [-]
    rollers : RollerBody, optional
        capacity Q_cr and speed ratio s; only the raceways fail if left out
    rows : int
        rows of Z rollers, one after the other in the loads; the terms of all of them are summed

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
    loads = [np.asarray(side) for side in (inner, outer)]
    sides = zip(loads, capacity, turning, strict=True)
    damage = sum(raceway_damage(q, c, share, rows=rows) for q, c, share in sides)
    if rollers:
        sides = zip(loads, rollers.capacity, strict=True)
        roller_damage = sum(raceway_damage(q, c, 1.0, rows=rows) for q, c in sides)
        damage = damage + loads[0].shape[-2] // rows * rollers.speed_ratio**LINE.weibull * roller_damage
    with np.errstate(divide="ignore"):  # no load, no damage: for ever
        return damage ** (-1 / LINE.weibull)


def slice_damages(
    inner: NDArray, outer: NDArray, capacity: tuple[float, float], turning: Turning, rows: int = 1
) -> NDArray:
    """Damage (2, R, K) of each of K slices of R rows at both raceways, whose sum is that of `slice_life`.

    In 10^6 revolutions to the power -9/8; arguments as of `slice_life`, here of one bearing.

    Source
    ------
    Lundberg and Palmgren (1952); ISO/TS 16281 (2008).

    Valid
    -----
    As `slice_life`.
    """
    damages = []
    for loads, of_raceway, share in zip((inner, outer), capacity, turning, strict=True):
        slices = loads.shape[-1]
        each = np.swapaxes(loads.reshape(rows, -1, slices), 1, 2)[..., None]  # each a raceway of its own
        damages.append(raceway_damage(each, of_raceway * slices**-LINE.capacity_by_length, share))
    return np.array(damages)


def slice_reference_loads(
    damages: NDArray, capacity: tuple[float, float], rollers: int, contact_angle: float = 0.0
) -> NDArray:
    r"""Equivalent load of each slice, for its own a_ISO.

    .. math:: P_{sk} = 0.323\, i Z \cos\alpha\, n_s \Big\{ \frac{q_{ei,k}^{9/2} + (1.038\,
              q_{ee,k}\, q_{ci}/q_{ce})^{9/2}}{1 + (1.038\, q_{ci}/q_{ce})^{9/2}} \Big\}^{2/9},\quad
              q_{e,k}^{9/2} = q_c^{9/2} d_k

    Parameters
    ----------
    damages : array (2, i, n_s)
        d_k of the slices of i rows at both raceways, see `slice_damages`
    capacity : tuple of float
        Q_c of the inner and outer raceway [N], with q_c = Q_c n_s^(-7/9)
    rollers : int
        Z of a row
    contact_angle : float
        alpha [rad]

    Returns
    -------
    array (i, n_s)
        P_sk [N], to be compared with the fatigue load limit of all rows

    Source
    ------
    Formula 31 of ISO 16281 (2025) as a public program states it (CHOICHOI-KIMM/AI_Seminar, manual of its
    tapered roller bearings); the text of the standard was not available. The factor i of rows: assumed.

    Valid
    -----
    As `slice_life`.
    """
    (inner, outer), (of_inner, of_outer) = damages, capacity
    together = (inner + OUTER_LOAD**4.5 * outer) / (1 + (OUTER_LOAD * of_inner / of_outer) ** 4.5)
    rows, slices = inner.shape
    whole = of_inner * slices ** (1 - LINE.capacity_by_length)  # n_s q_ci
    return 0.323 * rows * rollers * np.cos(contact_angle) * whole * together ** (2 / 9)


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


def reference_load(life: Any, rating: float, exponent: float = ROLLER_EXPONENT) -> Any:
    r"""Radial load that gives the bearing the same life under ordinary conditions.

    .. math:: P_{ref} = C_r / L_{10r}^{1/p}

    Parameters
    ----------
    life : float or array (...)
        L10r [10^6 revolutions], > 0
    rating : float
        C_r, dynamic load rating [N]
    exponent : float
        p [-], 10/3 of roller and 3 of ball bearings

    Returns
    -------
    float or array (...)
        P_ref [N]; zero for an endless life

    Source
    ------
    ISO/TS 16281 (2008).

    Valid
    -----
    As the life it comes from.
    """
    return rating * np.asarray(life) ** (-1 / exponent)


def turning_share(speed: Any, relative_speed: Any) -> Any:
    r"""Share of the damage that a ring's own turning spreads evenly around it.

    .. math:: s_t = \frac{x^2}{1 + x^2},\quad x = 10^6 \left| \frac{\omega}{\omega_i - \omega_o} \right|

    A ring that turns x times while the rings turn a million times against each other meets the load with
    one place of its raceway (x = 0) or with all of them in order: nothing jumps where it begins to move.

    Parameters
    ----------
    speed : float or array (...)
        omega of the ring against the load [rad/s]
    relative_speed : float or array (...)
        omega_i - omega_o [rad/s], not zero

    Returns
    -------
    float or array (...)
        s_t [-], 0 for a ring that is at rest, 0.5 for one turn, 1 - 1e-6 for a thousand turns

    Source
    ------
    Assumed; only the ends are those of ISO/TS 16281 (2008).

    Valid
    -----
    Lives of about a million revolutions: during a longer one a creeping ring turns further, and lives longer.
    """
    turns = REVOLUTIONS * speed / relative_speed
    return turns**2 / (1 + turns**2)


def _of_cases(number: Any) -> Any:
    """Numbers (C) of bearings that differ, from a column (C, 1); that of all of them as it is."""
    return number[:, 0] if np.ndim(number) else number
