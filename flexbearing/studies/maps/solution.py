"""A map that is computed: every state of every point, with its outputs."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from math import prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.outputs import UnknownOutput, WrongUnit, requested
from flexbearing.program.shared_map import shared_map
from flexbearing.program.threads import linear_algebra_alone
from flexbearing.progress import Logged, Report
from flexbearing.quantities.roller import LAYOUT
from flexbearing.runs.solved_rows import SolvedRows
from flexbearing.studies.maps.axes import MapAxis
from flexbearing.studies.maps.grid import MapGrid, grid
from quasidynamic.maps import GridPoints, MapFolds, SolvedGrid, folds, solve
from quasidynamic.outcome.bearing_states import BearingStates

ENOUGH = 64  # points for which worker processes are started at once, three seconds of a processor for two
AT_ONCE = 128  # states whose matrices fit into the processor's cache
OUTPUTS = (
    "cage_slip [%]", "max_roller_load [N]", "life_L10 [h]", "peak_pressure.inner [MPa]", "static_safety",
    "minimum_lambda.inner", "minimum_film.inner [um]", "driving_torque [N m]",
)  # fmt: skip


@dataclass(frozen=True)
class SolvedMap:
    """A map of C points and S states, the states in the order of their points."""

    title: str
    raceways: str
    axes: tuple[MapAxis, ...]
    solved: SolvedGrid
    folds: MapFolds
    outputs: dict[str, NDArray]  # (S) by headings, for people; left out are those that the case does not have
    sliced_peak_error: NDArray  # (S) of the peak pressure of slices [-]

    @property
    def points(self) -> int:
        """Points of the map."""
        return prod(len(axis.values) for axis in self.axes)

    @property
    def unsolved(self) -> NDArray:
        """Points without a state (n)."""
        return np.setdiff1d(np.arange(self.points), self.solved.point)

    @property
    def shape(self) -> tuple[int, ...]:
        """Points along each axis."""
        return tuple(len(axis.values) for axis in self.axes)

    def of_points(self, values: NDArray) -> tuple[NDArray, NDArray]:
        """Smallest and largest values of the stable states of each point, on the grid; NaN without one."""
        some = self.solved.stable
        low, high = np.full(self.points, np.inf), np.full(self.points, -np.inf)
        np.minimum.at(low, self.solved.point[some], values[some])
        np.maximum.at(high, self.solved.point[some], values[some])
        both = (np.where(np.isfinite(end), end, np.nan).reshape(self.shape) for end in (low, high))
        smallest, largest = both
        return smallest, largest

    @property
    def several(self) -> int:
        """Points with several stable states."""
        return int((self.solved.stable_count > 1).sum())


def solved_map(first: Case, axes: Sequence[MapAxis], texts: Sequence[str], report: Report) -> SolvedMap:
    """Compute a map.

    Raises `BadCase` as `grid`, and for a name that is no output; `NotSolved` where a ring has no trustworthy
    answer.
    """
    _require_outputs(texts)
    ahead = __name__ if prod(len(axis.values) for axis in axes) >= ENOUGH else None
    with linear_algebra_alone(), shared_map(ahead) as mapped:
        whole = grid(first, axes, Logged())  # its rings tell of every point
        solved = solve(whole.points, mapped, lambda stage: report.stage(stage, None))
        report.stage("folds", None)
        ended = folds(solved, lambda stage: report.stage(stage, None))
        report.stage("outputs", None)
        outputs, error = _outputs(whole, solved, texts, mapped)
    raceways = "rigid raceways" if whole.points.rigid else "flexible rings"
    return SolvedMap(first.title, raceways, whole.axes, solved, ended, outputs, error)


def _require_outputs(texts: Sequence[str]) -> None:
    for text in texts:
        try:
            requested(LAYOUT, text)
        except (UnknownOutput, WrongUnit) as problem:
            raise BadCase(f"--of {problem}") from None


def _outputs(
    whole: MapGrid, solved: SolvedGrid, texts: Sequence[str], mapped: Callable[..., Iterator[Any]]
) -> tuple[dict[str, NDArray], NDArray]:
    """Outputs of all states, without those that no state has; errors of the peak pressure of slices."""
    entries = [requested(LAYOUT, text) for text in texts]
    parts = mapped(partial(_numbers, texts), _rows(whole, solved))
    *columns, error = (np.concatenate(column) for column in zip(*parts, strict=True))
    named = (
        (_heading(entry.name, entry.unit), column) for entry, column in zip(entries, columns, strict=True)
    )
    return {name: column for name, column in named if not np.isnan(column).all()}, error


def _numbers(texts: Sequence[str], rows: SolvedRows) -> list[NDArray]:
    """Outputs of some states, and the error of the peak pressure of their slices."""
    return [*rows.numbers([requested(LAYOUT, text) for text in texts]), rows.sliced_peak_error]


def _heading(name: str, unit: str) -> str:
    return name if unit == "1" else f"{name} [{unit}]"


def _rows(whole: MapGrid, solved: SolvedGrid) -> Iterator[SolvedRows]:
    """States some at once, as runs of their cases would give them."""
    points: GridPoints = whole.points
    for first in range(0, len(solved.point), AT_ONCE):
        some = solved.point[first : first + AT_ONCE]
        states = BearingStates(points.at(some), solved.scaled[first : first + AT_ONCE], points.axial_modes)
        each = [whole.cases[point] for point in some], [points.bearings[point] for point in some]
        rings = [whole.rings[some[0]]] * len(some)  # only their shapes without load differ, which states know
        yield SolvedRows(*each, states, rings)
