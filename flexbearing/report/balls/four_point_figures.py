"""Pictures of a slow ball bearing."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.quantities.reductions import RACES, loaded
from flexbearing.report.balls.panels import STYLES, around, close_ring, stacked
from flexbearing.report.picture import titled
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

ARROWS = (23, 7)  # at most, across and along a contact


def pictures(result: Result) -> dict[str, Figure]:
    """Draw every picture of a slow bearing, by the name of its file.

    Parameters
    ----------
    result : Result
        what the run left behind

    Returns
    -------
    dict
        loads and torques around the ring when the ring is loaded, and the contacts of each chosen ball,
        between elastic rings where there are such; then also their loads beside those of rigid rings;
        empty when nothing was solved
    """
    if not result.rigid:
        return {}
    figures = {}
    if "ring_load" in result.rigid:
        figures |= {"ball_loads": ball_loads(result), "ball_torques": ball_torques(result)}
    if result.flexible:
        figures["rigid_and_elastic_rings"] = compared_loads(result)
    for place, ball in enumerate(_last(result)["field_ball"].astype(int)):
        figures[f"contacts_of_ball_{ball}"] = contact_fields(result, place)
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
    close_ring(lower)
    figure.legend(loc="outside lower center", ncols=2, frameon=False, fontsize=8 if len(states) > 1 else None)
    return figure


def ball_torques(result: Result) -> Figure:
    """Draw the torque of every ball and its parts, and how the balls turn."""
    values = _last(result)
    total = values["torque"][0]
    figure, (upper, middle, lower) = stacked(
        result, f"Torque of each ball on the inner ring, together {total:.4g} N m", 3, 1.9
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


def contact_fields(result: Result, place: int = 0) -> Figure:
    """Draw the shear stress on a ball: its size in colours, its direction in arrows.

    Parameters
    ----------
    result : Result
        what the run left behind
    place : int
        which of the chosen balls

    Returns
    -------
    matplotlib.figure.Figure
        one panel for each loaded contact, to scale
    """
    values = _last(result)
    ball = int(values["field_ball"][place])
    load = values["contact_load"][ball]
    width = np.ptp(values["field_across"][place], axis=(2, 3))
    drawn = [contact for contact in np.ndindex(load.shape) if width[contact] > 0]
    shear = np.hypot(values["shear_along"][place], values["shear_across"][place])
    largest = 1e-6 * float(shear.max()) if drawn else 1.0
    along, across = values["semi_axis_along"][ball], values["semi_axis_across"][ball]
    heights = [float(along[contact] / across[contact]) for contact in drawn]  # over their widths
    figure, panels = _panels(result, f"Shear stress on ball {ball} and its direction", heights)
    field = None
    for axes, contact in zip(panels, drawn, strict=False):
        field = _draw_shear(axes, values, (place, *contact), largest)
        if "field_stick" in values:
            _draw_stick(axes, values, (place, *contact))
        diagonal, race = contact
        axes.set_title(
            f"diagonal {diagonal + 1}, {RACES[race]} race: {load[contact]:,.0f} N, "
            f"{np.degrees(values['contact_angle'][ball][contact]):.2f}°, "
            f"{1e-6 * values['peak_pressure'][ball][contact]:,.0f} MPa",
            fontsize=9,
        )
        axes.set_ylabel("rolling [mm]", fontsize=8)
    if field is None:
        panels[0].text(0.5, 0.5, "this ball carries no load", transform=panels[0].transAxes, ha="center")
        return figure
    panels[-1].set_xlabel("across the groove [mm]")
    figure.colorbar(field, ax=panels, label="shear stress [MPa]", fraction=0.03, format="%.0f")
    return figure


def _panels(result: Result, what: str, heights: list[float]) -> tuple[Figure, list[Axes]]:
    from matplotlib.figure import Figure

    width, rows = 8.0, heights or [0.3]
    inches = [0.8 * width * height + 0.75 for height in rows]
    figure = Figure(figsize=(width, sum(inches) + 1.1), layout="constrained")
    heading = f"{titled(result.attributes['title'], 80)}\n{what}"
    figure.suptitle(heading, fontsize=11, parse_math=False)
    grid = figure.subplots(len(rows), 1, squeeze=False, gridspec_kw={"height_ratios": inches})
    return figure, list(grid[:, 0])


def _draw_shear(axes: Axes, values: Any, index: tuple[int, ...], largest: float) -> Any:
    """Size in colours, cut at the edge of the contact, and direction in arrows."""
    from matplotlib.patches import Ellipse

    across, along = 1e3 * values["field_across"][index], 1e3 * values["field_along"][index]
    shear = np.array([values["shear_across"][index], values["shear_along"][index]])
    size = np.hypot(*shear)
    levels = np.linspace(0, 1.0001 * largest, 41)
    field = axes.contourf(across, along, 1e-6 * size, levels, cmap="YlOrRd")
    contact = (int(values["field_ball"][index[0]]), *index[1:])
    width, height = (2e3 * values[f"semi_axis_{name}"][contact] for name in ("across", "along"))
    edge = Ellipse((0, 0), width, height, fill=False, edgecolor="0.4", linewidth=0.8)
    axes.add_patch(edge)
    field.set_clip_path(edge)
    kept = np.zeros(size.shape, bool)
    kept[
        tuple(np.ix_(*(_thinned(points, most) for points, most in zip(size.shape, ARROWS, strict=True))))
    ] = True
    kept &= size > 0
    axes.quiver(
        across[kept],
        along[kept],
        *(shear[:, kept] / size[kept]),
        color="0.15",
        pivot="mid",
        scale=42,
        width=0.0018,
    )
    axes.set_aspect("equal")
    axes.spines[["top", "right"]].set_visible(False)
    axes.tick_params(labelsize=8)
    return field


def _draw_stick(axes: Axes, values: Any, index: tuple[int, ...]) -> None:
    """Hatch where the surfaces stick."""
    stick = values["field_stick"][index]
    if stick.any():
        across, along = 1e3 * values["field_across"][index], 1e3 * values["field_along"][index]
        axes.contour(across, along, stick, [0.5], colors="tab:blue", linewidths=1.0)
        axes.contourf(across, along, stick, [0.5, 1.5], colors="none", hatches=["////"])


def _thinned(points: int, most: int) -> np.ndarray:
    """Evenly spaced places among so many points, the middle one of an odd number included."""
    step = max(1, -(-(points - 1) // (most + 1)))
    return np.arange((points - 1) // 2 % step, points, step)
