"""Pictures of a fast angular-contact ball bearing."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.quantities.angular_contact import DRY_TORQUE, LAYOUT
from flexbearing.quantities.reductions import RACES
from flexbearing.report.balls.contact_fields import DrawnBall, drawn_contact, require_cells, torque_words
from flexbearing.report.balls.contact_sheet import ball_sheet
from flexbearing.report.balls.panels import STYLES, around, close_ring, stacked
from flexbearing.report.picture import require_span
from flexbearing.report.subsurface_figure import subsurface
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def pictures(result: Result) -> dict[str, Figure]:
    """Draw every picture of a fast bearing, by the name of its file."""
    if not result.rigid:
        return {}
    figures = {"ball_loads": ball_loads(result)}
    if "line_count" in result.rigid:
        figures |= {"rolling_lines": rolling_lines(result), "slip_profiles": slip_profiles(result)}
    if "subsurface_von_mises" in result.rigid:
        figures["subsurface"] = subsurface(result.rigid, result.attributes["title"], "rigid rings")
    if "field_ball" in result.rigid:
        (ball,) = balls(result)
        figures[f"contacts_of_ball_{ball.number}"] = ball_sheet(result, ball)
    return figures


def balls(result: Result) -> tuple[DrawnBall, ...]:
    """Take the ball that carries most, with the cells of its contacts.

    Raises
    ------
    BadResult
        where no cells are stored
    """
    values = result.rigid
    require_cells(result, values)
    ball = int(values["field_ball"])
    contacts = {
        ("", f"{name} race"): drawn_contact(values, (race, ball), (race,)) for race, name in enumerate(RACES)
    }
    error = values["grid_error"].sum() if "grid_error" in values else None
    return (DrawnBall(ball, torque_words(DRY_TORQUE, float(values["friction_torque"]), error), contacts),)


def ball_loads(result: Result) -> Figure:
    """Draw loads and contact angles of both races around the ring."""
    values = result.rigid
    figure, (upper, lower) = stacked(result, "Contact loads and angles", 2)
    for race, name in enumerate(RACES):
        load = values["contact_load"][race]
        angle = np.where(load > 0, np.degrees(values["contact_angle"][race]), np.nan)
        style = {**STYLES[race], "label": f"{name} race, largest {load.max():,.1f} N"}
        around(upper, values["ball_azimuth"], load, style)
        around(lower, values["ball_azimuth"], angle, STYLES[race])
    upper.set_ylabel("contact load [N]")
    upper.set_ylim(bottom=0)
    lower.set_ylabel("contact angle [deg]")
    require_span(lower, 1.0)
    close_ring(lower)
    figure.legend(loc="outside lower center", ncols=2, frameon=False)
    return figure


def rolling_lines(result: Result) -> Figure:
    """Draw the places of the pure rolling lines of every ball; the grey band lies outside the contact."""
    values = result.rigid
    figure, panels = stacked(result, "Places of pure rolling; outside the contact in grey", 2)
    for race, (axes, name) in enumerate(zip(panels, RACES, strict=True)):
        first, second = values["first_line"][race], values["second_line"][race]
        names = ("second line c2", "first line c1") if race == 0 else (None, None)
        for line, style, label in zip((second, first), STYLES, names, strict=True):
            around(axes, values["ball_azimuth"], line, {**style, "label": label})
        lowest = min(-1.15, 1.1 * float(np.nanmin(first)))
        highest = max(1.15, 1.1 * float(np.nanmax(second)))
        for outside in ((lowest, -1.0), (1.0, highest)):
            axes.axhspan(*outside, color="0.92", linewidth=0)
        axes.set(ylim=(lowest, highest), ylabel=f"x/a, {name} race")
    close_ring(panels[-1])
    figure.legend(loc="outside lower center", ncols=2, frameon=False)
    return figure


def slip_profiles(result: Result) -> Figure:
    """Draw the slip across the middle of the contacts of the heaviest and of the lightest ball."""
    values = result.rigid
    both = np.flatnonzero(np.isfinite(values["line_count"]).all(0))
    load = values["contact_load"][0][both]
    chosen = [int(both[load.argmax()]), int(both[load.argmin()])]
    if np.ptp(load) <= 1e-9 * load.max():
        chosen = chosen[:1]
    figure, panels = stacked(result, "Slip of the ball on the race across the contact, lines marked", 2)
    for race, (axes, name) in enumerate(zip(panels, RACES, strict=True)):
        for ball, style in zip(chosen, STYLES, strict=False):
            label = f"ball {ball} at {np.degrees(values['ball_azimuth'][ball]):.0f}°" if race == 0 else None
            _draw_slip(axes, values, (race, ball), style["color"], label)
        axes.axhline(0, color="0.4", linewidth=0.8)
        axes.set_ylabel(f"slip, {name} race [mm/s]")
    panels[-1].set(xlabel="x/a, positive towards smaller contact angles", xlim=(-1, 1))
    figure.legend(loc="outside lower center", ncols=2, frameon=False)
    return figure


def _draw_slip(axes: Axes, values: Any, contact: tuple[int, int], color: str, label: str | None) -> None:
    axes.plot(
        values["slip_position"],
        LAYOUT["slip_profile"].for_people(values["slip_profile"][contact]),
        color=color,
        label=label,
    )
    first, second = values["first_line"][contact], values["second_line"][contact]
    axes.plot(second, 0, marker="o", markerfacecolor="white", color=color, clip_on=False)
    if values["line_count"][contact] == 2:
        axes.plot(first, 0, marker="s", color=color, clip_on=False)
