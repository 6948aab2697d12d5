"""The properties of an oil at a temperature."""

from difflib import get_close_matches
from math import log

from quasidynamic.errors import OutOfRange
from quasidynamic.parts.lubricant import Lubricant
from quasidynamic.parts.oil_curves import OILS, Oil, two_point_oil, walther_viscosity

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
        when the name is unknown or the temperature leaves the usable range

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
    extrapolated = (
        f"{oil.name} at {temperature:.0f} K is extrapolated: its data cover {coldest:.0f} to {hottest:.0f} K"
    )
    step = 0.5  # [K] the property curves are smooth on this scale
    colder, warmer = oil.viscosity(temperature - step), oil.viscosity(temperature + step)
    return Lubricant(
        temperature=temperature,
        viscosity=oil.viscosity(temperature),
        pressure_viscosity=oil.pressure_viscosity(temperature),
        temperature_viscosity=log(colder / warmer) / (2 * step),
        conductivity=oil.conductivity(temperature),
        density=oil.density(temperature),
        notes=oil.notes if coldest <= temperature <= hottest else (extrapolated, *oil.notes),
    )


def _named(name: str) -> Oil:
    """An oil of `OILS`, or an error that names the nearest."""
    if name in OILS:
        return OILS[name]
    close = get_close_matches(name, OILS, n=1)
    hint = f". Did you mean {close[0]}?" if close else ""
    raise OutOfRange(f"oil {name!r} is not known; known are {', '.join(sorted(OILS))}{hint}")
