"""How far the unknowns of a bearing may go in one step."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import BORDER, CAGE, OUTER
from quasidynamic.solve.rollers.static_equilibrium import (
    frictionless_loads,
    outward_force,
    room_between_raceways,
    static_equilibrium,
    tilts_between_raceways,
)

SPIN_CHANGE = 0.5  # of the spin in pure rolling in a step
KEPT = 0.1  # of an approach or a film in a step
GROWTH = 4.0  # of a gap in a step
MOVED = 0.3  # of an approach and of a force: above it a step has thrown a roller about
ALONE = 0.5  # of its approach and tilt, by which a roller may move alone in a step
FREE = 1.0  # scaled step of a roller that is never shortened: 2e-4 of its diameter
GRAZING = 3.0  # widths over which contact begins: a gap up to it has a force that leads back


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
    cage_speed = balance.rolling_cage + after[:, CAGE:BORDER] * balance.scales.unknown[:, CAGE:BORDER]
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
    ring = np.abs(change[:, :CAGE]).max(1, keepdims=True)
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
