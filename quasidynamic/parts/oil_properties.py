"""The properties of an oil at a temperature."""

from dataclasses import dataclass, field
from difflib import get_close_matches
from math import inf, log

from quasidynamic.errors import OutOfRange, require_positive
from quasidynamic.note import Note, outside
from quasidynamic.parts.oil_curves import (
    OILS,
    USABLE_ABOVE,
    USABLE_BELOW,
    Oil,
    Point,
    two_point_oil,
    walther_line,
    walther_viscosity,
)

ZERO_CELSIUS = 273.15  # [K]
THICKEST, STIFFEST = 1e4, 1e-4  # [Pa s], [1/Pa] beyond any oil

__all__ = ["OILS", "Oil", "kinematic_viscosity_at", "oil_at", "two_point_oil", "walther_viscosity"]


@dataclass(frozen=True, kw_only=True)
class Lubricant:
    """An oil at its inlet temperature."""

    temperature: float  # [K] at the inlet
    viscosity: float  # [Pa s] dynamic, at ambient pressure
    pressure_viscosity: float  # [1/Pa] alpha
    temperature_viscosity: float  # [1/K] beta = -d ln(viscosity)/dT
    conductivity: float  # [W/(m K)]
    density: float  # [kg/m3]
    # what a user must know, such as an extrapolation
    notes: tuple[Note, ...] = field(default=(), compare=False)

    def __post_init__(self):
        for name in ("temperature", "viscosity", "pressure_viscosity", "conductivity", "density"):
            require_positive(f"lubricant.{name}", getattr(self, name))


def oil_at(oil: str | Oil, temperature: float) -> Lubricant:
    r"""The properties of an oil at an inlet temperature.

    .. math:: \beta = -\mathrm{d}\ln\eta/\mathrm{d}T

    Parameters
    ----------
    oil : str or Oil
        a name in `OILS`, or an oil such as `two_point_oil` makes
    temperature : float
        T [K]

    Returns
    -------
    Lubricant
        with beta > 0 [1/K] by central differences over 1 K, and with the notes of the oil

    Raises
    ------
    OutOfRange
        when the name is unknown, the temperature leaves the usable range, or the curves leave that of any oil

    Source
    ------
    Each oil names its own.

    Valid
    -----
    Inside the measured range; from there to the usable range the result carries a note.

    >>> round(oil_at("MIL-PRF-23699", 373.15).viscosity * 1e3, 2)  # [mPa s]
    4.68
    """
    if isinstance(oil, str):
        oil = _named(oil)
    extrapolated = _extrapolated(oil.name, oil.measured, oil.usable, temperature)
    step = 0.5  # [K] the property curves are smooth on this scale
    colder, viscosity, warmer = (
        _value(oil, "viscosity", temperature + change, THICKEST) for change in (-step, 0.0, step)
    )
    return Lubricant(
        temperature=temperature,
        viscosity=viscosity,
        pressure_viscosity=_value(oil, "pressure_viscosity", temperature, STIFFEST),
        temperature_viscosity=log(colder / warmer) / (2 * step),
        conductivity=oil.conductivity(temperature),
        density=oil.density(temperature),
        notes=(*extrapolated, *oil.notes),
    )


def kinematic_viscosity_at(
    name: str, viscosities: tuple[Point, Point], temperature: float
) -> tuple[float, tuple[Note, ...]]:
    """Viscosity [m2/s] at T [K] of an oil of which a data sheet prints no more than two viscosities.

    They are points (T [K], kinematic nu [m2/s]), the second hotter and thinner; a note says where T is not
    between them.
    Raises `OutOfRange` more than 40 K below or 100 K above the two points, `ImpossiblePart` when the
    viscosity does not fall with temperature.

    Source
    ------
    ASTM D341, see `two_point_oil`.

    >>> nu, notes = kinematic_viscosity_at("VG 32", ((313.15, 32e-6), (373.15, 5.4e-6)), 343.15)
    >>> round(nu * 1e6, 1), notes
    (11.2, ())
    """
    measured = (viscosities[0][0], viscosities[1][0])
    usable = (measured[0] - USABLE_BELOW, measured[1] + USABLE_ABOVE)
    notes = _extrapolated(name, measured, usable, temperature)
    return walther_viscosity(temperature, *walther_line(*viscosities)), notes


def _extrapolated(name: str, measured: Point, usable: Point, temperature: float) -> tuple[Note, ...]:
    """A note where a temperature is not within the data; an error where it is outside the usable range."""
    (coldest, hottest), (low, high) = measured, usable
    if not low <= temperature <= high:
        raise OutOfRange(
            f"oil {name} at {temperature - ZERO_CELSIUS:z.1f} degC is outside {low - ZERO_CELSIUS:z.0f} to "
            f"{high - ZERO_CELSIUS:z.0f} degC, its usable range"
        )
    if coldest <= temperature <= hottest:
        return ()
    words = (
        f"{name} at {temperature - ZERO_CELSIUS:z.0f} degC is extrapolated: its data cover "
        f"{coldest - ZERO_CELSIUS:z.0f} to {hottest - ZERO_CELSIUS:z.0f} degC"
    )
    return (outside("oil-temperature", words),)


def _value(oil: Oil, name: str, temperature: float, most: float) -> float:
    """A property; a curve through points next to each other may leave the range of numbers."""
    try:
        found = getattr(oil, name)(temperature)
    except OverflowError:
        found = inf
    if not 0.0 < found < most:
        raise OutOfRange(
            f"oil {oil.name} at {temperature:.1f} K: {name} = {found:.3g} is not that of an oil, allowed is "
            f"above 0 and below {most:g}; points of a data sheet must lie apart, as those at 40 and 100 degC"
        )
    return found


def _named(name: str) -> Oil:
    """An oil of `OILS`, or an error that names the nearest."""
    if name in OILS:
        return OILS[name]
    close = get_close_matches(name, OILS, n=1)
    hint = f". Did you mean {close[0]}?" if close else ""
    raise OutOfRange(f"oil {name!r} is not known; known are {', '.join(sorted(OILS))}{hint}")
