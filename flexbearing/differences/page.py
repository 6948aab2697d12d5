"""Two results beside each other, as text."""

from collections.abc import Iterator
from math import isnan
from typing import Any

from rich.console import RenderableType
from rich.text import Text

from flexbearing.differences.compared import Compared, Differing
from flexbearing.findings import of_code
from flexbearing.printable import excerpt
from flexbearing.report.sections import right_aligned


def sections(found: Compared) -> Iterator[RenderableType]:
    """Keys that differ, outputs that differ, and what is known of their errors."""
    yield Text(f"A  {found.one}\nB  {found.other}", style="bold")
    if found.settings:
        yield Text("\nKeys of the cases that differ")
    else:
        yield Text("\nThe cases have the same keys and values.")
    for each in found.settings:
        yield Text(f"  {each.key}: {_setting(each.one, each.unit)} | {_setting(each.other, each.unit)}")
    for each in found.findings:
        name = ", ".join(filter(None, (of_code(each.code, each.grade).label, each.place)))
        yield Text(f"Limit of {name} ({each.source}): {each.one or 'none'} | {each.other or 'none'}")
    if found.outputs:
        table = right_aligned("output", "unit", "A", "B", "B - A", "error")
        table.columns[0].overflow = "fold"
        for each in found.outputs:
            table.add_row(*map(Text, _row(each)))
        yield table
    else:
        yield Text("No output differs by more than its estimated error.")
    yield from _errors(found)


def _row(each: Differing) -> tuple[str, ...]:
    unit, error = "" if each.unit == "1" else each.unit, "none" if isnan(each.error) else f"{each.error:.2g}"
    change = "none" if isnan(each.change) else f"{each.change:+.3g}"
    return each.name, unit, _shown(each.one), _shown(each.other), change, error


def _errors(found: Compared) -> Iterator[RenderableType]:
    """Say which outputs agree within their errors, and which have no estimate."""
    if found.within_error:
        names = ", ".join(each.name for each in found.within_error)
        yield Text(f"Within the estimated errors of both: {names}.")
    if found.without_estimate:
        count = len(found.without_estimate)
        yield Text(
            f"error: estimated numerical errors of A and B together. {count} outputs have no estimate: of "
            "them every difference beyond rounding is shown. --json names them."
        )


def _setting(value: Any, unit: str) -> str:
    return excerpt(_shown(value)) + (f" {unit}" if unit and value is not None else "")


def _shown(value: Any) -> str:
    if isinstance(value, list | tuple):
        return ", ".join(map(_shown, value)) or "none"
    if value is None or (isinstance(value, float) and isnan(value)):
        return "none"
    return f"{value:.6g}" if isinstance(value, float) else str(value)
