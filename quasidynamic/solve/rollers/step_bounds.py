"""How far the unknowns of a bearing may go in one step."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.scales import LENGTH
from quasidynamic.balance.rollers.unknowns import OUTER
from quasidynamic.contact.line import GAP_ROUNDING

SPIN_CHANGE = 0.5  # of the spin in pure rolling in a step
KEPT = 0.1  # of an approach or a film in a step


def bounded(balance: BearingBalance, before: NDArray, after: NDArray) -> NDArray:
    """Keep approaches at the outer raceway and films positive: at most nine tenths go in a step.

    A roller thrown off the outer raceway, or a film below zero, has no slope that leads back. Spins are
    those of `bounded_spins`.

    Parameters
    ----------
    balance : BearingBalance
        of C cases
    before, after : array (C, N)
        unknowns, scaled

    Returns
    -------
    array (C, N)
        `after` with rollers that stay within reach of what they touch
    """
    layout, held = balance.layout, bounded_spins(balance, before, after)
    approach, films = layout.field(0), slice(layout.field(-3).start, layout.field(-2).stop)
    held[:, films] = np.maximum(after[:, films], KEPT * before[:, films])
    old, new = _largest_approach(balance, before), _largest_approach(balance, after)
    lowest = np.minimum(old, KEPT * old) - 3 * GAP_ROUNDING / LENGTH
    held[:, approach] += np.maximum(lowest - new, 0.0)
    return held


def bounded_spins(balance: BearingBalance, before: NDArray, after: NDArray) -> NDArray:
    """Let spins move by a share only.

    The spin of a roller that hardly anything drives, or whose traction has reached its limit, may be sent
    anywhere, far from where friction has a slope that leads back.

    Parameters
    ----------
    balance : BearingBalance
        of C cases
    before, after : array (C, N)
        unknowns, scaled

    Returns
    -------
    array (C, N)
        `after` with spins that changed by `SPIN_CHANGE` at most
    """
    held, spin = after.copy(), balance.layout.field(-1)
    least, most = before[:, spin] - SPIN_CHANGE, before[:, spin] + SPIN_CHANGE
    held[:, spin] = np.minimum(np.maximum(after[:, spin], least), most)
    return held


def _largest_approach(balance: BearingBalance, scaled: NDArray) -> NDArray:
    """Approach (C, Z) where each roller is nearest to the outer raceway, whatever its shape, scaled."""
    layout = balance.layout
    centre = scaled[:, layout.field(0)]
    if layout.axial_modes == 1:
        return centre
    if not layout.elastic_raceways and balance.deviation is None:
        return centre + np.abs(scaled[:, layout.field(1)])
    beyond = balance.inputs(balance.unpack(scaled)).approach[OUTER, 1:] / LENGTH
    shape = balance.roller.raceways.slices.modes[:, 1:]
    return centre + np.einsum("km,mcz->kcz", shape, beyond).max(0)
