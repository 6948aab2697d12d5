"""Implicit Euler steps of cage and spins with their inertias, where Newton's method finds no way down."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.unknowns import CAGE, TILT_Z
from quasidynamic.solve.outcome import SolverOutcome
from quasidynamic.solve.rollers import bordered_system
from quasidynamic.solve.rollers.newton import Iterate, norm, step
from quasidynamic.solve.rollers.step_bounds import bounded

MAX_EVALUATIONS = 40  # evaluations before Newton's method is tried again
NEWTON_RESIDUAL = 1e-4  # residual from which it is tried at once
NEWTON_REDUCTION = 1e-2  # part of the first residual that must be reached before
FIRST_STEP = 1e-4  # [s]
SHORTEST_STEP = 1e-9  # [s]
LARGEST_RING_STEP = 5.0  # scaled ring displacement in a step: 5 micrometres
TILT_SHARE = 0.2  # scaled tilt of a ring that moves roller ends about as far as a scaled displacement
LARGEST_SPEED_CHANGE = 0.15  # of the cage speed in a step
LARGEST_GROWTH = 3.0  # growth of the residual that is still taken


@dataclass(frozen=True)
class StepLimits:
    """How far the next step of each case may go."""

    time: NDArray  # (C) [s]
    shift: NDArray  # (C) scaled ring displacement

    @classmethod
    def first(cls, cases: int) -> "StepLimits":
        """StepLimits to begin with."""
        return cls(np.full(cases, FIRST_STEP), np.full(cases, LARGEST_RING_STEP))

    def after(self, refused: NDArray, growth: NDArray) -> "StepLimits":
        """Slower where a step was refused, otherwise faster, the more so the more the residual fell."""
        return StepLimits(
            np.where(refused, self.time / 4, self.time * growth),
            np.where(refused, self.shift / 4, np.minimum(2 * self.shift, LARGEST_RING_STEP)),
        )

    def take(self, cases: NDArray) -> "StepLimits":
        """StepLimits of some cases."""
        return StepLimits(self.time[cases], self.shift[cases])


def pseudo_time(
    balance: BearingBalance, unknowns: NDArray, pace: StepLimits
) -> Iterator[tuple[Iterate, StepLimits]]:
    """Yield each sweep over the running cases, with their pace.

    Ring and rollers follow at once. The time step grows as the residual falls (switched evolution
    relaxation), and a ring that wants to run far, such as one balanced on a single roller, is led
    in short steps. `CONVERGED` means near enough for Newton's method, `LIMIT` that it may be tried.
    """
    cases, here = np.arange(len(unknowns)), balance
    before, size = unknowns, np.full(len(unknowns), np.inf)
    pull, turned = np.zeros(len(unknowns)), np.zeros(len(unknowns), bool)
    enough = None
    for number in range(MAX_EVALUATIONS + 1):
        system = here.evaluate(unknowns)
        new = norm(system)
        enough = np.minimum(NEWTON_RESIDUAL, NEWTON_REDUCTION * new) if enough is None else enough
        refused = ~(new < LARGEST_GROWTH * size) & (pace.time > SHORTEST_STEP)
        pace = pace.after(refused, _growth(size, new, turned))
        # A refused state is left for the one before it; the next sweep starts there with a shorter step.
        here_now = np.where(refused[:, None], before, unknowns)
        outcomes = [
            _outcome(*case, last=number == MAX_EVALUATIONS) for case in zip(new, enough, refused, strict=True)
        ]
        left = np.array([outcome is SolverOutcome.RUNNING for outcome in outcomes])
        yield Iterate(number, cases, here_now, system, outcomes, ~refused), pace
        if not left.any():
            return
        change = _step(here, system, pace)
        tilted = np.abs(change[:, TILT_Z:CAGE]).max(1) / TILT_SHARE
        hurry = tilted / pace.shift
        turned, pull = change[:, CAGE] * pull < 0, np.where(refused, pull, change[:, CAGE])
        following = np.where(
            refused[:, None],
            before,
            bounded(here, unknowns, unknowns + change / np.maximum(hurry, 1.0)[:, None]),
        )
        size = np.where(refused, np.inf, new)
        before, unknowns = here_now, following
        if not left.all():
            cases, here, pace = cases[left], here.take(left), pace.take(left)
            before, unknowns, size = before[left], unknowns[left], size[left]
            pull, turned, enough = pull[left], turned[left], enough[left]


def _growth(before: NDArray, now: NDArray, turned: NDArray) -> NDArray:
    """Factor of the next time step: a quarter where the cage turned back, else the more the residual fell."""
    with np.errstate(invalid="ignore"):
        fall = np.where(np.isfinite(before), before / now, 1.0)
    return np.where(turned, 0.25, np.clip(1.3 * fall, 1.3, 4.0))


def _outcome(size: float, enough: float, refused: bool, last: bool) -> SolverOutcome:
    if size <= enough:
        return SolverOutcome.CONVERGED
    if not np.isfinite(size) and not refused:
        return SolverOutcome.NOT_FINITE
    return SolverOutcome.LIMIT if last else SolverOutcome.RUNNING


def _step(balance: BearingBalance, system: Linearisation, pace: StepLimits) -> NDArray:
    bearing = balance.roller.bearing
    orbiting = bearing.cage.mass + bearing.rollers * bearing.roller.mass
    columns, rows = balance.scales.unknown, balance.scales.residual
    spin, cage = balance.layout.field(-1).start, CAGE
    own = system.table[balance.layout.per_roller - 1, balance.layout.per_roller - 1]
    inertia = bearing.roller.inertia * columns[:, spin] / rows[:, spin] / pace.time
    shift = bordered_system.Shift(
        # A spin that runs away, as on a traction curve that falls, is led the way it runs.
        spin=inertia[:, None] + np.maximum(2 * own, 0.0),
        cage=orbiting * (bearing.pitch_diameter / 2) ** 2 * columns[:, cage] / rows[:, cage] / pace.time,
    )
    return step(balance, system, pace.shift, LARGEST_SPEED_CHANGE, shift)
