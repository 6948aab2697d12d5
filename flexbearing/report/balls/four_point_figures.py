"""Pictures of a slow ball bearing."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.quantities.reductions import RACES
from flexbearing.report.balls.contact_fields import DrawnBall, drawn_contact, require_cells, torque_words
from flexbearing.report.balls.contact_sheet import ball_sheet
from flexbearing.report.html.figures import around
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import METRIC
from flexbearing.report.panels import picture
from flexbearing.report.subsurface_figure import subsurface
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure

WHAT = "Contact loads and angles"
LOADS = {"contact load": ("contact_load",), "contact angle": ("contact_angle",)}


def stacked(result: Result, what: str, wanted: dict[str, tuple[str, ...]]) -> Figure:
    """A titled figure with panels above each other, by the titles of their quantities."""
    reader = Reader(result, METRIC)
    found = (around(reader, title, names, "ball_azimuth") for title, names in wanted.items())
    drawn = [figure for figure in found if figure]
    return picture(reader.attributes["title"], what, drawn, size=(7.0, 2.5))


_TORQUES = {
    "torque of a ball": ("ball_torque",),
    "spin torque": ("spin_torque",),
    "roll torque": ("roll_torque",),
    "ball speed / ring speed": ("ball_speed_ratio",),
    "axis angle": ("ball_attitude",),
}


def pictures(result: Result) -> dict[str, Figure]:
    """Draw every picture of a slow bearing, by the name of its file."""
    if not result.rigid:
        return {}
    figures = {}
    values, rings = _last(result), "elastic rings" if result.flexible else "rigid rings"
    last = replace(result, rigid=values, flexible={})
    if "ring_load" in result.rigid:
        together = f"Torque of each ball, together {values['torque'][0]:,.4g} N m on the inner ring"
        figures["ball_loads"] = stacked(last, WHAT, LOADS)
        figures["ball_torques"] = stacked(last, together, _TORQUES)
    if result.flexible:
        figures["rigid_and_elastic_rings"] = stacked(result, f"{WHAT}, rigid and elastic rings", LOADS)
    if "subsurface_von_mises" in values:
        figures["subsurface"] = subsurface(values, result.attributes["title"], rings)
    for ball in balls(result):
        figures[f"contacts_of_ball_{ball.number}"] = ball_sheet(result, ball)
    return figures


def _last(result: Result) -> Any:
    """The block of elastic rings, else of rigid ones."""
    return result.flexible or result.rigid


def balls(result: Result) -> tuple[DrawnBall, ...]:
    """Take the chosen balls with the cells of their contacts; raises `BadResult` where nothing was solved."""
    values = _last(result)
    require_cells(result, values)
    return tuple(_ball(values, place, int(ball)) for place, ball in enumerate(values["field_ball"]))


def _ball(values: Any, place: int, ball: int) -> DrawnBall:
    """One of the chosen balls, with its loaded contacts."""
    width = np.ptp(values["field_across"][place], axis=(2, 3))
    contacts = {
        (f"diagonal {diagonal + 1}", f"{RACES[race]} race"): drawn_contact(
            values, (ball, diagonal, race), (place, diagonal, race)
        )
        for diagonal, race in np.ndindex(width.shape)
        if width[diagonal, race] > 0
    }
    error = values["grid_error"][ball] if "grid_error" in values else None
    return DrawnBall(
        ball, torque_words("torque of the ball", values["ball_torque"][ball, 0], error), contacts
    )
