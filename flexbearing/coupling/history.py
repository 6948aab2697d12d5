"""What an alternation has tried, and what it may expect of the next trial."""

from dataclasses import dataclass, field
from functools import partial

import numpy as np
from numpy.typing import NDArray

from flexbearing.coupling.acceleration import Seen
from flexbearing.coupling.partners import Compliance

TOUCHING = 1e-3  # of the largest stiffness: rollers above it touch both raceways


@dataclass
class History:
    """Trials of an alternation, oldest first."""

    given: list[NDArray] = field(default_factory=list)  # deviations, flat [m]
    residuals: list[NDArray] = field(default_factory=list)  # answers less what was given, flat [m]
    stiffness: list[NDArray] = field(default_factory=list)  # (Z) of the rollers [N/m]

    def add(self, given: NDArray, residual: NDArray, stiffness: NDArray) -> None:
        """Take note of a trial (2, Z, M)."""
        self.given.append(given.ravel())
        self.residuals.append(residual.ravel())
        self.stiffness.append(stiffness)

    @property
    def sizes(self) -> list[float]:
        """Lengths of the residuals [m]."""
        return [float(np.linalg.norm(residual)) for residual in self.residuals]

    def seen(self, compliance: Compliance | None) -> Seen:
        """What a rule may know; without a compliance no change can be estimated."""
        stiffness, size = self.stiffness[-1], len(self.given[-1])
        return Seen(
            given=np.array(self.given).T,
            residuals=np.array(self.residuals).T,
            alike=self._alike(),
            estimate=compliance and partial(change_per_residual, compliance, stiffness, size),
        )

    def _alike(self) -> int:
        """So many of the newest trials tell of the present slope; all of them while there is no headway.

        Contacts that open and close in turns would otherwise be forgotten each time.
        """
        if self.sizes[-1] > min(self.sizes):
            return len(self.given)
        touching = [stiffness > TOUCHING * stiffness.max() for stiffness in self.stiffness]
        other = [not np.array_equal(each, touching[-1]) for each in reversed(touching)]
        return other.index(True) if any(other) else len(other)


def change_per_residual(compliance: Compliance, stiffness: NDArray, size: int) -> NDArray:
    r"""How far deviations are from the root of C Q(w) = w where a residual is left, about.

    .. math:: G = (1 + C K)^{-1},\quad K_{jm} = \frac{k_j}{2m + 1}

    Every roller is a spring over its length between raceways that do not move; it feels the outer
    deviation less the inner one, the raceway is pushed by it inwards or outwards.

    Parameters
    ----------
    compliance : pair of arrays (Z, M, Z, M) or None
        C, outward deviation of the inner and the outer raceway per outward force [m/N]
    stiffness : array (Z)
        k of the rollers [N/m]
    size : int
        2 Z M

    Returns
    -------
    array (2 Z M, 2 Z M)
        G [-]
    """
    count = size // 2
    spring = (stiffness[:, None] / (2 * np.arange(count // len(stiffness)) + 1)).ravel()
    answer = np.zeros((2, count, 2, count))
    for race, matrix in enumerate(compliance):
        if matrix is not None:
            own = matrix.reshape(count, count) * spring
            answer[race, :, race], answer[race, :, 1 - race] = own, -own
    return np.linalg.inv(np.eye(size) + answer.reshape(size, size))
