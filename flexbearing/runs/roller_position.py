"""How much the place of the rollers within a pitch matters, told from the loads of one position."""

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.roller import Case
from quasidynamic import Equilibrium
from quasidynamic.contact.line import EXPONENT
from quasidynamic.note import Note, information

TOLD = 0.02  # change of the largest load that is told in a case without accuracy.target (assumed)


def load_half_a_pitch_further(azimuths: NDArray, loads: NDArray, direction: float) -> float:
    r"""Largest load when every roller has moved on by half a pitch, from the loads where they are.

    .. math:: Q' = f\,\Big(\tfrac{9}{16}(x_0 + x_1) - \tfrac{1}{16}(x_{-1} + x_2)\Big)_+^{10/9},
              \quad x = Q^{9/10}

    Approaches x between four neighbours by a cubic; f keeps the resultant along the load.

    Parameters
    ----------
    azimuths : array (Z)
        of the rollers, evenly around [rad]
    loads : array (Z)
        Q of the inner contacts [N], >= 0
    direction : float
        azimuth of the load [rad]

    Returns
    -------
    float
        [N]; NaN where the loads have no resultant along the load

    Source
    ------
    Cubic interpolation at the middle of an interval; derived here.

    Valid
    -----
    Within 2 % of the largest load on bearings of 14 and 30 rollers between rigid rings and on cages of 7 to
    24 bars; not where every roller stands alike to the bars.
    """
    approach = loads ** (1 / EXPONENT)
    before, after, beyond = (np.roll(approach, -shift) for shift in (-1, 1, 2))
    between = (9 * (approach + after) - before - beyond) / 16
    moved = np.maximum(between, 0.0) ** EXPONENT
    resultant = loads @ np.cos(azimuths - direction)
    there = moved @ np.cos(azimuths + np.pi / loads.size - direction)
    return float(moved.max() * resultant / there) if resultant > 0 and there > 0 else float("nan")


def notes(case: Case, state: Equilibrium) -> tuple[Note, ...]:
    """A note where half a pitch changes the largest load by more than the target, or may do so unseen."""
    loads, count = state.loads[0], case.bearing.rollers
    bars = case.outer.bars if case.outer.kind == "squirrel_cage" else None
    ask = "operation.roller_positions = 8 gives the range over a pitch"
    if bars is not None and bars % count == 0:
        words = (
            f"every roller stands alike to the bars of the cage, {bars} of them for {count} rollers; {ask}"
        )
        return (information("roller-position", f"roller position: {words}"),)
    azimuths = state.balance.roller.bearing.azimuths
    load = load_half_a_pitch_further(azimuths, loads, case.operation.load_direction)
    change = load / loads.max() - 1 if loads.max() > 0 else 0.0
    if not abs(change) > (case.accuracy.target or TOLD):
        return ()
    words = (
        f"with all rollers half a pitch further the largest inner load is about {load:,.3g} N instead of "
        f"{loads.max():,.4g} N ({change:+.1%}); {ask}"
    )
    return (information("roller-position", f"roller position: {words}"),)
