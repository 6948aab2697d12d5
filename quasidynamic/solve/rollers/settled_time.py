"""Implicit Euler steps of cage and spins of one case, with ring and rollers at rest after every one."""

from contextlib import suppress

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.unknowns import CAGE
from quasidynamic.solve.rollers import bordered_system
from quasidynamic.solve.rollers.load_continuation import Continuation
from quasidynamic.solve.rollers.newton import bounded, newton, norm, step
from quasidynamic.solve.rollers.normal_equilibrium import normal_equilibrium
from quasidynamic.solve.rollers.pressed_rollers import ContactWork, OutOfWork
from quasidynamic.solve.rollers.pseudo_time import LARGEST_RING_STEP, LARGEST_SPEED_CHANGE, scaled_inertia
from quasidynamic.solve.step_length import SolverOutcome

MAX_STEPS = 150  # steps
MOST_CONTACTS = 30_000  # evaluations of the contacts of all rollers: nearly all solutions take below 2000
FIRST_CHANGE = 0.1  # scaled change of the fastest speed in the first step
TRY_AFTER = 6  # steps after which Newton's method is tried at any residual
TRY_BELOW = 1e-2  # of the residual at the last trial: it is tried at once
MEMORY = 5  # steps that a residual is compared with
LARGEST_GROWTH = 5.0  # growth of the residual over these that is still taken
SMALL_SHARE = 1e-2  # of the first residual: up to it growth is no matter
TURNED = 0.25  # growth of the time step of a speed that turned back
GROWTH = (1.3, 4.0)  # least and most growth of a time step otherwise


def through_settled_time(balance: BearingBalance, start: NDArray) -> Continuation:
    """Equilibrium of one case from cage and spins that settle, each in time steps of its own.

    The normal equilibrium is found anew after every step, from wherever that leads, so that only friction is
    linearised; a speed that turns back, as where traction changes its side, takes shorter steps.
    """
    with suppress(OutOfWork):
        return _settled(balance, start, ContactWork(MOST_CONTACTS))
    return Continuation(None, MAX_STEPS)


def _settled(balance: BearingBalance, start: NDArray, work: ContactWork) -> Continuation:
    speeds = np.append(CAGE, np.arange(balance.layout.size)[balance.layout.field(-1)])
    inertia, evaluations = scaled_inertia(balance)[0, speeds], 0
    unknowns = normal_equilibrium(balance, start, work)
    system = balance.evaluate(unknowns)
    time = np.full(len(speeds), FIRST_CHANGE * np.min(inertia / np.abs(system.residual[0, speeds])))
    sizes, moved = [float(norm(system)[0])], np.zeros(len(speeds))
    tried = sizes[0]
    for number in range(1, MAX_STEPS + 1):
        if not np.isfinite(sizes[-1]) or not np.isfinite(time).all():
            break
        change = _step(balance, system, inertia / time)
        trial = unknowns.copy()
        trial[:, speeds] = bounded(balance, unknowns, unknowns + change)[:, speeds]
        trial = normal_equilibrium(balance, trial, work)
        after, evaluations = balance.evaluate(trial), evaluations + 1
        size = float(norm(after)[0])
        if not size < LARGEST_GROWTH * max(*sizes[-MEMORY:], SMALL_SHARE * sizes[0]):
            time = time * TURNED
            continue
        before, moved = moved, (trial - unknowns)[0, speeds]
        turned = after.residual[0, speeds] * system.residual[0, speeds] < 0
        turned[0] |= moved[0] * before[0] < 0
        time = time * np.where(turned, TURNED, np.clip(GROWTH[0] * sizes[-1] / size, *GROWTH))
        unknowns, system = trial, after
        sizes.append(size)
        if size < TRY_BELOW * tried or number % TRY_AFTER == 0:
            tried = size
            *_, last = newton(balance, unknowns)
            evaluations += last.number
            if last.outcomes[0] is SolverOutcome.CONVERGED:
                return Continuation(last.unknowns, evaluations)
    return Continuation(None, evaluations)


def _step(balance: BearingBalance, system: Linearisation, inertia: NDArray) -> NDArray:
    """Implicit Euler step (1, N), scaled, with inertias over time steps of cage and spins (1 + Z)."""
    spin = balance.layout.per_roller - 1
    # A spin that diverges, as on a traction curve that falls, is moved the way it diverges.
    falling = np.maximum(2 * system.table[spin, spin], 0.0)
    shift = bordered_system.Shift(spin=inertia[None, 1:] + falling, cage=inertia[:1])
    return step(balance, system, LARGEST_RING_STEP, LARGEST_SPEED_CHANGE, shift)
