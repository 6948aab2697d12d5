"""Picture of time against error, one panel for each output."""

from __future__ import annotations

from textwrap import fill
from typing import TYPE_CHECKING

from flexbearing.report.axes_look import plain_grid
from flexbearing.report.picture import titled
from flexbearing.report.roller.figures import BLUE, ORANGE
from flexbearing.report.studies.pareto_table import OUTPUTS, TARGETS, TIMES, Study, cheapest, front, percent

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SMALLEST = 1e-7  # errors below it are drawn there
_STYLE = {"cold": (BLUE, "o", "-"), "cached": (ORANGE, "s", "--")}
_TITLES = {
    "load": "roller loads",
    "slip": "cage slip",
    "life": "rating life",
    "stiffness": "radial stiffness",
}


def draw_pareto(study: Study) -> Figure:
    """Draw what every level cost and how wrong it was; the front and the cheapest levels are marked.

    Parameters
    ----------
    study : Study
        with its levels

    Returns
    -------
    matplotlib.figure.Figure
    """
    from matplotlib.figure import Figure  # a second to load: only pictures pay for it

    figure = Figure(figsize=(11.0, 10.6), layout="constrained")
    panels = figure.subplots(2, 2, sharex=True, sharey=True)
    for axes, output in zip(panels.ravel(), OUTPUTS, strict=True):
        _draw_panel(axes, study, output)
    errors = [max(error, SMALLEST) for level in study.solved for error in level.errors.values()]
    panels[0, 0].set_ylim(min(*errors, *TARGETS) / 2, max(*errors, *TARGETS) * 2)
    lines = [titled(study.title, 90), f"errors against a reference of {study.reference.times['cold']:.2g} s"]
    failed = [level.name for level in study.levels if not level.errors]
    if failed:
        lines.append(fill(f"without an answer: {', '.join(failed)}", 110))
    figure.suptitle("\n".join(lines), fontsize=12, parse_math=False)
    handles, labels = panels[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=len(labels), frameon=False)
    return figure


def _draw_panel(axes: Axes, study: Study, output: str) -> None:
    errors = [max(level.errors[output], SMALLEST) for level in study.solved]
    for when in TIMES:
        color, marker, line = _STYLE[when]
        points = [(level.times[when], error) for level, error in zip(study.solved, errors, strict=True)]
        axes.plot(
            *zip(*points, strict=True), marker, color=color, markersize=4.5, alpha=0.55, label=f"{when}"
        )
        best = [points[number] for number in front(points)]
        axes.plot(*zip(*best, strict=True), line, color=color, drawstyle="steps-post", linewidth=1.2,
                  label=f"best, {when}")  # fmt: skip
    for target in TARGETS:
        axes.axhline(target, color="0.6", linestyle=":", linewidth=1, zorder=0)
    _mark_cheapest(axes, study, output)
    axes.set(xscale="log", yscale="log", ylabel="error [-]")
    axes.set_title(_TITLES[output], fontsize=11)
    plain_grid(axes)
    axes.tick_params(labelbottom=True, labelleft=True)


def _mark_cheapest(axes: Axes, study: Study, output: str) -> None:
    """Stars on the cheapest level of each target; their names below, where nothing is in their way."""
    lines = []
    for target in TARGETS:
        names = []
        for when in TIMES:
            level = cheapest(study, when, target, (output,))
            names.append(f"{when}: {level.name} ({level.times[when]:.2g} s)" if level else f"{when}: none")
            if level:
                place = level.times[when], max(level.errors[output], SMALLEST)
                axes.plot(
                    *place, "*", color=_STYLE[when][0], markersize=15, markeredgecolor="white", zorder=5
                )
        lines.append(f"{percent(target)}  –  {';  '.join(names)}")
    axes.set_xlabel("time [s]\n★ cheapest within\n" + "\n".join(lines), fontsize=8.5)
