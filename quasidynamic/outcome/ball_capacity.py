"""Load ratings of ball bearings and their contacts."""

from functools import lru_cache
from math import cos, radians

import numpy as np

from quasidynamic.contact.ellipse.point_contact import INNER, OUTER, point_contact, race_curvatures
from quasidynamic.errors import OutOfRange
from quasidynamic.outcome.capacity import MILLIMETRE
from quasidynamic.parts.ball import BallRow
from quasidynamic.parts.material import Material, contact_modulus

BALL_MATERIAL_FACTOR = 1.3  # b_m of radial and angular-contact ball bearings without filling slots
STEEPEST = radians(45)  # contact angle of a radial bearing; steeper ones are thrust bearings
TABULATED = (0.01, 0.40)  # gamma, the range of the f_c table of ISO 281
ROUNDING = 1e-9  # of a gamma at the end of the table
USUAL_INNER, USUAL_OUTER = 0.52, 0.53  # conformities up to which the tables of f_c and f_0 hold
LARGEST_BY_POWER = 25.4  # [mm] ball diameter, above which C_r goes with its power 1.4 instead of 1.8
RATED_STEEL = Material(youngs_modulus=207e9, poisson_ratio=0.3, density=7850.0)  # of ISO 76
PERMANENT = 4.2e9  # [Pa] peak pressure at C_0


def require_radial(row: BallRow) -> None:
    """Refuse thrust bearings, whose ratings are axial loads.

    Raises `OutOfRange` for nominal contact angles above 45 deg.

    Source
    ------
    ISO 281 (2007), sections 5 and 6; ISO 76 (2006).
    """
    if row.contact_angle > STEEPEST * (1 + ROUNDING):
        raise OutOfRange(
            f"contact angle {np.degrees(row.contact_angle):.4g} deg is above 45 deg: ratings of thrust ball "
            "bearings are not offered"
        )


def ball_geometry_factor(row: BallRow) -> float:
    r"""Factor of the dynamic load rating that geometry alone decides.

    .. math:: f_c = 0.41 \cdot 98.0665 \cdot 0.95\, g(f_i{=}0.52, f_o{=}0.52)\,
              \frac{g(\max(f_i, 0.52), \max(f_o, 0.53))}{g(0.52, 0.53)}

    .. math:: g = \gamma^{0.3} \frac{(1 - \gamma)^{1.39}}{(1 + \gamma)^{1/3}}
              \Big(\frac{2 f_i}{2 f_i - 1}\Big)^{0.41}
              \Big\{1 + \Big[1.04 \Big(\frac{1-\gamma}{1+\gamma}\Big)^{1.72}
              \Big(\frac{f_i}{f_o}\, \frac{2 f_o - 1}{2 f_i - 1}\Big)^{0.41}\Big]^{10/3}\Big\}^{-3/10}

    The first part is the printed table, which holds for grooves up to f_i = 0.52 and f_o = 0.53: closer ones
    are not rated higher. The second reduces it for wider ones, as the standard requires.

    Parameters
    ----------
    row : BallRow
        gamma, f_i, f_o

    Returns
    -------
    float
        f_c [-] for N and mm

    Raises
    ------
    OutOfRange
        when gamma leaves the table of the standard, or the contact angle is that of a thrust bearing

    Source
    ------
    ISO 281 (2007), table 2, in the closed form of Lundberg and Palmgren (1947); how it is reduced for wider
    grooves is read from ISO 281, section 5.1 and annex C, which has 0.81 for 0.54 on both rings.

    Valid
    -----
    gamma from 0.01 to 0.40, one row, contact angles up to 45 deg; within 0.2 % of the table.
    """
    require_radial(row)
    g, (low, high) = row.diameter_ratio, TABULATED
    if not low * (1 - ROUNDING) <= g <= high * (1 + ROUNDING):
        raise OutOfRange(
            f"D cos(alpha) over pitch diameter {g:.4g} is outside {low} to {high} of ISO 281, table 2"
        )
    wide = max(row.inner_conformity, USUAL_INNER), max(row.outer_conformity, USUAL_OUTER)
    tabulated = 0.41 * 98.0665 * 0.95 * _lundberg_palmgren(g, USUAL_INNER, USUAL_INNER)
    return tabulated * _lundberg_palmgren(g, *wide) / _lundberg_palmgren(g, USUAL_INNER, USUAL_OUTER)


