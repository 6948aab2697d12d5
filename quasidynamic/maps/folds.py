"""Folds of a map: where stable states end between its points, and the curves of folds in its planes."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.maps.points import GridPoints
from quasidynamic.maps.sheets import FINEST
from quasidynamic.maps.solve import SolvedGrid
from quasidynamic.solve.fold_curve import (
    SAGITTA,
    CurveEnd,
    Fold,
    FoldCurve,
    PlaneLinearisation,
    fold_at,
    fold_near,
    followed,
)
from quasidynamic.solve.rollers import bordered_system
from quasidynamic.solve.rollers.parametric_balance import RESIDUAL_TOLERANCE, slip_weight

STEP_OF_SLIP = 0.05  # slip that counts like a step of the grid
DIFFERENCE = 1e-5  # steps of the grid, for derivatives by the place
BESIDE = 2 * FINEST + SAGITTA  # steps of the grid between a curve and an end that may lie on it
ALIKE = 0.5  # of states as they are weighted: a fold and the last state before it


@dataclass(frozen=True)
class MapPlaneEquations:
    """Balance of the bearings of a grid over a plane of it, in steps of the grid from its first point."""

    points: GridPoints
    axes: tuple[int, ...]  # two that span the plane; or one, and a place has a second number without meaning
    place: NDArray  # (d) of a point of the plane

    @property
    def weight(self) -> NDArray:
        """Weights (N) of the scaled unknowns."""
        return self._weight

    @cached_property
    def _weight(self) -> NDArray:
        return slip_weight(self.points.at(np.array([0]))) / STEP_OF_SLIP**2

    def at(self, states: NDArray, places: NDArray) -> PlaneLinearisation:
        """Scaled residual and its derivatives at scaled states (n, N) and places (n, 2)."""
        balance = self.points.within(self.whole(places))
        system = balance.evaluate(states)
        steps = DIFFERENCE * np.array([[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]])
        around = (places[:, None] + steps).reshape(-1, 2)
        beside = self.points.within(self.whole(around)).evaluate(np.repeat(states, 4, axis=0)).residual
        beside = beside.reshape(len(states), 4, -1)
        by_place = np.stack([beside[:, 0] - beside[:, 1], beside[:, 2] - beside[:, 3]], axis=2) / (
            2 * DIFFERENCE
        )
        return PlaneLinearisation(
            residual=system.residual,
            by_place=by_place,
            solve=lambda right: bordered_system.solve(balance, system, right),
            balanced=np.abs(system.residual).max(axis=1) <= RESIDUAL_TOLERANCE * system.loading,
        )

    def nearest(self, place: NDArray) -> NDArray:
        """The place (2) of the grid that is nearest to a place."""
        return np.clip(place, 0, np.array(self.points.shape)[list(self.axes)] - 1)

    def whole(self, places: NDArray) -> NDArray:
        """Places (n, d) on all axes."""
        every = np.repeat(self.place[None].astype(float), len(places), axis=0)
        every[:, list(self.axes)] = places[:, : len(self.axes)]
        return every


@dataclass(frozen=True)
class End:
    """Where a stable state ends between two points of a map."""

    state: int
    side: int
    place: NDArray  # (d) of the last state before, in steps of the grid
    last: NDArray | None  # (N) that state, scaled; None where it loses its stability or meets another sheet

    @property
    def axis(self) -> int:
        """Along which the state ends."""
        return self.side // 2

    @property
    def sense(self) -> float:
        """Whether upwards."""
        return 1.0 if self.side % 2 else -1.0

    def before_next_point(self, place: float) -> bool:
        """Whether a place along the axis comes before the point towards which the state is followed."""
        here = self.place[self.axis]
        return place <= np.floor(here) + 1 if self.side % 2 else place >= np.ceil(here) - 1


@dataclass(frozen=True)
class PlaneCurve:
    """A curve of folds in a plane of a map."""

    places: NDArray  # (n, d) in steps of the grid
    cusps: NDArray  # (n) which of them are cusps
    errors: NDArray  # (n) last correction of each, in steps of the grid
    ends: tuple[CurveEnd, CurveEnd]


@dataclass(frozen=True)
class MapFolds:
    """Folds of a map."""

    places: NDArray  # (n, d) where its `ends` lie, in steps of the grid
    located: NDArray  # (n) whether that is a fold that was solved for; else within `FINEST` of a step
    curves: tuple[PlaneCurve, ...]  # in planes of the last two axes

    @property
    def cut(self) -> int:
        """Curves that could not be followed to an end."""
        whole = {CurveEnd.RANGE_LEFT, CurveEnd.CLOSED}
        return sum(not whole.issuperset(curve.ends) for curve in self.curves)


def folds(solved: SolvedGrid, tell: Callable[[str], None] = lambda stage: None) -> MapFolds:
    """Solve for the folds at which stable states end, and follow the curves through them.

    Valid
    -----
    Between points of the grid as `GridPoints.within` has them. Curves through ends of the map alone: those
    that pass between its points are not known.
    """
    ends = list(_ends(solved))
    dimensions = len(solved.points.shape)
    places = np.array([end.place for end in ends]).reshape(-1, dimensions)
    located, curves = np.zeros(len(ends), bool), []
    in_plane = tuple(range(max(dimensions - 2, 0), dimensions))
    planes: dict[tuple, list[int]] = {}
    count = iter(range(1, len(ends) + 1))
    for number, end in enumerate(ends):
        across = () if end.axis in in_plane else (number,)  # each alone on its line
        planes.setdefault((*end.place[: in_plane[0]].tolist(), *across), []).append(number)
    for numbers in planes.values():
        some = [ends[number] for number in numbers]
        inside = some[0].axis in in_plane
        equations = MapPlaneEquations(solved.points, in_plane if inside else (some[0].axis,), some[0].place)
        found, new = _in_plane(
            equations, some, lambda: tell(f"folds: {next(count)} of {len(ends)} ends of stable states")
        )
        for number, fold in zip(numbers, found, strict=True):
            if fold is not None:
                places[number], located[number] = equations.whole(fold.place[None])[0], True
        curves += [_plane_curve(equations, curve) for curve in new]
    return MapFolds(places, located, tuple(curves))


def _ends(solved: SolvedGrid) -> Iterator[End]:
    shape = solved.points.shape
    for state, side in zip(*(each.tolist() for each in solved.ends), strict=True):
        place = np.array(np.unravel_index(solved.point[state], shape), float)
        share, last = solved.last.get((state, side), (solved.share[state, side], None))
        place[side // 2] += share if side % 2 else -share
        yield End(state, side, place, last)


def _in_plane(
    equations: MapPlaneEquations, ends: list[End], begin: Callable[[], None]
) -> tuple[list[Fold | None], list[FoldCurve]]:
    """Folds of ends in a plane, and the curves through them; of a line the folds alone."""
    found: list[Fold | None] = [None] * len(ends)
    curves: list[FoldCurve] = []
    for number, end in enumerate(ends):
        begin()
        if end.last is None or found[number] is not None:
            continue
        start = end.place[list(equations.axes)]
        across, axis = np.zeros(2), equations.axes.index(end.axis)
        across[axis] = end.sense
        fold = fold_near(equations, end.last, np.resize(start, 2), across)
        if fold is None or not end.before_next_point(fold.place[axis]):
            continue
        found[number] = fold
        if len(equations.axes) == 1 or any(_passes(equations, each, fold) for each in curves):
            continue
        curve = followed(equations, fold)
        curves.append(curve)
        for other in range(number + 1, len(ends)):
            found[other] = found[other] or _on_curve(equations, curve, ends[other])
    return found, curves


def _passes(equations: MapPlaneEquations, curve: FoldCurve, fold: Fold) -> bool:
    """Whether a curve passes through a fold."""
    for one, other in zip(curve.folds, curve.folds[1:], strict=False):
        chord = other.place - one.place
        share = np.clip((fold.place - one.place) @ chord / max(chord @ chord, SAGITTA**2), 0, 1)
        beside = fold.place - one.place - share * chord
        between = one.state + share * (other.state - one.state)
        if np.hypot(*beside) < 2 * SAGITTA and _distance(equations, between, fold.state) < ALIKE:
            return True
    return False


def _on_curve(equations: MapPlaneEquations, curve: FoldCurve, end: End) -> Fold | None:
    """The fold of an end where a curve passes it; None where none does."""
    if end.last is None:
        return None
    axis = equations.axes.index(end.axis)
    place = end.place[list(equations.axes)]
    for one, other in zip(curve.folds, curve.folds[1:], strict=False):
        before, after = (fold.place[1 - axis] - place[1 - axis] for fold in (one, other))
        if before * after > 0 or before == after:
            continue
        share = before / (before - after)
        crossing = one.place + share * (other.place - one.place)
        between = one.state + share * (other.state - one.state)
        if abs(crossing[axis] - place[axis]) > BESIDE or _distance(equations, between, end.last) > ALIKE:
            continue
        crossing[1 - axis] = place[1 - axis]
        fold = fold_at(equations, one if share < 0.5 else other, between, crossing, axis)
        if fold and abs(fold.place[axis] - place[axis]) < 2 * FINEST:
            return fold
    return None


def _distance(equations: MapPlaneEquations, one: NDArray, other: NDArray) -> float:
    return float(np.sqrt(equations.weight @ (one - other) ** 2))


def _plane_curve(equations: MapPlaneEquations, curve: FoldCurve) -> PlaneCurve:
    return PlaneCurve(
        places=equations.whole(curve.places),
        cusps=np.array([fold.cusp for fold in curve.folds]),
        errors=np.array([fold.error for fold in curve.folds]),
        ends=curve.ends,
    )
