"""Sensitivities as text."""

from collections.abc import Iterator
from math import isnan

from rich.console import RenderableType
from rich.text import Text

from flexbearing.derivatives.table import Sensitivities, Slope
from flexbearing.report.sections import listed, right_aligned

MOST = 12  # keys of an output


def sections(found: Sensitivities) -> Iterator[RenderableType]:
    """A table of the strongest keys for every output."""
    yield Text(f"{found.title}, {found.raceways}", style="bold")
    for output in found.outputs:
        unit = "" if output.unit == "1" else f" {output.unit}"
        yield Text(f"\n{output.name} = {output.value:.6g}{unit}")
        slopes = found.by_output[output.name]
        if not slopes:
            yield Text("  no key reaches it")
            continue
        yield _table(slopes[:MOST], output.unit)
        if len(slopes) > MOST:
            yield Text(f"  and {len(slopes) - MOST} weaker keys, which the table in the file has")
    yield Text("")
    if any(slope.one_sided for slopes in found.by_output.values() for slope in slopes):
        yield Text(
            "One-sided, with the derivative below and above: a contact opens or closes within 0.01 % of the "
            "key, a maximum changes its place, or the key ends there."
        )
    yield from listed("keys without derivatives", [f"{key}: {why}" for key, why in found.left_out])


def _table(slopes: tuple[Slope, ...], unit: str) -> RenderableType:
    sided = any(slope.one_sided for slope in slopes)
    table = right_aligned("key", "% per %", "derivative", *(("below", "above") if sided else ()))
    for column in table.columns:
        column.no_wrap, column.overflow = not sided, "fold"
    for slope in slopes:
        sides = (_number(slope.below), _number(slope.above)) if sided else ()
        row = slope.key.path, _number(slope.elasticity), _derivative(slope, unit), *sides
        table.add_row(*map(Text, row))
    return table


def _derivative(slope: Slope, unit: str) -> str:
    key = f"({slope.key.unit})" if {" ", "/"} & set(slope.key.unit) else slope.key.unit
    per = f"{unit}/{key}" if key else "" if unit == "1" else unit
    return f"{_number(slope.slope)} {per}".rstrip()


def _number(number: float) -> str:
    return "-" if isnan(number) else f"{number:+.4g}"
