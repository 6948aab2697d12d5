"""Named oils: viscosity, pressure-viscosity, conductivity, density against temperature."""

from collections.abc import Callable
from dataclasses import dataclass
from math import exp, log, log10

import numpy as np

from quasidynamic.errors import OutOfRange
from quasidynamic.parts.lubricant import Lubricant


@dataclass(frozen=True, kw_only=True)
class Oil:
    """Property functions of the temperature [K], with the range in which their data were taken."""

    name: str
    source: str
    measured: tuple[float, float]  # [K] where data exist
    usable: tuple[float, float]  # [K] how far the formulas are carried, with a note
    viscosity: Callable[[float], float]  # [Pa s]
    pressure_viscosity: Callable[[float], float]  # [1/Pa]
    conductivity: Callable[[float], float]  # [W/(m K)]
    density: Callable[[float], float]  # [kg/m3]


def walther_viscosity(temperature: float, a: float, b: float) -> float:
    """Kinematic viscosity [m2/s] by ASTM D341: log log(nu + 0.7) = A - B log T, nu in mm2/s, T in K."""
    return (10 ** (10 ** (a - b * log10(temperature))) - 0.7) * 1e-6


def line_through(temperature: float, temperatures: list[float], values: list[float]) -> float:
    """Piecewise linear property; beyond the ends the last piece goes on as a straight line."""
    piece = int(np.clip(np.searchsorted(temperatures, temperature) - 1, 0, len(values) - 2))
    slope = (values[piece + 1] - values[piece]) / (temperatures[piece + 1] - temperatures[piece])
    return values[piece] + slope * (temperature - temperatures[piece])


def _ester_density(temperature: float) -> float:
    return line_through(temperature, [233.0, 300.0, 367.0, 422.0], [1016.0, 966.0, 922.0, 884.0])


def _ester_viscosity(temperature: float) -> float:
    return walther_viscosity(temperature, 9.3126, 3.6665) * _ester_density(temperature)


def _ester_pressure_viscosity(temperature: float) -> float:
    # The pressure-viscosity fit belongs to its own viscosity fit, not to the Walther line.
    d = (311.111 - temperature) / (311.111 * temperature)
    viscosity = 0.0276 * exp(3609.6 * d + 7.7657e5 * d**2)
    return exp(1.15607 * log(viscosity) - 17.496) / viscosity


def _diester_viscosity(temperature: float) -> float:
    return 9.997e-4 * (exp(exp(-3.7048 * log(temperature) + 22.216)) - 0.87)


OILS = {
    oil.name: oil
    for oil in (
        Oil(
            name="MIL-PRF-23699",
            source="ASTM D341 line of Mobil Jet Oil II (27.6, 5.1 mm2/s); alpha, k, rho of ADORE-type fits",
            measured=(233.0, 478.0),
            usable=(233.0, 523.0),
            viscosity=_ester_viscosity,
            pressure_viscosity=_ester_pressure_viscosity,
            conductivity=lambda t: 0.14868 - 2.2275e-4 * (t - 366.67),
            density=_ester_density,
        ),
        Oil(
            name="MIL-L-7808",
            source="ADORE-type fits",
            measured=(311.0, 478.0),
            usable=(273.0, 523.0),
            viscosity=_diester_viscosity,
            pressure_viscosity=lambda t: 7.5808e-10 + 1.0742e-6 / (t - 215.56),
            conductivity=lambda t: line_through(
                t, [311.0, 367.0, 422.0, 478.0], [0.1449, 0.1340, 0.1327, 0.1314]
            ),
            density=lambda t: line_through(t, [311.0, 367.0, 422.0, 478.0], [954.0, 914.0, 870.0, 826.0]),
        ),
    )
}


def oil_at(name: str, temperature: float) -> Lubricant:
    """Return a named oil at an inlet temperature [K].

    Raises
    ------
    OutOfRange
        when the name is unknown or the temperature leaves the usable range

    Valid
    -----
    Inside the measured range; from there to the usable range the result carries a note.
    """
    if name not in OILS:
        raise OutOfRange(f"oil {name!r} is not known; known are {', '.join(sorted(OILS))}")
    oil = OILS[name]
    if not oil.usable[0] <= temperature <= oil.usable[1]:
        raise OutOfRange(
            f"{name} at {temperature:.1f} K is outside {oil.usable[0]:.0f} to {oil.usable[1]:.0f} K"
        )
    step = 0.5  # K; the property curves are smooth on this scale
    return Lubricant(
        temperature=temperature,
        viscosity=oil.viscosity(temperature),
        pressure_viscosity=oil.pressure_viscosity(temperature),
        temperature_viscosity=log(oil.viscosity(temperature - step) / oil.viscosity(temperature + step))
        / (2 * step),
        conductivity=oil.conductivity(temperature),
        density=oil.density(temperature),
        notes=_extrapolation_note(oil, temperature),
    )


def _extrapolation_note(oil: Oil, temperature: float) -> tuple[str, ...]:
    if oil.measured[0] <= temperature <= oil.measured[1]:
        return ()
    return (
        f"{oil.name} at {temperature:.0f} K is extrapolated: "
        f"its data cover {oil.measured[0]:.0f} to {oil.measured[1]:.0f} K",
    )
