"""Folds of equilibria over two parameters: where one lies, and the curve on which they lie, around cusps.

Searches are generators: each yields requests for solved systems, and those of many searches are solved
side by side.
"""

from collections.abc import Callable, Generator, Iterable, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cached_property
from typing import Any, NamedTuple, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

CORRECTIONS = 12  # of a fold
TOLERANCE = 1e-7  # of the last correction, in the units of state and place
LARGEST = 1.0  # correction, in the same units
STALLED = 3, 0.5  # corrections in which one must have become smaller, and to which part
DIFFERENCE = 1e-5  # of state and place: equations are singular at a fold, and are solved on both sides of it
FIRST_STEP, LONGEST_STEP, SHORTEST_STEP = 0.2, 1.0, 2e-3  # along the curve, in the same units
SHORTER = 0.25  # the next step where one fails
FEW_CORRECTIONS = 5  # up to which the next step may be longer
SMALLEST_COSINE = 0.9  # between the tangents at both ends of a step
SAGITTA = 0.02  # of the curve over its chord, in units of the place
STANDING = 12, 0.01  # steps in which a curve must go on, and how far, in units of the place
MOST_STEPS = 400
LONGEST_WAY = 1.0  # of solutions to a fold, in the same units
HALVINGS = 24  # of a step to it
CUSP_CORRECTIONS = 12  # steps to a cusp between two points


class CurveEnd(StrEnum):
    """Why a curve is not followed further."""

    RANGE_LEFT = "range left"
    CLOSED = "closed"
    STEP_TOO_SHORT = "step too short"
    LIMIT = "step limit"


class PlaneEquations(Protocol):
    """Equations F in N unknowns that depend on a place in a plane."""

    @property
    def weight(self) -> NDArray:
        """Weight (N) of the square of each unknown in the length of a curve; places have one."""
        ...

    def nearest(self, place: NDArray) -> NDArray:
        """The place within the range that is nearest to a place (2)."""
        ...


class Request(NamedTuple):
    """Where a search needs solved systems."""

    equations: Any  # of the kind that the answers are for
    states: NDArray  # (n, N)
    places: NDArray  # (n, 2)
    directions: NDArray  # (2, m) unit vectors of the plane, by which to differentiate
    beside: bool = False  # whether those of all other states are solved for the right sides of the first one


class Response(NamedTuple):
    """Solutions of the linearised equations at n states and places, or n - 1 beside the first; Jacobian J."""

    by_place: NDArray  # (n, N, m) 1/J times the derivative of F by the place in each direction
    rest: NDArray  # (n, N) 1/J times F
    balanced: bool  # whether F at the first of them is small enough


Found = TypeVar("Found")
Search = Generator[Sequence[Request], Sequence[Response], Found]


def search_together(
    searches: Iterable[Search[Found]],
    answer: Callable[[Sequence[Request]], Sequence[Response]],
    room: Callable[[], int],
) -> list[Found]:
    """What searches find, in their order; as many are under way at once as there is room for."""
    together, responses = _together(searches, room), None
    with np.errstate(all="ignore"):
        while True:
            try:
                requests = together.send(responses)  # type: ignore[arg-type]  # None begins it
            except StopIteration as end:
                return end.value
            responses = answer(requests)


def _together(searches: Iterable[Search[Found]], room: Callable[[], int]) -> Search[list[Found]]:
    """What searches find, in their order, as one search."""
    found: dict[int, Found] = {}
    requested: dict[int, tuple[Search[Found], Sequence[Request]]] = {}
    waiting = enumerate(searches)

    def go_on(number: int, search: Search[Found], responses: Sequence[Response] | None) -> None:
        try:
            requested[number] = search, search.send(responses)  # type: ignore[arg-type]  # None begins it
        except StopIteration as end:
            found[number] = end.value

    while True:
        while len(requested) < room() and (new := next(waiting, None)):
            go_on(*new, None)
        if not requested:
            return [found[number] for number in sorted(found)]
        under_way, requested = requested, {}
        responses = iter((yield [request for _, each in under_way.values() for request in each]))
        for number, (search, each) in under_way.items():
            go_on(number, search, [next(responses) for _ in each])


