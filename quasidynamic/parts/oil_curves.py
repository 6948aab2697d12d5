"""Oils as data: property curves with their source and range."""

from bisect import bisect_left
from collections.abc import Callable
from dataclasses import dataclass, replace
from math import exp, log, log10, sinh

from quasidynamic.errors import ImpossiblePart, require_positive
from quasidynamic.note import Note, information

Point = tuple[float, float]  # (temperature [K], value)

DENSITY_FALL = 0.65  # [kg/(m3 K)] typical of mineral oils (recalled); esters lose 0.7 to 0.8
USABLE_BELOW, USABLE_ABOVE = 40.0, 100.0  # [K] how far a Walther line is carried past its two points


@dataclass(frozen=True, kw_only=True)
class Oil:
    """Property functions of the temperature [K], with the range in which their data were taken."""

    name: str
    source: str
    measured: tuple[float, float]  # [K] where data exist
    usable: tuple[float, float]  # [K] how far the formulas are carried, with a note
    viscosity: Callable[[float], float]  # [Pa s] dynamic, at ambient pressure
    pressure_viscosity: Callable[[float], float]  # [1/Pa]
    conductivity: Callable[[float], float]  # [W/(m K)]
    density: Callable[[float], float]  # [kg/m3]
    notes: tuple[Note, ...] = ()  # what every user of this oil must know, such as recalled numbers


def walther_viscosity(temperature: float, a: float, b: float) -> float:
    r"""Kinematic viscosity of a petroleum or ester oil.

    .. math:: \log_{10}\log_{10}(\nu + 0.7) = A - B \log_{10} T \qquad (\nu\ \text{in mm2/s},\ T\ \text{in K})

    Parameters
    ----------
    temperature : float
        T [K], > 0
    a, b : float
        A and B > 0 of the oil [-], see `walther_line`

    Returns
    -------
    float
        nu [m2/s]

    Source
    ------
    ASTM D341, short form.

    Valid
    -----
    Newtonian oil above its cloud point. The terms left out add about 0.3 % at 1.4 mm2/s and grow below.

    >>> round(walther_viscosity(373.15, 9.3126, 3.6665) * 1e6, 2)
    5.1
    """
    return (10 ** (10 ** (a - b * log10(temperature))) - 0.7) * 1e-6


def walther_line(first: Point, second: Point) -> tuple[float, float]:
    """A and B of `walther_viscosity` through two points (T [K], nu [m2/s]), the second hotter and thinner.

    Raises `ImpossiblePart` when the viscosity does not fall with temperature, or is below the 0.3e-6 m2/s of
    the equation.

    Source
    ------
    ASTM D341, short form.
    """
    (t1, nu1), (t2, nu2) = first, second
    if not (0.0 < t1 < t2 and 0.3e-6 < nu2 < nu1 < float("inf")):
        raise ImpossiblePart(
            f"viscosities {nu1!r} at {t1!r} K, {nu2!r} at {t2!r} K: temperature must rise, viscosity [m2/s] "
            "must fall and stay above 0.3e-6"
        )
    y1, y2 = (log10(log10(nu * 1e6 + 0.7)) for nu in (nu1, nu2))
    b = (y1 - y2) / log10(t2 / t1)
    return y1 + b * log10(t1), b


