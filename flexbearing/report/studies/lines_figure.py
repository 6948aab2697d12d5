"""Picture of outputs over a varied key: a panel for each output, a line for each value of another key."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.printable import excerpt
from flexbearing.report.picture import NUMBERS, plain_grid, titled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LABELLED = 16  # lines at most that the legend names
STYLES = "o-", "s-.", "^:"  # one after the other, each with all colours
WIDE = 100  # highest over lowest value from which a panel is logarithmic
LONGEST = 100  # characters of a label: longer ones leave no place for the axes
LONG = 30  # characters of a label from which the legend has two columns
COLOURS = 10  # of lines, before they come again
MARKERS = ("0.2", "D", 6.5), ("0.45", "X", 9.0)  # grey, form and size of printed points, one after the other
AZIMUTH = "azimuth [deg]"  # label of an x around the bearing
EVEN = 1e-6  # by how much ratios of a logarithmic range differ


@dataclass(frozen=True)
class Line:
    """Points that belong together, in the order of x."""

    label: str
    x: Sequence[Any]  # numbers or texts
    y: Sequence[float]  # NaN where there is none
    rigid: Sequence[float] | None = None  # the same between rigid raceways, drawn dashed
    joined: bool = True  # else points alone


@dataclass(frozen=True)
class Printed:
    """A number from elsewhere: a point, a level across the panel where x is not known, or a range."""

    label: str
    low: float
    high: float
    x: Any = None


@dataclass(frozen=True)
class Panel:
    """The lines of one output."""

    label: str  # name and unit
    lines: tuple[Line, ...]
    printed: tuple[Printed, ...] = ()
    linear: bool = False  # never logarithmic, as loads are not, which are next to nothing outside their zone


def draw_lines(title: str, label: str, panels: Sequence[Panel]) -> Figure:
    """Draw panels below each other over the same x."""
    from matplotlib.figure import Figure  # a second to load: only pictures pay for it
    from matplotlib.ticker import MultipleLocator

    entries = max(len(panel.lines) for panel in panels)
    height = 1.6 + 2.6 * len(panels) + (2.5 if entries > COLOURS else 0.0)
    figure = Figure(figsize=(7.0, height), layout="constrained")
    rows = figure.subplots(len(panels), sharex=True, squeeze=False)[:, 0]
    for axes, panel in zip(rows, panels, strict=True):
        _draw(axes, panel)
    rows[-1].set_xlabel(label)
    if label == AZIMUTH:
        rows[-1].xaxis.set_major_locator(MultipleLocator(60))
    figure.suptitle(titled(title, 70), fontsize=11, parse_math=False)
    handles, labels = rows[0].get_legend_handles_labels()
    if len(labels) > 1:
        columns, size = (2, 8.5) if max(map(len, labels)) > LONG else (3, 10.0)
        figure.legend(
            handles[:LABELLED],
            labels[:LABELLED],
            loc="outside lower center",
            ncols=columns,
            fontsize=size,
            frameon=False,
        )
    return figure


def _draw(axes: Axes, panel: Panel) -> None:
    for number, line in enumerate(panel.lines):
        style = STYLES[number // COLOURS % len(STYLES)] if line.joined else "o"
        label = excerpt(line.label, LONGEST) or ("flexible" if line.rigid is not None else "")
        (drawn,) = axes.plot(line.x, line.y, style, markersize=3.5, linewidth=1.6, label=label)
        if line.rigid is not None:
            style = "--" if line.joined else "x"
            axes.plot(line.x, line.rigid, style, color=drawn.get_color(), linewidth=1.2, markersize=4)
    if any(line.rigid is not None for line in panel.lines):
        axes.plot([], [], "--", color="0.4", linewidth=1.2, label="rigid raceways")
    _draw_printed(axes, panel.printed)
    axes.set_ylabel(excerpt(panel.label.replace("_", " "), LONGEST))
    if _is_wide(panel) and not panel.linear:
        axes.set_yscale("log")
    if all(_is_geometric(line.x) for line in panel.lines):
        axes.set_xscale("log")
    plain_grid(axes)
    for axis, scale in ((axes.xaxis, axes.get_xscale()), (axes.yaxis, axes.get_yscale())):
        if scale == "linear" and not axis.have_units():
            axis.set_major_formatter(NUMBERS)


def _draw_printed(axes: Axes, printed: Sequence[Printed]) -> None:
    """Draw printed numbers in grey, named above the panel."""
    shown: list[Any] = []
    for number, each in enumerate(printed):
        half = (each.high - each.low) / 2
        grey, form, size = MARKERS[number % len(MARKERS)]
        if each.x is not None:
            bar = axes.errorbar([each.x], [each.low + half], [half] if half else None, fmt=form, capsize=4)
            bar.lines[0].set(color=grey, markersize=size, markeredgecolor="white", zorder=5)
            shown.append(bar)
        elif half:
            shown.append(axes.axhspan(each.low, each.high, color=grey, alpha=0.18, linewidth=0))
        else:
            shown.append(axes.axhline(each.low, color=grey, linestyle=":", linewidth=1.6))
    if shown:
        axes.legend(
            shown,
            [excerpt(each.label, LONGEST) for each in printed],
            loc="lower right",
            bbox_to_anchor=(1.0, 1.0),
            ncols=2,
            fontsize=8,
            frameon=False,
            borderaxespad=0.1,
        )


def _is_wide(panel: Panel) -> bool:
    """Whether values above zero span more than two decades."""
    drawn = [each for line in panel.lines for each in (line.y, line.rigid) if each is not None]
    values = np.concatenate(drawn)
    values = values[np.isfinite(values)]
    return bool(len(values) and values.min() > 0 and values.max() > WIDE * values.min())


def _is_geometric(values: Sequence[Any]) -> bool:
    """Whether values are those of a logarithmic range."""
    if len(values) < 3 or isinstance(values[0], str) or min(values) <= 0:
        return False
    ratios = np.divide(values[1:], values[:-1])
    return bool(ratios[0] > 1 and np.ptp(ratios) < EVEN * ratios[0])