@dataclass(frozen=True)
class Frame:
    """Coordinates of the solutions around one: s along their change, t along a line of the plane."""

    null: NDArray  # (N) change of the state by s, of length one
    measure: NDArray  # (N) by which a change of state is measured: s = measure . (x - x0)
    across: NDArray  # (2) unit vector, in which the place gives way
    along: NDArray  # (2) unit vector, of t
    slope: float = 0.0  # of the place across by s, at x0; at a fold zero

    @classmethod
    def along_change(
        cls, equations: PlaneEquations, change: NDArray, slope: float, across: NDArray
    ) -> "Frame":
        """Coordinates with s along a change of the state (N), by which the place has a slope."""
        length, along = _length(equations, change), np.array([-across[1], across[0]])
        return cls(change / length, equations.weight * change / length, across, along, slope / length)


@dataclass(frozen=True)
class Fold:
    """A fold over two parameters."""

    state: NDArray  # (N)
    place: NDArray  # (2)
    null: NDArray  # (N) null vector of the equations by the state, of length one
    tangent: NDArray  # (2) unit vector along which folds go on in the plane
    along: NDArray  # (N) change of the state by the place along it, without null vector
    direction: NDArray  # (2) along the curve in (s, t)
    bend: float  # derivative of the slope by s; it passes through zero at a cusp
    error: float  # last correction, in units of state and place
    corrections: int
    cusp: bool = False


@dataclass(frozen=True)
class FoldCurve:
    """Folds in their order along a curve."""

    folds: tuple[Fold, ...]
    ends: tuple[CurveEnd, CurveEnd]

    @cached_property
    def places(self) -> NDArray:
        """Places (n, 2)."""
        return np.array([fold.place for fold in self.folds])

    @cached_property
    def states(self) -> NDArray:
        """States (n, N)."""
        return np.array([fold.state for fold in self.folds])


def fold_near(
    equations: PlaneEquations, state: NDArray, place: NDArray, across: NDArray
) -> Search[Fold | None]:
    """The fold at which solutions end on a line through a place; None where none is found.

    Solutions are followed along their own length until the place moves back.
    """
    (response,) = yield [Request(equations, state[None], place[None], across[:, None])]
    frame = Frame.along_change(equations, -response.by_place[0, :, 0], 1.0, across)
    step, length = FIRST_STEP / 10, 0.0
    while np.isfinite(frame.slope) and length < LONGEST_WAY and step > SHORTEST_STEP / 20:
        following = yield from _solution(equations, state, place, frame, step)
        if following is None:
            step /= 2
            continue
        if following[2].slope <= 0:
            return (yield from _between(equations, (state, place), frame, step))
        (state, place, frame), length, step = following, length + step, 1.5 * step
    return None


def fold_at(
    equations: PlaneEquations, near: Fold, state: NDArray, place: NDArray, axis: int
) -> Search[Fold | None]:
    """The fold on a line along an axis of the plane through a place, from a guess beside a known fold."""
    frame = Frame.along_change(equations, near.null, 0.0, np.eye(2)[axis])
    return _corrected(equations, state, place, frame, np.array([0.0, 1.0]))


def _solution(
    equations: PlaneEquations, state: NDArray, place: NDArray, frame: Frame, step: float
) -> Search[tuple[NDArray, NDArray, Frame] | None]:
    """The solution further along s, and coordinates there; None where Newton's method does not converge."""
    change = step * frame.null, step * frame.slope * frame.across
    sizes: list[float] = []
    while len(sizes) < CORRECTIONS and not _stalled(sizes):
        state, place = state + change[0], place + change[1]
        surface = yield from _Surface.at(equations, state, place, frame)
        change = surface.correction
        size = _size(equations, *change)
        sizes.append(size)
        if not size < LARGEST:  # nor a number
            return None
        if size < TOLERANCE and surface.balanced:
            by_s, _ = surface.by_s
            return state, place, Frame.along_change(equations, by_s, surface.slope, frame.across)
    return None


