"""Damped Newton iterations of many cases side by side."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.unknowns import CAGE, OUTER, SHIFT, TILT_Z, Y, Z
from quasidynamic.solve.rollers import bordered_system
from quasidynamic.solve.rollers.static_equilibrium import (
    frictionless_loads,
    outward_force,
    room_between_raceways,
    static_equilibrium,
    tilts_between_raceways,
)
from quasidynamic.solve.step_length import SolverOutcome

SPIN_CHANGE = 0.5  # of the spin in pure rolling in a step
KEPT = 0.1  # of an approach or a film in a step
GROWTH = 4.0  # of a gap in a step
MOVED = 0.3  # of an approach and of a force: above it a step has thrown a roller about
ALONE = 0.5  # of its approach and tilt, by which a roller may move alone in a step
FREE = 1.0  # scaled step of a roller that is never shortened: 2e-4 of its diameter
GRAZING = 3.0  # widths over which contact begins: a gap up to it has a force that leads back
TOLERANCE = 1e-12  # of the reference force, or of the largest roller load if that is larger
ROUNDING_TOLERANCE = 1e-10  # the same, where rounding keeps a step from lowering the residual any more
ROUNDING = 1e-8  # residual from where rounding decides whether a step looks smaller
MAX_EVALUATIONS = 60  # evaluations
LARGEST_RING_STEP = 100.0  # scaled ring displacement in a step: 2 % of a roller's diameter
TILT_SHARE = 3.0  # scaled tilt of a ring in a step, of its scaled displacement: 0.3 rad
LARGEST_SPEED_CHANGE = 0.7  # of the cage speed in a step
SLOW_CAGE = 0.02  # of the cage speed in pure rolling, by which it may change at any speed
SMALLEST_DAMPING = 2.0**-10  # part of a Newton step


def bounded(balance: BearingBalance, before: NDArray, after: NDArray) -> NDArray:
    """Keep approaches at the outer raceway and films positive: at most nine tenths go in a step.

    A roller thrown off the outer raceway, or a film below zero, has no slope that leads back. Spins are
    those of `bounded_spins`.
    """
    layout, held = balance.layout, bounded_spins(balance, before, after)
    films = slice(layout.field(-3).start, layout.field(-2).stop)
    held[:, films] = np.maximum(after[:, films], KEPT * before[:, films])
    old, new = _largest_approach(balance, before), _largest_approach(balance, after)
    grazing = GRAZING * balance.roller.raceways.law.rounding / balance.scales.length
    held[:, layout.field(0)] += np.maximum(_lowest(old, grazing) - new, 0.0)
    return settled(balance, before, held)


def _lowest(approach: NDArray, grazing: NDArray | float) -> NDArray:
    """Smallest approach after a step: a tenth of that before it, or a gap that is several times as wide."""
    return np.minimum(GROWTH * approach, KEPT * approach) - grazing


def settled(balance: BearingBalance, before: NDArray, after: NDArray) -> NDArray:
    """Put rollers that a step has thrown about in their clearance on the raceway that they rest on.

    In a slow bearing weights decide where unloaded rollers are, and they fall from one raceway on the other:
    through a gap without any force that leads a linearised step there.
    """
    cage_speed = balance.rolling_cage + after[:, [CAGE]] * balance.scales.unknown[:, [CAGE]]
    slow = ~(np.abs(cage_speed) > balance.slow_cage)
    if not slow.any():
        return after
    unknowns = balance.unpack(after)
    force = outward_force(balance, unknowns)
    slow &= ~(force.min(axis=1, keepdims=True) > 0.0)
    if not slow.any():
        return after
    approach, former = balance.approach(unknowns), balance.approach(balance.unpack(before))
    on_outer, touching = force >= 0, balance.roller.raceways.law.rounding
    here, there = (np.where(on_outer, *side[::-1, 0]) for side in (approach, former))
    moved = np.abs(here - there) > MOVED * (np.abs(there) + touching)
    load_i, load_o = frictionless_loads(balance, unknowns, uneven=True)
    thrown = moved & (np.abs(load_o - load_i - force) > MOVED * np.abs(force))
    thrown &= slow & (room_between_raceways(balance, approach) < 0)
    if not thrown.any():
        return after
    if balance.roller.axial_modes > 1:
        tilted = tilts_between_raceways(balance, unknowns).tilt
        unknowns = unknowns._replace(tilt=np.where(thrown, tilted, unknowns.tilt))
    resting, after = balance.pack(static_equilibrium(balance, unknowns, uneven=True)), after.copy()
    for field in range(balance.layout.per_roller - 3):  # approach, and tilt where there is one
        place = balance.layout.field(field)
        after[:, place] = np.where(thrown, resting[:, place], after[:, place])
    return after


def bounded_spins(balance: BearingBalance, before: NDArray, after: NDArray) -> NDArray:
    """Let spins move by a share only.

    The spin of a roller that hardly anything drives, or whose traction has reached its limit, may be sent
    anywhere, far from where friction has a slope that leads back.
    """
    held, spin = after.copy(), balance.layout.field(-1)
    least, most = before[:, spin] - SPIN_CHANGE, before[:, spin] + SPIN_CHANGE
    held[:, spin] = np.minimum(np.maximum(after[:, spin], least), most)
    return held


def shortened(balance: BearingBalance, unknowns: NDArray, change: NDArray) -> NDArray:
    """Let rollers move and tilt no further than what is around them moves.

    A roller that hardly touches, or touches at one end alone, moves nearly without resistance: a linearised
    step sends it anywhere. It need not go further than ring and films do, and half of its approach and tilt.
    """
    layout = balance.layout
    moving = slice(layout.field(0).start, layout.field(-4).stop)
    if np.abs(change[:, moving]).max() <= FREE:
        return change
    cases, rollers = len(change), change[:, moving].reshape(len(change), -1, layout.rollers)
    size = np.abs(unknowns[:, moving]).reshape(rollers.shape).max(1)
    films = np.abs(change[:, layout.field(-3).start : layout.field(-2).stop]).reshape(cases, 2, -1).max(1)
    ring = np.abs(change[:, [*range(CAGE), *range(SHIFT, layout.border)]]).max(1, keepdims=True)
    most, furthest = ALONE * size + ring + films, np.abs(rollers).max(1)
    shorter = np.where(furthest > FREE, np.minimum(1.0, most / furthest), 1.0)
    held = change.copy()
    held[:, moving] = (rollers * shorter[:, None]).reshape(cases, -1)
    return held


def _largest_approach(balance: BearingBalance, scaled: NDArray) -> NDArray:
    """Approach (C, Z) where each roller is nearest to the outer raceway of any shape, scaled."""
    layout = balance.layout
    centre = scaled[:, layout.field(0)]
    if layout.axial_modes == 1:
        return centre
    if not layout.elastic_raceways and balance.deviation is None:
        return centre + np.abs(scaled[:, layout.field(1)])
    beyond = balance.approach(balance.unpack(scaled))[OUTER, 1:] / balance.scales.length
    shape = balance.roller.raceways.slices.modes[:, 1:]
    return centre + np.einsum("km,mcz->kcz", shape, beyond).max(0)


@dataclass(frozen=True)
class Iterate:
    """One evaluation of the cases that are still running."""

    number: int
    cases: NDArray  # which cases these are
    unknowns: NDArray  # (cases, N) scaled
    system: Linearisation
    outcomes: list[SolverOutcome]
    accepted: NDArray  # (cases) whether the step lowered the residual

    def numbered(self, number: int) -> "Iterate":
        """Return the same iterate under another number."""
        return replace(self, number=number)

    @property
    def residual(self) -> NDArray:
        """Largest unbalanced force over the reference force (cases) [-]."""
        return _largest(self.system.residual)


def newton(
    balance: BearingBalance, unknowns: NDArray, system: Linearisation | None = None
) -> Iterator[Iterate]:
    """Yield Newton iterates of all cases; a case leaves when its residual is below `TOLERANCE`.

    A step is halved until the residual falls; one too short to help ends as `STALLED`. Every iterate
    evaluates each running case once, whether it tries a full step or a shorter one. Its
    `unknowns` are the best so far, `system` belongs to what was tried; that of the start may be known.
    """
    cases, accepted = np.arange(len(unknowns)), np.ones(len(unknowns), bool)
    system = balance.evaluate(unknowns) if system is None else system
    yield Iterate(0, cases, unknowns, system, [SolverOutcome.RUNNING] * len(cases), accepted)
    # Types are declared where a checker would follow them around the loop for minutes.
    direction: NDArray = shortened(balance, unknowns, step(balance, system))
    size, worst, damping = norm(system), _worst(system), np.ones(len(cases))
    for number in range(1, MAX_EVALUATIONS + 1):
        trial = bounded(balance, unknowns, unknowns + damping[:, None] * direction)
        system = balance.evaluate(trial)
        trial_size = norm(system)
        better: NDArray = trial_size <= np.maximum((1 - 1e-4 * damping) * size, ROUNDING * system.loading)
        better &= (trial_size < size) | (worst > ROUNDING_TOLERANCE)
        everywhere = bool(better.all())
        if everywhere:  # as nearly always: nothing to choose
            unknowns, size, worst, damping = trial, trial_size, _worst(system), np.ones(len(cases))
        else:
            unknowns = np.where(better[:, None], trial, unknowns)
            size, worst = np.where(better, trial_size, size), np.where(better, _worst(system), worst)
            damping = np.where(better, 1.0, damping / 2)
        each_case = zip(better.tolist(), worst.tolist(), damping.tolist(), strict=True)
        outcomes = [_outcome(*case, last=number == MAX_EVALUATIONS) for case in each_case]
        yield Iterate(number, cases, unknowns, system, outcomes, better)
        left = np.flatnonzero([outcome is SolverOutcome.RUNNING for outcome in outcomes])
        if not len(left):
            return
        if everywhere:
            direction = shortened(balance, unknowns, step(balance, system))
        elif better.any():
            direction = np.where(
                better[:, None], shortened(balance, unknowns, step(balance, system)), direction
            )
        if len(left) < len(cases):
            cases, balance = cases[left], balance.take(left)
            unknowns, direction, damping, size, worst = (
                array[left] for array in (unknowns, direction, damping, size, worst)
            )


def _outcome(better: bool, worst: float, damping: float, last: bool) -> SolverOutcome:
    if worst <= TOLERANCE or (worst <= ROUNDING_TOLERANCE and (last or not better)):
        return SolverOutcome.CONVERGED
    if damping < SMALLEST_DAMPING:
        return SolverOutcome.STALLED
    return SolverOutcome.LIMIT if last else SolverOutcome.RUNNING


def _worst(system: Linearisation) -> NDArray:
    """Largest unbalanced force over reference or roller load (C) [-]."""
    return _largest(system.residual) / system.loading


def step(
    balance: BearingBalance,
    system: Linearisation,
    longest: NDArray | float = LARGEST_RING_STEP,
    speed_change: float = LARGEST_SPEED_CHANGE,
    shift: bordered_system.Shift = bordered_system.NO_SHIFT,
) -> NDArray:
    """Newton step (C, N), with a ring whose place and tilt move no further than `longest` (scaled).

    A ring that nothing holds in some direction, such as sideways on a single roller, is given a
    stiffness there: everything else still takes its full step. The cage changes its speed by a
    share `speed_change` at most, rollers are `bounded` one by one.
    """
    right = -system.residual[..., None]
    change = bordered_system.solve(balance, system, right, shift)[..., 0]
    ring_step, tilt_step = _ring_steps(change)
    if (ring_step > longest).any() or (tilt_step > longest).any():
        stiffness, tilting = _ring_steps(system.residual)
        held = shift._replace(
            ring=np.where(ring_step > longest, stiffness / longest, 0.0),
            tilt=np.where(tilt_step > longest, tilting / longest, 0.0),
        )
        change = bordered_system.solve(balance, system, right, held)[..., 0]
        ring_step, tilt_step = _ring_steps(change)
    cage_step = np.abs(change[:, CAGE]) / (speed_change * (system.cage_speed + SLOW_CAGE))
    excess = np.maximum(np.maximum(ring_step, tilt_step) / longest, cage_step)
    return change if (excess <= 1.0).all() else change / np.maximum(excess, 1.0)[:, None]


def _ring_steps(change: NDArray) -> tuple[NDArray, NDArray]:
    """Displacement and tilt (C) of the ring in a change (C, N), the latter as a displacement."""
    return _largest(change[:, Y : Z + 1]), _largest(change[:, TILT_Z:CAGE]) / TILT_SHARE


def norm(system: Linearisation) -> NDArray:
    """Length of the residual (C); not a number when a part of it is not."""
    return np.sqrt(np.vecdot(system.residual, system.residual))


def _largest(values: NDArray) -> NDArray:
    """Largest size (C) of values (C, n)."""
    return np.maximum.reduce(np.abs(values), axis=1)
