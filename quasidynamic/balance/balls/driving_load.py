"""Least load with which a race drives a ball."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

SERIES, EXACT = 1e-3, 20.0  # of the width: load below which N is taken from its series, above which it is Q


class DrivingLoad(NamedTuple):
    """Load that the friction balance of a ball sees."""

    value: NDArray  # (...) [N] N
    by_load: NDArray  # (...) [-] dN/dQ
    by_width: NDArray  # (...) [-] dN/dw
    hold: NDArray  # (...) [-] h = Q/N, the part of the friction that is there


def driving_load(load: NDArray, width: NDArray) -> DrivingLoad:
    r"""Load with which a race drives a ball, never below w.

    .. math:: N = Q / h,\qquad h = \tanh (Q/w)

    A cage carries a ball along that races press too lightly; there is none here, so these press with w.

    Parameters
    ----------
    load : array (...)
        Q [N], >= 0
    width : array (...)
        w [N], >= 0

    Returns
    -------
    DrivingLoad
        of both kinds of balls without a kink

    Source
    ------
    An assumption, with the h of `grip`.

    Valid
    -----
    N = Q to rounding from Q = 19 w on, to a hundredth from 2.5 w on; below, the motion is an estimate.

    >>> light = driving_load(np.array([0.0, 50.0]), np.array([2.0, 2.0]))
    >>> light.value.tolist(), light.hold.tolist()
    ([2.0, 50.0], [0.0, 1.0])
    """
    part = load / np.maximum(width, np.finfo(float).tiny)
    heavy, light = part > EXACT, part < SERIES
    safe = np.where(heavy | light, 1.0, part)
    hold = np.tanh(safe)
    share = (1 - hold**2) * safe / hold
    return DrivingLoad(
        value=np.where(heavy, load, np.where(light, width * (1 + part**2 / 3), load / hold)),
        by_load=np.where(heavy, 1.0, np.where(light, 2 * part / 3, (1 - share) / hold)),
        by_width=np.where(heavy, 0.0, np.where(light, 1 - part**2 / 3, safe * share / hold)),
        hold=np.where(heavy, 1.0, np.where(light, part, hold)),
    )
