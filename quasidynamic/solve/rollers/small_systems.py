"""Small linear systems side by side: a singular one is not a number and spoils no other."""

import numpy as np
from numpy.typing import NDArray


def cyclic_tridiagonal(middle: NDArray, before: NDArray, after: NDArray, sides: NDArray) -> NDArray:
    """Solve middle s_j + before s_(j-1) + after s_(j+1) = sides (R, C, Z), cyclic in j, for all cases.

    Not a number for cases whose system is singular, closed or cut open: such as that of rollers which only
    hand on their spin, where the speed of all of them together is undetermined.
    """
    # costly to import, and checking a case does without
    from scipy.linalg.lapack import dgtsv  # pyright: ignore[reportAttributeAccessIssue]  # made at import

    count, cases, rollers = sides.shape
    corners = np.zeros((2, cases, rollers))  # the last spin in the first equation, and the reverse
    corners[0, :, 0], corners[1, :, -1] = before[:, 0], after[:, 0]
    lower, upper = before.repeat(rollers, axis=1), after.repeat(rollers, axis=1)
    lower[:, 0] = upper[:, -1] = 0.0
    columns = np.concatenate([sides, corners]).reshape(count + 2, -1).T
    bands = lower.ravel()[1:], middle.ravel(), upper.ravel()[:-1]
    *_, solved, fault = dgtsv(*bands, columns, overwrite_dl=True, overwrite_du=True, overwrite_b=True)
    if fault:  # of one case; the columns of all are overwritten
        if cases == 1:
            return np.full(sides.shape, np.nan)
        each = (slice(case, case + 1) for case in range(cases))
        alone = [cyclic_tridiagonal(middle[c], before[c], after[c], sides[:, c]) for c in each]
        return np.concatenate(alone, axis=1)
    solved = solved.T.reshape(count + 2, cases, rollers)
    opened, (first, last) = solved[:count], solved[count:]
    # Both ends of the chain from each other: s_last = opened_last - first s_last - last s_first, ...
    a, b, c, d = 1 + first[:, -1], last[:, -1], first[:, 0], 1 + last[:, 0]
    end, begin = opened[:, :, -1], opened[:, :, 0]
    determinant = a * d - b * c
    determinant[determinant == 0] = np.nan
    end, begin = (d * end - b * begin) / determinant, (a * begin - c * end) / determinant
    return opened - first * end[..., None] - last * begin[..., None]


def dense(matrix: NDArray, side: NDArray) -> NDArray:
    """Solve small dense systems (C, n, n); not a number where one is singular."""
    try:
        return np.linalg.solve(matrix, side)
    except np.linalg.LinAlgError:
        if len(matrix) == 1:
            return np.full(side.shape, np.nan)
        return np.concatenate([dense(m[None], s[None]) for m, s in zip(matrix, side, strict=True)])
