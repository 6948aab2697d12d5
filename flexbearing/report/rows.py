"""Rows of a page: labels and numbers of summary values, as their declarations say."""

from typing import Any

from flexbearing.quantities import SummaryValue, Unit
from flexbearing.quantities.layout import Layout


def rows(layout: Layout, section: str = "") -> list[SummaryValue]:
    """Values of the summary with a row in a section of the page, in the order of declaration."""
    return [entry for entry in layout.summary if entry.label and entry.section == section]


def of_supports(entry: SummaryValue) -> bool:
    """Whether a row counts elastic rings and supports: between rigid rings it would repeat another."""
    return entry.of == ("total_stiffness",)


def label(entry: SummaryValue, part: str = "") -> str:
    """Label of a row with its unit: "peak pressure, inner [MPa]"."""
    unit = unit_of(entry).name
    return entry.label + (f", {part}" if part else "") + (f" [{unit}]" if unit else "")


def value(entry: SummaryValue, block: dict[str, Any] | None, part: str = "") -> Any:
    """Value of a row in the unit of its label, from a block of the summary; None if it is not known."""
    number: Any = block
    for key in (*entry.key.split("."), *([part] if part else [])):
        number = None if number is None else number[key]
    if number is None or not entry.in_si:
        return number
    scale = unit_of(entry).scale
    return [scale * end for end in number] if isinstance(number, list) else scale * number


def shown(entry: SummaryValue, number: Any) -> str:
    """A number, components, or a range whose ends differ as shown; a dash if it is not known."""
    if not isinstance(number, list):
        return "-" if number is None else formatted(number, entry.digits)
    ends = [shown(entry, end) for end in number]
    if entry.section == "ring":
        return ", ".join(ends)
    return ends[0] if ends[0] == ends[-1] else f"{ends[0]} to {ends[-1]}"


def formatted(number: float, digits: str) -> str:
    """A number without the sign of a zero that rounding leaves."""
    return format(number, digits if digits == "d" else f"z{digits}")


def unit_of(entry: SummaryValue) -> Unit:
    """The unit of a value, which every layout fills in."""
    assert entry.unit is not None
    return entry.unit
