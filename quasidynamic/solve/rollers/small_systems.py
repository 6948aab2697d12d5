"""Small linear systems side by side: a singular one is not a number and spoils no other."""

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray


def cyclic_tridiagonal(middle: NDArray, before: NDArray, after: NDArray, sides: NDArray) -> NDArray:
    """Solve middle s_j + before s_(j-1) + after s_(j+1) = sides (R, C, Z), cyclic in j, for all cases.

    Not a number for cases whose system is singular, closed or cut open: such as that of rollers which only
    hand on their spin, where the speed of all of them together is undetermined.
    """
    count, cases, rollers = sides.shape
    rows = np.zeros((rollers, count + 5, cases))  # the diagonal, two after it, and the right-hand sides
    rows[:, 0], rows[:-1, 1], rows[:, 3:-2] = middle.T, after[:, 0], sides.transpose(2, 0, 1)
    rows[0, -2], rows[-1, -1] = before[:, 0], after[:, 0]  # last spin in the first equation, the reverse
    solved = _tridiagonal(rows, before[:, 0]).transpose(1, 2, 0)
    opened, (first, last) = solved[:count], solved[count:]
    # Both ends of the chain from each other: s_last = opened_last - first s_last - last s_first, ...
    a, b, c, d = 1 + first[:, -1], last[:, -1], first[:, 0], 1 + last[:, 0]
    end, begin = opened[:, :, -1], opened[:, :, 0]
    determinant = _nonzero(a * d - b * c)
    end, begin = (d * end - b * begin) / determinant, (a * begin - c * end) / determinant
    return opened - first * end[..., None] - last * begin[..., None]


def _tridiagonal(rows: NDArray, lower: NDArray) -> NDArray:
    """Solve rows (Z, 3 + R, C) with `lower` (C) before the diagonal, in place: (Z, R, C).

    Gauss with the larger of two pivots, as LAPACK's gtsv: loading `scipy.linalg` takes longer than solving.
    """
    for row, below in pairwise(rows):
        under = np.concatenate([lower[None], below[:2], below[3:]])
        if (larger := np.abs(lower) > np.abs(row[0])).any():
            row[:], under = np.where(larger, under, row), np.where(larger, row, under)
        under -= under[0] / _nonzero(row[0]) * row
        below[:2], below[3:] = under[1:3], under[3:]
    solved = np.zeros((len(rows) + 2, *rows[0, 3:].shape))
    for number in reversed(range(len(rows))):
        diagonal, after, beyond = rows[number, :3]
        left = rows[number, 3:] - after * solved[number + 1] - beyond * solved[number + 2]
        solved[number] = left / _nonzero(diagonal)
    return solved[:-2]


def _nonzero(divisor: NDArray) -> NDArray:
    return np.where(divisor == 0, np.nan, divisor)


def dense(matrix: NDArray, side: NDArray) -> NDArray:
    """Solve small dense systems (C, n, n); not a number where one is singular."""
    try:
        return np.linalg.solve(matrix, side)
    except np.linalg.LinAlgError:
        if len(matrix) == 1:
            return np.full(side.shape, np.nan)
        return np.concatenate([dense(m[None], s[None]) for m, s in zip(matrix, side, strict=True)])
