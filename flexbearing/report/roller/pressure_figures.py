"""Pictures of the contact pressure along the rollers, by slices and on half-spaces."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from flexbearing.quantities.reductions import RACES
from flexbearing.quantities.roller import LAYOUT
from flexbearing.report.figure import BLUE, ORANGE, Axis, Figure, Line, Map, Rule, stairs
from flexbearing.report.panels import picture

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Page
    from numpy.typing import NDArray

Block = Mapping[str, "NDArray"]
ALONG = "along the roller [mm]"
MARGIN = 0.54  # of the length, drawn on both sides of the middle


def pressure_along(blocks: Mapping[str, Block], title: str) -> Page:
    """Draw the pressure along the most pressed roller of each raceway."""
    y = Axis("contact pressure [MPa]", from_zero=True)
    figures = []
    for race in RACES:
        borders = _borders(next(iter(blocks.values())))
        length = borders[-1] - borders[0]
        lines = [line for name, values in blocks.items() for line in _lines(values, race, name)]
        edges = [Rule(place, dash="dash") for place in (borders[0], borders[-1])]
        x = Axis(ALONG, ends=(-MARGIN * length, MARGIN * length))
        largest = ", ".join(f"{_pressure(values, race).max():,.0f} MPa" for values in blocks.values())
        figures.append(Figure(race, f"{race} raceway, largest {largest}", x, y, (*lines, *edges)))
    what = "Contact pressure along the most pressed roller; edges dashed"
    return picture(title, what, figures, columns=2, size=(4.5, 3.2))


def _pressure(values: Block, race: str) -> NDArray:
    """Pressures (Z, K) of a raceway in the unit for people; zero where no number is finite."""
    name = f"{race}_pressure"
    return np.nan_to_num(LAYOUT[name].for_people(values[name]), nan=0.0, posinf=0.0)


def _borders(values: Block) -> NDArray:
    """Borders of the slices (K + 1), the outermost ones being the edges of the roller [mm]."""
    places = LAYOUT["slice_position"].for_people(values["slice_position"])
    width = places[1] - places[0]
    return np.append(places - width / 2, places[-1] + width / 2)


def _lines(values: Block, race: str, name: str) -> list[Line]:
    """Pressure along the most pressed roller; on half-spaces that of slices alone beside it."""
    pressure, borders = _pressure(values, race), _borders(values)
    worst, lines = int(pressure.max(axis=1).argmax()), []
    sliced, words, dash = pressure[worst], f"{name} rings", "solid"
    colour = ORANGE if name == "flexible" else BLUE
    if "whole_roller" in values and int(values["whole_roller"]) == worst:
        along = LAYOUT["whole_roller_position"].for_people(values["whole_roller_position"])
        fine = LAYOUT["whole_roller_pressure"].for_people(values["whole_roller_pressure"])
        whole = fine[RACES.index(race)].max(axis=0)
        lines.append(Line(along.tolist(), whole.tolist(), f"{words}, half-spaces", colour, mark=""))
        sliced, words, dash = _by_slices(values, race)[worst], f"{words}, by slices alone", "dot"
    return [*lines, Line(*stairs(borders, sliced), words, colour, dash, "")]


def _by_slices(values: Block, race: str) -> NDArray:
    """Pressures (Z, K) of slices alone beside half-spaces, by the root of their loads [MPa]."""
    name, load = "sliced_peak_pressure", values[f"{race}_slice_load"]
    largest = LAYOUT[name].for_people(values[name][RACES.index(race)])
    return largest * np.sqrt(load / load.max())


def whole_roller(values: Block, title: str) -> Page:
    """Draw pressure and load per length of the roller at both raceways."""
    what = "Most loaded roller: pressure on half-spaces, load along the roller"
    figures = [draw(values, race) for race in (0, 1) for draw in (_half_space, _line_load)]
    return picture(title, what, figures, columns=2, size=(4.5, 2.5))


def _half_space(values: Block, race: int) -> Figure:
    along, across, pressure = (
        LAYOUT[f"whole_roller_{name}"].for_people(values[f"whole_roller_{name}"])
        for name in ("position", "across", "pressure")
    )
    shown = np.where(pressure[race] == 0, np.nan, pressure[race]).tolist()
    drawn = Map(along.tolist(), across[race].tolist(), shown, "pressure [MPa]")
    return Figure("pressure", f"{RACES[race]} raceway, pressure", Axis(ALONG), Axis("across [mm]"), (drawn,))


def _line_load(values: Block, race: int) -> Figure:
    along = LAYOUT["whole_roller_position"].for_people(values["whole_roller_position"])
    sliced = values[f"{RACES[race]}_slice_load"][int(values["whole_roller"])]
    whole = values["whole_roller_line_load"][race]
    lines = (
        Line(*stairs(_borders(values), sliced / 1e3), "slices", BLUE, mark=""),
        Line(along.tolist(), (whole / 1e3).tolist(), "half-spaces", ORANGE, mark=""),
    )
    y = Axis("load per length [kN/m]", from_zero=True)
    return Figure("load", f"{RACES[race]} raceway, load", Axis(ALONG), y, lines)
