"""Sensitivities as text."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isnan
from typing import TYPE_CHECKING

import numpy as np
from rich.console import RenderableType
from rich.text import Text

from flexbearing.derivatives.table import Chosen, OutputValue, Sensitivities, Slope
from flexbearing.report.figure import BLUE, DARK, ORANGE, Axis, Bars, Figure, Line, Rule
from flexbearing.report.html.document import Table
from flexbearing.report.panels import picture
from flexbearing.report.sections import listed, titled

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Page

    from flexbearing.derivatives.table import Sensitivities

MOST = 12  # keys of an output


def sections(found: Sensitivities) -> Iterator[RenderableType]:
    """A table of the keys for every output, by what a realistic step of each changes."""
    yield Text(f"{found.title}, {found.raceways}", style="bold")
    for output in found.outputs:
        unit = "" if output.unit == "1" else f" {output.unit}"
        yield Text(f"\n{output.name} = {output.value:.6g}{unit}")
        slopes = found.by_output[output.name]
        if not slopes:
            yield Text("  no key reaches it")
            continue
        yield from titled("", _table(slopes[:MOST], output.unit))
        if len(slopes) > MOST:
            yield Text(f"  and {len(slopes) - MOST} weaker keys, which the table in the file has")
    yield Text("\nchange: of the output by one step of the key, by the derivative; of a choice as solved.")
    if any(_one_sided(each) for changes in found.by_output.values() for each in changes):
        yield Text(
            "One-sided, with the derivative below and above: a contact opens or closes within 0.01 % of the "
            "key, a maximum changes its place, or the key ends there."
        )
    yield from listed("keys without derivatives", [f"{key}: {why}" for key, why in found.left_out])


def _table(changes: Sequence[Slope | Chosen], unit: str) -> Table:
    sided = any(map(_one_sided, changes))
    rows: list[tuple[str, ...]] = []
    for each in changes:
        change = f"{each.change:+.3g} {unit}" if isnan(each.percent) else f"{each.percent:+.3g} %"
        if isinstance(each, Chosen):
            rows.append((each.key, each.words.rpartition(", ")[2], change, "", *([""] * 2 if sided else ())))
        else:
            step = f"{each.key.realistic_step:.4g} {each.key.unit}".strip()
            sides = (_number(each.below), _number(each.above)) if sided else ()
            rows.append((each.key.path, step, change, _derivative(each, unit), *sides))
    head = ("key", "step", "change", "derivative", *(("below", "above") if sided else ()))
    return Table(head, tuple(rows))


def _one_sided(change: Slope | Chosen) -> bool:
    return isinstance(change, Slope) and change.one_sided


def _derivative(slope: Slope, unit: str) -> str:
    key = f"({slope.key.unit})" if {" ", "/"} & set(slope.key.unit) else slope.key.unit
    per = f"{unit}/{key}" if key else "" if unit == "1" else unit
    return f"{_number(slope.slope)} {per}".rstrip()


def _number(number: float) -> str:
    return "-" if isnan(number) else f"{number:+.4g}"


BARS = 14  # bars of an output; the strongest are drawn
ROW = 0.26  # height of a bar with its gap [inches]
SMALLEST = 1e-3  # of the longest bar: shorter ones are not drawn


def draw_tornado(found: Sensitivities) -> Page:
    """Draw what a realistic step of each key changes; both sides of a derivative are marked."""
    panels = {name: _strongest(slopes) for name, slopes in found.by_output.items()}
    longest = max((len(slopes) for slopes in panels.values()), default=0)
    figures = [_chart(output, panels[output.name]) for output in found.outputs]
    what = f"Change by a realistic step of each key, {found.raceways}"
    size = (6.2, 0.8 + ROW * max(longest, 2))
    return picture(found.title, what, figures, 2 if len(figures) > 1 else 1, size)


def _strongest(changes: tuple[Slope | Chosen, ...]) -> list[Slope | Chosen]:
    """The strongest changes that have a size."""
    sized = [each for each in changes if np.isfinite(each.change)][:BARS]
    least = SMALLEST * max((abs(each.change) for each in sized), default=0.0)
    return [each for each in sized if abs(each.change) >= least]


def _chart(output: OutputValue, changes: list[Slope | Chosen]) -> Figure:
    factor = output.percent(1.0) if output.ratio and output.value else 1.0
    sizes, names = [factor * each.change for each in changes], list(map(_key_with_step, changes))
    items: list[Bars | Line | Rule] = [
        Bars([size if (size >= 0) == rises else None for size in sizes], names, "", colour, level=True)
        for rises, colour in ((True, BLUE), (False, ORANGE))
    ]
    for each, name in zip(changes, names, strict=True):
        if isinstance(each, Slope) and each.one_sided:
            sides = [factor * each.by_step(side) for side in (each.below, each.above)]
            items.append(Line(sides, [name] * 2, "", DARK, "", "tick", 9.0))
    unit = "" if output.unit == "1" else f" {output.unit}"
    x = Axis("percent" if output.ratio else f"change [{output.unit}]")
    title, y = f"{output.name} = {output.value:.5g}{unit}", Axis(scale="category", falling=True)
    return Figure(output.name, title, x, y, (*items, Rule(0.0)))


def _key_with_step(change: Slope | Chosen) -> str:
    """A key with its step."""
    if isinstance(change, Chosen):
        return f"{change.key}: {change.words}"
    return f"{change.key.path} +{change.key.realistic_step:.4g} {change.key.unit}".rstrip()
