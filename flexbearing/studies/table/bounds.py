"""Rows of a duty cycle without an answer: the damage of a row with more load is a bound."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

NONE = -1  # of a row that needs no bound, or has none


@dataclass(frozen=True)
class Conditions:
    """What tells whether a row of a cycle bounds another one."""

    loads: NDArray  # (N, L) every load that varies, without its sign
    others: NDArray  # (N) rows with the same number differ in loads alone

    def above(self, row: int, solved: NDArray) -> int:
        """The row with the next higher load among those that are solved (N); `NONE` where there is none."""
        more = np.all(self.loads >= self.loads[row], axis=1)
        found = np.flatnonzero(solved & more & (self.others == self.others[row]))
        if not found.size:
            return NONE
        return int(found[np.argmin(np.linalg.norm(self.loads[found], axis=1))])

    def bounds(self, lives: NDArray) -> NDArray:
        """For each row (C, N) without a life the row whose life is its bound; `NONE` for all others."""
        found, solved = np.full(lives.shape, NONE), np.isfinite(lives)
        for cycle, row in np.argwhere(np.isnan(lives)):
            found[cycle, row] = self.above(row, solved[cycle])
        return found
