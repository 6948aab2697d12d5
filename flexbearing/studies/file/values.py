"""Values of one varied key: a list, a range, a single value."""

import re
from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pydantic_core import PydanticCustomError

from flexbearing import inputs
from flexbearing.case.declarations import Declaration, toml
from flexbearing.case.quantity import LONGEST, Kind
from flexbearing.printable import excerpt
from flexbearing.studies.file.columns import Written

MOST = 1_000_000  # variants of a study
DIGITS = 12  # of values within a range
RANGE = 'a range is "FROM .. TO, COUNT", such as "2.9 mm .. 5.1 mm, 6", or "log 1 N .. 1 kN, 20"'
_RANGE = re.compile(
    r"\s*(?P<log>log\s)?\s*(?P<first>.+?)\s*\.\.\s*(?P<last>.+?)\s*,\s*(?P<count>[0-9]{1,7})\s*"
)
_NUMBER = re.compile(r"[+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?")


class BadValues(ValueError):
    """Values that a key cannot take; the message completes a sentence that names file and key."""


def values(given: Any, declaration: Declaration) -> Sequence[Any]:
    """Values of a key, in the words of a case file.

    Raises `BadValues` for an empty list, or a range that is none.
    """
    if isinstance(given, list) and not (declaration.listed and not _lists(given)):
        if not given:
            raise BadValues("is an empty list; give one value or more")
        return tuple(given)
    counts = not declaration.listed and (declaration.kind or declaration.number)
    if counts and isinstance(given, str) and ".." in given:
        return _range(given, declaration)
    return (given,)


def count(given: Any) -> int:
    """How many values a range has, before they are made; 1 of anything else."""
    short = isinstance(given, str) and len(given) <= 3 * LONGEST
    parts = _RANGE.fullmatch(given) if short else None
    return int(parts["count"]) if parts else 1


def _lists(given: list[Any]) -> bool:
    """Whether every value is a list itself, as the values of a key that holds a list are."""
    return all(isinstance(value, list) for value in given)


def _range(text: str, declaration: Declaration) -> Written:
    parts = _RANGE.fullmatch(text) if len(text) <= 3 * LONGEST else None
    if parts is None:
        raise BadValues(f"is no range: {RANGE}")
    number = int(parts["count"])
    if not 2 <= number <= MOST:
        raise BadValues(f"has {number} values; a range has 2 to {MOST}")
    (first, last), unit = ends(parts["first"], parts["last"], declaration)
    if parts["log"] and min(first, last) <= 0:
        raise BadValues("has an end that is not above zero, which a logarithmic range cannot have")
    numbers = (np.geomspace if parts["log"] else np.linspace)(first, last, number)
    if declaration.whole:
        _require_whole(numbers)
        return Written(numbers, round)
    return Written(numbers, partial(_word, unit=unit))


def _word(number: float, unit: str) -> str | float:
    rounded = float(f"{number:.{DIGITS}g}")
    return f"{rounded!r} {unit}" if unit else rounded


def ends(first: str, last: str, declaration: Declaration) -> tuple[tuple[float, float], str]:
    """Both ends of a range in their common unit, or in SI; an empty unit where the key takes plain numbers.

    Raises `BadValues` with what is wrong with one of them.
    """
    kind = declaration.kind
    if kind is None:
        return (_plain(first), _plain(last)), ""
    if _NUMBER.fullmatch(first.strip()):  # "3 .. 14 mm"
        first = f"{first.strip()} {kind.split(last)[1]}"
    in_si = in_si_units(first, kind), in_si_units(last, kind)
    (one, unit), (other, unit_of_last) = kind.split(first), kind.split(last)
    return ((one, other), unit) if unit and unit == unit_of_last else (in_si, kind.unit)


def in_si_units(text: str, kind: Kind) -> float:
    """Value of a quantity in SI units.

    Raises `BadValues` with what is wrong with it.
    """
    try:
        return kind.to_si(text)
    except PydanticCustomError as problem:
        raise BadValues(f"has {toml(excerpt(text))}, which {problem.message()}") from None


def _plain(text: str) -> float:
    try:
        return inputs.number(text)
    except inputs.BadNumber as problem:
        raise BadValues(f"has an end that is none: {problem}; {RANGE}") from None


def _require_whole(numbers: NDArray) -> None:
    broken = np.abs(numbers - np.rint(numbers)) > 10.0**-DIGITS * np.abs(numbers)
    if broken.any():
        raise BadValues(f"has {numbers[broken][0]:g} among its values, which is no whole number")
