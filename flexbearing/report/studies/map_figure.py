"""Pictures of a map: outputs over one or two keys, with folds and limits; the cage slip along a branch."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexbearing.quantities.roller import CAGE_SLIP
from flexbearing.report.picture import NUMBERS, plain_grid, set_heading
from flexbearing.report.roller.figures import BLUE, ORANGE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Contours:
    """Values of an output that are drawn as lines."""

    limits: tuple[float, ...] = ()  # from where, or below which, the bearing is in danger
    levels: tuple[float, ...] = ()  # of what has no limit

    def within(self, values: NDArray) -> Contours:
        """Those that lie between the smallest and the largest value."""
        finite = values[np.isfinite(values)]
        if not finite.size:
            return Contours()
        low, high = finite.min(), finite.max()
        limits, levels = (
            tuple(value for value in each if low < value < high) for each in (self.limits, self.levels)
        )
        return Contours(limits, levels)


LEVELS = 24  # of colours
DECADES = 2.0  # of values from where colours are logarithmic
ABREAST = 2  # panels
LEVEL = {"colors": "white", "linewidths": 0.8}
LIMIT = {"colors": ORANGE, "linewidths": 1.6}


@dataclass(frozen=True)
class Along:
    """An axis of a map."""

    label: str
    values: NDArray  # rising or falling
    logarithmic: bool


@dataclass(frozen=True)
class Field:
    """An output over two keys."""

    heading: str
    values: NDArray  # (x, y), of the stable state with the largest one; NaN where a point is not solved
    contours: Contours


@dataclass(frozen=True)
class MapLines:
    """What is drawn on every field, in units of the axes."""

    several: NDArray  # (x, y) number of stable states
    folds: NDArray  # (n, 2, 2) both ends of each piece, x and y
    unsolved: NDArray  # (n, 2) points without a state


def draw_fields(
    title: str, what: str, x: Along, y: Along, fields: Sequence[Field], lines: MapLines
) -> Figure:
    """Draw outputs over two keys."""
    from matplotlib.figure import Figure  # a second to load: only pictures pay for it
    from matplotlib.patches import Patch

    rows = -(-len(fields) // ABREAST)
    figure = Figure(figsize=(10.0, 1.0 + 3.6 * rows), layout="constrained")
    panels = figure.subplots(rows, ABREAST, squeeze=False).ravel()
    for axes, field in zip(panels, fields, strict=False):
        _draw_field(figure, axes, x, y, field)
        _draw_lines(axes, x, y, lines)
        for axis, along in ((axes.xaxis, x), (axes.yaxis, y)):
            axis.set_major_formatter(NUMBERS)
            axis.set_label_text(along.label)
    for axes in panels[len(fields) :]:
        axes.set_visible(False)
    set_heading(figure, title, what, 90)
    handles, labels = panels[0].get_legend_handles_labels()
    if (lines.several > 1).any():
        handles.append(Patch(facecolor="0.5", edgecolor="white", hatch="//", label="several equilibria"))
        labels.append("several equilibria")
    if handles:
        figure.legend(handles, labels, loc="outside lower center", ncols=3, frameon=False)
    return figure


def _draw_field(figure: Figure, axes: Axes, x: Along, y: Along, field: Field) -> None:
    from matplotlib.colors import LogNorm

    values = np.ma.masked_invalid(field.values.T)
    norm = None
    if values.count() and values.min() > 0 and values.max() > 10**DECADES * values.min():
        norm = LogNorm(values.min(), values.max())
    shown = axes.pcolormesh(
        x.values, y.values, values, norm=norm, cmap="viridis", shading="nearest", rasterized=True
    )
    figure.colorbar(shown, ax=axes, label=field.heading)
    drawn = field.contours.within(field.values)
    for levels, look in ((drawn.levels, LEVEL), (drawn.limits, LIMIT)):
        if levels:
            lines = axes.contour(x.values, y.values, values, sorted(levels), **look)
            axes.clabel(lines, fmt=lambda value: f"{value:g}", fontsize=8)
    axes.set_xscale("log" if x.logarithmic else "linear")
    axes.set_yscale("log" if y.logarithmic else "linear")


def _draw_lines(axes: Axes, x: Along, y: Along, lines: MapLines) -> None:
    from matplotlib.collections import LineCollection

    if (lines.several > 1).any():
        hatched = axes.contourf(
            x.values, y.values, (lines.several > 1).T.astype(float), [0.5, 2.0], colors="none", hatches=["//"]
        )
        hatched.set(edgecolor=(1.0, 1.0, 1.0, 0.5), linewidth=0.0)  # the hatching; folds are black
        axes.add_collection(LineCollection(list(lines.folds), colors="black", linewidths=0.6, label="fold"))
    if len(lines.unsolved):
        axes.plot(*lines.unsolved.T, "x", color="red", markersize=4, label="not converged")


@dataclass(frozen=True)
class StatesOver:
    """An output of S states over one key."""

    heading: str
    values: NDArray  # (S)
    stable: NDArray  # (S) whether each state is stable
    folds: NDArray  # (n) values of the key where stable states end


def draw_states(title: str, what: str, x: Along, states: StatesOver) -> Figure:
    """Draw every state over one key."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.0, 4.6), layout="constrained")
    axes = figure.add_subplot()
    values, stable = states.values, states.stable
    for some, color, name in ((stable, BLUE, "stable"), (~stable, ORANGE, "unstable")):
        if some.any():
            axes.plot(x.values[some], values[some], ".", color=color, markersize=5, label=name)
    for number, fold in enumerate(states.folds):
        axes.axvline(fold, color="0.2", linewidth=0.8, label=None if number else "fold")
    axes.set(xlabel=x.label, ylabel=states.heading, xscale="log" if x.logarithmic else "linear")
    if np.nanmin(values) > 0 and np.nanmax(values) > 10**DECADES * np.nanmin(values):
        axes.set_yscale("log")
    plain_grid(axes)
    set_heading(figure, title, what, 70)
    figure.legend(loc="outside lower center", ncols=3, frameon=False)
    return figure


