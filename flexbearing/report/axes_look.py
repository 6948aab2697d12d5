"""Look of axes that the pictures share."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.axes import Axes

NUMBERS = "{x:,.10g}"  # of ticks, with separated thousands as in tables


def plain(axes: Axes) -> None:
    """Draw a light grid below everything, no frame above and to the right, thousands separated."""
    plain_grid(axes)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(NUMBERS)


def plain_grid(axes: Axes) -> None:
    """Draw a light grid below everything, no frame above and to the right."""
    axes.set_axisbelow(True)
    axes.grid(color="0.88", linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)


def require_span(axes: Axes, span: float) -> None:
    """Widen the y axis, so that rounding errors of a constant do not fill it."""
    low, high = axes.get_ylim()
    if high - low < span:
        middle = (low + high) / 2
        axes.set_ylim(middle - span / 2, middle + span / 2)
