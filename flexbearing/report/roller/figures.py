"""Pictures of a roller bearing."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.quantities.reductions import loaded
from flexbearing.quantities.roller import LAYOUT
from flexbearing.report.picture import NUMBERS, plain, set_heading
from flexbearing.report.roller.pressure_figures import pressure_along, pressure_map, whole_roller
from flexbearing.report.subsurface_figure import subsurface
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.projections.polar import PolarAxes

PLACES = ("roller_azimuth", "slice_position")
NOWHERE = "places of rollers or slices are not finite"
# Okabe and Ito (2008): distinguished by colour-blind readers; marks distinguish them in grey
BLUE, ORANGE = "#0072B2", "#D55E00"

NO_LOAD = 1e-100  # [N] that an axis of loads cannot tell from zero

_RIGID = {"color": BLUE, "marker": "o", "markerfacecolor": "white", "markersize": 6}
_FLEXIBLE = {"color": ORANGE, "marker": "s", "markersize": 4.5}


def polar_loads(result: Result) -> Figure:
    """Draw the inner roller loads around the bearing, azimuth zero pointing down."""
    figure = _figure(6.4, 6.6)
    axes: Any = figure.add_subplot(projection="polar")
    drawn = _blocks(result)
    for name, values in drawn.items():
        _draw_loads(axes, name, values)
    loads = np.concatenate([[0.0], *(values["inner_load"] for values in drawn.values())])
    _shape_load_axes(axes, float(loads[np.isfinite(loads)].max()))
    for values in list(drawn.values())[-1:]:
        _mark_load(axes, float(values["load_direction"]))
    _title(figure, result, "Inner roller loads [N], azimuth 0 pointing down")
    axes.set_xlabel("azimuth [deg]" if result.flexible else "the flexible state was not solved", labelpad=14)
    figure.legend(loc="outside lower center", ncols=2, frameon=False)
    return figure


def _draw_loads(axes: PolarAxes, name: str, values: Mapping[str, np.ndarray]) -> None:
    order = np.argsort(values["roller_azimuth"] % (2 * np.pi))
    azimuth, load = values["roller_azimuth"][order], values["inner_load"][order]
    touching = np.flatnonzero(loaded(load))
    style = _FLEXIBLE if name == "flexible" else _RIGID
    axes.vlines(azimuth[touching], 0, load[touching], color=style["color"], linewidth=0.8, alpha=0.5)
    axes.fill(azimuth, load, color=style["color"], alpha=0.12, linewidth=0)
    size = f", largest {load.max():,.0f} N" if np.isfinite(load).all() else ": not finite"
    around = np.append(np.arange(azimuth.size), 0)  # closed
    axes.plot(azimuth[around], load[around], markevery=touching, linewidth=1.2, label=name + size, **style)
    axes.plot(azimuth, 0 * azimuth, linestyle="none", marker=".", color="0.6", markersize=4, clip_on=False)


def _shape_load_axes(axes: PolarAxes, largest: float) -> None:
    axes.set_theta_zero_location("S")
    axes.set_thetagrids(
        range(0, 360, 30),
        [f"{angle}°" if angle <= 180 else f"\N{MINUS SIGN}{360 - angle}°" for angle in range(0, 360, 30)],
    )
    top = 1.12 * largest if largest > NO_LOAD else 1.0
    axes.set_rlim(0, top)
    axes.set_rorigin(-0.3 * top)  # unloaded rollers are on a ring of their own, not in one point
    axes.set_rlabel_position(165)
    axes.set_rticks(_ticks(top))
    axes.yaxis.set_major_formatter(NUMBERS)
    axes.grid(color="0.85", linewidth=0.6)


def _mark_load(axes: PolarAxes, direction: float) -> None:
    """Arrow along the load on the inner ring, about the middle of the axes, of its azimuth [rad]."""
    if not np.isfinite(direction):
        return
    along = 0.08 * np.array([np.sin(direction), -np.cos(direction)])
    axes.annotate(
        "load",
        xy=tuple(0.5 + along),
        xytext=tuple(0.5 - along),
        xycoords="axes fraction",
        ha="center",
        va="center",
        arrowprops={"arrowstyle": "-|>", "color": "0.2", "linewidth": 1.5},
    )


def _ticks(top: float) -> list[float]:
    """Find three to six round numbers below `top`, clear of the rim."""
    decade = 10.0 ** np.floor(np.log10(top))
    step = next(decade * part for part in (0.2, 0.5, 1.0, 2.0) if top < 6 * decade * part)
    return [step * number for number in range(1, int(0.95 * top / step) + 1)]


def convergence(result: Result) -> Figure:
    """Draw load change and residual over the iterations, at least one."""
    figure, axes = _blank()
    histories = {
        "largest change of a roller load / largest load": (result.history("load_change"), BLUE, "o"),
        "largest unbalanced force / applied load": (result.history("residual"), ORANGE, "s"),
    }
    together = np.array([values for values, _, _ in histories.values()])
    floor = _floor(together)
    for label, (values, color, marker) in histories.items():
        _draw_history(axes, values, floor, {"color": color, "marker": marker, "label": label})
    for number in 1 + np.flatnonzero(~np.isfinite(together).all(axis=0)):
        axes.axvline(float(number), color="0.3", linestyle=":", label=f"not finite in iteration {number}")
    axes.set(xlabel="iteration", ylabel="relative size [-]")
    _title(figure, result, f"Convergence ({result.attributes['method']}): {result.attributes['status']}")
    axes.set_yscale("log")
    if not (np.isfinite(together) & (together > 0)).any():
        axes.set_ylim(floor / 10, 10 * floor)  # a logarithmic axis of nothing has no ends
    axes.locator_params(axis="x", integer=True)
    figure.legend(loc="outside lower center", ncols=2, frameon=False)
    return figure


def _draw_history(axes: Axes, values: np.ndarray, floor: float, style: dict[str, Any]) -> None:
    number = np.arange(1, values.size + 1)
    positive = np.where(values > 0, values, np.nan)
    axes.plot(number, positive, markersize=5, linewidth=1.2, **style)
    zero = number[values == 0]
    if zero.size:
        axes.plot(
            zero,
            np.full(zero.size, floor),
            linestyle="none",
            markerfacecolor="none",
            markersize=7,
            **{**style, "label": "exactly zero"},
        )


def _floor(histories: np.ndarray) -> float:
    """A place for zeros, a decade below the smallest positive number."""
    positive = histories[np.isfinite(histories) & (histories > 0)]
    return 0.1 * float(positive.min()) if positive.size else 1e-16


def deviations(result: Result) -> Figure:
    """Draw the deviation of both raceways around the ring, of a solved flexible state."""
    figure, axes = _blank()
    for race, color, marker in (("outer", ORANGE, "s"), ("inner", BLUE, "o")):
        _draw_deviation(axes, result.flexible, race, {"color": color, "marker": marker})
    axes.axhline(0, color="0.5", linewidth=0.8, zorder=0)
    axes.set(xlabel="azimuth [deg]", ylabel="deviation, positive outward [µm]")
    axes.set_xlim(-180, 180)
    axes.set_xticks(range(-180, 181, 60))
    _title(figure, result, "Raceway deviation at mid-roller; band: range along the roller")
    figure.legend(loc="outside lower center", ncols=2, frameon=False)
    return figure


def _draw_deviation(axes: Axes, values: Mapping[str, np.ndarray], race: str, style: dict[str, Any]) -> None:
    azimuth = (np.degrees(values["roller_azimuth"]) + 180) % 360 - 180
    order = np.argsort(azimuth)
    around = np.concatenate([order[-1:], order, order[:1]])  # a roller beyond each edge: no gap at 180
    degrees = azimuth[around] + np.concatenate([[-360], np.zeros(order.size), [360]])
    along = LAYOUT[f"{race}_deviation"].for_people(values[f"{race}_deviation"][around])
    middle = [np.interp(0.0, values["slice_position"], row) for row in along]
    band = {"color": style["color"], "alpha": 0.2, "linewidth": 0}
    axes.fill_between(degrees, along.min(axis=1), along.max(axis=1), **band)
    axes.plot(degrees, middle, markersize=4, linewidth=1.2, label=f"{race} raceway", **style)


def pictures(result: Result) -> dict[str, Figure | str]:
    """Draw every picture of a roller bearing, by the name of its file."""
    title, blocks = result.attributes["title"], _blocks(result)
    if not blocks:
        return {}
    drawn: dict[str, Figure | str] = {
        "roller_loads": polar_loads(result),
        "convergence": convergence(result) if result.iterations else _without_iterations(result),
        "raceway_deviation": deviations(result) if "flexible" in blocks else _without_flexible(result),
    }
    name, last = ("flexible" if "flexible" in blocks else "rigid"), list(blocks.values())[-1]
    placed = all(np.isfinite(values[place]).all() for values in blocks.values() for place in PLACES)
    drawn["pressure_map"] = pressure_map(last, title, f"{name} rings") if placed else NOWHERE
    drawn["pressure_along"] = pressure_along(blocks, title) if placed else NOWHERE
    if "subsurface_von_mises" in last:
        drawn["subsurface"] = subsurface(last, title, f"{name} rings")
    if "whole_roller_pressure" in last:
        drawn["whole_roller"] = whole_roller(last, title)
    return drawn


def _figure(width: float, height: float) -> Figure:
    # matplotlib takes a second to load: only pictures pay for it, not every command
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), layout="constrained")


def _blank() -> tuple[Figure, Axes]:
    figure = _figure(7.0, 4.4)
    axes = figure.add_subplot()
    plain(axes)
    return figure, axes


def _blocks(result: Result) -> dict[str, Mapping[str, np.ndarray]]:
    blocks = {"rigid": result.rigid, "flexible": result.flexible}
    if _nothing_flexible(result):
        return {"rigid rings": result.rigid}
    return {name: values for name, values in blocks.items() if values}


def _nothing_flexible(result: Result) -> bool:
    """Whether no part is flexible: both states are the same, nothing was iterated."""
    return bool(result.flexible) and not result.attributes["iterations"]


def _without_iterations(result: Result) -> str:
    if _nothing_flexible(result):
        return "no part is flexible, so no iterations"
    return "the result contains no iterations" if result.attributes["iterations"] else "no iterations"


def _without_flexible(result: Result) -> str:
    return "no part is flexible" if _nothing_flexible(result) else "the flexible state was not solved"


def _title(figure: Figure, result: Result, what: str) -> None:
    set_heading(figure, result.attributes["title"], what, 70)
