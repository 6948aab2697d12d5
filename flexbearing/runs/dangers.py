"""What makes an answer dangerous to act on, of any family of bearings."""

from collections.abc import Iterator

import numpy as np

from quasidynamic.note import Note, danger, information, outside

USUAL_OF_ROLLERS, USUAL_OF_BALLS = 1.5, 1.0  # s_0 of bearings in normal running
LEAST_OF_ROLLERS, LEAST_OF_BALLS = 0.02, 0.01  # P/C_r below which rolling elements may skid
SHORT_LIFE = 3600.0  # [s]


def pressed(pressure: float, limit: float) -> Iterator[Note]:
    """Danger of a contact pressure that dents raceways.

    Parameters
    ----------
    pressure : float
        largest contact pressure [Pa]
    limit : float
        that of the static rating, see `quasidynamic.outcome.static_pressure` [Pa]

    Yields
    ------
    Note
        "contact-pressure" above the limit

    Source
    ------
    ISO 76 (2006).
    """
    if pressure > limit:
        yield danger(
            "contact-pressure",
            f"contact pressure of {pressure / 1e9:.3g} GPa: {limit / 1e9:g} GPa dents raceways of bearing "
            "steel (ISO 76), and elastic contact laws end there",
        )


def overloaded(safety: float, usual: float) -> Iterator[Note]:
    """What a static safety asks for.

    Parameters
    ----------
    safety : float
        s_0 = C_0/P_0 [-]
    usual : float
        of bearings of that kind in normal running [-], `USUAL_OF_ROLLERS`

    Yields
    ------
    Note
        "static-safety": a danger below 1, information below the usual value

    Source
    ------
    ISO 76 (2006) for s_0; its usual values from the catalogue of SKF.
    """
    if safety < 1:
        yield danger(
            "static-safety",
            f"static safety s_0 = {safety:.3g}: the load is above the static rating C_0, which dents "
            "raceways (ISO 76)",
        )
    elif safety < usual:
        yield information(
            "static-safety",
            f"static safety s_0 = {safety:.3g}: at least {usual:g} is usual for such bearings in normal "
            f"running, {2 * usual:g} where they must run quietly or carry shocks",
        )


def heavily_loaded(load: float, rating: float) -> Iterator[Note]:
    """A load beyond that up to which lives hold.

    Parameters
    ----------
    load : float
        equivalent load P [N]
    rating : float
        C_r [N]

    Yields
    ------
    Note
        "heavy-load" above half of C_r

    Source
    ------
    ISO 281 (2007), 5: life by C_r holds up to 0.5 C_r.
    """
    if load > rating / 2:
        yield outside(
            "heavy-load",
            f"life: the load of {load:,.0f} N is above half of C_r = {rating:,.0f} N, up to which life "
            "formulas hold (ISO 281); plastic flow shortens the life beyond",
        )


def lightly_loaded(load: float, rating: float, least: float) -> Iterator[Note]:
    """A load below the minimum that makers ask for.

    Parameters
    ----------
    load : float
        equivalent load P [N]
    rating : float
        C_r [N]
    least : float
        P/C_r below which there is a note, such as `LEAST_OF_ROLLERS` [-]

    Yields
    ------
    Note
        "light-load" below that share of C_r

    Source
    ------
    SKF, Rolling bearings (2018): minimum load of 0.02 C of roller, 0.01 C of ball bearings.
    """
    if load < least * rating:
        yield information(
            "light-load",
            f"minimum load: {load:,.0f} N is below {least:g} C_r = {least * rating:,.0f} N, a rule of thumb "
            "of SKF against skidding; which slip does damage is not computed",
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
