"""Speeds of cage and rollers when nothing slips."""

from typing import Any


def rolling_cage_speed(inner: Any, outer: Any, ratio: float) -> Any:
    r"""Cage speed of a radial bearing in pure rolling.

    .. math:: \omega_c = \omega_i (1 - \gamma)/2 + \omega_o (1 + \gamma)/2

    Parameters
    ----------
    inner, outer : float or array (...)
        ring speeds [rad/s], positive towards growing azimuth
    ratio : float
        gamma, roller over pitch diameter [-]

    Returns
    -------
    float or array (...)
        cage speed [rad/s]

    Source
    ------
    Harris and Kotzalas, Essential Concepts of Bearing Technology (2006), ch. 10.

    >>> round(rolling_cage_speed(38000.0, 0.0, 5 / 70), 4)
    17642.8571
    """
    return inner * (1 - ratio) / 2 + outer * (1 + ratio) / 2


def rolling_roller_speed(inner: Any, outer: Any, ratio: float) -> Any:
    r"""Spin of a roller relative to the cage in pure rolling.

    .. math:: \omega_r = (\omega_i - \omega_o) (1 - \gamma^2) / (2 \gamma)

    Parameters
    ----------
    inner, outer : float or array (...)
        ring speeds [rad/s]
    ratio : float
        gamma, roller over pitch diameter [-]

    Returns
    -------
    float or array (...)
        roller speed [rad/s], positive when it rolls forwards on the inner ring

    Source
    ------
    Harris and Kotzalas, Essential Concepts of Bearing Technology (2006), ch. 10.
    """
    return (inner - outer) * (1 - ratio**2) / (2 * ratio)
