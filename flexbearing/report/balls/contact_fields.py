"""Pictures of the shear stress over the contacts of one ball."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from flexbearing.report.picture import titled
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

ARROWS = (23, 7)  # at most, across and along a contact


class DrawnContact(NamedTuple):
    """One contact of the ball that is drawn."""

    title: str
    semi_axes: tuple[float, float]  # [m] across and along the rolling direction
    places: np.ndarray  # (2, ...) [m] across and along it
    shear: np.ndarray  # (2, ...) [Pa] across and along it
    stick: np.ndarray | None  # where the surfaces stick; None in full sliding


def drawn_contact(values: Any, name: str, contact: tuple[int, ...], field: tuple[int, ...]) -> DrawnContact:
    """Take a contact from the arrays of a result.

    Parameters
    ----------
    values : mapping
        arrays of a ball bearing
    name : str
        of the contact
    contact : tuple of int
        where it stands among all contacts
    field : tuple of int
        where it stands among those with fields

    Returns
    -------
    DrawnContact
    """
    angle = np.degrees(values["contact_angle"][contact])
    return DrawnContact(
        f"{name}: {values['contact_load'][contact]:,.0f} N, {angle:.2f}°, "
        f"{1e-6 * values['peak_pressure'][contact]:,.0f} MPa",
        (float(values["semi_axis_across"][contact]), float(values["semi_axis_along"][contact])),
        np.array([values["field_across"][field], values["field_along"][field]]),
        np.array([values["shear_across"][field], values["shear_along"][field]]),
        values["field_stick"][field] if "field_stick" in values else None,
    )


def shear_figure(result: Result, ball: int, contacts: list[DrawnContact]) -> Figure:
    """Draw the shear stress on a ball: its size in colours, its direction in arrows, stick hatched.

    Parameters
    ----------
    result : Result
        what the run left behind
    ball : int
        its number
    contacts : list of DrawnContact
        those that carry load

    Returns
    -------
    matplotlib.figure.Figure
        one panel for each contact, to scale
    """
    heights = [each.semi_axes[1] / each.semi_axes[0] for each in contacts]  # over their widths
    largest = max((1e-6 * float(np.hypot(*each.shear).max()) for each in contacts), default=1.0)
    figure, panels = _panels(result, f"Shear stress on ball {ball} and its direction", heights)
    field = None
    for axes, contact in zip(panels, contacts, strict=False):
        field = _draw_shear(axes, contact, largest)
        if contact.stick is not None:
            _draw_stick(axes, contact.places, contact.stick)
        axes.set_title(contact.title, fontsize=9)
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


def _draw_shear(axes: Axes, contact: DrawnContact, largest: float) -> Any:
    """Size in colours, cut at the edge of the contact, and direction in arrows."""
    from matplotlib.patches import Ellipse

    (across, along), shear = 1e3 * contact.places, contact.shear
    size = np.hypot(*shear)
    levels = np.linspace(0, 1.0001 * largest, 41)
    field = axes.contourf(across, along, 1e-6 * size, levels, cmap="YlOrRd")
    width, height = (2e3 * semi_axis for semi_axis in contact.semi_axes)
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


def _draw_stick(axes: Axes, places: np.ndarray, stick: np.ndarray) -> None:
    """Hatch where the surfaces stick."""
    if stick.any():
        across, along = 1e3 * places
        axes.contour(across, along, stick, [0.5], colors="tab:blue", linewidths=1.0)
        axes.contourf(across, along, stick, [0.5, 1.5], colors="none", hatches=["////"])


def _thinned(points: int, most: int) -> np.ndarray:
    """Evenly spaced places among so many points, the middle one of an odd number included."""
    step = max(1, -(-(points - 1) // (most + 1)))
    return np.arange((points - 1) // 2 % step, points, step)
