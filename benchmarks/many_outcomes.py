"""Time of the outputs of many cases on one core: `python -m benchmarks.many_outcomes`.

Loads and speeds of a bearing between rigid rings, and of the paper's bearing between its rings, condensed
before; processor time of a case over that of a rigid solve of a single bearing in the same rounds.
"""

import statistics
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from itertools import product
from typing import TypeVar

import numpy as np

from benchmarks.bearings import CASE
from benchmarks.machine import describe
from flexbearing.api import read_case
from flexbearing.case.roller import Case
from flexbearing.outputs import outputs, requested
from flexbearing.program.threads import linear_algebra_alone
from flexbearing.quantities.roller import LAYOUT
from flexbearing.runs import roller_findings
from flexbearing.runs.answer import Answer
from flexbearing.runs.rows import answers
from flexbearing.runs.side_by_side import Solved, solved_side_by_side
from flexbearing.runs.solved_rows import SolvedRows

Result = TypeVar("Result")

RIGID_CASE = "configs/nu209.toml"
ROUNDS = 5
FEW = ("max_roller_load", "cage_slip", "life_L10", "stiffness")
EVERY = tuple(output.name for output in outputs(LAYOUT))
GROUPS = {
    "loads, slip, life and stiffness": FEW,
    "every scalar but the life's error": tuple(name for name in EVERY if name != "life_error"),
    "every scalar": EVERY,
}


def main() -> None:
    print(describe())
    with linear_algebra_alone():
        measured(
            "rigid rings", loads_and_speeds(RIGID_CASE, np.linspace(4e3, 3e4, 32), (500, 3000, 5000, 9000))
        )
        measured(
            "elastic rings", loads_and_speeds(CASE, np.linspace(1e4, 3e4, 40), np.linspace(5e3, 4e4, 25))
        )


def loads_and_speeds(path: str, loads: Iterable[float], speeds: Iterable[float]) -> list[Case]:
    return [
        read_case(path, {"operation.radial_load": f"{load} N", "operation.inner_speed": f"{speed} rpm"})
        for load, speed in product(loads, speeds)
    ]


def measured(name: str, cases: list[Case]) -> None:
    """Print processor times over that of a rigid solve of a single bearing, medians of the rounds."""
    rows = [measured_once(cases) for _ in range(ROUNDS)]
    alone = statistics.median([row.pop("alone") for row in rows])
    print(f"{name}, {len(cases)} cases, over a rigid solve of one of them ({alone:.2f} ms):")
    for part in rows[0]:
        shares = [row[part] for row in rows]
        print(f"  {part}: {statistics.median(shares):.3f} ({min(shares):.3f} to {max(shares):.3f})")


def measured_once(cases: list[Case]) -> dict[str, float]:
    """Time of a case by part."""
    ended, solving = spent(lambda: list(solved_side_by_side(cases, set())))
    tables = [each.rows for each in ended if isinstance(each, Solved)]
    models = [model for rows in tables for model in rows.models]
    alone = statistics.median(spent(replace(model).solve)[1] for model in models[:: len(models) // 31])
    row = {"alone": 1e3 * alone, "build and solve": solving / len(cases) / alone}
    for group, names in GROUPS.items():
        fresh = [replace(rows, states=rows.states.take(np.arange(len(rows)))) for rows in tables]
        row[group] = spent(lambda fresh=fresh, names=names: computed(fresh, names))[1] / len(cases) / alone
    row["dangers"] = spent(lambda: [roller_findings.dangers(rows) for rows in tables])[1] / len(cases) / alone
    few = spent(lambda: answers(cases, FEW, refused))[1]
    return row | {"a table of loads, slip, life and stiffness, in all": few / len(cases) / alone}


def computed(tables: list[SolvedRows], names: Sequence[str]) -> None:
    for rows in tables:
        for name in names:
            rows.numbers([requested(LAYOUT, name)])


def refused(place: int) -> Answer:
    raise AssertionError(f"case {place} needed a run of its own")


def spent(job: Callable[[], Result]) -> tuple[Result, float]:
    """What a job returns, and its processor time [s]."""
    began = time.process_time()
    return job(), time.process_time() - began


if __name__ == "__main__":
    main()
