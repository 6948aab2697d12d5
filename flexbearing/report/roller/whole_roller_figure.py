"""Picture of the most loaded roller on half-spaces: pressure of both contacts, load along it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.quantities.reductions import RACES
from flexbearing.quantities.roller import LAYOUT
from flexbearing.report.axes_look import NUMBERS, plain
from flexbearing.report.picture import set_heading

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

BLUE, ORANGE = "#0072B2", "#D55E00"


def whole_roller(values: Mapping[str, np.ndarray], title: str) -> Figure:
    """Draw pressure and load per length of the roller at both raceways."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9.0, 5.6), layout="constrained")
    set_heading(figure, title, "Most loaded roller: pressure on half-spaces, load along the roller", 90)
    rows: Any = figure.subplots(2, 2, sharex=True)
    for race, name in enumerate(RACES):
        _draw_pressure(figure, rows[race][0], values, race)
        _draw_load(rows[race][1], values, race)
        rows[race][0].set_ylabel(f"{name}: across [mm]")
        rows[race][1].set_ylabel("load per length [kN/m]")
    for axes in rows[1]:
        axes.set_xlabel("along the roller [mm]")
    rows[0][1].legend(frameon=False)
    return figure


def _draw_pressure(figure: Figure, axes: Axes, values: Mapping[str, np.ndarray], race: int) -> None:
    along, across, pressure = (
        LAYOUT[f"whole_roller_{name}"].for_people(values[f"whole_roller_{name}"])
        for name in ("position", "across", "pressure")
    )
    shown = np.ma.masked_equal(pressure[race], 0.0)
    mesh = axes.pcolormesh(along, across[race], shown, cmap="viridis", rasterized=True)
    figure.colorbar(mesh, ax=axes, label="pressure [MPa]", format=NUMBERS)


def _draw_load(axes: Axes, values: Mapping[str, np.ndarray], race: int) -> None:
    place = LAYOUT["slice_position"].for_people(values["slice_position"])
    sliced = values[f"{RACES[race]}_slice_load"][int(values["whole_roller"])]
    whole = values["whole_roller_line_load"][race]
    along = LAYOUT["whole_roller_position"].for_people(values["whole_roller_position"])
    axes.step(place, sliced / 1e3, where="mid", color=BLUE, linewidth=1.2, label="slices")
    axes.plot(along, whole / 1e3, color=ORANGE, linewidth=1.2, label="half-spaces")
    plain(axes)
    axes.set_ylim(bottom=0)
