"""Axial loads that a maker permits for cylindrical roller bearings with ribs on both rings."""

from typing import Any

import numpy as np

MM, KN, RPM = 1e-3, 1e3, 2 * np.pi / 60
WARM_SURFACE = 0.05  # [m2] of bore and outside: above it the heat of ribs has a formula of its own
OIL = 1.5, 0.15  # k_1, k_2 of oil; of grease 1 and 0.1


def rib_strength(outside_diameter: Any) -> Any:
    r"""Axial load that ribs withstand without damage if it acts all the time.

    .. math:: F_{ap} = 0.0023\, D^{1.7}

    in kN and mm; here F_ap [N] of the outside diameter D (...) [m]; `rib_strength_of_series_2` is lower.

    Source
    ------
    SKF, web catalogue, single row cylindrical roller bearings, dynamic axial load carrying capacity.

    Valid
    -----
    Its single row bearings, also full complement ones; twice as much for about a thousand revolutions, three
    times as much for occasional shocks.
    """
    return KN * 0.0023 * (np.asarray(outside_diameter, float) / MM) ** 1.7


def rib_strength_of_series_2(outside_diameter: Any) -> Any:
    r"""The same of series 2, whose ribs are lower.

    .. math:: F_{ap} = 0.0045\, D^{1.5}

    in kN and mm; here F_ap [N] of D (...) [m].

    Source
    ------
    SKF, as `rib_strength`.
    """
    return KN * 0.0045 * (np.asarray(outside_diameter, float) / MM) ** 1.5


def warm_rib_load(
    static_rating: Any, speed: Any, bore: Any, outside_diameter: Any, width: Any, radial_load: Any
) -> Any:
    r"""Axial load up to which the heat of ribs leaves a bearing at its usual temperature.

    .. math:: F_{ap} = \frac{k_1 C_0\, 10^4}{n (d + D)} - k_2 F_r,\quad k_1 = 1.5,\; k_2 = 0.15

    in kN, rpm and mm, with oil.

    Parameters
    ----------
    static_rating : array (...)
        C_0 [N]
    speed : array (...)
        n, one ring against the other [rad/s], its sense does not count
    bore, outside_diameter, width : array (...)
        d, D, B [m]; a smaller width than that of the rings widens the range by as much
    radial_load : array (...)
        F_r [N]

    Returns
    -------
    array (...)
        F_ap [N], not a number beyond its range; not below zero

    Source
    ------
    SKF, web catalogue: range and factors for oil; the equation as in its printed catalogues.

    Valid
    -----
    60 K above the surroundings, 0.5 mW/mm2 of heat through bore and outside, kappa of 2 or more, and
    pi B (d + D) up to 50 000 mm2.
    """
    both = np.asarray(bore, float) + np.asarray(outside_diameter, float)
    first, second = OIL
    with np.errstate(divide="ignore"):
        carried = first * np.asarray(static_rating, float) * 1e4 * RPM * MM / (np.abs(speed) * both)
    permitted = np.maximum(carried - second * np.asarray(radial_load, float), 0.0)
    return np.where(np.pi * np.asarray(width, float) * both <= WARM_SURFACE, permitted, np.nan)