def _between(
    equations: PlaneEquations, begin: tuple[NDArray, NDArray], frame: Frame, step: float
) -> Search[Fold | None]:
    """The fold within a step along s, at the end of which the place moves back."""
    inside, outside = 0.0, step
    for _ in range(HALVINGS):
        middle = (inside + outside) / 2
        following = yield from _solution(equations, *begin, frame, middle)
        if following is None:
            return None
        found = yield from _corrected(equations, *following[:2], frame, np.array([0.0, 1.0]))
        if (
            found
            and _size(equations, found.state - following[0], found.place - following[1]) < outside - inside
        ):
            return found
        inside, outside = (middle, outside) if following[2].slope > 0 else (inside, middle)
    return None


def followed(equations: PlaneEquations, first: Fold) -> Search[FoldCurve]:
    r"""The curve of folds through one of them, both ways.

    Solutions near a fold are a surface over (s, t), with the slope h of the place across the curve by s:

    .. math:: F(x, u) = 0,\quad c \cdot (x - x_0) = s,\quad T \cdot (u - u_0) = t,\quad
        h = -\frac{1}{c \cdot F_x^{-1} F_u n}

    Folds are where h = 0. Predictor along that curve in (s, t), corrector across it. At a cusp the curve is
    smooth in (s, t) and turns back in the plane of the places.

    The search is one for `search_together`; the first fold is of `fold_near`.

    Source
    ------
    Minimally augmented systems, Govaerts, Numerical Methods for Bifurcations of Dynamical Equilibria (2000),
    ch. 3 and 4; pseudo-arclength, Keller (1977).
    """
    ways = (_one_way(equations, first, sense) for sense in (1.0, -1.0))
    (ahead, end), (behind, begin) = yield from _together(ways, lambda: 2)
    if end is CurveEnd.CLOSED:
        return FoldCurve((first, *ahead), (end, end))
    return FoldCurve((*reversed(behind), first, *ahead), (begin, end))


def _one_way(equations: PlaneEquations, first: Fold, sense: float) -> Search[tuple[list[Fold], CurveEnd]]:
    fold, folds, step = replace(first, direction=sense * first.direction), [], FIRST_STEP
    while len(folds) < MOST_STEPS and not _stands(folds):
        following = yield from _next(equations, fold, step)
        if following is None or not _near(equations, fold, following):
            step *= SHORTER
            if step < SHORTEST_STEP:
                return folds, CurveEnd.STEP_TOO_SHORT
            continue
        if not _inside(equations, following.place):
            last = yield from _at_the_edge(equations, fold, following)
            return [*folds, last] if last else folds, CurveEnd.RANGE_LEFT
        if following.bend * fold.bend < 0 and (cusp := (yield from _cusp(equations, fold, following, step))):
            folds.append(cusp)
        folds.append(following)
        away = _size(equations, following.state - first.state, following.place - first.place)
        if len(folds) > 2 and away < step / 2:
            return [*folds[:-1], first], CurveEnd.CLOSED
        fold = following
        if following.corrections <= FEW_CORRECTIONS:
            step = min(1.5 * step, LONGEST_STEP)
    return folds, CurveEnd.STEP_TOO_SHORT if _stands(folds) else CurveEnd.LIMIT


def _stands(folds: Sequence[Fold]) -> bool:
    """Whether the place does not go on although the state changes."""
    steps, least = STANDING
    return len(folds) > steps and _squared(folds[-1].place - folds[-1 - steps].place) < least**2


