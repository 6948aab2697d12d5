"""Load ratings of thrust ball bearings, and of slewing bearings that are rated as such."""

from math import cos, degrees, sin, tan

import numpy as np

from quasidynamic.errors import OutOfRange
from quasidynamic.outcome.ball_capacity import (
    BALL_MATERIAL_FACTOR,
    LARGEST_BY_POWER,
    ROUNDING,
    STEEPEST,
    inner_over_outer,
)
from quasidynamic.outcome.capacity import MILLIMETRE
from quasidynamic.parts.ball import BallRow

TABLE_CONFORMITY = 0.535  # of both grooves, with which the closed form gives the printed table
WIDEST_OF_TABLE = 0.54  # conformity up to which the table holds
SMALLEST_RATIO = 0.01  # gamma, and its largest values by the contact angles [deg] of the table
LARGEST_RATIOS = {45.0: 0.30, 60.0: 0.20, 75.0: 0.10}


def is_thrust(row: BallRow) -> bool:
    """Whether balls are rated as those of a thrust bearing: from 45 deg of contact angle on.

    Source
    ------
    ISO 281 (2007) rates bearings above 45 deg as thrust bearings, and its table of these begins at 45 deg,
    by which NREL DG03 (2009) rates four-point pitch and yaw bearings of that angle.
    """
    return row.contact_angle >= STEEPEST * (1 - ROUNDING)


def thrust_ball_geometry_factor(row: BallRow) -> float:
    r"""Factor of the dynamic axial load rating that geometry alone decides.

    .. math:: f_c = 98.0665 \cdot 0.9 \Big(1 - \frac{\sin\alpha}{3}\Big)\, g(0.535, 0.535)\,
              \frac{g(\max(f_i, 0.54), \max(f_o, 0.54))}{g(0.54, 0.54)}

    .. math:: g = \gamma^{0.3} \frac{(1 - \gamma)^{1.39}}{(1 + \gamma)^{1/3}}
              \Big(\frac{2 f_i}{2 f_i - 1}\Big)^{0.41} \{1 + X^{10/3}\}^{-3/10}

    with X of `inner_over_outer`, c = 1. The first part is the printed table, which holds for grooves up to
    0.54: closer ones are not rated higher. The second reduces it for wider ones, as with radial bearings.

    Parameters
    ----------
    row : BallRow
        gamma, alpha, f_i, f_o

    Returns
    -------
    float
        f_c [-] for N and mm

    Raises
    ------
    OutOfRange
        when the contact angle is below 45 deg, or gamma leaves the table of the standard

    Source
    ------
    ISO 281 (2007), table of thrust ball bearings, as printed in Machinery's Handbook (31st ed.), table 29,
    in the closed form of Lundberg and Palmgren (1947).

    Valid
    -----
    45 to below 90 deg; gamma from 0.01 to 0.30 at 45, 0.20 at 60, 0.10 at 75 deg and above, straight lines
    between; within 0.06 of the table.
    """
    _require_of_table(row)
    wide = max(row.inner_conformity, WIDEST_OF_TABLE), max(row.outer_conformity, WIDEST_OF_TABLE)
    g = row.diameter_ratio
    tabulated = 98.0665 * 0.9 * (1 - sin(row.contact_angle) / 3) * _of_grooves(g, *[TABLE_CONFORMITY] * 2)
    return tabulated * _of_grooves(g, *wide) / _of_grooves(g, *[WIDEST_OF_TABLE] * 2)


def thrust_ball_dynamic_rating(row: BallRow) -> float:
    r"""Axial load that the bearing survives for a million revolutions with 90 % probability.

    .. math:: C_a = b_m f_c (\cos\alpha)^{0.7} \tan\alpha\, Z^{2/3} D^{1.8} \;(D \le 25.4),\quad
              C_a = 3.647\, b_m f_c (\cos\alpha)^{0.7} \tan\alpha\, Z^{2/3} D^{1.4} \quad \text{(N, mm)}

    with b_m = 1.3; one row that carries in the direction of the load.

    Parameters
    ----------
    row : BallRow
        alpha, D, Z and what f_c needs

    Returns
    -------
    float
        C_a [N]

    Source
    ------
    ISO 281 (2007), single-direction thrust ball bearings with a contact angle below 90 deg.

    Valid
    -----
    As `thrust_ball_geometry_factor`; balls and rings of bearing steel.
    """
    size = row.ball_diameter / MILLIMETRE
    power = size**1.8 if size <= LARGEST_BY_POWER else 3.647 * size**1.4
    factor = BALL_MATERIAL_FACTOR * thrust_ball_geometry_factor(row)
    return factor * cos(row.contact_angle) ** 0.7 * tan(row.contact_angle) * row.balls ** (2 / 3) * power


def thrust_ball_raceway_capacity(row: BallRow, rating: float | None = None) -> tuple[float, float]:
    r"""Ball load that a raceway survives for a million revolutions, from the rating C_a.

    .. math:: Q_{ci} = \frac{C_a}{Z \sin\alpha} \{1 + X^{10/3}\}^{3/10},\quad
              Q_{ce} = \frac{C_a}{Z \sin\alpha} \{1 + X^{-10/3}\}^{3/10}

    with X of `inner_over_outer`, c = 1: under C_a, which all balls share evenly, both raceways together live
    for a million revolutions.

    Parameters
    ----------
    row : BallRow
        gamma, alpha, Z and the groove radii
    rating : float, optional
        C_a [N]; `thrust_ball_dynamic_rating` if left out

    Returns
    -------
    tuple of float
        inner and outer capacity [N]

    Source
    ------
    ISO/TS 16281 (2008), thrust ball bearings; the identity above is how they were derived here.

    Valid
    -----
    As for C_a.
    """
    x = inner_over_outer(1.0, row.diameter_ratio, row.inner_conformity, row.outer_conformity) ** (10 / 3)
    rated = thrust_ball_dynamic_rating(row) if rating is None else rating
    share = rated / (row.balls * sin(row.contact_angle))
    return share * (1 + x) ** (3 / 10), share * (1 + 1 / x) ** (3 / 10)


def _require_of_table(row: BallRow) -> None:
    """Raise `OutOfRange` where the table of thrust ball bearings has no factor."""
    angle, g = degrees(row.contact_angle), row.diameter_ratio
    if not is_thrust(row):
        raise OutOfRange(
            f"contact angle {angle:.4g} deg is below 45 deg: the bearing is rated as a radial one"
        )
    largest = float(np.interp(angle, [*LARGEST_RATIOS], [*LARGEST_RATIOS.values()]))
    if not SMALLEST_RATIO * (1 - ROUNDING) <= g <= largest * (1 + ROUNDING):
        raise OutOfRange(
            f"D cos(alpha) over pitch diameter {g:.4g} is outside {SMALLEST_RATIO} to {largest:.3g} of ISO "
            f"281, table of thrust ball bearings, at {angle:.4g} deg"
        )


def _of_grooves(gamma: float, inner: float, outer: float) -> float:
    """What the rating owes to gamma and to the conformities."""
    one = gamma**0.3 * (1 - gamma) ** 1.39 / (1 + gamma) ** (1 / 3) * (2 * inner / (2 * inner - 1)) ** 0.41
    return one * (1 + inner_over_outer(1.0, gamma, inner, outer) ** (10 / 3)) ** (-3 / 10)
