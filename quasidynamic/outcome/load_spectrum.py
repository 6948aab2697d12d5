"""Life under a load spectrum: rows of a duty cycle, each with its share of time or of revolutions."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray


def revolution_shares(time: ArrayLike, speed: ArrayLike) -> NDArray:
    r"""Share of the revolutions that each row turns.

    .. math:: \varphi_i = t_i |n_i| / \sum_j t_j |n_j|

    Parameters
    ----------
    time : array (..., N)
        t, share of the time, or any measure of it [-], >= 0
    speed : array (..., N)
        n, of the inner ring against the outer one [rad/s]

    Returns
    -------
    array (..., N)
        phi [-], the sum is 1; 0 where nothing turns in any row

    Source
    ------
    Harris, Rolling Bearing Analysis, fatigue life with varying loads.

    Valid
    -----
    Speeds constant within a row.

    >>> revolution_shares([0.5, 0.5], [100.0, -300.0])
    array([0.25, 0.75])
    """
    turned = np.asarray(time, dtype=float) * np.abs(speed)
    total = turned.sum(axis=-1, keepdims=True)
    return turned / np.where(total > 0, total, 1.0)


def time_shares(revolutions: ArrayLike, speed: ArrayLike) -> NDArray:
    r"""Share of the time that each row takes.

    .. math:: t_i = (\varphi_i / |n_i|) / \sum_j (\varphi_j / |n_j|)

    t is (..., N) [-] and its sum 1; 0 of a row at standstill, whose time is not known: phi must be 0 where n
    is.

    Source
    ------
    The inverse of `revolution_shares`.

    Valid
    -----
    As `revolution_shares`.

    >>> time_shares([0.25, 0.75], [100.0, -300.0])
    array([0.5, 0.5])
    """
    turning = np.abs(speed)
    taken = np.where(turning > 0, revolutions, 0.0) / np.where(turning > 0, turning, 1.0)
    return taken / taken.sum(axis=-1, keepdims=True)


def mean_speed(time: ArrayLike, speed: ArrayLike) -> Any:
    r"""Mean speed in time, by which cumulated revolutions become hours.

    .. math:: n_m = \sum_i t_i |n_i|

    n_m [rad/s] of shares t of the time (..., N) whose sum is 1, and speeds n as of `revolution_shares`.

    Source
    ------
    Harris, Rolling Bearing Analysis, fatigue life with varying loads.

    Valid
    -----
    As `revolution_shares`.
    """
    return (np.asarray(time) * np.abs(speed)).sum(axis=-1)


def damage(revolutions: ArrayLike, lives: ArrayLike) -> NDArray:
    r"""Damage of each row in a revolution of the whole cycle, by the linear rule of Palmgren and Miner.

    .. math:: d_i = \varphi_i / L_i

    Parameters
    ----------
    revolutions : array (..., N)
        phi, share of the revolutions, whose sum is 1 [-], >= 0
    lives : array (..., N)
        L, life if the row lasted for ever [rev], > 0; infinite without load

    Returns
    -------
    array (..., N)
        d [1/rev]; the cumulated life is one over their sum, the damage share of a row d over their sum

    Source
    ------
    Palmgren (1924); Miner (1945), J. Appl. Mech. 12.

    Valid
    -----
    The order of the rows does not matter; lives with the same survival probability.
    """
    return np.asarray(revolutions) / np.asarray(lives)


def cumulated_life(revolutions: ArrayLike, lives: ArrayLike) -> Any:
    r"""Life under all rows, one after the other again and again.

    .. math:: L = 1 / \sum_i \varphi_i / L_i

    L [rev] of shares and lives as of `damage`; infinite where no row carries load.

    Source
    ------
    Palmgren (1924); Miner (1945), J. Appl. Mech. 12.

    Valid
    -----
    As `damage`.

    >>> float(cumulated_life([0.5, 0.5], [1e6, 3e6]))
    1500000.0
    """
    with np.errstate(divide="ignore"):  # no load, no damage
        return 1 / damage(revolutions, lives).sum(axis=-1)


def cumulated_life_error(revolutions: ArrayLike, lives: ArrayLike, errors: ArrayLike) -> Any:
    r"""Largest error of the cumulated life, to first order, where lives of rows may err to either side.

    .. math:: e = \sum_i d_i e_i / \sum_j d_j

    e (..., N) is the error of the life of each row over it, or any multiple such as percent, >= 0, and the
    result is in the same; it is not a number where no row does damage. Shares and lives [rev] as of `damage`.

    Source
    ------
    The derivative of `cumulated_life`.

    Valid
    -----
    Errors far below 1. Rows without damage may have any error.

    >>> round(float(cumulated_life_error([0.5, 0.5], [1e6, 3e6], [0.01, 0.02])), 6)
    0.0125
    """
    each = damage(revolutions, lives)
    with np.errstate(invalid="ignore"):  # no load, no damage
        return np.where(each > 0, each * errors, 0.0).sum(axis=-1) / each.sum(axis=-1)


def mean_load(revolutions: ArrayLike, loads: ArrayLike, exponent: ArrayLike) -> Any:
    r"""Constant load with the basic rating life of all rows together.

    .. math:: P_m = \left(\sum_i \varphi_i P_i^p\right)^{1/p}

    Parameters
    ----------
    revolutions : array (..., N)
        phi, share of the revolutions, whose sum is 1 [-], >= 0
    loads : array (..., N)
        P, equivalent load of each row [N], >= 0
    exponent : float or array (...)
        p of the rating life [-]

    Returns
    -------
    float or array (...)
        P_m [N]

    Source
    ------
    Harris, Rolling Bearing Analysis, fatigue life with varying loads.

    Valid
    -----
    As `damage`, with lives that go with P^-p.

    >>> round(float(mean_load([0.5, 0.5], [1000.0, 2000.0], 3.0)), 1)
    1651.0
    """
    shares, largest = np.asarray(revolutions), np.max(loads, axis=-1, keepdims=True)
    relative, power = np.asarray(loads) / np.where(largest > 0, largest, 1.0), np.asarray(exponent)
    return largest[..., 0] * (shares * relative ** power[..., None]).sum(axis=-1) ** (1 / power)
