"""Axes that the pictures of ball bearings share."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from flexbearing.report.picture import plain, set_heading
from flexbearing.report.roller.figures import BLUE, ORANGE
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MOST_MARKS = 60  # balls that are marked one by one
STYLES = (  # of two things that are reported apart
    {"color": BLUE, "marker": "o", "markerfacecolor": "white", "markersize": 7},  # seen around the other
    {"color": ORANGE, "marker": "s"},
)


def stacked(result: Result, what: str, rows: int, height: float = 2.4) -> tuple[Figure, list[Axes]]:
    """A titled figure with panels above each other, over one axis."""
    from matplotlib.figure import Figure  # a second to load: only pictures pay for it

    figure = Figure(figsize=(7.0, height * rows + 1.2), layout="constrained")
    set_heading(figure, result.attributes["title"], what, 70)
    panels = list(figure.subplots(rows, 1, sharex=True, squeeze=False)[:, 0])
    for axes in panels:
        plain(axes)
    return figure, panels


def around(axes: Axes, azimuth: np.ndarray, values: np.ndarray, style: dict) -> None:
    """Draw ball by ball around the ring; balls without a value leave a gap."""
    order = np.argsort(azimuth % (2 * np.pi))
    marks = {"marker": ""} if azimuth.size > MOST_MARKS else {}
    degrees = np.degrees(azimuth[order] % (2 * np.pi))
    closed = np.append(degrees, degrees[0] + 360), np.append(values[order], values[order[0]])
    axes.plot(*closed, linewidth=1.2, **{"markersize": 4.5, **style, **marks})


def close_ring(axes: Axes) -> None:
    """Label the axis around the ring."""
    axes.set(xlabel="azimuth [deg]", xlim=(-5, 365), xticks=range(0, 361, 60))
