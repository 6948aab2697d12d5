"""Sections that the pages of ball bearings share."""

from collections.abc import Iterator
from typing import Any

from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from flexbearing.quantities import SummaryValue
from flexbearing.quantities.layout import Layout
from flexbearing.report.rows import formatted, label, rows, value
from flexbearing.report.sections import matrix, right_aligned


def single_values(block: dict[str, Any], layout: Layout) -> Table:
    """What is one number, or one range, of the bearing."""
    table = right_aligned("", "value")
    for entry in rows(layout):
        if not entry.parts and block[entry.key] is not None:
            table.add_row(Text(label(entry)), shown(entry, value(entry, block)))
    return table


def of_races(block: dict[str, Any], layout: Layout) -> Table:
    """What inner and outer race have each."""
    table = right_aligned("", "inner", "outer")
    for entry in rows(layout):
        if entry.parts and block[entry.key] is not None:
            table.add_row(
                Text(label(entry)), *(shown(entry, value(entry, block, race)) for race in entry.parts)
            )
    return table


def ring(block: dict[str, Any], layout: Layout) -> Iterator[RenderableType]:
    """Displacement and stiffness of the inner ring; nothing when contact loads are given."""
    if block["ring_displacement_um"] is None:
        return
    table = right_aligned("inner ring", "")
    for entry in rows(layout, "ring"):
        components = (formatted(component, entry.digits) for component in value(entry, block))
        table.add_row(Text(label(entry)), ", ".join(components))
    yield table
    yield from matrix("tangent stiffness [N, m, rad]", block["stiffness_matrix_SI"])


def shown(entry: SummaryValue, number: Any) -> str:
    """A number, or a range in which both ends are reported apart only when they differ as shown."""
    if not isinstance(number, list):
        return "-" if number is None else formatted(number, entry.digits)
    first, last = (shown(entry, end) for end in number)
    return first if first == last else f"{first} to {last}"


def ending(numbers: dict[str, Any]) -> str:
    """Say in a line how a run ended."""
    if numbers["status"] == "unfinished":
        return f"unfinished: {numbers['message']}"
    seconds = f"{numbers['wall_time_s']:.1f} s"
    if numbers["status"] == "converged":
        return f"converged: {numbers['message']}, {seconds}"
    return f"NOT CONVERGED: {numbers['status']} ({numbers['ending']}), {seconds}: {numbers['message']}"
