"""Spins of tapered rollers and speeds of their cages, by Newton's method."""

from collections.abc import Callable
from contextlib import suppress
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.inclined_motion import InclinedMotion, MotionState
from quasidynamic.errors import NotSolved
from quasidynamic.solve.step_length import SolverOutcome, before_the_minimum

TOLERANCE = 1e-14  # of the largest load on the lever of each balance
ROUNDING_TOLERANCE = 1e-10  # the same, where steps lower the imbalance no more
NEWTON_STEPS, SHORT_STEPS = 60, 300
GROWTH = 1.2  # of the imbalance in a short step; else the next is shorter
EASING = 0.8  # of what makes a step short, from step to step
SHORTEST = 1e6  # times the steepest slopes make a step short


class _Trial(NamedTuple):
    """Rollers and cages at some speeds."""

    place: NDArray  # (Z + R) drifts from pure rolling [rad/s]
    state: MotionState
    scale: NDArray  # (Z + R) largest load on the lever of each balance [N m]

    @property
    def excess(self) -> NDArray:
        """Imbalance (Z + R) [N m]."""
        return self.state.imbalance

    @property
    def left(self) -> float:
        """Largest imbalance, in the unit of the tolerances."""
        return float(np.abs(self.excess / self.scale).max())


At = Callable[[NDArray], _Trial]


def balanced_motion(motion: InclinedMotion) -> MotionState:
    """Motion in balance, found from pure rolling.

    Raises
    ------
    NotSolved
        when no search reaches a balance

    Source
    ------
    `InclinedMotion`.

    Valid
    -----
    As the laws; of several balances under a traction that falls with sliding the one that is reached first.
    """
    rollers, rows = motion.bearing.all_rollers, len(motion.bearing.rows)
    loads = np.maximum(motion.slice_loads, motion.smallest_load) @ motion.slices.widths
    levers = motion.bearing.roller.diameter / 2, motion.bearing.rollers * motion.bearing.pitch_diameter / 2
    scale = float(loads.max()) * np.repeat(levers, [rollers, rows])

    def at(place: NDArray) -> _Trial:
        return _Trial(place, motion.state(place[:rollers], place[rollers:]), scale)

    start = at(np.zeros(rollers + rows))
    trial = start
    for search in (_newton, _short_steps):
        with suppress(np.linalg.LinAlgError):  # where nothing resists
            trial = search(at, start)
        if trial.left <= ROUNDING_TOLERANCE:
            return trial.state
    raise NotSolved(
        f"no speeds of rollers and cage in balance: {trial.left:.2g} of the largest load is left",
        SolverOutcome.LIMIT,
    )


def _newton(at: At, trial: _Trial) -> _Trial:
    """Newton's method; steps end before the minimum of the dissipation on their way.

    Friction that grows with sliding is the slope of a dissipation, which is convex in the speeds.
    """
    for _ in range(NEWTON_STEPS):
        if trial.left <= TOLERANCE:
            break
        step = -np.linalg.solve(trial.state.slopes, trial.excess)
        before, (trial, _) = trial, before_the_minimum(at, trial, step)
        if before.left <= ROUNDING_TOLERANCE and not trial.left < before.left:
            return before
    return trial


def _short_steps(at: At, trial: _Trial) -> _Trial:
    """Steps that the steepest slopes make short, longer the less is left: for friction that also falls."""
    steepest, share = np.abs(np.diag(trial.state.slopes)), 1.0
    for _ in range(SHORT_STEPS):
        if trial.left <= TOLERANCE:
            break
        change = np.linalg.solve(np.diag(share * steepest) - trial.state.slopes, trial.excess)
        after = at(trial.place + change)
        if trial.left <= ROUNDING_TOLERANCE and not after.left < trial.left:
            break
        steepest = np.maximum(steepest, np.abs(np.diag(after.state.slopes)))
        if after.left > GROWTH * trial.left and share < SHORTEST:
            share = min(4 * share, SHORTEST)
            continue
        share *= float(np.clip(after.left / trial.left, 0.1, 1.0)) * EASING
        trial = after
    return trial
