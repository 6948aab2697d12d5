"""What a study of speed against error found, with its tables."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from textwrap import fill
from typing import TYPE_CHECKING

import numpy as np

from flexbearing.files import as_csv
from flexbearing.report.figure import BLUE, COLOURS, ORANGE, Axis, Figure, Line, Rule
from flexbearing.report.panels import picture

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Page

OUTPUTS = {  # name, what it is the error of
    "load": "loads of rollers or balls, largest error over largest load",
    "slip": "cage slip, of itself or of 1 %",
    "life": "rating life",
    "stiffness": "radial stiffness from base to shaft ends",
    "torque": "torque that keeps the inner ring turning",
}
TARGETS = (0.05, 0.01, 0.001)
TIMES = ("cold", "cached")
SMALLEST = 1e-7  # errors below it are rounding and tolerance of the solution
TOLD = ("load", "life")  # outputs that a target keeps


@dataclass(frozen=True, kw_only=True)
class Measured:
    """One level: what it cost and how wrong it was."""

    name: str
    settings: tuple[str, ...]
    times: dict[str, float] = field(default_factory=dict)  # [s] by the names in TIMES
    errors: dict[str, float] = field(default_factory=dict)  # [-] by the names in OUTPUTS; empty: failed
    message: str = ""  # why it failed
    physics: bool = False  # another law: its errors are differences, and it is on no front
    picked: str = ""  # levels that a target chose
    estimated: dict[str, float] = field(default_factory=dict)  # [-] errors that a target estimated


@dataclass(frozen=True, kw_only=True)
class Study:
    """All levels of one case."""

    title: str
    reference: Measured  # errors zero
    levels: tuple[Measured, ...]
    left_out: tuple[str, ...]

    @property
    def solved(self) -> tuple[Measured, ...]:
        """Levels that gave an answer."""
        return tuple(level for level in self.levels if level.errors)

    @property
    def numerical(self) -> tuple[Measured, ...]:
        """Those of the physics of the reference."""
        return tuple(level for level in self.solved if not level.physics)

    @property
    def other_physics(self) -> tuple[Measured, ...]:
        """Those of another physics."""
        return tuple(level for level in self.solved if level.physics)

    @property
    def outputs(self) -> tuple[str, ...]:
        """Names in OUTPUTS that such a bearing has."""
        return tuple(name for name in OUTPUTS if name in self.reference.errors)


def front(points: Sequence[tuple[float, float]]) -> list[int]:
    """Numbers of the points (time, error) that no other one beats in both, from fast to slow."""
    best, kept = float("inf"), []
    for number in sorted(range(len(points)), key=points.__getitem__):
        if points[number][1] < best:
            best = points[number][1]
            kept.append(number)
    return kept


def cheapest(study: Study, when: str, target: float, outputs: Sequence[str]) -> Measured | None:
    """The fastest level of the same physics whose errors of some outputs are within a target, or None."""
    good = [level for level in study.numerical if all(level.errors[name] <= target for name in outputs)]
    return min(good, key=lambda level: level.times[when], default=None)


def text(study: Study) -> str:
    """The study as Markdown: a line for each level, then the cheapest ones, then what is missing."""
    outputs = study.outputs
    lines = [f"# {study.title}", "", "Errors against the reference, "
             + "; ".join(f"{name}: {OUTPUTS[name]}" for name in outputs) + ".", ""]  # fmt: skip
    lines += [
        head("level", outputs),
        *(row(level, outputs) for level in (*study.numerical, study.reference)),
    ]
    if study.other_physics:
        lines += ["", "Other physics: differences instead of errors, never among the cheapest.", ""]
        lines += [head("law", outputs), *(row(level, outputs) for level in study.other_physics)]
    lines += ["", "| cheapest within | " + " | ".join(TIMES) + " |", "|---|" + "---|" * len(TIMES)]
    for target in TARGETS:
        fastest = (cheapest(study, when, target, outputs) for when in TIMES)
        names = (f"{level.name}, {level.times[when]:.2g} s" if level else "none"
                 for when, level in zip(TIMES, fastest, strict=True))  # fmt: skip
        lines.append(f"| {percent(target)} in all | " + " | ".join(names) + " |")
    picked = [level for level in study.numerical if level.picked]
    if picked:
        lines += [
            "",
            "| target | chooses | estimated, true error of loads [%] | of life [%] |",
            "|---|---|---|---|",
        ]
        lines += [picked_row(level) for level in picked]
    failed = [f"- {level.name}: {level.message}" for level in study.levels if not level.errors]
    if failed:
        lines += ["", "Not computed:", "", *failed]
    if study.left_out:
        lines += ["", "Left out:", "", *(f"- {words}" for words in study.left_out)]
    return "\n".join(lines) + "\n"


def table(study: Study) -> str:
    """Every level with its settings, times [s], errors [-] and message, as CSV."""
    errors = (*(f"error_{name}" for name in study.outputs), *(f"told_{name}" for name in TOLD))
    head = ["level", "kind", *(f"{when}_s" for when in TIMES), *errors, "picked", "settings", "message"]
    rows: list[list[object]] = [[*head]]
    for level in (*study.levels, study.reference):
        numbers: list[object] = [level.times.get(when, "") for when in TIMES]
        numbers += [level.errors.get(name, "") for name in study.outputs]
        numbers += [level.estimated.get(name, "") for name in TOLD]
        kind = "reference" if level is study.reference else "physics" if level.physics else "numerical"
        rows.append([level.name, kind, *numbers, level.picked, " ".join(level.settings), level.message])
    return as_csv(rows)


def percent(value: float) -> str:
    """A share in percent, as short as possible."""
    return f"{100 * value:g} %"


def head(first: str, outputs: Sequence[str]) -> str:
    """Heading of a Markdown table of levels."""
    return (
        f"| {first} | cold [s] | cached [s] | " + " | ".join(f"{name} [%]" for name in outputs) + " |\n"
        "|---|" + "---:|" * (len(TIMES) + len(outputs))
    )


def row(level: Measured, outputs: Sequence[str]) -> str:
    """One level under `head`."""
    numbers = [f"{level.times[when]:.3g}" for when in TIMES]
    numbers += [_share(level.errors[name]) for name in outputs]
    return f"| {level.name} | " + " | ".join(numbers) + " |"


def picked_row(level: Measured) -> str:
    """What a target chose, and its estimated and true errors."""
    errors = (f"{100 * level.estimated[name]:.2g}, {100 * level.errors[name]:.2g}" for name in TOLD)
    return f"| {level.name.removeprefix('target ')} | {level.picked} | " + " | ".join(errors) + " |"


def _share(error: float) -> str:
    """An error in percent."""
    return f"{100 * error:.3g}" if error >= SMALLEST or error == 0 else f"< {100 * SMALLEST:.0e}"


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
