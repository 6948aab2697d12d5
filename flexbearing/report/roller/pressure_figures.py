"""Pictures of the contact pressure along the rollers, by slices and on half-spaces."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.quantities.reductions import RACES, loaded
from flexbearing.quantities.roller import LAYOUT
from flexbearing.report.picture import NUMBERS, plain, set_heading

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    Block = Mapping[str, NDArray]


MARGIN = 0.04  # of the length, drawn beyond the edges of the rollers
ASIDE = 1.5  # pitches, drawn beyond the loaded rollers
COLOURS = {"rigid": "#0072B2", "flexible": "#D55E00"}


def pressure_map(values: Block, title: str, what: str) -> Figure:
    """Draw the pressure of every slice of all loaded rollers, at both raceways."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import MaxNLocator

    figure = Figure(figsize=(9.0, 5.2), layout="constrained")
    set_heading(figure, title, f"Contact pressure along the rollers, {what}; edges dashed, x the largest", 90)
    panels: Any = figure.subplots(1, 2, sharex=True, sharey=True)
    largest = max(float(pressure_of(values, race).max()) for race in RACES)
    largest = largest if largest > 0.0 else 1.0
    for axes, race in zip(panels, RACES, strict=True):
        mesh = _draw_map(axes, values, race, largest)
        axes.set_xlabel("along the roller [mm]")
    panels[0].set_ylabel("azimuth of the roller [deg]")
    panels[0].yaxis.set_major_locator(MaxNLocator(9, steps=[1, 1.5, 3, 4.5, 9, 10]))
    figure.colorbar(mesh, ax=panels, label="contact pressure [MPa]", format=NUMBERS)
    return figure


def pressure_along(blocks: Mapping[str, Block], title: str) -> Figure:
    """Draw the pressure along the most pressed roller of each raceway."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9.0, 4.4), layout="constrained")
    set_heading(figure, title, "Contact pressure along the most pressed roller; edges dashed", 90)
    panels: Any = figure.subplots(1, 2, sharex=True, sharey=True)
    for axes, race in zip(panels, RACES, strict=True):
        for name, values in blocks.items():
            _draw_along(axes, values, race, name)
        axes.set(title=f"{race} raceway", xlabel="along the roller [mm]")
        plain(axes)
        axes.legend(frameon=False, fontsize=9)
    panels[0].set_ylabel("contact pressure [MPa]")
    panels[0].set_ylim(bottom=0, top=1.08 * panels[0].get_ylim()[1])
    return figure


def pressure_of(values: Block, race: str) -> NDArray:
    """Pressures (Z, K) of a raceway in the unit for people; zero where no number is finite."""
    name = f"{race}_pressure"
    return np.nan_to_num(LAYOUT[name].for_people(values[name]), nan=0.0, posinf=0.0)


def _borders(values: Block) -> NDArray:
    """Borders of the slices (K + 1), the outermost ones being the edges of the roller [mm]."""
    places = LAYOUT["slice_position"].for_people(values["slice_position"])
    width = places[1] - places[0]
    return np.append(places - width / 2, places[-1] + width / 2)


def _draw_map(axes: Axes, values: Block, race: str, largest: float) -> Any:
    pressure, borders = pressure_of(values, race), _borders(values)
    worst, slice_ = np.unravel_index(pressure.argmax(), pressure.shape)
    degrees, pitch = np.degrees(values["roller_azimuth"]), 360 / len(pressure)
    centre = (degrees[worst] + 180) % 360 - 180
    degrees = centre + (degrees - degrees[worst] + 180) % 360 - 180  # the worst roller amid the others
    order = np.argsort(degrees)
    rows = np.append(degrees[order] - pitch / 2, degrees[order[-1]] + pitch / 2)
    shown = np.ma.masked_less_equal(pressure[order], 0.01 * largest)
    mesh = axes.pcolormesh(borders, rows, shown, cmap="viridis", vmin=0, vmax=largest, rasterized=True)
    carrying = degrees[loaded(values[f"{race}_load"])]
    axes.set_ylim(
        max(carrying.min(initial=centre) - (0.5 + ASIDE) * pitch, rows[0]),
        min(carrying.max(initial=centre) + (0.5 + ASIDE) * pitch, rows[-1]),
    )
    axes.plot((borders[slice_] + borders[slice_ + 1]) / 2, centre, "x", color="#D55E00", markersize=8)
    _draw_edges(axes, borders)
    axes.set_title(f"{race} raceway, largest {pressure.max():,.0f} MPa at {centre:.1f}°", fontsize=10)
    return mesh


def _draw_along(axes: Axes, values: Block, race: str, name: str) -> None:
    pressure, borders = pressure_of(values, race), _borders(values)
    worst = int(pressure.max(axis=1).argmax())
    style = {"color": COLOURS["flexible" if name == "flexible" else "rigid"], "linewidth": 1.3}
    words = f"{name}, {pressure[worst].max():,.0f} MPa"
    if "whole_roller" in values and int(values["whole_roller"]) == worst:
        along = LAYOUT["whole_roller_position"].for_people(values["whole_roller_position"])
        fine = LAYOUT["whole_roller_pressure"].for_people(values["whole_roller_pressure"])
        axes.plot(along, fine[RACES.index(race)].max(axis=0), label=f"{words}, half-spaces", **style)
        pressure[worst] = _by_slices(values, race)[worst]
        style |= {"linestyle": ":"}
        words = f"{name}, by slices alone"
    axes.stairs(pressure[worst], borders, label=words, **style)
    _draw_edges(axes, borders)


def _by_slices(values: Block, race: str) -> NDArray:
    """Pressures (Z, K) of slices alone beside half-spaces, by the root of their loads [MPa]."""
    name, load = "sliced_peak_pressure", values[f"{race}_slice_load"]
    largest = LAYOUT[name].for_people(values[name][RACES.index(race)])
    return largest * np.sqrt(load / load.max())


def _draw_edges(axes: Axes, borders: NDArray) -> None:
    for edge in (borders[0], borders[-1]):
        axes.axvline(edge, color="0.3", linestyle="--", linewidth=0.9)
    aside = MARGIN * (borders[-1] - borders[0])
    axes.set_xlim(borders[0] - aside, borders[-1] + aside)


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
