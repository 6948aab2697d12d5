"""Pictures of a roller bearing."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.quantities.reductions import loaded
from flexbearing.quantities.roller import LAYOUT
from flexbearing.report.picture import titled
from flexbearing.report.roller.whole_roller_figure import whole_roller
from flexbearing.results import Result

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.projections.polar import PolarAxes

# Okabe and Ito (2008): told apart by colour-blind readers; marks tell them apart in grey
BLUE, ORANGE = "#0072B2", "#D55E00"

NO_LOAD = 1e-100  # [N] that an axis of loads cannot tell from zero

_RIGID = {"color": BLUE, "marker": "o", "markerfacecolor": "white", "markersize": 6}
_FLEXIBLE = {"color": ORANGE, "marker": "s", "markersize": 4.5}


def polar_loads(result: Result) -> Figure:
    """Draw the inner roller loads around the bearing, azimuth zero pointing down.

    Parameters
    ----------
    result : Result
        what the run left behind

    Returns
    -------
    matplotlib.figure.Figure
        rigid and flexible loads [N]; says so when no part is flexible
    """
    figure = _figure(6.4, 6.6)
    axes: Any = figure.add_subplot(projection="polar")
    drawn = _blocks(result)
    for name, values in drawn.items():
        _draw_loads(axes, name, values)
    loads = np.concatenate([[0.0], *(values["inner_load"] for values in drawn.values())])
    _shape_load_axes(axes, float(loads[np.isfinite(loads)].max()))
    _title(axes, result, "Inner roller loads [N], azimuth 0 pointing down")
    axes.set_xlabel(_caption(result), labelpad=14)
    if drawn:
        figure.legend(loc="outside lower center", ncols=2, frameon=False)
    return figure


def _draw_loads(axes: PolarAxes, name: str, values: Mapping[str, np.ndarray]) -> None:
    order = np.argsort(values["roller_azimuth"] % (2 * np.pi))
    azimuth, load = values["roller_azimuth"][order], values["inner_load"][order]
    touching = np.flatnonzero(loaded(load))
    style = _FLEXIBLE if name == "flexible" else _RIGID
    axes.vlines(azimuth[touching], 0, load[touching], color=style["color"], linewidth=0.8, alpha=0.5)
    axes.fill(azimuth, load, color=style["color"], alpha=0.12, linewidth=0)
    size = f", largest {load.max():.0f} N" if np.isfinite(load).all() else ": not finite"
    around = np.append(np.arange(azimuth.size), 0)  # closed
    axes.plot(azimuth[around], load[around], markevery=touching, linewidth=1.2, label=name + size, **style)
    axes.plot(azimuth, 0 * azimuth, linestyle="none", marker=".", color="0.6", markersize=4, clip_on=False)


def _shape_load_axes(axes: PolarAxes, largest: float) -> None:
    axes.set_theta_zero_location("S")
    axes.set_thetagrids(
        range(0, 360, 30), [f"{angle if angle <= 180 else angle - 360}°" for angle in range(0, 360, 30)]
    )
    top = 1.12 * largest if largest > NO_LOAD else 1.0
    axes.set_rlim(0, top)
    axes.set_rorigin(-0.3 * top)  # unloaded rollers stand on a ring of their own, not in one point
    axes.set_rlabel_position(165)
    axes.set_rticks(_ticks(top))
    axes.grid(color="0.85", linewidth=0.6)
    axes.annotate(
        "load",
        xy=(0.5, 0.41),
        xytext=(0.5, 0.54),
        xycoords="axes fraction",
        ha="center",
        arrowprops={"arrowstyle": "-|>", "color": "0.2", "linewidth": 1.5},
    )


def _ticks(top: float) -> list[float]:
    """Find three to six round numbers below `top`, clear of the rim."""
    decade = 10.0 ** np.floor(np.log10(top))
    step = next(decade * part for part in (0.2, 0.5, 1.0, 2.0) if top < 6 * decade * part)
    return [step * number for number in range(1, int(0.95 * top / step) + 1)]


def convergence(result: Result) -> Figure:
    """Draw load change and residual over the iterations.

    Parameters
    ----------
    result : Result
        what the run left behind

    Returns
    -------
    matplotlib.figure.Figure
        both relative, on a logarithmic axis; zeros stand as open marks below all else
    """
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
    _title(axes, result, f"Convergence ({result.attributes['method']}): {result.attributes['status']}")
    if not result.iterations:
        rigid = result.flexible and not result.attributes["iterations"]
        stored = "no iterations stored" if result.attributes["iterations"] else "no iterations"
        _say(axes, "no iterations: no part is flexible" if rigid else stored)
        axes.set(xticks=[], yticks=[])
        return figure
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
    """Draw the deviation of both flexible raceways around the ring.

    Parameters
    ----------
    result : Result
        what the run left behind

    Returns
    -------
    matplotlib.figure.Figure
        deviation at mid-roller [um], positive outward, with its range along the rollers
    """
    figure, axes = _blank()
    for race, color, marker in (("outer", ORANGE, "s"), ("inner", BLUE, "o")):
        if result.flexible:
            _draw_deviation(axes, result.flexible, race, {"color": color, "marker": marker})
    axes.axhline(0, color="0.5", linewidth=0.8, zorder=0)
    axes.set(xlabel="azimuth [deg]", ylabel="deviation, positive outward [µm]")
    axes.set_xlim(-180, 180)
    axes.set_xticks(range(-180, 181, 60))
    _title(axes, result, "Raceway deviation at mid-roller; band: range along the roller")
    if not result.flexible or not result.attributes["iterations"]:
        _say(axes, _caption(result))
    if result.flexible:
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


def pictures(result: Result) -> dict[str, Figure]:
    """Draw every picture of a roller bearing, by the name of its file."""
    drawn = {
        "roller_loads": polar_loads(result),
        "convergence": convergence(result),
        "raceway_deviation": deviations(result),
    }
    last = result.flexible or result.rigid
    if last and "whole_roller_pressure" in last:
        drawn["whole_roller"] = whole_roller(last, result.attributes["title"])
    return drawn


def _figure(width: float, height: float) -> Figure:
    # matplotlib takes a second to load: only pictures pay for it, not every command
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), layout="constrained")


def _blank() -> tuple[Figure, Axes]:
    figure = _figure(7.0, 4.4)
    axes = figure.add_subplot()
    axes.grid(color="0.88", linewidth=0.6)
    axes.spines[["top", "right"]].set_visible(False)
    return figure, axes


def _blocks(result: Result) -> dict[str, Mapping[str, np.ndarray]]:
    blocks = {"rigid": result.rigid, "flexible": result.flexible}
    if result.flexible and not result.attributes["iterations"]:
        return {"rigid = flexible": result.rigid}
    return {name: values for name, values in blocks.items() if values}


def _caption(result: Result) -> str:
    if not result.flexible:
        return "the flexible state was not solved"
    if not result.attributes["iterations"]:
        return "no part is flexible: both states are the same"
    return "azimuth [deg]"


def _title(axes: Axes, result: Result, what: str) -> None:
    heading = f"{titled(result.attributes['title'], 70)}\n{what}"
    axes.set_title(heading, fontsize=11, pad=12, parse_math=False)


def _say(axes: Axes, words: str) -> None:
    axes.text(0.5, 0.6, words, transform=axes.transAxes, ha="center", va="center", color="0.3")