def ball_dynamic_rating(row: BallRow, material_factor: float = BALL_MATERIAL_FACTOR) -> float:
    r"""Radial load that the bearing survives for a million revolutions with 90 % probability.

    .. math:: C_r = b_m f_c (\cos\alpha)^{0.7} Z^{2/3} D^{1.8} \;(D \le 25.4),\quad
              C_r = 3.647\, b_m f_c (\cos\alpha)^{0.7} Z^{2/3} D^{1.4} \quad \text{(N, mm; one row)}

    Parameters
    ----------
    row : BallRow
        alpha, D, Z and what f_c needs
    material_factor : float
        b_m [-]

    Returns
    -------
    float
        C_r [N]

    Source
    ------
    ISO 281 (2007), Eqs. 1 and 2.

    Valid
    -----
    As `ball_geometry_factor`; half the balls loaded, rigid rings, balls and rings of bearing steel.
    """
    size = row.ball_diameter / MILLIMETRE
    power = size**1.8 if size <= LARGEST_BY_POWER else 3.647 * size**1.4
    factor = material_factor * ball_geometry_factor(row)
    return factor * cos(row.contact_angle) ** 0.7 * row.balls ** (2 / 3) * power


def ball_raceway_capacity(row: BallRow, rating: float | None = None) -> tuple[float, float]:
    r"""Ball load that a raceway survives for a million revolutions, from the rating C_r.

    .. math:: Q_{ci} = \frac{C_r}{0.407\, Z \cos\alpha} \{1 + X^{10/3}\}^{3/10},\quad
              Q_{ce} = \frac{C_r}{0.389\, Z \cos\alpha} \{1 + X^{-10/3}\}^{3/10}

    .. math:: X = 1.044 \Big(\frac{1-\gamma}{1+\gamma}\Big)^{1.72}
              \Big(\frac{r_i}{r_e}\, \frac{2 r_e - D}{2 r_i - D}\Big)^{0.41}

    Parameters
    ----------
    row : BallRow
        gamma, alpha, Z and the groove radii
    rating : float, optional
        C_r [N]; `ball_dynamic_rating` if left out

    Returns
    -------
    tuple of float
        inner and outer capacity [N]

    Source
    ------
    ISO/TS 16281 (2008), radial ball bearings, one row.

    Valid
    -----
    As for C_r.
    """
    x = inner_over_outer(1.044, row.diameter_ratio, row.inner_conformity, row.outer_conformity) ** (10 / 3)
    require_radial(row)
    share = (ball_dynamic_rating(row) if rating is None else rating) / (row.balls * cos(row.contact_angle))
    return share / 0.407 * (1 + x) ** (3 / 10), share / 0.389 * (1 + 1 / x) ** (3 / 10)


@lru_cache(maxsize=64)  # a run needs it for its rating, its life and what it is judged by
def static_factor(row: BallRow, ball: Material = RATED_STEEL) -> float:
    r"""Factor of the static load rating.

    .. math:: f_0 = \frac{1}{5 D^2} \min_{i, o} Q(p_0 = 4200\ \text{MPa}) \quad \text{(N, mm)}

    by Hertz for balls and rings of 207 GPa and 0.3, in grooves not closer than 0.52 inside and 0.53 outside:
    closer ones are not rated higher.

    Parameters
    ----------
    row : BallRow
        gamma, f_i, f_o
    ball : Material
        of the balls; the rings are of the steel of the table

    Returns
    -------
    float
        f_0 [-] for N and mm

    Raises
    ------
    OutOfRange
        when gamma is above the table of the standard

    Source
    ------
    ISO 76 (2006), table 1 with its note. Of other balls than steel the same pressure is assumed: ISO 20056-2
    (2017) says in its introduction that hybrids are allowed slightly more, its table was not found printed.

    Valid
    -----
    gamma up to 0.40; within the last printed digit of the table for steel.
    """
    require_radial(row)
    if not row.diameter_ratio <= TABULATED[1] * (1 + ROUNDING):
        raise OutOfRange(
            f"D cos(alpha) over pitch diameter {row.diameter_ratio:.4g} is above {TABULATED[1]} of ISO 76, "
            "table 1"
        )
    wide = np.array([max(row.inner_conformity, USUAL_INNER), max(row.outer_conformity, USUAL_OUTER)])
    diameter, sides = row.ball_diameter, np.array([INNER, OUTER])
    curvatures = race_curvatures(diameter, wide * diameter, row.pitch_diameter, row.contact_angle, sides)
    contacts = point_contact(curvatures, contact_modulus(RATED_STEEL, ball))
    loads = (PERMANENT / contacts.peak_pressure(1.0)) ** 3  # the peak pressure goes with Q^(1/3)
    return float(loads.min()) / (5 * (diameter / MILLIMETRE) ** 2)


