"""Implicit Euler steps of cage and spins with their inertias, where Newton's method fails."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.unknowns import CAGE, TILT_Z
from quasidynamic.solve.rollers import bordered_system
from quasidynamic.solve.rollers.newton import Iterate, bounded, norm, shortened, step
from quasidynamic.solve.step_length import SolverOutcome

MAX_EVALUATIONS = 40  # evaluations before Newton's method is tried again
NEWTON_RESIDUAL = 1e-4  # residual from which it is tried at once
NEWTON_REDUCTION = 1e-2  # part of the first residual that must be reached before
FIRST_STEP = 1e-4  # [s]
SHORTEST_STEP = 1e-9  # [s]
LARGEST_RING_STEP = 5.0  # scaled ring displacement in a step: 0.1 % of a roller's diameter
TILT_SHARE = 0.2  # scaled tilt of a ring that moves roller ends about as far as a scaled displacement
LARGEST_SPEED_CHANGE = 0.15  # of the cage speed in a step
LARGEST_GROWTH = 3.0  # growth of the residual that is still taken


@dataclass(frozen=True)
class StepLimits:
    """Largest next step of each case."""

    time: NDArray  # (C) [s]
    ring_step: NDArray  # (C) scaled ring displacement

    @classmethod
    def first(cls, cases: int) -> "StepLimits":
        """StepLimits to begin with."""
        return cls(np.full(cases, FIRST_STEP), np.full(cases, LARGEST_RING_STEP))

    def after(self, refused: NDArray, growth: NDArray) -> "StepLimits":
        """Smaller where a step was refused, otherwise larger by the growth (C) of the time step."""
        return StepLimits(
            np.where(refused, self.time / 4, self.time * growth),
            np.where(refused, self.ring_step / 4, np.minimum(2 * self.ring_step, LARGEST_RING_STEP)),
        )

    def take(self, cases: NDArray) -> "StepLimits":
        """StepLimits of some cases."""
        return StepLimits(self.time[cases], self.ring_step[cases])


def pseudo_time(
    balance: BearingBalance, unknowns: NDArray, limits: StepLimits
) -> Iterator[tuple[Iterate, StepLimits]]:
    """Yield each evaluation of the running cases, with the limits of their next steps.

    Ring and rollers follow at once. The time step grows as the residual falls (switched evolution
    relaxation), and a ring that would move far, such as one balanced on a single roller, takes short
    steps. `CONVERGED` means near enough for Newton's method, `LIMIT` that it may be tried.
    """
    cases, before = np.arange(len(unknowns)), unknowns
    size: NDArray = np.full(len(unknowns), np.inf)
    cage_change: NDArray = np.zeros(len(unknowns))
    turned: NDArray = np.zeros(len(unknowns), bool)
    near: NDArray | None = None
    for number in range(MAX_EVALUATIONS + 1):
        system = balance.evaluate(unknowns)
        trial_size = norm(system)
        near = np.minimum(NEWTON_RESIDUAL, NEWTON_REDUCTION * trial_size) if near is None else near
        refused: NDArray = ~(trial_size < LARGEST_GROWTH * size) & (limits.time > SHORTEST_STEP)
        limits = limits.after(refused, _growth(size, trial_size, turned))
        # A refused state is left for the one before it, from where the next step is shorter.
        accepted: NDArray = np.where(refused[:, None], before, unknowns)
        each_case = zip(trial_size, near, refused, strict=True)
        outcomes = [_outcome(*case, last=number == MAX_EVALUATIONS) for case in each_case]
        running = np.array([outcome is SolverOutcome.RUNNING for outcome in outcomes])
        yield Iterate(number, cases, accepted, system, outcomes, ~refused), limits
        if not running.any():
            return
        change: NDArray = shortened(balance, unknowns, _step(balance, system, limits))
        tilt = np.abs(change[:, TILT_Z:CAGE]).max(1) / TILT_SHARE
        change_in_limits = change / np.maximum(tilt / limits.ring_step, 1.0)[:, None]
        turned = change[:, CAGE] * cage_change < 0
        cage_change = np.where(refused, cage_change, change[:, CAGE])
        trial = bounded(balance, unknowns, unknowns + change_in_limits)
        unknowns = np.where(refused[:, None], before, trial)
        size = np.where(refused, np.inf, trial_size)
        before = accepted
        if not running.all():
            cases, balance, limits = cases[running], balance.take(running), limits.take(running)
            before, unknowns, size, cage_change, turned, near = (
                array[running] for array in (before, unknowns, size, cage_change, turned, near)
            )


def _growth(size: NDArray, trial_size: NDArray, turned: NDArray) -> NDArray:
    """Factor of the next time step: a quarter where the cage turned back, else the more the residual fell."""
    with np.errstate(invalid="ignore"):
        fall = np.where(np.isfinite(size), size / trial_size, 1.0)
    return np.where(turned, 0.25, np.clip(1.3 * fall, 1.3, 4.0))


def _outcome(size: float, near: float, refused: bool, last: bool) -> SolverOutcome:
    if size <= near:
        return SolverOutcome.CONVERGED
    if not np.isfinite(size) and not refused:
        return SolverOutcome.NOT_FINITE
    return SolverOutcome.LIMIT if last else SolverOutcome.RUNNING


def _step(balance: BearingBalance, system: Linearisation, limits: StepLimits) -> NDArray:
    """Implicit Euler step (C, N) of cage and spins, scaled."""
    inertia = scaled_inertia(balance) / limits.time[:, None]
    spin = balance.layout.per_roller - 1
    shift = bordered_system.Shift(
        # A spin that diverges, as on a traction curve that falls, is moved the way it diverges.
        spin=inertia[:, balance.layout.field(-1)] + np.maximum(2 * system.table[spin, spin], 0.0),
        cage=inertia[:, CAGE],
    )
    return step(balance, system, limits.ring_step, LARGEST_SPEED_CHANGE, shift)


def scaled_inertia(balance: BearingBalance) -> NDArray:
    """Inertia (C, N) [s] of each scaled unknown in its scaled residual, zero but for cage and spins."""
    bearing, spins = balance.roller.bearing, balance.layout.field(-1)
    inertia = np.zeros((len(balance.points), balance.layout.size))
    inertia[:, spins] = bearing.roller.inertia
    orbiting = bearing.cage.mass + bearing.all_rollers * bearing.roller.mass
    inertia[:, CAGE : CAGE + 1] = orbiting * (bearing.pitch_diameter / 2) ** 2
    return inertia * balance.scales.unknown / balance.scales.residual


def growth_rates(balance: BearingBalance, system: Linearisation) -> NDArray:
    r"""Eigenvalues of cage and spins with their inertias, at equilibria of C cases.

    Ring, approaches, tilts and films follow at once, as in pseudo-time: with the inertias M of cage and
    spins, and S what is left of the Jacobian J for them when everything else is eliminated,

    .. math:: M \dot x = S x,\qquad \lambda v = M^{-1} S v

    S is not formed: its inverse is the block of the inverse of J, so that the eigenvalues of (J^-1)_{dd} M
    are 1 / lambda. The equilibrium is stable when every real part is negative; one real eigenvalue passes
    through zero at a fold.

    Growth rates (C, Z + 1) are complex [1/s]; not a number where the Jacobian is singular.

    Source
    ------
    Linearised motion about an equilibrium; derived here.

    Valid
    -----
    Steady state seen from the cage: rollers pass from azimuth to azimuth, and the spin at an azimuth
    changes. The ring has no mass here: whirling is left out.
    """
    moving = np.concatenate([[CAGE], np.arange(balance.layout.size)[balance.layout.field(-1)]])
    unit = np.zeros((len(balance.points), balance.layout.size, len(moving)))
    unit[:, moving, range(len(moving))] = 1.0
    inverse = bordered_system.solve(balance, system, unit)[:, moving]
    regular = np.isfinite(inverse).all(axis=(1, 2))
    by_rate = inverse[regular] * scaled_inertia(balance)[regular][:, None, moving]
    rates = np.full(inverse.shape[:2], np.nan, complex)
    rates[regular] = 1.0 / np.linalg.eigvals(by_rate).astype(complex)
    return rates
