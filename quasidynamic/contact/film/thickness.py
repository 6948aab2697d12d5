"""Thickness of the lubricant film in a line contact."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line import half_width as hertz_half_width
from quasidynamic.parts.oil_properties import Lubricant

SLIP_ROUNDING = 1e-3  # of the slide-to-roll ratio in the heating of the inlet
FIT_ENDS = 8.0  # [-] xi at which the source switches its fit off
FIT = ((-1.68005, 0.8315), (0.260137, 1.558), (-0.016146, 2.296))  # (coefficient, exponent) of xi


class Film(NamedTuple):
    """Film thickness [m] with its derivatives."""

    thickness: NDArray
    by_line_load: NDArray  # [m2/N]
    by_sliding: NDArray  # [s]
    by_entrainment: NDArray  # [s]


@dataclass(frozen=True, kw_only=True)
class FilmFormula:
    r"""A regression of film thickness in the groups of line contact.

    .. math:: h/R = c\, G^{g} U^{s} W^{-w},\quad
              U = \eta_0 u/(E' R),\; G = \alpha E',\; W = q/(E' R)

    with q load per length, u mean surface speed, E' = 2/[(1-nu1^2)/E1 + (1-nu2^2)/E2].

    Source
    ------
    Groups of Dowson and Higginson; the coefficients of each formula name their own in `FORMULAS`.

    Valid
    -----
    Flooded, isothermal, elastic and piezoviscous contacts.
    """

    source: str
    factor: NDArray | float  # c
    material: float  # exponent g
    speed: float  # exponent s
    load: float  # exponent w, counted positive


FORMULAS = {
    "dowson_higginson": FilmFormula(
        source="minimum; Dowson and Higginson (1961, 1966)", factor=1.6, material=0.6, speed=0.7, load=0.13
    ),
    "dowson": FilmFormula(
        source="minimum; Dowson, Proc. IMechE 182 (1968)", factor=2.65, material=0.54, speed=0.7, load=0.13
    ),
    "dowson_toyoda": FilmFormula(
        source="central; Dowson and Toyoda (1978)", factor=3.06, material=0.56, speed=0.69, load=0.10
    ),
    "pan_hamrock": FilmFormula(
        source="minimum; Pan and Hamrock (1989)", factor=1.714, material=0.568, speed=0.694, load=0.128
    ),
    "pan_hamrock_central": FilmFormula(
        source="central; Pan and Hamrock (1989)", factor=2.922, material=0.470, speed=0.692, load=0.166
    ),
}


@dataclass(frozen=True, kw_only=True)
class FilmLaw:
    """A film formula at the contacts of a bearing, thinned by inlet shear heating if wanted."""

    formula: FilmFormula
    radius: NDArray | float  # [m] reduced radius R, broadcasts against the loads
    modulus: NDArray | float  # [Pa] E'
    oil: Lubricant
    inlet_heating: bool = True

    @cached_property
    def _scale(self) -> NDArray | float:
        """Film at unit speed and load per length [SI]."""
        f, oil = self.formula, self.oil
        elastic = self.modulus * self.radius
        material = (oil.pressure_viscosity * self.modulus) ** f.material
        return f.factor * self.radius * material * (oil.viscosity / elastic) ** f.speed * elastic**f.load

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray) -> Film:
        """Film of loads per length q > 0 [N/m], sliding [m/s] of any sign, entrainment u > 0 [m/s]."""
        f, oil = self.formula, self.oil
        thickness = self._scale * np.exp(f.speed * np.log(entrainment) - f.load * np.log(line_load))
        by_slip, by_log_speed = 0.0, f.speed
        if self.inlet_heating:
            factor, by_slip, by_log_speed = inlet_heating_factor(entrainment, sliding, oil)
            thickness, by_log_speed = factor * thickness, f.speed + by_log_speed
        per_speed = thickness / entrainment
        return Film(thickness, -f.load * thickness / line_load, by_slip * per_speed, by_log_speed * per_speed)


def inlet_heating_factor(
    entrainment: NDArray, sliding: NDArray, oil: Lubricant
) -> tuple[NDArray, NDArray, NDArray]:
    r"""Reduction of the film by inlet shear heating, and its derivatives.

    .. math:: \varphi_T = 1/[1 + 0.1 (1 + 14.8\, S^{0.83}) L^{0.64}],\quad L = \eta_0 \beta u^2/k

    Parameters
    ----------
    entrainment, sliding : array (...)
        u and u1 - u2 [m/s]; S is their ratio without its sign
    oil : Lubricant
        eta0, beta, k at the inlet

    Returns
    -------
    tuple of array (...)
        factor in (0, 1] [-], d ln(factor) by the signed ratio (u1 - u2)/u and by ln u at constant sliding [-]

    Source
    ------
    Murch and Wilson (1975), extended for slip.

    Valid
    -----
    S below about 1; beyond it the trend only. S^0.83 is infinitely steep at zero: S is rounded over
    `SLIP_ROUNDING`, which thins the film of pure rolling by less than 0.5 %.
    """
    thermal_unit = 0.1 * np.power(oil.viscosity * oil.temperature_viscosity / oil.conductivity, 0.64)
    ratio = sliding / entrainment
    squared = ratio * ratio + SLIP_ROUNDING**2
    rolling = thermal_unit * np.exp(1.28 * np.log(entrainment))
    sliding_part = rolling * (14.8 * np.exp(0.83 / 2 * np.log(squared)))
    heating = rolling + sliding_part
    factor = 1.0 / (1.0 + heating)
    by_slip = -0.83 * factor * sliding_part * ratio / squared
    return factor, by_slip, -1.28 * factor * heating - by_slip * ratio


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
