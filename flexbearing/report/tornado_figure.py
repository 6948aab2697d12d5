"""Tornado chart: how strongly each key moves an output, the strongest on top."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from flexbearing.report.axes_look import plain_grid
from flexbearing.report.picture import set_heading
from flexbearing.report.roller.figures import BLUE, ORANGE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from flexbearing.derivatives.table import Sensitivities, Slope

MOST = 14  # bars of an output; the strongest are drawn
ROW = 0.26  # height of a bar with its gap [inches]
SMALLEST = 1e-3  # of the longest bar: shorter ones are not drawn


def draw_tornado(found: Sensitivities) -> Figure:
    """Draw the elasticities of every output as bars.

    Keys without an elasticity, which are temperatures and values that are zero, are not drawn. A bar with
    two sides ends at the stronger one, the weaker one is marked.
    """
    from matplotlib.figure import Figure  # a second to load: only pictures pay for it

    panels = {name: _drawn(slopes) for name, slopes in found.by_output.items()}
    columns = 2 if len(panels) > 1 else 1
    lines = -(-len(panels) // columns)
    longest = max((len(slopes) for slopes in panels.values()), default=0)
    height = 1.0 + lines * (0.8 + ROW * max(longest, 2))
    figure = Figure(figsize=(6.2 * columns, height), layout="constrained")
    each = figure.subplots(lines, columns, squeeze=False).ravel()
    for axes, output in zip(each, found.outputs, strict=False):
        _bars(axes, panels[output.name])
        unit = "" if output.unit == "1" else f" {output.unit}"
        axes.set_title(f"{output.name} = {output.value:.5g}{unit}", fontsize=10, parse_math=False)
    for axes in each[len(panels) :]:
        axes.set_axis_off()
    set_heading(figure, found.title, f"Change in percent by one percent of each key, {found.raceways}", 90)
    return figure


def _drawn(slopes: tuple[Slope, ...]) -> list[Slope]:
    """The strongest keys with an elasticity."""
    sized = [slope for slope in slopes if np.isfinite(slope.elasticity)][:MOST]
    least = SMALLEST * max((abs(slope.elasticity) for slope in sized), default=0.0)
    return [slope for slope in sized if abs(slope.elasticity) >= least]


def _bars(axes: Axes, slopes: list[Slope]) -> None:
    sizes = [slope.elasticity for slope in slopes]
    places = range(len(slopes))
    axes.barh(places, sizes, height=0.7, color=[BLUE if size >= 0 else ORANGE for size in sizes])
    for place, slope in zip(places, slopes, strict=True):
        if slope.one_sided:
            sides = [slope.elastic(side) for side in (slope.below, slope.above)]
            axes.plot(sides, [place] * 2, "|", color="0.1", markersize=9, markeredgewidth=1.6)
    axes.axvline(0.0, color="0.3", linewidth=0.8)
    axes.set_yticks(places, [slope.key.path for slope in slopes], fontsize=8, parse_math=False)
    axes.set_ylim(max(len(slopes), 2) - 0.4, -0.6)
    axes.set_xlabel("percent per percent", fontsize=9)
    axes.tick_params(axis="x", labelsize=8)
    plain_grid(axes)
