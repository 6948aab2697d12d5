"""The iterations of a fixed-point coupling so far."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from flexbearing.coupling.partners import Compliance

IN_CONTACT = 1e-3  # of the largest stiffness: rolling elements above it touch both raceways


@dataclass(frozen=True)
class CouplingHistory:
    """Deviations that the bearing was given and what they led to, k iterations, newest last; N = 2 Z M."""

    deviations: tuple[NDArray, ...] = ()  # (N) given to the bearing [m]
    residuals: tuple[NDArray, ...] = ()  # (N) answer of the structure less what was given [m]
    contacts: tuple[NDArray, ...] = ()  # (Z) whether an element touches both raceways
    force_by_deviation: NDArray | None = None  # (N, N) [N/m] about that of the newest iteration
    compliance: Compliance | None = None  # of the structure there; None where unknown

    def extended(
        self, deviation: NDArray, answer: NDArray, by_deviation: NDArray, compliance: Compliance | None
    ) -> "CouplingHistory":
        """The history with one more iteration, deviation and answer (2, Z, M)."""
        stiffness = np.abs(by_deviation.diagonal()).reshape(deviation.shape).max((0, 2))
        return replace(
            self,
            deviations=(*self.deviations, deviation.ravel()),
            residuals=(*self.residuals, (answer - deviation).ravel()),
            contacts=(*self.contacts, stiffness > IN_CONTACT * stiffness.max()),
            force_by_deviation=by_deviation,
            compliance=compliance,
        )

    @property
    def residual_norms(self) -> list[float]:
        """Lengths of the residuals [m]."""
        return [float(np.linalg.norm(residual)) for residual in self.residuals]

    @property
    def same_contacts(self) -> int:
        """How many of the newest iterations have the contacts of the last one, at least one.

        All of them while the last residual is not the smallest: contacts that open and close in turns would
        otherwise be forgotten each time.
        """
        count, norms = len(self.residuals), self.residual_norms
        if norms[-1] > min(norms):
            return count
        changed = [not np.array_equal(earlier, self.contacts[-1]) for earlier in reversed(self.contacts)]
        return changed.index(True) if any(changed) else count
