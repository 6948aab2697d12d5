"""What a study of speed against error found, with its tables."""

from __future__ import annotations

from collections.abc import Sequence
from csv import writer
from dataclasses import dataclass, field
from io import StringIO

OUTPUTS = {  # name, what it is the error of
    "load": "roller loads, largest error over largest load",
    "slip": "cage slip, of itself or of 1 %",
    "life": "rating life",
    "stiffness": "radial stiffness from base to shaft ends",
}
TARGETS = (0.1, 0.01, 0.001)
TIMES = ("cold", "cached")


@dataclass(frozen=True, kw_only=True)
class Measured:
    """One level: what it cost and how wrong it was."""

    name: str
    settings: tuple[str, ...]
    times: dict[str, float] = field(default_factory=dict)  # [s] by the names in TIMES
    errors: dict[str, float] = field(default_factory=dict)  # [-] by the names in OUTPUTS; empty: failed
    message: str = ""  # why it failed


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


def front(points: Sequence[tuple[float, float]]) -> list[int]:
    """Numbers of the points (time, error) that no other one beats in both, from fast to slow."""
    best, kept = float("inf"), []
    for number in sorted(range(len(points)), key=points.__getitem__):
        if points[number][1] < best:
            best = points[number][1]
            kept.append(number)
    return kept


def cheapest(study: Study, when: str, target: float, outputs: Sequence[str]) -> Measured | None:
    """The fastest level whose errors of some outputs are all within a target, None if there is none.

    Parameters
    ----------
    study : Study
        with its levels
    when : "cold" or "cached"
        whose time counts
    target : float
        largest error [-]
    outputs : sequence of str
        names in OUTPUTS

    Returns
    -------
    Measured or None
    """
    good = [level for level in study.solved if all(level.errors[name] <= target for name in outputs)]
    return min(good, key=lambda level: level.times[when], default=None)


def text(study: Study) -> str:
    """The study as Markdown: a line for each level, then the cheapest ones, then what is missing.

    Parameters
    ----------
    study : Study
        with its levels

    Returns
    -------
    str
    """
    lines = [f"# {study.title}", "", "Errors against the reference, "
             + "; ".join(f"{name}: {words}" for name, words in OUTPUTS.items()) + ".", ""]  # fmt: skip
    lines += ["| level | cold [s] | cached [s] | " + " | ".join(f"{name} [%]" for name in OUTPUTS) + " |"]
    lines += ["|---|" + "---:|" * (len(TIMES) + len(OUTPUTS))]
    lines += [_row(level) for level in (*study.solved, study.reference)]
    lines += ["", "| cheapest within | " + " | ".join(TIMES) + " |", "|---|" + "---|" * len(TIMES)]
    for target in TARGETS:
        fastest = (cheapest(study, when, target, tuple(OUTPUTS)) for when in TIMES)
        names = (f"{level.name}, {level.times[when]:.2g} s" if level else "none"
                 for when, level in zip(TIMES, fastest, strict=True))  # fmt: skip
        lines.append(f"| {percent(target)} in all | " + " | ".join(names) + " |")
    failed = [f"- {level.name}: {level.message}" for level in study.levels if not level.errors]
    if failed:
        lines += ["", "Without an answer:", "", *failed]
    if study.left_out:
        lines += ["", "Left out:", "", *(f"- {words}" for words in study.left_out)]
    return "\n".join(lines) + "\n"


def table(study: Study) -> str:
    """Every level with its settings, times [s], errors [-] and message, as CSV."""
    file = StringIO(newline="")
    rows = writer(file)
    rows.writerow(
        [
            "level",
            *(f"{when}_s" for when in TIMES),
            *(f"error_{name}" for name in OUTPUTS),
            "settings",
            "message",
        ]
    )
    for level in (*study.levels, study.reference):
        numbers = [level.times.get(when, "") for when in TIMES]
        numbers += [level.errors.get(name, "") for name in OUTPUTS]
        rows.writerow([level.name, *numbers, " ".join(level.settings), level.message])
    return file.getvalue()


def percent(value: float) -> str:
    """A share in percent, as short as it can be told."""
    return f"{100 * value:g} %"


def _row(level: Measured) -> str:
    numbers = [f"{level.times[when]:.3g}" for when in TIMES]
    numbers += [f"{100 * level.errors[name]:.3g}" for name in OUTPUTS]
    return f"| {level.name} | " + " | ".join(numbers) + " |"
