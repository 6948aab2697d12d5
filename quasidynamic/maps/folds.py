"""Folds of a map: where stable states end between its points, and the curves of folds in its planes."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
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
    Request,
    Response,
    Search,
    fold_at,
    fold_near,
    followed,
    search_together,
)
from quasidynamic.solve.rollers import bordered_system
from quasidynamic.solve.rollers.parametric_balance import RESIDUAL_TOLERANCE, slip_weight

STEP_OF_SLIP = 0.05  # slip that counts like a step of the grid
DIFFERENCE = 1e-5  # steps of the grid, for derivatives by the place
BESIDE = 2 * FINEST + SAGITTA  # steps of the grid between a curve and an end that may lie on it
ALIKE = 0.5  # of states as they are weighted: a fold and the last state before it
AT_ONCE = 48  # searches
FIRST_AT_ONCE = 4  # so that few of them find the same curve
GOLDEN = (5**0.5 - 1) / 2


@dataclass(frozen=True, eq=False)
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

    def nearest(self, place: NDArray) -> NDArray:
        """The place (2) of the grid that is nearest to a place."""
        return np.clip(place, 0, np.array(self.points.shape)[list(self.axes)] - 1)

    def whole(self, places: NDArray) -> NDArray:
        """Places (n, d) on all axes."""
        every = np.repeat(self.place[None].astype(float), len(places), axis=0)
        every[:, list(self.axes)] = places[:, : len(self.axes)]
        return every


def solutions(points: GridPoints, requests: Sequence[Request]) -> list[Response]:
    """Solutions of the linearised balance for requests of searches in planes of a grid, in one evaluation.

    Derivatives by the place are one-sided differences: their error scales the slope of the place, which is
    zero at the same fold.
    """
    states, places = [each.states for each in requests], [each.places for each in requests]
    for _, state, place, directions, beside in requests:
        first = slice(1 if beside else None)
        moved = place[first, None] + DIFFERENCE * directions.T
        states.append(np.repeat(state[first], moved.shape[1], axis=0))
        places.append(moved.reshape(-1, 2))
    planes = [each.equations for each in requests] * 2
    whole = [plane.whole(each) for plane, each in zip(planes, places, strict=True)]
    balance = points.within(np.concatenate(whole))
    system = balance.evaluate(np.concatenate(states))
    count, ends = len(requests), np.cumsum([len(each) for each in states])
    residuals = np.split(system.residual, ends[:-1])
    each_right = [_right(*each) for each in zip(requests, residuals, residuals[count:], strict=False)]
    first = np.array([0, *ends[: count - 1]])
    solved = np.delete(np.arange(ends[count - 1]), first[[each.beside for each in requests]])
    parts = bordered_system.solve(balance, system.of(solved), np.concatenate(each_right))
    parts = np.split(parts, np.cumsum([len(each) for each in each_right])[:-1])
    balanced = np.abs(system.residual[first]).max(axis=1) <= RESIDUAL_TOLERANCE * system.loading[first]
    return [
        Response(part[..., : each.directions.shape[1]], part[..., -1], bool(enough))
        for each, part, enough in zip(requests, parts, balanced, strict=True)
    ]


def _right(request: Request, here: NDArray, moved: NDArray) -> NDArray:
    """Right sides (n, N, 3): residuals (., N) moved in the directions of the place, and those here."""
    right, number = np.zeros((len(here) - request.beside, here.shape[1], 3)), request.directions.shape[1]
    here = here[: 1 if request.beside else None]
    change = moved.reshape(len(here), number, -1) - here[:, None]
    right[..., :number], right[..., -1] = change.swapaxes(1, 2) / DIFFERENCE, here
    return right


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
    ends, points = list(_ends(solved)), solved.points
    places = np.array([end.place for end in ends]).reshape(-1, len(points.shape))
    searches, order = FoldSearches(points), _spread(len(ends))

    def begun() -> Iterator[Search[Fold | None]]:
        for number, end in enumerate(order):
            tell(f"folds: {number + 1} of {len(ends)} ends of stable states")
            yield searches.of(ends[end])

    found = search_together(begun(), lambda requests: solutions(points, requests), lambda: searches.room)
    located = np.zeros(len(ends), bool)
    for end, fold in zip(order, found, strict=True):
        if fold:
            places[end], located[end] = searches.plane(ends[end]).whole(fold.place[None])[0], True
    curves = [_plane_curve(plane, curve) for plane, each in searches.curves.items() for curve in each]
    return MapFolds(places, located, tuple(curves))


def _spread(count: int) -> NDArray:
    """The numbers of ends in an order in which those of the same curve do not follow each other."""
    return np.argsort(np.mod(GOLDEN * np.arange(count), 1.0))


def _ends(solved: SolvedGrid) -> Iterator[End]:
    shape = solved.points.shape
    for state, side in zip(*(each.tolist() for each in solved.ends), strict=True):
        place = np.array(np.unravel_index(solved.point[state], shape), float)
        share, last = solved.last.get((state, side), (solved.share[state, side], None))
        place[side // 2] += share if side % 2 else -share
        yield End(state, side, place, last)


@dataclass
class FoldSearches:
    """Searches of the folds of ends and of the curves through them; a known one is not followed again."""

    points: GridPoints
    planes: dict[tuple, MapPlaneEquations] = field(default_factory=dict)
    curves: dict[MapPlaneEquations, list[FoldCurve]] = field(default_factory=dict)  # known ones of each plane
    new: int = 0  # searches that did not end at a known curve

    @property
    def room(self) -> int:
        """Searches that may be under way: few where many end at the same curve."""
        return min(AT_ONCE, FIRST_AT_ONCE + 2 * self.new)

    def plane(self, end: End) -> MapPlaneEquations:
        """The plane of the last two axes through an end, or its line across them."""
        dimensions = len(self.points.shape)
        axes = tuple(range(max(dimensions - 2, 0), dimensions))
        if end.axis not in axes:
            axes = (end.axis,)
        key = axes, *np.delete(end.place, axes).tolist()
        return self.planes.setdefault(key, MapPlaneEquations(self.points, axes, end.place))

    def of(self, end: End) -> Search[Fold | None]:
        """The fold of an end, and the curve through it; of a line the fold alone."""
        if end.last is None:
            return None
        plane = self.plane(end)
        curves = self.curves.setdefault(plane, [])
        for curve in curves:
            if fold := (yield from _on_curve(plane, curve, end)):
                return fold
        across, axis = np.zeros(2), plane.axes.index(end.axis)
        across[axis] = end.sense
        fold = yield from fold_near(plane, end.last, np.resize(end.place[list(plane.axes)], 2), across)
        if fold is None or not end.before_next_point(fold.place[axis]):
            self.new += 1
            return None
        if len(plane.axes) > 1 and not _on_one_of(plane, curves, fold):
            curve = yield from followed(plane, fold)
            if _on_one_of(plane, curves, fold):  # by now: its search was under way beside this one
                return fold
            curves.append(curve)
        self.new += 1
        return fold


def _on_one_of(plane: MapPlaneEquations, curves: Sequence[FoldCurve], fold: Fold) -> bool:
    return any(_passes(plane, curve, fold) for curve in curves)


def _passes(equations: MapPlaneEquations, curve: FoldCurve, fold: Fold) -> bool:
    """Whether a curve passes through a fold."""
    chord, from_one = np.diff(curve.places, axis=0), fold.place - curve.places[:-1]
    share = np.vecdot(from_one, chord) / np.maximum(np.vecdot(chord, chord), SAGITTA**2)
    share = np.clip(share, 0, 1)[:, None]
    between = curve.states[:-1] + share * np.diff(curve.states, axis=0)
    beside = np.hypot(*(from_one - share * chord).T) < 2 * SAGITTA
    return bool((beside & (_distance(equations, between, fold.state) < ALIKE)).any())


def _on_curve(equations: MapPlaneEquations, curve: FoldCurve, end: End) -> Search[Fold | None]:
    """The fold of an end where a curve passes it; None where none does."""
    assert end.last is not None
    axis = equations.axes.index(end.axis)
    place = end.place[list(equations.axes)]
    sides = curve.places[:, 1 - axis] - place[1 - axis]
    before, after = sides[:-1], sides[1:]
    for piece in np.flatnonzero((before * after <= 0) & (before != after)):
        one, other = curve.folds[piece : piece + 2]
        share = before[piece] / (before[piece] - after[piece])
        crossing = one.place + share * (other.place - one.place)
        between = one.state + share * (other.state - one.state)
        if abs(crossing[axis] - place[axis]) > BESIDE or _distance(equations, between, end.last) > ALIKE:
            continue
        crossing[1 - axis] = place[1 - axis]
        fold = yield from fold_at(equations, one if share < 0.5 else other, between, crossing, axis)
        if fold and abs(fold.place[axis] - place[axis]) < 2 * FINEST:
            return fold
    return None


def _distance(equations: MapPlaneEquations, one: NDArray, other: NDArray) -> NDArray:
    return np.sqrt((one - other) ** 2 @ equations.weight)


def _plane_curve(equations: MapPlaneEquations, curve: FoldCurve) -> PlaneCurve:
    return PlaneCurve(
        places=equations.whole(curve.places),
        cusps=np.array([fold.cusp for fold in curve.folds]),
        errors=np.array([fold.error for fold in curve.folds]),
        ends=curve.ends,
    )