def draw_branch(
    title: str, label: str, table: dict[str, np.ndarray], raceways: str = "rigid raceways"
) -> Figure:
    """Draw the slip over load or speed: solid where it is stable, dashed where not, folds marked."""
    from matplotlib.figure import Figure  # a second to load: only pictures pay for it

    figure = Figure(figsize=(7.0, 4.6), layout="constrained")
    axes = figure.add_subplot()
    along, slip = next(iter(table.values())), CAGE_SLIP.for_people(table[CAGE_SLIP.name])
    stable, fold = table["stable"].astype(bool), table["fold"].astype(bool)
    # A fold belongs to the lines on both of its sides.
    for kept, style, name in ((stable, "-", "stable"), (~stable & ~fold, "--", "unstable")):
        joined = kept | (fold & (np.roll(kept, 1) | np.roll(kept, -1)))
        shown = np.where(joined, slip, np.nan)
        if kept.any():
            color = BLUE if style == "-" else ORANGE
            axes.plot(along, shown, style, color=color, linewidth=1.6, label=name)
    if fold.any():
        axes.plot(along[fold], slip[fold], "o", color="0.2", markersize=5, label="fold")
    axes.set(xlabel=label, ylabel=CAGE_SLIP.axis_label)
    if (along > 0).all():
        axes.set_xscale("log")
        axes.xaxis.set_minor_formatter(_two_and_five)
        axes.tick_params(axis="x", which="minor", pad=5)  # on one line with the major ones
    if (slip > 0).all():
        axes.set_yscale("log")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(NUMBERS)
    plain_grid(axes)
    axes.grid(color="0.88", linewidth=0.6, which="minor")
    set_heading(figure, title, f"Cage slip, {raceways}", 70)
    figure.legend(loc="outside lower center", ncols=3, frameon=False)
    return figure


def _two_and_five(value: float, _: object) -> str:
    """Label the minor lines 2 and 5 of a decade."""
    leading = round(value / 10 ** np.floor(np.log10(value)))
    return f"{value:,.10g}" if leading in (2, 5) else ""
