"""What makes an answer dangerous to act on, of any family of bearings."""

from collections.abc import Iterator

import numpy as np

from quasidynamic.note import Note, danger

DENTING = 4e9  # [Pa] static rating of roller bearings, ISO 76: a lasting dent of 1e-4 of the diameter
SHORT_LIFE = 3600.0  # [s]


def pressed(pressure: float) -> Iterator[Note]:
    """Danger of a contact pressure that dents raceways.

    Parameters
    ----------
    pressure : float
        largest Hertz pressure [Pa]

    Yields
    ------
    Note
        "contact-pressure" above `DENTING`

    Source
    ------
    ISO 76 (2006): 4000 MPa for roller bearings, 4200 MPa for ball bearings; the lower one for both.
    """
    if pressure > DENTING:
        yield danger(
            "contact-pressure",
            f"contact pressure of {pressure / 1e9:.3g} GPa: {DENTING / 1e9:g} GPa dents raceways of "
            "bearing steel "
            "(ISO 76), and elastic contact laws end there",
        )


def short_lived(life: float, speed: float) -> Iterator[Note]:
    """Danger of a life that ends within `SHORT_LIFE`.

    Parameters
    ----------
    life : float
        [10^6 revolutions]
    speed : float
        of one ring against the other [rad/s], any sign

    Yields
    ------
    Note
        "short-life"
    """
    rate = abs(speed) / (2 * np.pi)  # [1/s]
    seconds = life * 1e6 / rate if rate else np.inf
    if seconds < SHORT_LIFE:
        yield danger(
            "short-life",
            f"life: {life:.3g} million revolutions last {seconds / 60:.3g} minutes at {rate * 60:,.0f} rpm",
        )


def yielding(part: str, stress: float, limit: float | None) -> Iterator[Note]:
    """Danger of a part that is stressed beyond its yield stress.

    Parameters
    ----------
    part : str
        its name, such as "bars of the squirrel cage"
    stress : float
        largest stress that is known of it [Pa]
    limit : float or None
        yield stress of its material [Pa]; None where the case does not give one

    Yields
    ------
    Note
        "yield-stress"
    """
    if limit is not None and stress > limit:
        yield danger(
            "yield-stress",
            f"stress: {part} reach {stress / 1e6:,.0f} MPa, above the yield stress of {limit / 1e6:,.0f} MPa",
        )