def _next(equations: PlaneEquations, fold: Fold, step: float) -> Search[Fold | None]:
    """The fold a step further; None where corrections do not converge."""
    frame = Frame.along_change(equations, fold.null, 0.0, np.array([fold.tangent[1], -fold.tangent[0]]))
    by_s, by_t = step * fold.direction
    state, place = fold.state + by_s * fold.null + by_t * fold.along, fold.place + by_t * fold.tangent
    found = yield from _corrected(equations, state, place, frame, fold.direction)
    if found is None or found.direction @ fold.direction >= 0:
        return found
    return replace(found, direction=-found.direction)


def _corrected(
    equations: PlaneEquations, state: NDArray, place: NDArray, frame: Frame, kept: NDArray
) -> Search[Fold | None]:
    """The fold that Newton's method finds with `kept` . (s, t) as it is; None where it does not converge."""
    sizes: list[float] = []
    while len(sizes) < CORRECTIONS and not _stalled(sizes):
        surface = yield from _Surface.at(equations, state, place, frame)
        correction = surface.correction
        state, place = state + correction[0], place + correction[1]
        slope, by = yield from _slope(equations, state, place, frame, surface.by_t)
        determinant = by[0] * kept[1] - by[1] * kept[0]
        change = surface.moved(-slope / determinant * np.array([kept[1], -kept[0]]))
        size = max(_size(equations, *correction), _size(equations, *change))
        sizes.append(size)
        if not size < LARGEST:  # nor a number
            return None
        state, place = state + change[0], place + change[1]
        if size < TOLERANCE and surface.balanced:
            return _fold(equations, state, place, surface, by, (size, len(sizes)))
    return None


def _stalled(sizes: Sequence[float]) -> bool:
    """Whether corrections do not become smaller any more."""
    few, part = STALLED
    return len(sizes) > few and sizes[-1] > max(part * sizes[-1 - few], TOLERANCE)


def _fold(
    equations: PlaneEquations,
    state: NDArray,
    place: NDArray,
    surface: "_Surface",
    by: NDArray,
    how: tuple[float, int],
) -> Fold:
    """A fold with its own coordinates, from those of the frame in which it was found."""
    (by_s, _), (by_t, along) = surface.by_s, surface.by_t
    length, speed = _length(equations, by_s), np.sqrt(_squared(along))
    null = by_s / length
    curve = by[0] * by_t - by[1] * by_s  # along it the slope stays zero
    direction = np.array([null @ (equations.weight * curve), by[0] * speed])
    direction /= np.sqrt(_squared(direction))
    by_place = (by_t - null * (null @ (equations.weight * by_t))) / speed
    return Fold(state, place, null, along / speed, by_place, direction, by[0] / length**2, *how)


def _length(equations: PlaneEquations, state: NDArray) -> float:
    return float(np.sqrt(equations.weight @ state**2))


def _squared(place: NDArray) -> float:
    return float(place @ place)


def _size(equations: PlaneEquations, state: NDArray, place: NDArray) -> float:
    return float(np.sqrt(equations.weight @ state**2 + _squared(place)))


def _inside(equations: PlaneEquations, place: NDArray) -> bool:
    return bool((equations.nearest(place) == place).all())


def _near(equations: PlaneEquations, one: Fold, other: Fold) -> bool:
    """Whether a curve bends little between two folds."""
    if (
        other.null @ (equations.weight * one.null) < SMALLEST_COSINE
        or one.direction @ other.direction < SMALLEST_COSINE
    ):
        return False
    chord = other.place - one.place
    turn = abs(one.tangent[0] * other.tangent[1] - one.tangent[1] * other.tangent[0])
    return turn * np.sqrt(_squared(chord)) / 8 <= SAGITTA


