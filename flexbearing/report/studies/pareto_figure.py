"""Picture of time against error, one panel for each output."""

from __future__ import annotations

from string import ascii_lowercase
from textwrap import fill
from typing import TYPE_CHECKING

from flexbearing.report.picture import plain_grid, titled
from flexbearing.report.roller.figures import BLUE, ORANGE
from flexbearing.report.studies.pareto_table import SMALLEST, TARGETS, TIMES, Study, cheapest, front, percent

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_STYLE = {"cold": (BLUE, "o", "-"), "cached": (ORANGE, "s", "--")}
_TITLES = {
    "load": "loads of rollers or balls",
    "slip": "cage slip",
    "life": "rating life",
    "stiffness": "radial stiffness",
    "torque": "torque",
}
_PHYSICS = "0.35"  # grey of other physics


def draw_pareto(study: Study) -> Figure:
    """Draw what every level cost and how wrong it was; the front and the cheapest levels are marked.

    Other physics has marks and a name, and is part of no front.
    """
    from matplotlib.figure import Figure  # a second to load: only pictures pay for it

    outputs = study.outputs
    rows = -(-len(outputs) // 2)
    figure = Figure(figsize=(11.0, 1.2 + 4.7 * rows), layout="constrained")
    panels = figure.subplots(rows, 2, sharex=True, sharey=True, squeeze=False).ravel()
    for axes, output in zip(panels, outputs, strict=False):
        _draw_panel(axes, study, output)
    for axes in panels[len(outputs) :]:
        axes.remove()
    errors = [max(error, SMALLEST) for level in study.solved for error in level.errors.values()]
    panels[0].set_ylim(min(*errors, *TARGETS) / 2, max(*errors, *TARGETS) * 2)
    lines = [titled(study.title, 90), f"errors against a reference of {study.reference.times['cold']:.2g} s"]
    failed = [level.name for level in study.levels if not level.errors]
    if failed:
        lines.append(fill(f"not computed: {', '.join(failed)}", 110))
    figure.suptitle("\n".join(lines), fontsize=12, parse_math=False)
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=len(labels), frameon=False)
    return figure


def _draw_panel(axes: Axes, study: Study, output: str) -> None:
    errors = [max(level.errors[output], SMALLEST) for level in study.numerical]
    for when in TIMES:
        color, marker, line = _STYLE[when]
        points = [(level.times[when], error) for level, error in zip(study.numerical, errors, strict=True)]
        axes.plot(
            *zip(*points, strict=True), marker, color=color, markersize=4.5, alpha=0.55, label=f"{when}"
        )
        best = [points[number] for number in front(points)]
        axes.plot(*zip(*best, strict=True), line, color=color, drawstyle="steps-post", linewidth=1.2,
                  label=f"best, {when}")  # fmt: skip
    _draw_other_physics(axes, study, output)
    for target in TARGETS:
        axes.axhline(target, color="0.6", linestyle=":", linewidth=1, zorder=0)
    _mark_cheapest(axes, study, output)
    axes.set(xscale="log", yscale="log", ylabel="error [-]")
    axes.set_title(_TITLES[output], fontsize=11)
    plain_grid(axes)
    axes.tick_params(labelbottom=True, labelleft=True)


def _draw_other_physics(axes: Axes, study: Study, output: str) -> None:
    """Differences of other laws at their cached times, by letters that are below the panel."""
    for letter, level in zip(ascii_lowercase, study.other_physics, strict=False):
        place = level.times["cached"], max(level.errors[output], SMALLEST)
        label = "other physics, cached" if letter == "a" else None
        axes.plot(*place, "x", color=_PHYSICS, markersize=6, markeredgewidth=1.4, label=label, zorder=6)
        axes.annotate(
            letter, place, xytext=(0, 5), textcoords="offset points", ha="center", fontsize=9,
            color=_PHYSICS, zorder=6,
        )  # fmt: skip


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
    names = zip(ascii_lowercase, study.other_physics, strict=False)
    if others := ", ".join(f"{letter} {level.name}" for letter, level in names):
        lines.append(f"× {others}")
    axes.set_xlabel("time [s]\n★ cheapest within\n" + "\n".join(lines), fontsize=8.5)
