"""Picture of time against error, one panel for each output."""

from __future__ import annotations

from textwrap import fill
from typing import TYPE_CHECKING

import numpy as np

from flexbearing.report.figure import BLUE, COLOURS, ORANGE, Axis, Figure, Line, Rule
from flexbearing.report.panels import picture
from flexbearing.report.studies.pareto_table import SMALLEST, TARGETS, TIMES, Study, cheapest, front, percent

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Page

_STYLE = {"cold": (BLUE, "circle", "solid"), "cached": (ORANGE, "square", "dash")}
_TITLES = {
    "load": "loads of rollers or balls",
    "slip": "cage slip",
    "life": "rating life",
    "stiffness": "radial stiffness",
    "torque": "torque",
}


def draw_pareto(study: Study) -> Page:
    """Draw what every level cost and how wrong it was; the front and the cheapest levels are marked.

    Other physics has marks and a name, and is part of no front.
    """
    lines = [f"errors against a reference of {study.reference.times['cold']:.2g} s"]
    failed = [level.name for level in study.levels if not level.errors]
    if failed:
        lines.append(fill(f"not computed: {', '.join(failed)}", 110))
    figures = [_figure(study, output) for output in study.outputs]
    return picture(study.title, "\n".join(lines), figures, columns=2, size=(5.5, 4.7))


def _figure(study: Study, output: str) -> Figure:
    stars, words = _cheapest(study, output)
    items = [*_levels(study, output), *_other_physics(study, output), *stars]
    items += [Rule(target, level=True, dash="dot") for target in TARGETS]
    solved = [level for level in study.levels if level.errors]
    errors = [*TARGETS, *(max(error, SMALLEST) for level in solved for error in level.errors.values())]
    times = [level.times[when] for level in solved for when in TIMES]
    x = Axis(
        "\n".join(["time [s]", "★ cheapest within", *words]), "log", (min(times) / 1.5, max(times) * 1.5)
    )
    y = Axis("error [-]", "log", (min(errors) / 2, max(errors) * 2))
    return Figure(output, _TITLES[output], x, y, tuple(items))


def _levels(study: Study, output: str) -> list[Line]:
    """Every level, and those that no other one beats in time and error."""
    errors, lines = [max(level.errors[output], SMALLEST) for level in study.numerical], []
    for when in TIMES:
        colour, mark, dash = _STYLE[when]
        points = [(level.times[when], error) for level, error in zip(study.numerical, errors, strict=True)]
        best = np.repeat([points[number] for number in front(points)], 2, axis=0)
        times = [time for time, _ in points]
        lines.append(Line(times, errors, when, colour, "", mark))
        lines.append(
            Line(best[1:, 0].tolist(), best[:-1, 1].tolist(), f"best, {when}", colour, dash, "", width=1.2)
        )
    return lines


def _other_physics(study: Study, output: str) -> list[Line]:
    """Differences of other laws at their cached times."""
    return [
        Line([level.times["cached"]], [max(level.errors[output], SMALLEST)], f"other physics: {level.name}",
             COLOURS[(2 + number) % len(COLOURS)], "", "x", 6.0)
        for number, level in enumerate(study.other_physics)
    ]  # fmt: skip


def _cheapest(study: Study, output: str) -> tuple[list[Line], list[str]]:
    """Stars on the cheapest level of each target, and their names."""
    stars, lines = [], []
    for target in TARGETS:
        names = []
        for when in TIMES:
            level = cheapest(study, when, target, (output,))
            names.append(f"{when}: {level.name} ({level.times[when]:.2g} s)" if level else f"{when}: none")
            if level:
                place = [level.times[when]], [max(level.errors[output], SMALLEST)]
                stars.append(Line(*place, "", _STYLE[when][0], "", "star", 14.0))
        lines.append(f"{percent(target)}  –  {';  '.join(names)}")
    return stars, lines