def ball_static_rating(row: BallRow, ball: Material = RATED_STEEL) -> float:
    r"""Radial load at which the most loaded contact meets 4200 MPa.

    .. math:: C_{0r} = f_0 Z D^2 \cos\alpha \quad \text{(N, mm; one row)}

    Parameters
    ----------
    row : BallRow
        alpha, D, Z and what f_0 needs
    ball : Material
        of the balls, see `static_factor`

    Returns
    -------
    float
        C_0r [N]

    Source
    ------
    ISO 76 (2006), Eq. 1.

    Valid
    -----
    As `static_factor`; the most loaded ball carries 5/(Z cos(alpha)) of the load.
    """
    return (
        static_factor(row, ball) * row.balls * (row.ball_diameter / MILLIMETRE) ** 2 * cos(row.contact_angle)
    )


def ball_fatigue_load_limit(row: BallRow, rating: float | None = None) -> float:
    r"""Radial load at which the most loaded contact just reaches the fatigue limit of the steel.

    .. math:: C_u = \frac{C_{0r}}{22} \min\Big(1, \frac{100}{D_{pw}}\Big)^{0.5} \quad \text{(N, mm)}

    Parameters
    ----------
    row : BallRow
        for C_0r and D_pw
    rating : float, optional
        C_0r [N]; `ball_static_rating` if left out

    Returns
    -------
    float
        C_u [N]

    Source
    ------
    ISO 281 (2007), annex B.3.3.2, the simplified way for ball bearings.

    Valid
    -----
    Fatigue limit of 1500 MPa contact pressure, good bearing steel; the root acts above 100 mm only.
    """
    rating = ball_static_rating(row) if rating is None else rating
    return rating / 22 * min(1.0, 100 / (row.pitch_diameter / MILLIMETRE)) ** 0.5


def _lundberg_palmgren(gamma: float, inner: float, outer: float) -> float:
    """What the rating owes to gamma and to the conformities."""
    one = gamma**0.3 * (1 - gamma) ** 1.39 / (1 + gamma) ** (1 / 3) * (2 * inner / (2 * inner - 1)) ** 0.41
    return one * (1 + inner_over_outer(1.04, gamma, inner, outer) ** (10 / 3)) ** (-3 / 10)


def inner_over_outer(constant: float, gamma: float, inner: float, outer: float) -> float:
    r"""Capacity of the inner raceway over that of the outer.

    .. math:: X = c \Big(\frac{1-\gamma}{1+\gamma}\Big)^{1.72}
              \Big(\frac{f_i}{f_o}\, \frac{2 f_o - 1}{2 f_i - 1}\Big)^{0.41}

    X [-] of gamma, D cos(alpha) over the pitch diameter, and of the conformities f of both grooves [-]; c is
    1 by theory, other standards have 1.04 or 1.044 for it.

    Source
    ------
    Lundberg and Palmgren (1947); ISO 281 (2007); ISO/TS 16281 (2008).

    Valid
    -----
    Point contacts of steel.
    """
    grooves = (inner / outer * (2 * outer - 1) / (2 * inner - 1)) ** 0.41
    return constant * ((1 - gamma) / (1 + gamma)) ** 1.72 * grooves
