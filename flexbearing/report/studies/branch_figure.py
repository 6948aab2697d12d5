"""Picture of the cage slip over load or speed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from flexbearing.quantities.roller import CAGE_SLIP
from flexbearing.report.axes_look import NUMBERS, plain_grid
from flexbearing.report.picture import set_heading
from flexbearing.report.roller.figures import BLUE, ORANGE

if TYPE_CHECKING:
    from matplotlib.figure import Figure


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
