"""Tornado chart: how strongly each key moves an output, the strongest on top."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from flexbearing.derivatives.table import Chosen, OutputValue, Slope
from flexbearing.report.figure import BLUE, DARK, ORANGE, Axis, Bars, Figure, Line, Rule
from flexbearing.report.panels import picture

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Page

    from flexbearing.derivatives.table import Sensitivities

MOST = 14  # bars of an output; the strongest are drawn
ROW = 0.26  # height of a bar with its gap [inches]
SMALLEST = 1e-3  # of the longest bar: shorter ones are not drawn


def draw_tornado(found: Sensitivities) -> Page:
    """Draw what a realistic step of each key changes; both sides of a derivative are marked."""
    panels = {name: _drawn(slopes) for name, slopes in found.by_output.items()}
    longest = max((len(slopes) for slopes in panels.values()), default=0)
    figures = [_figure(output, panels[output.name]) for output in found.outputs]
    what = f"Change by a realistic step of each key, {found.raceways}"
    size = (6.2, 0.8 + ROW * max(longest, 2))
    return picture(found.title, what, figures, 2 if len(figures) > 1 else 1, size)


def _drawn(changes: tuple[Slope | Chosen, ...]) -> list[Slope | Chosen]:
    """The strongest changes that have a size."""
    sized = [each for each in changes if np.isfinite(each.change)][:MOST]
    least = SMALLEST * max((abs(each.change) for each in sized), default=0.0)
    return [each for each in sized if abs(each.change) >= least]


def _figure(output: OutputValue, changes: list[Slope | Chosen]) -> Figure:
    factor = output.percent(1.0) if output.ratio and output.value else 1.0
    sizes, names = [factor * each.change for each in changes], list(map(_words, changes))
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


def _words(change: Slope | Chosen) -> str:
    """A key with its step."""
    if isinstance(change, Chosen):
        return f"{change.key}: {change.words}"
    return f"{change.key.path} +{change.key.realistic_step:.4g} {change.key.unit}".rstrip()
