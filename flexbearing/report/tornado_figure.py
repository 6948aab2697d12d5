"""Tornado chart: how strongly each key moves an output, the strongest on top."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from flexbearing.derivatives.table import Chosen, OutputValue, Slope
from flexbearing.report.picture import plain_grid, set_heading
from flexbearing.report.roller.figures import BLUE, ORANGE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from flexbearing.derivatives.table import Sensitivities

MOST = 14  # bars of an output; the strongest are drawn
ROW = 0.26  # height of a bar with its gap [inches]
SMALLEST = 1e-3  # of the longest bar: shorter ones are not drawn


def draw_tornado(found: Sensitivities) -> Figure:
    """Draw what a realistic step of each key changes; both sides of a derivative are marked."""
    from matplotlib.figure import Figure  # a second to load: only pictures pay for it

    panels = {name: _drawn(slopes) for name, slopes in found.by_output.items()}
    columns = 2 if len(panels) > 1 else 1
    lines = -(-len(panels) // columns)
    longest = max((len(slopes) for slopes in panels.values()), default=0)
    height = 1.0 + lines * (0.8 + ROW * max(longest, 2))
    figure = Figure(figsize=(6.2 * columns, height), layout="constrained")
    each = figure.subplots(lines, columns, squeeze=False).ravel()
    for axes, output in zip(each, found.outputs, strict=False):
        _bars(axes, output, panels[output.name])
        unit = "" if output.unit == "1" else f" {output.unit}"
        axes.set_title(f"{output.name} = {output.value:.5g}{unit}", fontsize=10, parse_math=False)
    for axes in each[len(panels) :]:
        axes.set_axis_off()
    set_heading(figure, found.title, f"Change by a realistic step of each key, {found.raceways}", 90)
    return figure


def _drawn(changes: tuple[Slope | Chosen, ...]) -> list[Slope | Chosen]:
    """The strongest changes that have a size."""
    sized = [each for each in changes if np.isfinite(each.change)][:MOST]
    least = SMALLEST * max((abs(each.change) for each in sized), default=0.0)
    return [each for each in sized if abs(each.change) >= least]


def _bars(axes: Axes, output: OutputValue, changes: list[Slope | Chosen]) -> None:
    factor = output.percent(1.0) if output.ratio and output.value else 1.0
    sizes = [factor * each.change for each in changes]
    places = range(len(changes))
    axes.barh(places, sizes, height=0.7, color=[BLUE if size >= 0 else ORANGE for size in sizes])
    for place, each in zip(places, changes, strict=True):
        if isinstance(each, Slope) and each.one_sided:
            sides = [factor * each.by_step(side) for side in (each.below, each.above)]
            axes.plot(sides, [place] * 2, "|", color="0.1", markersize=9, markeredgewidth=1.6)
    axes.axvline(0.0, color="0.3", linewidth=0.8)
    axes.set_yticks(places, list(map(_words, changes)), fontsize=8, parse_math=False)
    axes.set_ylim(max(len(changes), 2) - 0.4, -0.6)
    axes.set_xlabel("percent" if output.ratio else f"change [{output.unit}]", fontsize=9)
    axes.tick_params(axis="x", labelsize=8)
    plain_grid(axes)


def _words(change: Slope | Chosen) -> str:
    """A key with its step."""
    if isinstance(change, Chosen):
        return f"{change.key}: {change.words}"
    return f"{change.key.path} +{change.key.realistic_step:.4g} {change.key.unit}".rstrip()
