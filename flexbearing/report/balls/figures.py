"""Pictures of a ball bearing, slow or fast."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.quantities.angular_contact import DRY_TORQUE, LAYOUT
from flexbearing.quantities.reductions import RACES
from flexbearing.report.balls.contact_fields import DrawnBall, drawn_contact, require_cells, torque_words
from flexbearing.report.balls.contact_sheet import ball_sheet
from flexbearing.report.figure import COLOURS, Axis, Figure, Line, Rule
from flexbearing.report.html.figures import around
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import METRIC
from flexbearing.report.panels import convergence_picture, picture
from flexbearing.report.subsurface_figure import subsurface
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Page

WHAT = "Contact loads and angles"
LOADS = {"contact load": ("contact_load",), "contact angle": ("contact_angle",)}
_TORQUES = {
    "torque of a ball": ("ball_torque",),
    "spin torque": ("spin_torque",),
    "roll torque": ("roll_torque",),
    "ball speed / ring speed": ("ball_speed_ratio",),
    "axis angle": ("ball_attitude",),
}


def stacked(result: Result, what: str, wanted: dict[str, tuple[str, ...]]) -> Page:
    """A titled figure with panels above each other, by the titles of their quantities."""
    reader = Reader(result, METRIC)
    found = (around(reader, title, names, "ball_azimuth") for title, names in wanted.items())
    drawn = [figure for figure in found if figure]
    return picture(reader.attributes["title"], what, drawn, size=(7.0, 2.5))


def pictures(result: Result) -> dict[str, Page]:
    """Draw every picture that the quantities of a result allow, by the name of its file."""
    if not result.rigid:
        return {}
    values, figures = result.flexible or result.rigid, {}
    last = replace(result, rigid=values, flexible={})
    if "ring_load" in values:  # else the loads of the contacts are given
        figures["ball_loads"] = stacked(last, WHAT, LOADS)
    if "ring_load" in values and "ball_torque" in values:
        together = f"Torque of each ball, together {values['torque'][0]:,.4g} N m on the inner ring"
        figures["ball_torques"] = stacked(last, together, _TORQUES)
    if result.flexible:
        figures["rigid_and_elastic_rings"] = stacked(result, f"{WHAT}, rigid and elastic rings", LOADS)
    figures |= {"convergence": drawn} if (drawn := convergence_picture(Reader(result, METRIC))) else {}
    if "line_count" in values:
        figures |= {"rolling_lines": rolling_lines(last), "slip_profiles": slip_profiles(last)}
    if "subsurface_von_mises" in values:
        rings = "elastic rings" if result.flexible else "rigid rings"
        figures["subsurface"] = subsurface(values, result.attributes["title"], rings)
    for ball in balls(result) if "field_ball" in values else ():
        figures[f"contacts_of_ball_{ball.number}"] = ball_sheet(result, ball)
    return figures


def balls(result: Result) -> tuple[DrawnBall, ...]:
    """Take the balls whose cells are stored; raises `BadResult` where there are none.

    Of a fast bearing it is the one that carries most, of a slow one those that were chosen.
    """
    values = result.flexible or result.rigid
    require_cells(result, values)
    if np.ndim(values["field_ball"]):
        return tuple(_slow_ball(values, place, int(ball)) for place, ball in enumerate(values["field_ball"]))
    ball = int(values["field_ball"])
    contacts = {
        ("", f"{name} race"): drawn_contact(values, (race, ball), (race,)) for race, name in enumerate(RACES)
    }
    error = values["grid_error"].sum() if "grid_error" in values else None
    return (DrawnBall(ball, torque_words(DRY_TORQUE, float(values["friction_torque"]), error), contacts),)


def _slow_ball(values: Mapping[str, Any], place: int, ball: int) -> DrawnBall:
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
    words = torque_words("torque of the ball", values["ball_torque"][ball, 0], error)
    return DrawnBall(ball, words, contacts)


def rolling_lines(result: Result) -> Page:
    """Draw the places of the pure rolling lines of every ball, and the edges of the contacts."""
    reader = Reader(result, METRIC)
    drawn = around(reader, "place of pure rolling x/a", ("first_line", "second_line"), "ball_azimuth")
    assert drawn
    edges = (Rule(place, level=True, name="edges of the contact", dash="dash") for place in (-1.0, 1.0))
    figure = replace(drawn, items=(*drawn.items, *edges))
    return picture(reader.attributes["title"], "Places of pure rolling", [figure])


def slip_profiles(result: Result) -> Page:
    """Draw the slip across the middle of the contacts of the heaviest and of the lightest ball."""
    values = result.rigid
    both = np.flatnonzero(np.isfinite(values["line_count"]).all(0))
    load = values["contact_load"][0][both]
    chosen = [int(both[load.argmax()]), int(both[load.argmin()])]
    if np.ptp(load) <= 1e-9 * load.max():
        chosen = chosen[:1]
    x = Axis("x/a, positive towards smaller contact angles", ends=(-1, 1))
    figures = [
        Figure("slip", f"{name} race", x, Axis("slip [mm/s]"), _slip(result, race, chosen))
        for race, name in enumerate(RACES)
    ]
    what = "Slip of the ball on the race across the contact, places of pure rolling marked"
    return picture(result.attributes["title"], what, figures, size=(7.0, 2.5))


def _slip(result: Result, race: int, balls: list[int]) -> tuple[Line | Rule, ...]:
    """Slip of some balls, with the places of pure rolling."""
    values, lines = result.rigid, []
    for ball, colour in zip(balls, COLOURS, strict=False):
        slip = LAYOUT["slip_profile"].for_people(values["slip_profile"][race, ball]).tolist()
        label = f"ball {ball} at {np.degrees(values['ball_azimuth'][ball]):.0f}°"
        lines.append(Line(values["slip_position"].tolist(), slip, label, colour, mark=""))
        marks = (("second", "circle-open"), ("first", "square"))
        for name, mark in marks[: int(values["line_count"][race, ball])]:
            place = float(values[f"{name}_line"][race, ball])
            lines.append(Line([place], [0.0], "", colour, "", mark, 7.0))
    return (*lines, Rule(0.0, level=True))
