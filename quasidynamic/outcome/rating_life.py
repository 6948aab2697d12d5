"""Life and safety as a catalogue has them: from ratings and one load."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

ROLLER_EXPONENT = 10 / 3  # p of ISO 281 for roller bearings, between 3 and 4
LINE_EXPONENT = 4.0  # of line contact at both raceways
BALL_EXPONENT = 3.0  # of point contact
# [Pa] a lasting dent of 1e-4 of the rolling element's diameter, over which static ratings are defined
ROLLERS, BALLS, SELF_ALIGNING_BALLS = 4.0e9, 4.2e9, 4.6e9
LINE, POINT = 2.0, 3.0  # pressure to this power goes with the load


@dataclass(frozen=True)
class EquivalentLoad:
    """P = X F_r + Y F_a with what it is made of."""

    value: float  # [N]
    radial_factor: float  # [-] X
    axial_factor: float  # [-] Y
    limit: float | None = None  # [-] e, F_a/F_r up to which the axial load does not count; None at rest
    note: str = ""  # where an end of the table was held


def rating_life(rating: ArrayLike, load: ArrayLike, exponent: ArrayLike = ROLLER_EXPONENT) -> Any:
    r"""Basic rating life.

    .. math:: L_{10} = (C_r / P_r)^p

    Parameters
    ----------
    rating : float or array (...)
        C_r, dynamic load rating [N]
    load : float or array (...)
        P_r, equivalent radial load [N], >= 0
    exponent : float or array (...)
        p [-]

    Returns
    -------
    float or array (...)
        L10 [10^6 revolutions]; infinite without load

    Source
    ------
    ISO 281 (2007).

    Valid
    -----
    Ordinary clearance, aligned rings that stay round, loads up to about C_r / 2, no skidding.
    """
    with np.errstate(divide="ignore"):
        return (np.asarray(rating) / np.asarray(load, dtype=float))[()] ** np.asarray(exponent)


def required_rating(load: ArrayLike, life: ArrayLike, exponent: ArrayLike = ROLLER_EXPONENT) -> Any:
    """Dynamic load rating that a basic rating life requires.

    .. math:: C_r = P_r L_{10}^{1/p}

    C_r [N] of an equivalent radial load P_r [N] and a life L10 [10^6 revolutions], both >= 0.

    Source
    ------
    The inverse of `rating_life`.

    Valid
    -----
    As `rating_life`.

    >>> round(float(required_rating(1000.0, 8.0, 3.0)), 9)
    2000.0
    """
    return np.asarray(load) * np.asarray(life) ** (1 / np.asarray(exponent))


def static_safety(rating: ArrayLike, load: ArrayLike) -> Any:
    r"""Static safety factor.

    .. math:: s_0 = C_{0r} / P_{0r}

    Parameters
    ----------
    rating : float or array (...)
        C_0r, static load rating [N]
    load : float or array (...)
        P_0r, equivalent static load [N], >= 0

    Returns
    -------
    float or array (...)
        s_0 [-]; infinite without load

    Source
    ------
    ISO 76 (2006).

    Valid
    -----
    As the rating: permanent deformation of 1e-4 of the rolling element at s_0 = 1.
    """
    with np.errstate(divide="ignore"):
        return (np.asarray(rating) / np.asarray(load, dtype=float))[()]


def effective_static_safety(
    rating: ArrayLike, load: ArrayLike, elements: ArrayLike, contact_angle: float = 0.0, rows: int = 1
) -> Any:
    r"""Static safety from the largest load of a rolling element.

    .. math:: S_{0,eff} = \frac{Q_0}{Q_{max}},\quad Q_0 = \frac{5\, C_{0r}}{i Z \cos\alpha},\quad
              Q_0 = \frac{C_{0a}}{Z} \;(\alpha = 90°)

    Parameters
    ----------
    rating : float or array (...)
        C_0r, static load rating of i rows, or C_0a [N]
    load : float or array (...)
        Q_max, largest contact load [N], >= 0; of rollers that of n_s slices as loaded as the most loaded one
    elements : int or array (...)
        Z, rolling elements of a row
    contact_angle : float
        alpha of the design [rad]
    rows : int
        i

    Returns
    -------
    float or array (...)
        S_0,eff [-]; infinite without load

    Source
    ------
    Of rollers Formulas 5 to 7 of ISO 17956 (2025) as a public program states them (CHOICHOI-KIMM/AI_Seminar,
    CRB-main/Manual/13_StaticLoadRating.md), not checked against its text; of balls the same with one contact.
    The 5 is the share of the most loaded element in ISO 76; between washers all are loaded alike.

    Valid
    -----
    As the rating, for any distribution of the load.

    >>> float(effective_static_safety(12e3, 3e3, 10))
    2.0
    """
    with np.errstate(divide="ignore"):
        share = 1.0 if contact_angle == np.pi / 2 else 5 / (rows * np.cos(contact_angle))
        allowed = share * np.asarray(rating) / np.asarray(elements)
        return (allowed / np.asarray(load, dtype=float))[()]


def pressure_safety(pressure: ArrayLike, limit: float, exponent: float) -> Any:
    r"""Static safety of a contact: load over that of the static rating's pressure, by the pressure alone.

    .. math:: s_p = (p_{lim}/p_{max})^n

    with n = 2 of line and 3 of point contact, so that it falls with the load of the contact as s_0 does with
    that of the bearing.

    Parameters
    ----------
    pressure : float or array (...)
        p_max [Pa], >= 0
    limit : float
        p_lim [Pa]: `ROLLERS`, `BALLS` or `SELF_ALIGNING_BALLS`
    exponent : float
        n [-]: `LINE` or `POINT`

    Returns
    -------
    float or array (...)
        s_p [-]; infinite without pressure

    Source
    ------
    ISO 76 (2006) for the pressures of 4000 MPa (rollers), 4200 MPa (balls), 4600 MPa (self-aligning balls);
    Hertz for the exponents.

    Valid
    -----
    Hardened bearing steel, elastic contact: above the limit the pressure itself is overstated. At the end of
    a roller it is the safety of that place, not of the load of the roller.
    """
    with np.errstate(divide="ignore"):
        return ((limit / np.asarray(pressure, dtype=float)) ** exponent)[()]
