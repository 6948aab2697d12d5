"""The variants at which levels are chosen that others share: extremes of what varies, and some between."""

from array import array
from hashlib import sha256
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.studies.plan.checked import CheckedVariants
from flexbearing.studies.plan.task import LENGTH, Base, Corners

MOST = 6  # variants at which levels are chosen; two for each of the first three keys
FIRST = "operation."  # keys that come first: errors depend on loads before all


def share_levels(base: Base, variants: CheckedVariants) -> tuple[Corners, ...]:
    """Find which variants share their levels, and where these are chosen."""
    if not variants.have_levels:
        return ()
    keys = sorted(range(len(base.keys)), key=lambda number: not base.keys[number].startswith(FIRST))
    groups: dict[Any, tuple[array, array]] = {}  # numbers of variants, and their coordinates
    for number, variant in enumerate(variants):
        if not variant.levels:
            continue
        values = [variant.in_si[key] for key in keys]
        words = tuple(repr(value) for value in values if not _is_number(value))
        members, points = groups.setdefault((variant.levels, words), (array("Q"), array("d")))
        members.append(number)
        points.extend(float(value) for value in values if _is_number(value))
    corners = []
    for members, points in groups.values():
        some = extremes(np.array(points).reshape(len(members), len(points) // len(members)))
        places = [members[place] for place in some]
        name = sha256(" ".join(variants.identity(place) for place in places).encode()).hexdigest()[:LENGTH]
        for number in members:
            text = f"{variants.identity(number)} {name}"
            variants.rename(number, sha256(text.encode()).hexdigest()[:LENGTH], name)
        corners.append(Corners(base, tuple(variants[place] for place in places), name))
    return tuple(corners)


def extremes(points: NDArray) -> list[int]:
    """Points with the lowest and the highest value of each of the first coordinates, then some between.

    Of points with the same extreme value it is the one farthest from those that were taken before, all
    coordinates from 0 to 1; at first the one with the lowest sum. So crossed coordinates give corners. The
    points between are always the one farthest from all that were taken.

    >>> extremes(np.array([[1.0], [2.0], [3.0], [4.0], [5.0], [6.0], [7.0], [8.0], [9.0]]))
    [0, 8, 4, 2, 6, 1]
    """
    ordered, places = np.unique(points, axis=0, return_index=True)
    lowest, width = ordered.min(axis=0), np.ptp(ordered, axis=0)
    scaled = ((ordered - lowest) / np.where(width > 0, width, 1.0))[:, width > 0]
    taken: list[int] = []
    for coordinate in scaled.T[: MOST // 2]:
        for end in (0.0, 1.0):
            at_end = np.flatnonzero(coordinate == end)
            taken.append(int(at_end[np.argmax(_away(scaled[at_end], scaled[taken]))]))
    taken = list(dict.fromkeys(taken))
    while len(taken) < min(MOST, len(ordered)):
        taken.append(int(np.argmax(_away(scaled, scaled[taken]))))
    return [int(places[place]) for place in taken]


def _away(points: NDArray, taken: NDArray) -> NDArray:
    """Distance of points (N, K) from the nearest of those taken (T, K); at first how low they are."""
    if not len(taken):
        return -points.sum(axis=1)
    return np.min([np.linalg.norm(points - one, axis=1) for one in taken], axis=0)


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
