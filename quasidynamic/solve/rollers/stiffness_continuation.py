"""Down from nearly rigid raceways to those that are requested."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.solve.rollers.load_continuation import Continuation

STIFFEST = 2.0**-12  # of the compliance that is requested, at which raceways are nearly rigid
FIRST_STEP = 2 * np.log(2)  # of the logarithm of the compliance
SHORT_STEP = 0.1  # from where every way is tried before a step is halved
SHORTEST_STEP = 0.02
MAX_EVALUATIONS = 3000  # of the bearing

Solver = Callable[[BearingBalance, NDArray, bool], Continuation]


def from_stiffer_raceways(balance: BearingBalance, unknowns: NDArray, solve: Solver) -> Continuation:
    """Equilibrium of one case, from raceways that are nearly rigid in growing or halved steps of compliance.

    Rollers touch one after the other as raceways grow softer, where one step to the soft ones leaps between
    sets of rollers that touch.
    """
    reached, step, evaluations = np.log(STIFFEST) - FIRST_STEP, FIRST_STEP, 0
    while evaluations < MAX_EVALUATIONS:
        target = min(reached + step, 0.0)
        solved = solve(softened(balance, np.exp(target)), unknowns, step < SHORT_STEP)
        evaluations += solved.evaluations
        if solved.unknowns is None:
            step /= 2
            if step < SHORTEST_STEP:
                break
            continue
        reached, unknowns = target, solved.unknowns
        if reached == 0.0:
            return Continuation(unknowns, evaluations)
        step *= 2
    return Continuation(None, evaluations)


def softened(balance: BearingBalance, factor: float) -> BearingBalance:
    """The same balance between raceways of a multiple of the compliance and of the given shape."""
    inner, outer = (None if matrix is None else factor * matrix for matrix in balance.compliance)
    shape = None if balance.deviation is None else factor * balance.deviation
    return replace(balance, compliance=(inner, outer), deviation=shape)
