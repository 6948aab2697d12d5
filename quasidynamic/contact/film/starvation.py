"""Loss of film where the inlet holds too little oil."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.film.thickness import Film
from quasidynamic.contact.line.hertz import half_width as hertz_half_width

FLOODED_FROM = 8.0  # [-] xi at which the meniscus formula is switched off
FIT = ((-1.68005, 0.8315), (0.260137, 1.558), (-0.016146, 2.296))  # (coefficient, exponent) of xi

BATH_OR_JET, GREASE_OR_OIL_AIR = 3e-8, 6e-8  # [-] replenishment constant K_rs, read
DEEP_GROOVE, ANGULAR_CONTACT = 3.1, 4.4  # [-] geometry constant K_z, read
CYLINDRICAL_ROLLER = 5.1  # [-] K_z with a cage, recalled


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
              \quad \xi = c_s \left[\frac{b^2}{2 h R}\right]^{2/3} < 8;\qquad \varphi_s = 1,\quad \xi \ge 8

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
    Elastic line contact, half-width far above the film. At xi = 8 the factor jumps from 0.99125 to 1 and its
    slopes drop to zero: a Newton step meets a jump of 0.9 %.

    >>> contact = {"half_width": np.array(1e-4), "film": np.array(1e-6), "radius": 5e-3}  # b^2/(2 h R) = 1
    >>> round(float(meniscus_factor(**contact, inlet_length=1.0).factor), 4)
    0.7621
    """
    xi = inlet_length * (half_width**2 / (2 * film * radius)) ** (2 / 3)
    fitted = np.minimum(xi, FLOODED_FROM)
    left = np.exp(sum(c * fitted**n for c, n in FIT))
    by_log = np.where(xi < FLOODED_FROM, -left * sum(c * n * fitted**n for c, n in FIT), 0.0)  # d phi/d ln xi
    return Starvation(
        np.where(xi < FLOODED_FROM, 1.0 - left, 1.0), -2 / 3 * by_log / film, 4 / 3 * by_log / half_width
    )


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
    As `meniscus_factor`, with its jump at xi = 8.
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


def replenishment_factor(
    kinematic_viscosity: NDArray | float,
    speed: NDArray | float,
    diameters: tuple[float, float],
    replenishment: float = BATH_OR_JET,
    geometry: float = CYLINDRICAL_ROLLER,
) -> NDArray:
    r"""Share of the rolling torque left when rollers outrun the oil that flows back into their track.

    .. math:: \varphi_{rs} = \exp\left\{-K_{rs}\, \nu n (d + D) \sqrt{\frac{K_z}{2 (D - d)}}\right\}
              \qquad (\nu\ \text{in mm2/s},\ n\ \text{in rpm},\ d, D\ \text{in mm})

    Parameters
    ----------
    kinematic_viscosity : array (...)
        nu at the inlet temperature [m2/s], > 0
    speed : array (...)
        omega of the rotating ring [rad/s], any sign
    diameters : tuple
        d, bore, and D, outside diameter [m], 0 < d < D
    replenishment : float
        K_rs [-]: `BATH_OR_JET` or `GREASE_OR_OIL_AIR`
    geometry : float
        K_z [-]: `DEEP_GROOVE`, `ANGULAR_CONTACT` or `CYLINDRICAL_ROLLER` (recalled)

    Returns
    -------
    array (...)
        phi_rs in (0, 1] [-]

    Source
    ------
    SKF model of the frictional moment, kinematic replenishment; read in a public implementation.

    Valid
    -----
    A factor on the rolling torque, not on the film; depends on neither load nor film. Kink at zero speed.

    >>> round(float(replenishment_factor(32e-6, 314.159, (0.050, 0.090))), 4)
    0.9032
    """
    bore, outside = (1e3 * value for value in diameters)
    turns = np.abs(speed) * 30 / np.pi
    crowding = np.sqrt(geometry / (2 * (outside - bore)))
    return np.exp(
        -replenishment * np.asarray(kinematic_viscosity) * 1e6 * turns * (bore + outside) * crowding
    )
