"""Values for which a rating of a case was given: those of its file, before settings changed them."""

from collections.abc import Iterable
from functools import lru_cache
from typing import Any

from pydantic import ValidationError

from flexbearing.case.declarations import find
from flexbearing.case.head import Head, value_at
from flexbearing.case.problems import BadCase
from flexbearing.case.ratings import OF_CATALOGUE
from flexbearing.case.read import settings_applied
from flexbearing.case.text import tables

ROLLER_SIZES = (
    "bearing.rollers",
    "bearing.outer_raceway_diameter",
    "bearing.roller.diameter",
    "bearing.roller.length",
)
GROOVES = tuple(f"bearing.{ring}.{name}" for ring in ("inner", "outer") for name in ("conformity", "radius"))
BALL_SIZES = (
    "bearing.balls",
    "bearing.ball.diameter",
    "bearing.pitch_diameter",
    "bearing.contact_angle",
    *GROOVES,
)
TAPERED_SIZES = (
    "bearing.rollers",
    "bearing.pitch_diameter",
    "bearing.cup_angle",
    "bearing.contact_angle",  # in place of that of the cup
    "bearing.roller.diameter",
    "bearing.roller.length",
)
SIZES = (*ROLLER_SIZES, *BALL_SIZES, *TAPERED_SIZES)
RATINGS = tuple(f"life.{name}" for name in OF_CATALOGUE)


def rated_apart(rated: Iterable[str], varied: Iterable[str]) -> str:
    """Why ratings cannot be among the keys of some settings while others vary; empty where they can.

    A rating of a setting belongs to the bearing that results, so that it would not follow what varies.
    """
    ratings = [key for key in rated if key in RATINGS]
    sizes = [key for key in varied if key in SIZES]
    if not (ratings and sizes):
        return ""
    return f"{ratings[0]} is set while {sizes[0]} varies; write it into the case file, then it follows"


def as_written(case: Head, rating: str, keys: tuple[str, ...]) -> tuple[Any, ...]:
    """Values [SI] of some keys for which another key of the case was given; None of those not stated.

    A rating of the file belongs to the values of the file, one of a setting to those that result from all
    settings. Cases that derivatives make of a case keep its source, and so these values.
    """
    source = case.source
    if not source.text:
        return (None,) * len(keys)
    names = (setting.partition("=")[0].strip() for setting in source.overrides)
    by_setting = any(rating == name or rating.startswith(f"{name}.") for name in names)
    return _stated(source.text, source.overrides if by_setting else (), type(case), rating, keys)


def require_readable(case: Head) -> None:
    """Refuse a case with a rating whose sizes in the file cannot be read."""
    for rating in RATINGS:
        if getattr(getattr(case, "life", None), rating.partition(".")[2], None) is not None:
            as_written(case, rating, SIZES)


@lru_cache(maxsize=256)
def _stated(
    text: str, settings: tuple[str, ...], model: type[Head], rating: str, keys: tuple[str, ...]
) -> tuple[Any, ...]:
    raw = tables(text)
    settings_applied(raw, settings, model)
    return tuple(_read(value_at(raw, key), key, model, rating) for key in keys)


def _read(value: Any, key: str, model: type[Head], rating: str) -> Any:
    declaration = find(key, model)
    if value is None or declaration is None:
        return None
    table = declaration.section
    try:
        return table.model_validate(value) if table else declaration.reader(value)
    except ValidationError:
        raise BadCase(
            f"{rating} of the file belongs to its {key}, which is none: {value!r:.60}; correct it there."
        ) from None
