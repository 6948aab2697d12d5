"""What is varied: keys of a case between bounds, on a scale from 0 to 1."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import exp, log
from typing import Any

from pydantic import ValidationError

from flexbearing.case.declarations import Declaration, toml
from flexbearing.printable import excerpt
from flexbearing.studies.file.values import BadValues, ends, in_si_units

BOUNDS = 'bounds are "FROM .. TO", such as "0.5 um .. 20 um", or "log 1 kN .. 10 kN"'
DIGITS = 12  # of values that are tried, so that a point that was computed is found again
_BOUNDS = re.compile(r"\s*(?P<log>log\s)?\s*(?P<low>.+?)\s*\.\.\s*(?P<high>.+?)\s*")
_ENTRY = re.compile(r"(?P<key>.+)\.(?P<number>[1-9][0-9]{0,3})")


@dataclass(frozen=True)
class Variable:
    """A key, or an entry of a key that holds a list, between bounds."""

    name: str  # as the file has it
    key: str  # of the case
    entry: int | None  # of a list, from 0; None of a single value
    low: float  # in the unit
    high: float
    unit: str  # empty of a plain number
    size: float = 1.0  # of the unit in SI
    given: float | None = None  # what the case has, in the unit
    logarithmic: bool = False
    digits: int = DIGITS  # of the share of the range: designs closer to each other are one

    @property
    def start(self) -> float:
        """Share where the search begins: what the case has, or the middle."""
        return 0.5 if self.given is None else min(max(self.share(self.given), 0.0), 1.0)

    def value(self, share: float) -> float:
        """Value at a share of the range, from 0 to 1, in the unit."""
        inside = round(min(max(share, 0.0), 1.0), self.digits)
        if self.logarithmic:
            value = exp(log(self.low) + inside * log(self.high / self.low))
        else:
            value = self.low + inside * (self.high - self.low)
        return float(f"{min(max(value, self.low), self.high):.{DIGITS}g}")

    def share(self, value: float) -> float:
        """Share of the range at a value in the unit; below 0 or above 1 outside of the bounds."""
        if not self.logarithmic:
            return (value - self.low) / (self.high - self.low)
        return log(value / self.low) / log(self.high / self.low) if value > 0 else 0.0

    def by_share(self, value: float) -> float:
        """Derivative of the value by the share, at a value."""
        return value * log(self.high / self.low) if self.logarithmic else self.high - self.low

    def words(self, value: float) -> str | float:
        """A value as a case file has it."""
        return f"{value!r} {self.unit}" if self.unit else value


def variables(
    given: Mapping[str, Any], find: Callable[[str], Declaration], stated: Callable[[str], Any]
) -> tuple[Variable, ...]:
    """What the table [vary] holds.

    Raises `BadValues` naming the key.
    """
    if not given:
        raise BadValues('names no key; give one or more, such as "bearing.clearance" = "0 um .. 60 um".')
    found = []
    for name, text in given.items():
        try:
            found.append(_variable(name, text, find, stated))
        except BadValues as problem:
            words = "" if name in str(problem) else f"{name} = {excerpt(toml(text))} "
            raise BadValues(f"{words}{problem}") from None
    return tuple(found)


def _variable(
    name: str, text: Any, find: Callable[[str], Declaration], stated: Callable[[str], Any]
) -> Variable:
    parts = _ENTRY.fullmatch(name)
    key, entry = (parts["key"], int(parts["number"]) - 1) if parts else (name, None)
    declaration = find(key)
    if declaration.listed is (entry is None) or declaration.section or declaration.whole:
        raise BadValues(f"cannot be varied between bounds: the key takes {declaration.allowed}")
    if not (declaration.kind or declaration.number or declaration.listed):
        raise BadValues(f"cannot be varied between bounds: the key takes {declaration.allowed}")
    bounds = _BOUNDS.fullmatch(text) if isinstance(text, str) and len(text) <= 300 else None
    if bounds is None:
        raise BadValues(f"is no pair of bounds: {BOUNDS}")
    (low, high), unit = ends(bounds["low"], bounds["high"], declaration)
    if not low < high:
        raise BadValues("has bounds of which the second is not above the first")
    if bounds["log"] and low <= 0:
        raise BadValues("has a bound that is not above zero, which a logarithmic scale cannot have")
    size = declaration.kind.unit_of(f"1 {unit}")[1] if declaration.kind else 1.0
    given = _number(_entry(name, key, entry, stated(key)), declaration, unit)
    found = Variable(name, key, entry, low, high, unit, size, given, bool(bounds["log"]))
    if entry is None:
        _require_allowed(found, declaration)
    return found


def _require_allowed(found: Variable, declaration: Declaration) -> None:
    """Refuse bounds that the key itself does not take."""
    for end in map(found.words, (found.low, found.high)):
        try:
            declaration.reader(end)
        except ValidationError:
            raise BadValues(f"has the bound {toml(end)}; it must be {declaration.allowed}") from None


def _entry(name: str, key: str, entry: int | None, value: Any) -> Any:
    """What the case has at a key, or at an entry of its list."""
    if entry is None:
        return value
    if not isinstance(value, list) or entry >= len(value):
        count = f"has {len(value)} entries" if isinstance(value, list) else "is not given"
        raise BadValues(f"{name}: {key} {count} in the case and [set]")
    return value[entry]


def _number(value: Any, declaration: Declaration, unit: str) -> float | None:
    """A value in the unit; None where the case does not give it."""
    if value is None or declaration.kind is None:
        return value if isinstance(value, int | float) else None
    return declaration.kind.number(in_si_units(value, declaration.kind), f"1 {unit}")


def keys_of(varied: Sequence[Variable]) -> tuple[str, ...]:
    """Keys of the case that are varied, those of several entries once."""
    return tuple(dict.fromkeys(each.key for each in varied))


def settings(
    varied: Sequence[Variable], values: Sequence[float], lists: Mapping[str, Sequence[Any]]
) -> dict[str, Any]:
    """Values of the keys at a point, in the words of a case file."""
    found: dict[str, Any] = {}
    for each, value in zip(varied, values, strict=True):
        if each.entry is None:
            found[each.key] = each.words(value)
        else:
            found.setdefault(each.key, [*lists[each.key]])[each.entry] = each.words(value)
    return found
