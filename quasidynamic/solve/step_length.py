"""How long a step towards a minimum is."""

import numpy as np
from numpy.typing import NDArray

SHARES = (0.1, 0.7)  # of the step that went too far: least and most of what is tried next


def shortened(before: NDArray, after: NDArray) -> NDArray:
    """Part (n) of a step that went too far to try next: where the slope along it would vanish if straight.

    Parameters
    ----------
    before, after : array (n)
        slope along the step at its start, below zero, and at its end; half a step where neither is passed
    """
    straight = before / np.where(after > before, before - after, -1.0)
    return np.clip(np.where(after > 0.0, straight, 0.5), *SHARES)