def two_point_oil(
    name: str,
    *,
    viscosities: tuple[Point, Point],
    density: float,
    pressure_viscosities: tuple[Point, ...],
    conductivity: float,
    source: str,
) -> Oil:
    r"""An oil from what a data sheet prints.

    .. math:: \eta = \nu(T)\,\rho(T),\quad \rho = \rho_{15} - 0.65\,(T - 288.15),\quad
              \ln\alpha \text{ linear in } T

    Parameters
    ----------
    name : str
        how notes and messages call it
    viscosities : tuple
        two points (T [K], kinematic nu [m2/s]), the second hotter and thinner
    density : float
        rho at 15 degC [kg/m3]
    pressure_viscosities : tuple
        one or two points (T [K], alpha [1/Pa]); one means constant, and a note says so
    conductivity : float
        k [W/(m K)], constant
    source : str
        where the numbers come from

    Returns
    -------
    Oil
        measured between the two viscosities, usable from 40 K below to 100 K above them;
        `dataclasses.replace(oil, usable=...)` widens that

    Raises
    ------
    ImpossiblePart
        when the viscosity does not fall with temperature, a property is not above zero, or the
        pressure-viscosities are not one point or two at rising temperatures

    Source
    ------
    ASTM D341; the fall of density is recalled, typical of mineral oils.

    Valid
    -----
    90 K above its points the line of a 5 mm2/s ester is 3 % off a measured chart; 80 K below (at -40 degC)
    it is far too thick.

    >>> from quasidynamic.parts.oil_properties import oil_at
    >>> oil = two_point_oil("data sheet", viscosities=((313.15, 32e-6), (373.15, 5.4e-6)), density=870.0,
    ...                     pressure_viscosities=((313.15, 20e-9),), conductivity=0.137, source="maker")
    >>> round(oil_at(oil, 313.15).viscosity * 1e3, 1)  # [mPa s]
    27.3
    """
    first, second = viscosities
    a, b = walther_line(first, second)
    require_positive(f"oil {name}: conductivity", conductivity)

    def rho(temperature: float) -> float:
        return density - DENSITY_FALL * (temperature - 288.15)

    measured = (first[0], second[0])
    usable = (first[0] - USABLE_BELOW, second[0] + USABLE_ABOVE)
    require_positive(f"oil {name}: density at {usable[1]:.0f} K", rho(usable[1]))
    pressure_viscosity = _exponential(name, pressure_viscosities)
    held = information(
        "constant-pressure-viscosity",
        f"{name}: pressure-viscosity is that of {pressure_viscosities[0][0]:.0f} K at any temperature",
    )
    return Oil(
        name=name,
        source=source,
        measured=measured,
        usable=usable,
        viscosity=lambda t: walther_viscosity(t, a, b) * rho(t),
        pressure_viscosity=pressure_viscosity,
        conductivity=lambda t: conductivity,
        density=rho,
        notes=(held,) if len(pressure_viscosities) == 1 else (),
    )


def _exponential(name: str, points: tuple[Point, ...]) -> Callable[[float], float]:
    """Curve with ln(value) linear in temperature through two points; constant for one."""
    for temperature, value in points:
        require_positive(f"oil {name}: pressure-viscosity at {temperature!r} K", value)
    if len(points) == 1:
        constant = points[0][1]
        return lambda t: constant
    if len(points) != 2 or not points[0][0] < points[1][0]:
        raise ImpossiblePart(
            f"oil {name}: pressure_viscosities has {len(points)} points; "
            "give one, or two at rising temperatures"
        )
    (t1, v1), (t2, v2) = points
    rate = log(v2 / v1) / (t2 - t1)
    return lambda t: v1 * exp(rate * (t - t1))


def _piecewise_linear(temperature: float, temperatures: list[float], values: list[float]) -> float:
    """Property with straight lines between its points; beyond the ends the last line goes on."""
    piece = min(max(bisect_left(temperatures, temperature) - 1, 0), len(values) - 2)
    slope = (values[piece + 1] - values[piece]) / (temperatures[piece + 1] - temperatures[piece])
    return values[piece] + slope * (temperature - temperatures[piece])


def _ester_density(temperature: float) -> float:
    return _piecewise_linear(temperature, [233.0, 300.0, 367.0, 422.0], [1016.0, 966.0, 922.0, 884.0])


def _ester_pressure_viscosity(temperature: float) -> float:
    # The pressure-viscosity fit belongs to its own viscosity fit, not to the Walther line.
    d = (311.111 - temperature) / (311.111 * temperature)
    viscosity = 0.0276 * exp(3609.6 * d + 7.7657e5 * d**2)
    return exp(1.15607 * log(viscosity) - 17.496) / viscosity


def _thin_aviation_density(temperature: float) -> float:
    return 970.0 - 0.7 * (temperature - 293.15)


