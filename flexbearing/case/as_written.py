"""Values for which a rating of a case was given: those of its file, before settings changed them."""

from functools import lru_cache
from typing import Any

from pydantic import ValidationError

from flexbearing.case.declarations import find
from flexbearing.case.file_keys import value_at
from flexbearing.case.head import Head
from flexbearing.case.problems import BadCase
from flexbearing.case.read import settings_applied
from flexbearing.case.text import tables


def as_written(case: Head, rating: str, keys: tuple[str, ...]) -> tuple[Any, ...]:
    """Values [SI] of some keys for which another key of the case was given; None of those not stated.

    A rating of the file belongs to the values of the file, one of a setting to those that result from all
    settings. Cases that derivatives make of a case keep its source, and so these values.

    Raises
    ------
    BadCase
        where a setting replaced a value of the file that cannot be read
    """
    source = case.source
    if not source.text:
        return (None,) * len(keys)
    names = (setting.partition("=")[0].strip() for setting in source.overrides)
    by_setting = any(rating == name or rating.startswith(f"{name}.") for name in names)
    return _stated(source.text, source.overrides if by_setting else (), type(case), rating, keys)


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
