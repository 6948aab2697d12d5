"""Systems of units of a report, and numbers printed in them."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from math import floor, isinf, isnan, log10
from typing import Any

from flexbearing.report.html.document import Number
from flexbearing.units import unit

_POUNDS = {  # by the unit of the metric page
    "N": "lbf", "kN": "lbf", "N m": "lbf in", "mN m": "lbf in", "N/m": "lbf/in", "kN/m": "lbf/in",
    "N/mm": "lbf/in", "kN/mm": "lbf/in", "kN/rad": "lbf/rad", "kN m/m": "lbf in/in", "kN m/rad": "lbf in/rad",
    "Pa": "psi", "MPa": "psi", "GPa": "ksi", "1/GPa": "1/ksi", "N/mm^3": "lbf/in^3",
    "m": "in", "mm": "in", "um": "uin", "m/s": "in/s", "mm/s": "in/s", "m/s^2": "ft/s^2",
    "W": "hp", "degC": "degF", "1/K": "1/degF", "kg": "lb", "kg/m^3": "lb/in^3",
}  # fmt: skip
_FOR_PEOPLE = {  # units of keys of a case, in SI, as an engineer writes them
    "N/m": "kN/mm", "N/m^3": "N/mm^3", "rad": "deg", "rad/s": "rpm", "K": "degC", "1/Pa": "1/GPa",
    "Pa s": "mPa s", "m^2/s": "mm^2/s",
}  # fmt: skip
_PRINTED = {
    "um": "µm", "uin": "µin", "degC": "°C", "degF": "°F", "deg": "°", "1": "", "N m": "N·m", "mN m": "mN·m",
    "lbf in": "lbf·in",
    "1/degF": "1/°F", "kN m/rad": "kN·m/rad", "lbf in/rad": "lbf·in/rad", "kN m/m": "kN·m/m",
    "lbf in/in": "lbf·in/in", "mPa s": "mPa·s", "m^2/s": "m²/s", "mm^2/s": "mm²/s", "kg/m^3": "kg/m³",
    "lb/in^3": "lb/in³", "m/s^2": "m/s²", "ft/s^2": "ft/s²", "N/mm^3": "N/mm³", "lbf/in^3": "lbf/in³",
}  # fmt: skip
_FINE, _STIFF = 3e-4, 1e9  # [m] below which lengths are in micrometres, [Pa] from which pressures are in GPa
NOTHING = "–"
FEWEST = 4  # significant digits of a converted number, 45 mm are 1.772 in; most of one with decimals
LARGEST, MOST_DECIMALS = 1e9, 8  # of numbers without an exponent


@dataclass(frozen=True)
class Units:
    """A system of units."""

    name: str
    instead: Mapping[str, str]  # units of this system by those of the metric page

    def of(self, people: str) -> str:
        """Unit of this system for one of the metric page."""
        return self.instead.get(people, people)

    def value(self, value: Any, stored: str, people: str) -> float:
        """A value, stored in one unit, in the unit of this system for one of the metric page."""
        return converted(value, stored, self.of(people))

    def number(self, value: Any, stored: str, people: str, digits: str, of: str) -> Number:
        """Print a number."""
        shown = self.of(people)
        if value is None or isnan(value):
            return Number(NOTHING, shown, of, stored)
        if isinf(value):
            return Number("∞" if value > 0 else "-∞", shown, of, stored)
        metric = converted(value, stored, people)
        text = _without_exponent(int(metric) if digits.endswith("d") else metric, digits)
        if shown != people:
            mantissa = text.partition("e")[0].lstrip("+-0.,")
            text = _significant(converted(value, stored, shown), sum(map(str.isdigit, mantissa)))
        return Number(text.lstrip("+-") if not text.strip("-+0.,") else text, shown, of, stored)

    def of_key(self, value: float, si: str, of: str) -> Number:
        """Print the value of a key of the case, whose SI unit is known."""
        return self.number(value, si, _people(value, si), ",.6g", of)


def printed(unit_name: str) -> str:
    """A unit as the page shows it."""
    return _PRINTED.get(unit_name, unit_name)


def with_unit(label: str, unit_name: str) -> str:
    """A label with its unit in brackets, where it has one."""
    return f"{label} [{printed(unit_name)}]" if printed(unit_name) else label


def units_in_words(text: str) -> str:
    """A text with the units behind its numbers as the page shows them.

    >>> units_in_words("33.6 um at 70 degC, deg")
    '33.6 µm at 70 °C, deg'
    """
    return re.sub(r"(?<=\d )(um|degC|deg)\b", lambda found: printed(found[1]), text)


def converted(value: Any, stored: str, shown: str) -> Any:
    """A number, or an array of numbers, in another unit; a temperature keeps its zero."""
    if stored == shown or {stored, shown} <= {"", "1"}:
        return value
    here, there = unit(stored or "1"), unit(shown or "1")
    return (here.to_si(value) - float(there.offset)) / there.scale


def _people(value: float, si: str) -> str:
    if si == "m":
        return "um" if abs(value) < _FINE else "mm"
    if si == "Pa":
        return "GPa" if abs(value) >= _STIFF else "MPa"
    return _FOR_PEOPLE.get(si, si)


def _without_exponent(value: float, digits: str) -> str:
    """A number in its format, all digits before the point where that has an exponent."""
    text = format(value, _at_most(value, digits))
    return f"{value:,.0f}" if "e+" in text and abs(value) < LARGEST else text


def _at_most(value: float, digits: str) -> str:
    """A format of fixed decimals with no more of them than leave so many significant digits.

    >>> _at_most(10435.66, ",.2f"), _at_most(0.044, ",.2f"), _at_most(0.0, "+.1f")
    (',.0f', ',.2f', '+.1f')
    """
    front, point, decimals = digits.removesuffix("f").rpartition(".")
    if not digits.endswith("f") or not point or value == 0:
        return digits
    whole = floor(log10(abs(value))) + 1
    return f"{front}.{min(int(decimals), max(0, FEWEST - whole))}f"


def _significant(value: float, digits: int) -> str:
    """A number with at least so many significant digits, four or more, and all before the point."""
    if value == 0:
        return "0"
    whole = floor(log10(abs(value))) + 1
    digits = max(digits, FEWEST)
    decimals = max(0, digits - whole)
    if decimals > MOST_DECIMALS or abs(value) >= LARGEST:
        return f"{value:.{digits - 1}e}"
    return f"{value:,.{decimals}f}"


METRIC = Units("metric", {})
IMPERIAL = Units("imperial", _POUNDS)
SYSTEMS = {system.name: system for system in (METRIC, IMPERIAL)}
