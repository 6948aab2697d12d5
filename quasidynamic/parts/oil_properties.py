"""The properties of an oil at a temperature."""

from difflib import get_close_matches
from math import inf, log

from quasidynamic.errors import OutOfRange
from quasidynamic.note import Note, outside
from quasidynamic.parts.lubricant import Lubricant
from quasidynamic.parts.oil_curves import OILS, Oil, two_point_oil, walther_viscosity

THICKEST, STIFFEST = 1e4, 1e-4  # [Pa s], [1/Pa] beyond any oil

__all__ = ["OILS", "Oil", "oil_at", "two_point_oil", "walther_viscosity"]


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
    (coldest, hottest), (low, high) = oil.measured, oil.usable
    if not low <= temperature <= high:
        raise OutOfRange(
            f"oil {oil.name} at {temperature:.1f} K is outside {low:.0f} to {high:.0f} K, its usable range"
        )
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
        notes=oil.notes
        if coldest <= temperature <= hottest
        else (_extrapolated(oil, temperature), *oil.notes),
    )


def _extrapolated(oil: Oil, temperature: float) -> Note:
    coldest, hottest = oil.measured
    return outside(
        "oil-temperature",
        f"{oil.name} at {temperature:.0f} K is extrapolated: its data cover {coldest:.0f} to {hottest:.0f} K",
    )


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
