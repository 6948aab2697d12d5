"""Load ratings of the bearing and its contacts."""

from typing import Protocol

import numpy as np

from quasidynamic.errors import OutOfRange
from quasidynamic.parts.roller_bearing import Roller

MILLIMETRE = 1e-3  # [m] the printed forms are in N and mm
MATERIAL_FACTOR = 1.1  # b_m of modern cylindrical roller bearings
STRESS_REDUCTION = 0.83  # lambda nu of ISO 281, edge stress and uneven load along the roller
TABULATED = (0.01, 0.30)  # gamma, the range of the f_c table of ISO 281


class RatedRollers(Protocol):
    """What load ratings know of rows of rollers."""

    @property
    def rollers(self) -> int:
        """Their number Z in a row."""
        ...

    @property
    def row_count(self) -> int:
        """Number of rows i."""
        ...

    @property
    def roller(self) -> Roller:
        """Diameter D and length l; inclined rollers count with l cos(alpha)."""
        ...

    @property
    def pitch_diameter(self) -> float:
        """D_pw [m]."""
        ...

    @property
    def diameter_ratio(self) -> float:
        """Gamma, D cos(alpha)/D_pw [-]."""
        ...


def raceway_capacity(bearing: RatedRollers) -> tuple[float, float]:
    r"""Roller load that a raceway survives for a million revolutions with 90 % probability.

    .. math:: Q_c = 552\, b_m \frac{(1 \mp \gamma)^{29/27}}{(1 \pm \gamma)^{1/4}}
              \gamma^{2/9} D^{29/27} l^{7/9} Z^{-1/4} \quad \text{(N, mm; upper sign inner)}

    Parameters
    ----------
    bearing : RatedRollers
        gamma, D, l, Z

    Returns
    -------
    tuple of float
        inner and outer capacity [N]

    Source
    ------
    Lundberg and Palmgren (1952), line contact; b_m of ISO 281.

    Valid
    -----
    Bearing steel, full film, evenly loaded rollers.
    """
    g = bearing.diameter_ratio
    size = 552 * MATERIAL_FACTOR * g ** (2 / 9) * roller_size(bearing) * bearing.rollers ** (-1 / 4)
    inner = (1 - g) ** (29 / 27) / (1 + g) ** (1 / 4)
    outer = (1 + g) ** (29 / 27) / (1 - g) ** (1 / 4)
    return size * inner, size * outer


def geometry_factor(diameter_ratio: float) -> float:
    r"""Factor of the dynamic load rating that depends on the diameter ratio alone.

    .. math:: f_c = 551.13373 \cdot 0.377\, \lambda\nu\, \gamma^{2/9}
              \frac{(1 - \gamma)^{29/27}}{(1 + \gamma)^{1/4}}
              \Big\{1 + \Big[1.04 \Big(\frac{1-\gamma}{1+\gamma}\Big)^{143/108}\Big]^{9/2}\Big\}^{-2/9}

    Parameters
    ----------
    diameter_ratio : float
        gamma, roller over pitch diameter [-]

    Returns
    -------
    float
        f_c [-] for N and mm

    Raises
    ------
    OutOfRange
        when gamma leaves the table of the standard

    Source
    ------
    ISO 281 (2007), table 7, in closed form; lambda nu = 0.83.

    Valid
    -----
    gamma from 0.01 to 0.30, as tabulated.
    """
    g, (low, high) = diameter_ratio, TABULATED
    if not low <= g <= high:
        raise OutOfRange(f"roller over pitch diameter {g:.4g} is outside {low} to {high} of ISO 281, table 7")
    inner = g ** (2 / 9) * (1 - g) ** (29 / 27) / (1 + g) ** (1 / 4)
    both = (1 + _inner_over_outer(1.04, g) ** (9 / 2)) ** (-2 / 9)
    return 551.13373 * 0.377 * STRESS_REDUCTION * inner * both


def dynamic_rating(bearing: RatedRollers, material_factor: float = MATERIAL_FACTOR) -> float:
    r"""Radial load that the bearing survives for a million revolutions with 90 % probability.

    .. math:: C_r = b_m f_c\, (i l)^{7/9} Z^{3/4} D^{29/27} \quad \text{(N, mm)}

    Parameters
    ----------
    bearing : RatedRollers
        gamma, D, l, Z in each of i rows
    material_factor : float
        b_m [-]

    Returns
    -------
    float
        C_r [N]

    Source
    ------
    ISO 281 (2007), radial roller bearings.

    Valid
    -----
    gamma from 0.01 to 0.30; half the rollers loaded, rigid rings, profiled rollers, rows alike.
    """
    factor = material_factor * geometry_factor(bearing.diameter_ratio)
    return factor * _rows(bearing) * roller_size(bearing) * bearing.rollers ** (3 / 4)


