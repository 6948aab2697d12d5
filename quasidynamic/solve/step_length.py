"""How long a step towards a minimum is."""

from collections.abc import Callable
from enum import StrEnum
from typing import Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

HALVINGS = 50
SHARES = (0.1, 0.7)  # of the step that went too far: least and most of what is tried next


def shortened(before: NDArray, after: NDArray) -> NDArray:
    """Part (n) of a step that went too far to try next: where the slope along it would vanish if straight."""
    straight = before / np.where(after > before, before - after, -1.0)
    return np.clip(np.where(after > 0.0, straight, 0.5), *SHARES)


class RingState(Protocol):
    """A ring at a place, with the forces there."""

    @property
    def place(self) -> NDArray:
        """Displacements of any shape."""
        ...

    @property
    def excess(self) -> NDArray:
        """Unbalanced forces that belong to them: minus the gradient of the energy."""
        ...


S = TypeVar("S", bound=RingState)


def before_the_minimum(at: Callable[[NDArray], S], state: S, step: NDArray) -> tuple[S, int]:
    """State after a step on a convex energy, halved while it runs far past the lowest energy on its way."""
    uphill, trials = -0.5 * float((state.excess * step).sum()), 0
    while True:
        trial, trials = at(state.place + step * 0.5**trials), trials + 1
        if float((trial.excess * step).sum()) >= uphill or trials == HALVINGS:
            return trial, trials


class SolverOutcome(StrEnum):
    """How the solve of a case ended."""

    RUNNING = ""  # no outcome yet
    CONVERGED = "converged"
    UNDETERMINED = "undetermined"  # nothing holds the ring: neither load nor contact
    STALLED = "stalled"  # no step lowers the residual
    LIMIT = "iteration limit"
    WORK = "work limit"  # every way together took as many evaluations as a case may
    NOT_FINITE = "not finite"
    OUT_OF_RANGE = "out of range"  # a balance far outside the range of the model
    TOO_SOFT = "too soft"  # a balance between stiffer grooves has none as they become as soft as these
    OVER_SHOULDER = "over the shoulder"  # a balance of whole contacts has none as shoulders cut these off