def _mineral(grade: int, hot_viscosity: float, density: float, alphas: tuple[float, float]) -> Oil:
    """An ISO VG mineral oil: grade = nu at 40 degC, nu at 100 degC [mm2/s], alpha at both [1/GPa]."""
    name = f"ISO VG {grade}"
    oil = two_point_oil(
        name,
        viscosities=((313.15, grade * 1e-6), (373.15, hot_viscosity * 1e-6)),
        density=density,
        pressure_viscosities=((313.15, alphas[0] * 1e-9), (373.15, alphas[1] * 1e-9)),
        conductivity=0.137,
        source="ASTM D341 line of a grade of viscosity index near 100; viscosity at 100 degC, alpha, k, rho "
        "recalled as typical of paraffinic mineral oils: alpha 20-24 (40 degC), 15-18 1/GPa (100 degC), "
        "k 0.13-0.145 W/(m K), rho falling 0.65 kg/(m3 K)",
    )
    typical = information(
        "typical-oil",
        f"{name}: all but the grade are typical of mineral oils, recalled, not measured on one oil",
    )
    return replace(oil, notes=(*oil.notes, typical))


OILS = {
    oil.name: oil
    for oil in (
        Oil(
            name="MIL-PRF-23699",
            source="nu: ASTM D341 line of Mobil Jet Oil II (27.6, 5.1 mm2/s at 40, 100 degC), within 6 % of "
            "a published chart from 311 to 464 K; alpha, k, rho: ADORE-type fits, rho data end at 422 K, "
            "alpha 5 to 12 % above recalled NASA measurements",
            measured=(311.0, 478.0),
            usable=(273.0, 523.0),
            viscosity=lambda t: walther_viscosity(t, 9.3126, 3.6665) * _ester_density(t),
            pressure_viscosity=_ester_pressure_viscosity,
            conductivity=lambda t: 0.14868 - 2.2275e-4 * (t - 366.67),
            density=_ester_density,
        ),
        Oil(
            name="MIL-L-7808",
            source="ADORE-type fits; nu 13 % below a published chart at 478 K, rho 5 % above it at 433 K",
            measured=(311.0, 478.0),
            usable=(273.0, 523.0),
            viscosity=lambda t: 9.997e-4 * (exp(exp(-3.7048 * log(t) + 22.216)) - 0.87),
            pressure_viscosity=lambda t: 7.5808e-10 + 1.0742e-6 / (t - 215.56),
            conductivity=lambda t: _piecewise_linear(
                t, [311.0, 367.0, 422.0, 478.0], [0.1449, 0.1340, 0.1327, 0.1314]
            ),
            density=lambda t: _piecewise_linear(
                t, [311.0, 367.0, 422.0, 478.0], [954.0, 914.0, 870.0, 826.0]
            ),
        ),
        Oil(
            name="4 cSt aviation",
            source="public bearing program after Wang Yanshuang (thesis, Harbin 2006): nu from its formula, "
            "alpha and k at 20 degC, rho = 970 - 0.7 (t - 20 degC); "
            "its roller version has alpha 12.5 1/GPa, k 0.14, rho 885",
            measured=(293.0, 423.0),
            usable=(273.0, 503.0),
            # printed with 148.85 and T = degC + 273; 149.00 for kelvin gives the printed table
            viscosity=lambda t: 0.132e-6 * sinh(925.19 / (t - 149.0)) * _thin_aviation_density(t),
            pressure_viscosity=lambda t: 1.28e-8,
            conductivity=lambda t: 0.0966,
            density=_thin_aviation_density,
            notes=(
                information(
                    "typical-oil",
                    "4 cSt aviation: an oil its source does not identify; range of its data assumed",
                ),
                information(
                    "constant-pressure-viscosity",
                    "4 cSt aviation: pressure-viscosity and conductivity are those of 293 K at any "
                    "temperature",
                ),
            ),
        ),
        _mineral(32, 5.4, 870.0, (20.0, 15.0)),
        _mineral(68, 8.7, 878.0, (22.0, 16.5)),
        _mineral(100, 11.1, 882.0, (24.0, 18.0)),
    )
}
