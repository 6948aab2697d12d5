"""The variants at which levels are chosen that others share: extremes of what varies, and some between."""

from collections.abc import Sequence
from dataclasses import replace
from hashlib import sha256
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.studies.plan.identity import LENGTH
from flexbearing.studies.plan.task import Base, Corners, Variant

MOST = 6  # variants at which levels are chosen; two for each of the first three keys
FIRST = "operation."  # keys that come first: errors depend on loads before all


def sharing_levels(
    base: Base, variants: Sequence[Variant]
) -> tuple[tuple[Variant, ...], tuple[Corners, ...]]:
    """Find which variants share their levels, and where these are chosen.

    Parameters
    ----------
    base : Base
        what the variants are made of
    variants : sequence of Variant
        of a study; those with the same `levels` have the same parts and the same choices

    Returns
    -------
    variants : tuple of Variant
        whose levels are named by their corners, which the identities contain too: other corners may ask for
        other levels, and give other numbers
    corners : tuple of Corners
        one for each name; variants with other words, such as the profile of the rollers, have others
    """
    keys = sorted(range(len(base.keys)), key=lambda number: not base.keys[number].startswith(FIRST))
    groups: dict[Any, dict[int, tuple[float, ...]]] = {}
    for number, variant in enumerate(variants):
        if not variant.levels:
            continue
        values = [variant.in_si[key] for key in keys]
        words = tuple(repr(value) for value in values if not _is_number(value))
        numbers = tuple(float(value) for value in values if _is_number(value))
        groups.setdefault((variant.levels, words), {})[number] = numbers
    found, corners = list(variants), []
    for group in groups.values():
        places = [[*group][place] for place in extremes(np.array([*group.values()]))]
        name = sha256(" ".join(variants[place].identity for place in places).encode()).hexdigest()[:LENGTH]
        for number in group:
            text = f"{variants[number].identity} {name}"
            identity = sha256(text.encode()).hexdigest()[:LENGTH]
            found[number] = replace(variants[number], identity=identity, levels=name)
        corners.append(Corners(base, tuple(found[place] for place in places), name))
    return tuple(found), tuple(corners)


def extremes(points: NDArray) -> list[int]:
    """Points with the lowest and the highest value of each of the first coordinates, then some between.

    Of points with the same extreme value it is the one farthest from those that were taken before, all
    coordinates from 0 to 1; at first the one with the lowest sum. So crossed coordinates give corners. The
    points between are always the one farthest from all that were taken.

    Parameters
    ----------
    points : array (N, K)
        in any order, N >= 1

    Returns
    -------
    list of int
        six, or all if there are fewer different ones; the extremes of the first three coordinates that vary
        are the first

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
    return np.linalg.norm(points[:, None] - taken, axis=2).min(axis=1)


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
