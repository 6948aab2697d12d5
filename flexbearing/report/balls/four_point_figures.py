"""Pictures of a slow ball bearing."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.quantities.reductions import RACES, loaded
from flexbearing.report.balls.contact_fields import DrawnBall, drawn_contact, require_cells, torque_words
from flexbearing.report.balls.contact_sheet import ball_sheet
from flexbearing.report.balls.panels import STYLES, around, close_ring, stacked
from flexbearing.report.picture import require_span
from flexbearing.report.subsurface_figure import subsurface
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def pictures(result: Result) -> dict[str, Figure]:
    """Draw every picture of a slow bearing, by the name of its file."""
    if not result.rigid:
        return {}
    figures = {}
    if "ring_load" in result.rigid:
        figures |= {"ball_loads": ball_loads(result), "ball_torques": ball_torques(result)}
    if result.flexible:
        figures["rigid_and_elastic_rings"] = compared_loads(result)
    last, rings = _last(result), "elastic rings" if result.flexible else "rigid rings"
    if "subsurface_von_mises" in last:
        figures["subsurface"] = subsurface(last, result.attributes["title"], rings)
    for ball in balls(result):
        figures[f"contacts_of_ball_{ball.number}"] = ball_sheet(result, ball)
    return figures


def _last(result: Result) -> Any:
    """The block of elastic rings, else of rigid ones."""
    return result.flexible or result.rigid


def ball_loads(result: Result) -> Figure:
    """Draw loads and contact angles of both diagonals around the ring."""
    return _load_figure(result, [("", _last(result), {})])


def compared_loads(result: Result) -> Figure:
    """Draw loads and contact angles of both diagonals around the ring, rigid in dashes."""
    dashes = {"linestyle": "--", "marker": "", "alpha": 0.6}
    return _load_figure(
        result, [("rigid rings, ", result.rigid, dashes), ("elastic rings, ", result.flexible, {})]
    )


def _load_figure(result: Result, states: list[tuple[str, Any, dict[str, Any]]]) -> Figure:
    """Loads and contact angles of end states, each with its name, its arrays and its style."""
    figure, (upper, lower) = stacked(result, "Contact loads and angles at the inner race", 2)
    for name, values, look in states:
        for diagonal in range(values["contact_load"].shape[1]):
            load = values["contact_load"][:, diagonal, 0]
            angle = np.where(loaded(load), np.degrees(values["contact_angle"][:, diagonal, 0]), np.nan)
            style = {**STYLES[diagonal], **look}
            label = f"diagonal {diagonal + 1}, {name}largest {load.max():,.0f} N"
            around(upper, values["ball_azimuth"], load, {**style, "label": label})
            around(lower, values["ball_azimuth"], angle, style)
    upper.set_ylabel("contact load [N]")
    lower.set_ylabel("contact angle [deg]")
    require_span(lower, 1.0)
    close_ring(lower)
    figure.legend(loc="outside lower center", ncols=2, frameon=False, fontsize=8 if len(states) > 1 else None)
    return figure


def ball_torques(result: Result) -> Figure:
    """Draw the torque of every ball and its parts, and how the balls turn."""
    values = _last(result)
    total = values["torque"][0]
    figure, (upper, middle, lower) = stacked(
        result, f"Torque of each ball on the inner ring, together {total:,.4g} N m", 3, 1.9
    )
    azimuth, spin, roll = values["ball_azimuth"], values["spin_torque"][:, 0], values["roll_torque"][:, 0]
    around(upper, azimuth, values["ball_torque"][:, 0], {"color": "0.2", "marker": ".", "label": "total"})
    around(upper, azimuth, spin, {**STYLES[0], "label": "spin"})
    around(upper, azimuth, roll, {**STYLES[1], "label": "roll"})
    around(middle, azimuth, values["ball_speed_ratio"], {"color": "0.2", "marker": "."})
    around(lower, azimuth, np.degrees(values["ball_attitude"]), {"color": "0.2", "marker": "."})
    upper.set_ylabel("torque [N m]")
    middle.set_ylabel("ball speed / ring speed")
    lower.set_ylabel("axis angle [deg]")
    close_ring(lower)
    figure.legend(loc="outside lower center", ncols=3, frameon=False)
    return figure


def balls(result: Result) -> tuple[DrawnBall, ...]:
    """Take the chosen balls with the cells of their contacts.

    Raises
    ------
    BadResult
        where nothing was solved
    """
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
