"""Changes that reach a life against brute force: `python -m benchmarks.goals`.

Three bearings, every lever of each. Numbers are swept from end to end in even steps, graded choices are all
run; the first place where the life is reached is compared with that of `flexbearing goal`, and where none is,
the longest life with how far it says the lever comes.
"""

import sys
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

import flexbearing as fb
from flexbearing.families import FAMILIES
from flexbearing.goal.answer import Change, Goal
from flexbearing.goal.levers import Lever, choices, levers
from flexbearing.runs.run_case import answers, reader

WITHIN = 0.02  # of the change, or of the longest life
POINTS = 61  # from the value of the case to each end
ROLLERS = {
    "bore": "50 mm", "outside": "90 mm", "width": "20 mm", "inner_raceway": "59.5 mm",
    "outer_raceway": "81.5 mm", "clearance": "30 um", "oil": "ISO VG 68", "load": "15 kN",
    "speed": "3000 rpm",
}  # fmt: skip
BALLS = {
    "bore": "45 mm", "outside": "85 mm", "width": "19 mm", "clearance": "12 um", "oil": "ISO VG 68",
    "load": "6 kN", "speed": "2000 rpm",
}  # fmt: skip


@dataclass(frozen=True)
class Compared:
    """A lever by both ways."""

    lever: str
    found: float  # change of its value, or the longest life where none reaches it
    scanned: float
    reaches: tuple[bool, bool]

    @property
    def error(self) -> float:
        """Relative difference; infinite where one way reaches it and the other does not."""
        return abs(self.found / self.scanned - 1) if self.reaches[0] == self.reaches[1] else np.inf


def cases() -> dict[str, fb.Case]:
    """Bearings by name."""
    return {
        "NU 210": fb.new("cylindrical_roller", **ROLLERS),
        "NU 209": fb.Case("configs/nu209.toml"),
        "6209": fb.new("deep_groove_ball", **BALLS),
    }


def compared(case: fb.Case, goal: Goal) -> Iterator[Compared]:
    """Every lever that changes the life by a percent."""
    known = {change.name: change for change in goal.changes}
    for lever in levers(case.head):
        if change := known.get(lever.key.path):
            yield _number(case, goal, lever, change)
    for graded in choices(case.head):
        if graded and (change := known.get(graded[0].key)):
            far = _lives(case, goal, [each.settings for each in graded])
            reached = [each.steps for each, distance in zip(graded, far, strict=True) if distance >= 0]
            longest = goal.target.wanted * np.exp(np.nanmax(far))
            pair = (change.steps, min(reached)) if reached else (change.life, longest)
            yield Compared(change.name, *pair, (change.reaches, bool(reached)))


def _number(case: fb.Case, goal: Goal, lever: Lever, change: Change) -> Compared:
    """A number, by a sweep to both sides."""
    places, best = [], -np.inf
    for sign in (-1.0, 1.0):
        steps = np.linspace(0.0, sign * lever.end(sign), POINTS)
        changed = [(f"{lever.key.path}={lever.words(float(step))}",) for step in steps]
        far = np.array(_lives(case, goal, changed))
        known = np.isfinite(far)  # between rows that did not converge, too
        steps, usable = steps[known], far[known]
        best = max(best, usable.max(initial=-np.inf))
        if (usable >= 0).any():
            after = int(np.argmax(usable >= 0))
            share = usable[after - 1] / (usable[after - 1] - usable[after])
            places.append(abs(steps[after - 1] + share * (steps[after] - steps[after - 1])))
    longest = goal.target.wanted * np.exp(best)
    pair = (change.steps, min(places)) if places else (change.life, longest)
    return Compared(change.name, *pair, (change.reaches, bool(places)))


def _lives(case: fb.Case, goal: Goal, settings: Sequence[tuple[str, ...]]) -> list[float]:
    """Distance of the life of each changed case from the wanted one; NaN without a life."""
    read, cases = reader(case.head, FAMILIES[case.head.kind]), {}
    for place, each in enumerate(settings):
        with suppress(fb.BadCase):
            cases[place] = read(each)
    found = [np.nan] * len(settings)
    solved = answers(list(cases.values()), [goal.target.text], FAMILIES[case.head.kind])
    for place, answer in zip(cases, solved, strict=True):
        found[place] = goal.target.distance(answer.numbers.get(goal.target.text, np.nan))
    return found


def main(names: list[str]) -> None:
    """Print a row for each lever."""
    worst, count = 0.0, 0
    for name, case in cases().items():
        if names and name not in names:
            continue
        goal = case.goal("x2")
        for row in compared(case, goal):
            what = "steps" if row.reaches[0] else f"longest life [{goal.target.unit}]"
            print(f"{name:7} {row.lever:36} {what:20} {row.found:12.5g} {row.scanned:12.5g} {row.error:8.2%}")
            worst, count = max(worst, row.error), count + 1
            sys.stdout.flush()
    print(
        f"{count} levers, largest difference {worst:.2%}: {'within' if worst <= WITHIN else 'NOT within'} 2 %"
    )


if __name__ == "__main__":
    main(sys.argv[1:])
