"""How far one number has to go until a function changes its sign, many numbers side by side."""

from collections.abc import Callable, Generator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import inf, isnan

import numpy as np
from scipy.optimize import elementwise

HALVINGS = 7  # towards a place that can be computed, or where the function grows
CLOSE = 0.02  # of the distance to a place that cannot be computed
TOLERANCE = 1e-4  # of the distance
ITERATIONS = 40
SHARES = (0.1, 0.3, 0.6, 1.0)  # of the way to an end, where a function is looked at
Batch = Callable[[Sequence[int], Sequence[float]], list[float]]  # numbers of searches and places to values
Walk = Generator[float, float, None]


@dataclass
class Track:
    """A search: what is known of a function that is negative at zero; NaN: it cannot be computed."""

    values: dict[float, float]  # by place, from zero on
    end: float  # the last place that is tried
    closed: bool = field(default=False)  # whether places beyond the end cannot be computed

    @property
    def places(self) -> list[float]:
        """Places with a value, in their order."""
        return sorted(place for place, value in self.values.items() if not isnan(value))

    @property
    def best(self) -> float:
        """Where the largest value is."""
        return max(self.places, key=self.values.__getitem__)

    @property
    def bracket(self) -> tuple[float, float] | None:
        """Neighbours of which the second is the first one without a negative value."""
        places = self.places
        for before, place in pairwise(places):
            if self.values[place] >= 0:
                return before, place
        return None

    @property
    def root(self) -> float | None:
        """The place next to the change of sign with the smallest value; None without one."""
        return self.bracket and min(self.bracket, key=lambda place: abs(self.values[place]))

    @property
    def peak(self) -> tuple[float, float, float] | None:
        """The largest value between its neighbours; None where it is at an end."""
        places = self.places
        number = places.index(self.best)
        return tuple(places[number - 1 : number + 2]) if 0 < number < len(places) - 1 else None  # type: ignore[return-value]


def reach(tracks: Sequence[Track], first: Sequence[float], batch: Batch) -> None:
    """Follow every function from zero to its root, else to its largest value.

    Each track has its value at zero, and takes all further ones; `first` is where each root is expected, and
    `batch` gives values of some of the functions, a place each.
    """
    _side_by_side(tracks, [_walk(track, place) for track, place in zip(tracks, first, strict=True)], batch)
    refine(tracks, batch)


def look(tracks: Sequence[Track], batch: Batch) -> None:
    """Take functions that fall at first at a few places up to their ends, and refine what is found there."""
    _take(tracks, [(n, share * track.end) for share in SHARES for n, track in enumerate(tracks)], batch)
    refine(tracks, batch)


def _take(tracks: Sequence[Track], wanted: Sequence[tuple[int, float]], batch: Batch) -> None:
    """Values of functions at some places."""
    found = batch([number for number, _ in wanted], [place for _, place in wanted]) if wanted else []
    for (number, place), value in zip(wanted, found, strict=True):
        tracks[number].values[place] = value


def refine(tracks: Sequence[Track], batch: Batch) -> None:
    """The largest values between known places, then the roots."""
    ends = {n: track.places[-2:] for n, track in enumerate(tracks) if track.bracket is None}
    rising = [(n, sum(last) / 2) for n, last in ends.items() if tracks[n].best == last[-1] > 0.0]
    _take(tracks, rising, batch)  # the largest value may be before an end
    peaks = {n: track.peak for n, track in enumerate(tracks) if track.bracket is None and track.peak}
    _refine(tracks, peaks, batch, largest=True)
    _refine(tracks, {n: track.bracket for n, track in enumerate(tracks) if track.bracket}, batch)


def _walk(track: Track, first: float) -> Walk:
    """Places until the sign changes, the end is met, or the largest value has neighbours."""
    place, halvings = min(first, 0.5 * track.end), 0
    while track.bracket is None:
        value = yield place
        if isnan(value):
            track.end, track.closed = place, True
        known = track.places
        if track.bracket or track.peak:
            return
        if known[-1] >= (1 - CLOSE * track.closed) * track.end and track.best > 0:
            return
        halvings += bool(track.closed or track.best == 0.0)
        if halvings > HALVINGS:
            return
        place = _next(track, known)


def _next(track: Track, known: list[float]) -> float:
    if track.best == 0.0 and len(known) > 1:  # it falls further away: there may be a rise before
        return 0.5 * known[1]
    if track.closed:
        return 0.5 * (known[-1] + track.end)
    return min(2.0 * known[-1], track.end)


def _side_by_side(tracks: Sequence[Track], walks: Sequence[Walk], batch: Batch) -> None:
    """Advance all walks together, a place of each at a time."""
    wanted = {number: next(walk) for number, walk in enumerate(walks) if tracks[number].end > 0}
    while wanted:
        values = batch(list(wanted), list(wanted.values()))
        following = {}
        for (number, place), value in zip(wanted.items(), values, strict=True):
            tracks[number].values[place] = value
            try:
                following[number] = walks[number].send(value)
            except StopIteration:
                continue
        wanted = following


def _refine(tracks: Sequence[Track], brackets: dict, batch: Batch, *, largest: bool = False) -> None:
    """Roots between two places, or largest values among three."""
    if not brackets:
        return

    def values(places: np.ndarray, numbers: np.ndarray) -> np.ndarray:
        numbers, flat = np.broadcast_arrays(numbers, places)
        wanted = [(int(n), float(place)) for n, place in zip(numbers.ravel(), flat.ravel(), strict=True)]
        new = [pair for pair in dict.fromkeys(wanted) if pair[1] not in tracks[pair[0]].values]
        _take(tracks, new, batch)
        found = np.array([tracks[n].values[place] for n, place in wanted]).reshape(flat.shape)
        return -np.where(np.isnan(found), -inf, found) if largest else found

    ends = tuple(np.array(each) for each in zip(*brackets.values(), strict=True))
    numbers = np.array(list(brackets))
    if largest:
        tolerances = {"xatol": 0.0, "xrtol": 1e-3, "fatol": 0.0, "frtol": 1e-7}
        elementwise.find_minimum(values, ends, args=(numbers,), tolerances=tolerances, maxiter=ITERATIONS)
    else:
        tolerances = {"xatol": 0.0, "xrtol": TOLERANCE, "fatol": 1e-6, "frtol": 0.0}
        elementwise.find_root(values, ends, args=(numbers,), tolerances=tolerances, maxiter=ITERATIONS)