def reference_raceway_capacity(bearing: RatedRollers, rating: float | None = None) -> tuple[float, float]:
    r"""Roller load that a raceway survives for a million revolutions, from the rating C_r.

    .. math:: Q_{ci} = \frac{C_r}{0.378\, \lambda\nu\, Z\, i^{7/9}} \{1 + X^{9/2}\}^{2/9},\quad
              Q_{ce} = \frac{C_r}{0.364\, \lambda\nu\, Z\, i^{7/9}} \{1 + X^{-9/2}\}^{2/9},\quad
              X = 1.038 \Big(\frac{1-\gamma}{1+\gamma}\Big)^{143/108}

    Parameters
    ----------
    bearing : RatedRollers
        gamma, D, l, Z in each of i rows
    rating : float, optional
        C_r [N]; `dynamic_rating` if left out

    Returns
    -------
    tuple of float
        inner and outer capacity [N]

    Source
    ------
    ISO/TS 16281 (2008), Eqs. 47-49, contact angle zero.

    Valid
    -----
    As for C_r; lambda nu is taken out again, for the slices carry their own edge stress.
    """
    x = _inner_over_outer(1.038, bearing.diameter_ratio) ** (9 / 2)
    of_row = (dynamic_rating(bearing) if rating is None else rating) / _rows(bearing)
    share = of_row / (STRESS_REDUCTION * bearing.rollers)
    return share / 0.378 * (1 + x) ** (2 / 9), share / 0.364 * (1 + 1 / x) ** (2 / 9)


def roller_capacity(bearing: RatedRollers) -> tuple[float, float]:
    r"""Load that a roller itself survives for a million of its own turns with 90 % probability.

    .. math:: Q_{cr} = 464\, (1 \mp \gamma)^{1.324} D^{29/27} l^{7/9}
              \quad \text{(N, mm; upper sign inner)}

    One load cycle per contact and turn of the roller: 464 is 552 without the 2^(1/4) of a raceway's
    cycles, Z (1 +- gamma)/2 in each turn of the ring. No material factor b_m.

    Parameters
    ----------
    bearing : RatedRollers
        gamma, D, l

    Returns
    -------
    tuple of float
        capacity at the inner and at the outer contact [N]

    Source
    ------
    Lundberg and Palmgren (1952) in Harris, Rolling Bearing Analysis; here from a published program.

    Valid
    -----
    Bearing steel, full film, aligned rollers.
    """
    g, size = bearing.diameter_ratio, 464 * roller_size(bearing)
    return size * (1 - g) ** 1.324, size * (1 + g) ** 1.324


def static_rating(bearing: RatedRollers) -> float:
    r"""Radial load at which the most loaded roller meets the inner raceway with 4000 MPa.

    .. math:: C_0 = 44\, (1 - \gamma) i\, Z\, l\, D \quad \text{(N, mm)}

    Parameters
    ----------
    bearing : RatedRollers
        gamma, D, l, Z in each of i rows

    Returns
    -------
    float
        C_0 [N]

    Source
    ------
    ISO 76 (2006), radial roller bearings, contact angle zero.

    Valid
    -----
    Steel on steel; the most loaded roller carries 5/Z of the load.
    """
    roller = bearing.roller
    area = roller.length * roller.diameter / MILLIMETRE**2
    return 44 * (1 - bearing.diameter_ratio) * bearing.row_count * bearing.rollers * area


def fatigue_load_limit(bearing: RatedRollers, rating: float | None = None) -> float:
    r"""Radial load at which the most loaded contact just reaches the fatigue limit of the steel.

    .. math:: C_u = \frac{C_0}{8.2} \min\Big(1, \frac{100}{D_{pw}}\Big)^{0.3} \quad \text{(N, mm)}

    Parameters
    ----------
    bearing : RatedRollers
        for C_0 and D_pw
    rating : float, optional
        C_0 [N]; `static_rating` if left out

    Returns
    -------
    float
        C_u [N]

    Source
    ------
    ISO 281 (2007), annex B.3.3, the simplified way for roller bearings.

    Valid
    -----
    Fatigue limit of 1500 MPa contact pressure, good bearing steel; the exponent 0.3 acts above 100 mm only.
    """
    pitch = bearing.pitch_diameter / MILLIMETRE
    rating = static_rating(bearing) if rating is None else rating
    return rating / 8.2 * float(np.minimum(1.0, 100 / pitch)) ** 0.3


def roller_size(bearing: RatedRollers) -> float:
    """D^(29/27) l^(7/9) of the roller (N, mm)."""
    roller = bearing.roller
    return (roller.diameter / MILLIMETRE) ** (29 / 27) * (roller.length / MILLIMETRE) ** (7 / 9)


def _rows(bearing: RatedRollers) -> float:
    """Dynamic rating of all rows over that of one, i^(7/9) [-]."""
    return bearing.row_count ** (7 / 9)


def _inner_over_outer(constant: float, diameter_ratio: float) -> float:
    """Capacity of the inner raceway over that of the outer."""
    return constant * ((1 - diameter_ratio) / (1 + diameter_ratio)) ** (143 / 108)
