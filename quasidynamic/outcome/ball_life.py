"""Fatigue life of ball bearings under the loads of their balls."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from quasidynamic.outcome.ball_capacity import ball_raceway_capacity
from quasidynamic.outcome.raceway_damage import POINT, raceway_damage
from quasidynamic.parts.ball import BallRow


def ball_raceway_lives(
    loads: NDArray, row: BallRow, turning: tuple[float, float], rating: float | None = None
) -> NDArray:
    r"""Basic reference life of each raceway on its own.

    .. math:: L_{10,i} = (Q_{ci}/Q_{ei})^3,\quad Q_e = \Big(\frac1Z \sum_j Q_j^s\Big)^{1/s}

    with s = 3 of a ring that turns against the load and 10/3 of one that is at rest under it, for each row;
    a raceway of several rows survives where all of them do.

    Parameters
    ----------
    loads : array (2, R Z)
        normal loads at the inner and the outer race [N], >= 0, of R rows of Z balls one after the other
    row : BallRow
        for the capacities
    turning : tuple of float
        how far the inner and the outer ring turn against the load, 0 standing to 1, see `turning_share` [-]
    rating : float, optional
        C_r of one row [N]; that of ISO 281 if left out

    Returns
    -------
    array (2)
        of the inner and the outer raceway [10^6 revolutions]; infinite without load

    Source
    ------
    ISO/TS 16281 (2008), ball bearings.

    Valid
    -----
    As `ball_raceway_capacity`; reliability 90 %, no lubrication factor.
    """
    return _life(ball_row_damages(loads, row, turning, rating).sum(axis=-1))


def ball_reference_life(
    loads: NDArray, row: BallRow, turning: tuple[float, float], rating: float | None = None
) -> float:
    r"""Basic reference life L10r of both raceways, and of all rows together.

    .. math:: L_{10r} = \big\{\sum (Q_{ci}/Q_{ei})^{-10/3} + (Q_{ce}/Q_{ee})^{-10/3}\big\}^{-9/10}

    In 10^6 revolutions, infinite without load; arguments as of `ball_raceway_lives`.

    Source
    ------
    ISO/TS 16281 (2008), ball bearings.

    Valid
    -----
    As `ball_raceway_lives`.
    """
    return float(_life(ball_row_damages(loads, row, turning, rating).sum()))


def ball_row_damages(
    loads: NDArray, row: BallRow, turning: tuple[float, float], rating: float | None = None
) -> NDArray:
    """Damage (2, R) of the inner and the outer raceway of each row, the terms of `ball_reference_life`.

    In 10^6 revolutions to the power -10/9; arguments as of `ball_raceway_lives`.

    Source
    ------
    ISO/TS 16281 (2008), ball bearings.
    """
    rows = np.asarray(loads).reshape(2, -1, row.balls)
    sides = zip(rows, ball_raceway_capacity(row, rating), turning, strict=True)
    return np.array([
        raceway_damage(of_race[..., None], capacity, share, POINT) for of_race, capacity, share in sides
    ])  # fmt: skip


def _life(damage: Any) -> Any:
    with np.errstate(divide="ignore"):  # no load, no damage: for ever
        return damage ** (-1 / POINT.weibull)
