"""Picture of the stresses below the most pressed contact of each raceway."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.quantities.reductions import RACES
from flexbearing.quantities.units import MPA, UM
from flexbearing.report.picture import set_heading

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

LEVELS = 12  # colours, at most


def subsurface(values: Mapping[str, NDArray], title: str, what: str) -> Figure:
    """Draw von Mises and orthogonal shear stress in the plane of rolling."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import MaxNLocator

    figure = Figure(figsize=(9.0, 5.9), layout="constrained")
    set_heading(figure, title, f"Stresses below the most pressed contacts, {what}; the contact in black", 90)
    panels: Any = figure.subplots(2, 2, sharex="col", sharey="col")
    rows = (
        ("subsurface_von_mises", "YlOrRd", "von Mises stress [MPa]"),
        ("subsurface_shear", "RdBu_r", "orthogonal shear stress [MPa]"),
    )
    for row, (name, colours, words) in zip(panels, rows, strict=True):
        largest = MPA.scale * float(np.abs(values[name]).max()) or 1.0
        levels = np.array(MaxNLocator(LEVELS).tick_values(-largest if "shear" in name else 0.0, largest))
        for race, axes in enumerate(row):
            filled = _draw(axes, values, name, race, levels, colours)
        figure.colorbar(filled, ax=row, label=words, format="{x:,.0f}")
    for race, axes in enumerate(panels[0]):
        size, depth = MPA.scale * values["von_mises_stress"][race], UM.scale * values["von_mises_depth"][race]
        axes.set_title(f"{RACES[race]} raceway: {size:,.0f} MPa, {depth:.0f} µm deep", fontsize=10)
        place = np.unravel_index(
            values["subsurface_von_mises"][race].argmax(), values["subsurface_von_mises"][race].shape
        )
        axes.plot(UM.scale * values["subsurface_position"][race][place[1]], depth, "x", color="black")
    for race, axes in enumerate(panels[1]):
        size, depth = (values[f"orthogonal_shear_{each}"][race] for each in ("stress", "depth"))
        words = f"amplitude {MPA.scale * size:,.0f} MPa, {UM.scale * depth:.0f} µm deep"
        axes.set_title(words, fontsize=10)
        axes.set_xlabel("in the rolling direction [µm]")
    for row in panels:
        row[0].set_ylabel("depth [µm]")
    return figure


def _draw(
    axes: Any, values: Mapping[str, NDArray], name: str, race: int, levels: NDArray, colours: str
) -> Any:
    along, depth = (UM.scale * values[f"subsurface_{each}"][race] for each in ("position", "depth"))
    filled = axes.contourf(along, depth, MPA.scale * values[name][race], levels, cmap=colours)
    half = UM.scale * values["contact_half_width"][race]
    axes.plot([-half, half], [0, 0], color="black", linewidth=3, solid_capstyle="butt", clip_on=False)
    axes.set_aspect("equal")
    axes.set_ylim(depth[-1], 0)
    return filled