def _at_the_edge(equations: PlaneEquations, fold: Fold, beyond: Fold) -> Search[Fold | None]:
    """The fold at which the curve leaves the range; None where it is not found."""
    edge = equations.nearest(beyond.place)
    axis = int(np.argmax(np.abs(edge - beyond.place)))
    share = (edge[axis] - fold.place[axis]) / (beyond.place[axis] - fold.place[axis])
    place = fold.place + share * (beyond.place - fold.place)
    place[axis] = edge[axis]
    found = yield from fold_at(
        equations, fold, fold.state + share * (beyond.state - fold.state), place, 1 - axis
    )
    return found if found and _inside(equations, found.place) else None


def _cusp(equations: PlaneEquations, fold: Fold, following: Fold, step: float) -> Search[Fold | None]:
    """The cusp between two folds, where the bend passes through zero; None where it is not found."""
    ends, bends, found = [0.0, step], [fold.bend, following.bend], None
    for _ in range(CUSP_CORRECTIONS):
        share = np.clip(bends[0] / (bends[0] - bends[1]), 0.1, 0.9)
        middle = ends[0] + share * (ends[1] - ends[0])
        found = yield from _next(equations, fold, middle)
        if found is None:
            return None
        side = 0 if found.bend * bends[0] > 0 else 1
        ends[side], bends[side] = middle, found.bend
        if ends[1] - ends[0] < SHORTEST_STEP:
            break
    return replace(found, cusp=True) if found else None


def _slope(
    equations: PlaneEquations, state: NDArray, place: NDArray, frame: Frame, by_t: tuple[NDArray, NDArray]
) -> Search[tuple[float, NDArray]]:
    """The slope at a solution, and its derivatives (2) by s and t."""
    states = state + DIFFERENCE * np.array([frame.null, -frame.null, frame.null + by_t[0]])
    places = place + DIFFERENCE * np.outer([0.0, 0.0, 1.0], by_t[1])
    (response,) = yield [Request(equations, states, places, frame.across[:, None])]
    ahead, behind, moved = _slopes(response, frame)
    return (ahead + behind) / 2, np.array([(ahead - behind) / 2, moved - ahead]) / DIFFERENCE


def _slopes(response: Response, frame: Frame) -> NDArray:
    """Slopes (n) of the place across the curve by s; the first direction is across."""
    return -1.0 / (response.by_place[:, :, 0] @ frame.measure)


@dataclass(frozen=True)
class _Surface:
    """Linearised solutions near a state and a place, each of these a pair of changes of both."""

    balanced: bool
    slope: float  # of the place across by s
    correction: tuple[NDArray, NDArray]  # towards the solutions, with neither s nor t
    by_s: tuple[NDArray, NDArray]
    by_t: tuple[NDArray, NDArray]

    @classmethod
    def at(
        cls, equations: PlaneEquations, state: NDArray, place: NDArray, frame: Frame
    ) -> Search["_Surface"]:
        """From the equations there, and the mean of those with their derivatives on both sides."""
        states = state + DIFFERENCE * np.outer([0.0, 1.0, -1.0], frame.null)
        places, both = np.broadcast_to(place, (3, 2)), np.stack([frame.across, frame.along], axis=1)
        (response,) = yield [Request(equations, states, places, both, beside=True)]
        slope, (across, along) = _slopes(response, frame), np.moveaxis(response.by_place, 2, 0)

        def change(rest: NDArray, along: float) -> tuple[NDArray, NDArray]:
            """Without s, where `rest` is left over."""
            gives_way = slope * (rest @ frame.measure)
            state = -rest - across * gives_way[:, None]
            return state.mean(axis=0), gives_way.mean() * frame.across + along * frame.along

        by_s = -across * slope[:, None]
        return cls(
            balanced=response.balanced,
            slope=slope.mean(),
            correction=change(response.rest, 0.0),
            by_s=(by_s.mean(axis=0), slope.mean() * frame.across),
            by_t=change(along, 1.0),
        )

    def moved(self, by: NDArray) -> tuple[NDArray, NDArray]:
        """Changes of state (N) and place (2) by s and t."""
        state, place = (by[0] * s + by[1] * t for s, t in zip(self.by_s, self.by_t, strict=True))
        return state, place
