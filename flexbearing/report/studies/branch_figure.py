"""Picture of the cage slip along a branch of equilibria."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from flexbearing.quantities.roller import CAGE_SLIP
from flexbearing.report.figure import BLUE, DARK, ORANGE, Axis, Figure, Line
from flexbearing.report.panels import picture

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Page


def draw_branch(
    title: str, label: str, table: dict[str, np.ndarray], raceways: str = "rigid raceways"
) -> Page:
    """Draw the slip over load or speed: solid where it is stable, dashed where not, folds marked."""
    along, slip = next(iter(table.values())), CAGE_SLIP.for_people(table[CAGE_SLIP.name])
    stable, fold = table["stable"].astype(bool), table["fold"].astype(bool)
    lines = []
    # A fold belongs to the lines on both of its sides.
    for kept, dash, name in ((stable, "solid", "stable"), (~stable & ~fold, "dash", "unstable")):
        joined = kept | (fold & (np.roll(kept, 1) | np.roll(kept, -1)))
        if kept.any():
            colour = BLUE if dash == "solid" else ORANGE
            lines.append(
                Line(along.tolist(), np.where(joined, slip, np.nan).tolist(), name, colour, dash, "")
            )
    if fold.any():
        lines.append(Line(along[fold].tolist(), slip[fold].tolist(), "fold", DARK, "", "circle"))
    x, y = (
        Axis(words, "log" if (values > 0).all() else "linear")
        for words, values in ((label, along), (CAGE_SLIP.axis_label, slip))
    )
    return picture(title, f"Cage slip, {raceways}", [Figure("branch", "cage slip", x, y, tuple(lines))])
