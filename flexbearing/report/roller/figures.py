"""Pictures of a roller bearing."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from flexbearing.report.html import elements
from flexbearing.report.html.figures import around, deviations
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import METRIC
from flexbearing.report.panels import convergence_picture, picture
from flexbearing.report.roller.pressure_figures import pressure_along, whole_roller
from flexbearing.report.subsurface_figure import subsurface
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PLACES = ("roller_azimuth", "slice_position")
NOWHERE = "places of rollers or slices are not finite"


def pictures(result: Result) -> dict[str, Figure | str]:
    """Draw every picture of a roller bearing, by the name of its file."""
    reader = Reader(replace(result, flexible={}) if _nothing_flexible(result) else result, METRIC)
    title, blocks, shown = reader.attributes["title"], reader.blocks, result.family.report().elements
    if not blocks or shown is None:
        return {}
    last = blocks[reader.last]
    rings = f"{reader.last} rings"
    placed = all(np.isfinite(values[place]).all() for values in blocks.values() for place in PLACES)
    loads = around(reader, "contact load", ("inner_load", "outer_load"), "roller_azimuth")
    solved, bent = convergence_picture(reader), deviations(reader)
    drawn: dict[str, Figure | str] = {
        "roller_loads": picture(title, "Contact loads of the rollers", [loads]) if loads else NOWHERE,
        "convergence": solved or _no_iterations(result),
        "raceway_deviation": picture(title, _sentence(bent.title), [bent]) if bent else _rigid(result),
        "pressure_map": picture(
            title, f"Contact pressure along the rollers, {rings}", elements.maps(reader, shown)
        ) if placed else NOWHERE,
        "pressure_along": pressure_along(blocks, title) if placed else NOWHERE,
    }  # fmt: skip
    if "subsurface_von_mises" in last:
        drawn["subsurface"] = subsurface(last, title, rings)
    if "whole_roller_pressure" in last:
        drawn["whole_roller"] = whole_roller(last, title)
    return drawn


def tapered_pictures(result: Result) -> dict[str, Figure | str]:
    """Draw every picture of a tapered roller bearing, by the name of its file."""
    reader = Reader(result, METRIC)
    title, blocks, shown = reader.attributes["title"], reader.blocks, result.family.report().elements
    if not blocks or shown is None:
        return {}
    wanted = {"contact load": ("inner_load", "outer_load"), "rib load": ("rib_load",)}
    found = (around(reader, label, names, "roller_azimuth") for label, names in wanted.items())
    maps = elements.maps(reader, shown)
    return {
        "roller_loads": picture(
            title, "Contact loads of the rollers", [each for each in found if each], size=(7.0, 2.5)
        ),
        "pressure_map": picture(title, "Contact pressure along the rollers", maps),
        "pressure_along": pressure_along(blocks, title),
    }


def _sentence(title: str) -> str:
    return title[:1].upper() + title[1:]


def _nothing_flexible(result: Result) -> bool:
    """Whether no part is flexible: both states are the same, nothing was iterated."""
    return bool(result.flexible) and not result.attributes["iterations"]


def _no_iterations(result: Result) -> str:
    if _nothing_flexible(result):
        return "no part is flexible, so no iterations"
    return "the result contains no iterations" if result.attributes["iterations"] else "no iterations"


def _rigid(result: Result) -> str:
    return "no part is flexible" if _nothing_flexible(result) else "the flexible state was not solved"
