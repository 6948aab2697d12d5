"""Linear equations of a ring and balls that touch nothing but the ring's races."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

REFINEMENTS = 1  # of a solution, for balls near the point where they jump


class BorderedMatrix(NamedTuple):
    r"""Derivatives of the forces on a ring in F directions and on Z balls in two.

    .. math:: A = \begin{pmatrix} K & L \\ M & D \end{pmatrix},\quad
              D = \operatorname{diag}(D_1 \dots D_Z),\quad S = K - L D^{-1} M

    Source
    ------
    Golub and Van Loan, Matrix Computations, 4th ed. (2013), sec. 3.2, Schur complement.
    """

    ring: NDArray  # (F, F) K
    ring_by_balls: NDArray  # (F, 2 Z) L
    balls_by_ring: NDArray  # (2 Z, F) M
    balls: NDArray  # (Z, 2, 2) D_j

    def solved(self, right: NDArray) -> NDArray:
        """Unknowns (F + 2 Z, R) for right-hand sides (F + 2 Z, R); not a number where A is singular."""
        try:
            solution = self._eliminated(right)
            for _ in range(REFINEMENTS):
                solution = solution + self._eliminated(right - self.times(solution))
        except np.linalg.LinAlgError:
            return np.full_like(right, np.nan)
        return solution

    def times(self, unknowns: NDArray) -> NDArray:
        """Product (F + 2 Z, R) with unknowns (F + 2 Z, R)."""
        ring, balls = np.split(unknowns, [len(self.ring)])
        own = (self.balls @ balls.reshape(-1, 2, balls.shape[-1])).reshape(balls.shape)
        return np.concatenate(
            [self.ring @ ring + self.ring_by_balls @ balls, self.balls_by_ring @ ring + own]
        )

    def sign(self) -> float:
        """Sign of the determinant; zero where a ball or A is singular."""
        try:
            reduced = self.ring - self.ring_by_balls @ self._of_balls(self.balls_by_ring)
        except np.linalg.LinAlgError:
            return 0.0
        return float(np.linalg.slogdet(self.balls)[0].prod() * np.linalg.slogdet(reduced)[0])

    def _eliminated(self, right: NDArray) -> NDArray:
        count = len(self.ring)
        both = self._of_balls(np.concatenate([self.balls_by_ring, right[count:]], axis=1))
        by_ring, alone = both[:, :count], both[:, count:]
        ring = np.linalg.solve(
            self.ring - self.ring_by_balls @ by_ring, right[:count] - self.ring_by_balls @ alone
        )
        return np.concatenate([ring, alone - by_ring @ ring])

    def _of_balls(self, right: NDArray) -> NDArray:
        """Unknowns (2 Z, R) of the balls alone."""
        return np.linalg.solve(self.balls, right.reshape(-1, 2, right.shape[-1])).reshape(right.shape)
