"""Starvation: loss of film where the inlet holds too little oil."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.film.thickness import Film
from quasidynamic.contact.line import half_width as hertz_half_width

FIT_ENDS = 8.0  # [-] xi at which the source switches its fit off
FIT = ((-1.68005, 0.8315), (0.260137, 1.558), (-0.016146, 2.296))  # (coefficient, exponent) of xi


class Starvation(NamedTuple):
    """Share of the flooded film that is left, with its derivatives."""

    factor: NDArray  # [-] in (0, 1]
    by_film: NDArray  # [1/m] by the flooded film, <= 0
    by_half_width: NDArray  # [1/m] >= 0


def meniscus_factor(
    half_width: NDArray, film: NDArray, radius: NDArray | float, inlet_length: float
) -> Starvation:
    r"""Film left in a line contact whose inlet is filled up to a meniscus.

    .. math:: \varphi_s = 1 - \exp(-1.68005\,\xi^{0.8315} + 0.260137\,\xi^{1.558} - 0.016146\,\xi^{2.296}),
              \quad \xi = c_s \left[\frac{b^2}{2 h R}\right]^{2/3} < 8;\qquad
              1 - \varphi_s \sim \xi^{-1.917},\quad \xi \ge 8

    Parameters
    ----------
    half_width : array (...)
        b, Hertzian half-width [m], > 0
    film : array (...)
        h, flooded film [m], > 0
    radius : array (...)
        R, reduced radius [m], > 0
    inlet_length : float
        c_s, dimensionless inlet length [-], > 0; by the shape of the Hertzian gap, the distance of the
        meniscus before the edge of the contact over b

    Returns
    -------
    Starvation of array (...)
        phi_s [-] and its derivatives by h and by b [1/m]

    Source
    ------
    Line contact form of the program ADORE, read in a public code of its lineage, not in its primary paper;
    the meaning of c_s is inferred.

    Valid
    -----
    Elastic line contact, half-width far above the film. At xi = 8 the source lets the factor jump from
    0.99125 to 1: a bearing with a contact there has no equilibrium on either side. Here what is lost goes on
    along the power of xi that the fit has at 8 (assumed), with a continuous slope.

    >>> contact = {"half_width": np.array(1e-4), "film": np.array(1e-6), "radius": 5e-3}  # b^2/(2 h R) = 1
    >>> round(float(meniscus_factor(**contact, inlet_length=1.0).factor), 4)
    0.7621
    """
    xi = inlet_length * (half_width**2 / (2 * film * radius)) ** (2 / 3)
    fitted = np.minimum(xi, FIT_ENDS)
    power = sum(c * n * fitted**n for c, n in FIT)  # d ln(lost)/d ln xi
    lost = np.exp(sum(c * fitted**n for c, n in FIT)) * (xi / fitted) ** power
    by_log = -lost * power  # d phi/d ln xi
    return Starvation(1.0 - lost, -2 / 3 * by_log / film, 4 / 3 * by_log / half_width)


def starved_film(
    flooded: Film,
    line_load: NDArray,
    radius: NDArray | float,
    modulus: NDArray | float,
    inlet_length: float,
) -> Film:
    r"""Film of a starved line contact, from the flooded one.

    .. math:: h_s = \varphi_s(b, h)\, h,\quad b = \sqrt{8 q R/(\pi E')}

    Parameters
    ----------
    flooded : Film of array (...)
        h [m] > 0 and its derivatives
    line_load : array (...)
        q, load per length [N/m], > 0
    radius : array (...)
        R, reduced radius [m], > 0
    modulus : float
        E' = 2/[(1-nu1^2)/E1 + (1-nu2^2)/E2] [Pa]
    inlet_length : float
        c_s [-], see `meniscus_factor`

    Returns
    -------
    Film of array (...)
        h_s [m] and its derivatives by load, sliding and entrainment

    Source
    ------
    `meniscus_factor`, with the Hertzian half-width.

    Valid
    -----
    As `meniscus_factor`.
    """
    width = hertz_half_width(line_load, radius, modulus)
    factor, by_film, by_width = meniscus_factor(width, flooded.thickness, radius, inlet_length)
    slope = factor + flooded.thickness * by_film  # d h_s/d h at fixed width
    return Film(
        factor * flooded.thickness,
        slope * flooded.by_line_load + flooded.thickness * by_width * width / (2 * line_load),
        slope * flooded.by_sliding,
        slope * flooded.by_entrainment,
    )
