"""Rows of a duty cycle without a result: the damage of a row with more load is a bound."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

NONE = -1  # of a row that needs no bound, or has none


@dataclass(frozen=True)
class Conditions:
    """What decides whether a row of a cycle bounds another one."""

    loads: NDArray  # (N, L) every load that varies, without its sign
    others: NDArray  # (N) rows with the same number differ in loads alone

    def bounds(self, lives: NDArray) -> NDArray:
        """For each row (C, N) without a life the row whose life is its bound; `NONE` for all others."""
        found = np.full(lives.shape, NONE)
        for cycle, of_rows in enumerate(lives):
            lacking, solved = np.flatnonzero(np.isnan(of_rows)), np.flatnonzero(np.isfinite(of_rows))
            for group in np.unique(self.others[lacking]):
                alike = solved[self.others[solved] == group]
                for row in lacking[self.others[lacking] == group]:
                    found[cycle, row] = self._above(row, alike)
        return found

    def _above(self, row: int, solved: NDArray) -> int:
        """The row with the next higher load among some rows; `NONE` where there is none."""
        more = solved[np.all(self.loads[solved] >= self.loads[row], axis=1)]
        return int(more[np.argmin(np.linalg.norm(self.loads[more], axis=1))]) if more.size else NONE
