"""Axes that the pictures of ball bearings share."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from flexbearing.report.picture import titled
from flexbearing.report.roller.figures import BLUE, ORANGE
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

STYLES = (  # of two things that are told apart
    {"color": BLUE, "marker": "o", "markerfacecolor": "white"},
    {"color": ORANGE, "marker": "s"},
)


def stacked(result: Result, what: str, rows: int, height: float = 2.4) -> tuple[Figure, list[Axes]]:
    """A titled figure with panels above each other, over one axis."""
    from matplotlib.figure import Figure  # a second to load: only pictures pay for it

    figure = Figure(figsize=(7.0, height * rows + 1.2), layout="constrained")
    heading = f"{titled(result.attributes['title'], 70)}\n{what}"
    figure.suptitle(heading, fontsize=11, parse_math=False)
    panels = list(figure.subplots(rows, 1, sharex=True, squeeze=False)[:, 0])
    for axes in panels:
        axes.grid(color="0.88", linewidth=0.6)
        axes.spines[["top", "right"]].set_visible(False)
    return figure, panels


def around(axes: Axes, azimuth: np.ndarray, values: np.ndarray, style: dict) -> None:
    """Draw ball by ball around the ring; balls without a value leave a gap."""
    order = np.argsort(azimuth % (2 * np.pi))
    size = 4.5 if azimuth.size <= 60 else 0
    degrees = np.degrees(azimuth[order] % (2 * np.pi))
    closed = np.append(degrees, degrees[0] + 360), np.append(values[order], values[order[0]])
    axes.plot(*closed, linewidth=1.2, **{"markersize": size, **style})


def close_ring(axes: Axes) -> None:
    """Label the axis around the ring."""
    axes.set(xlabel="azimuth [deg]", xlim=(-5, 365), xticks=range(0, 361, 60))
