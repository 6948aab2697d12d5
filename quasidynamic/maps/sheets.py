"""How states continue from point to point, up to the folds where sheets of equilibria end."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.maps.newton_states import Mapped, Reached, apart, by_newton, in_batches
from quasidynamic.maps.points import GridPoints
from quasidynamic.maps.states import ENDS, SAME, UNKNOWN, States
from quasidynamic.solve.rollers.newton import bounded

NEAR = 0.02  # of the largest load or of pure rolling: states of neighbouring points that are alike
STEEPER = 2.0  # than both next changes along a line of the grid: such a change is followed
FINEST = 1 / 64  # of the way between two points: how exactly a fold is located
ROUNDS = 40  # of steps between two points


def connect_all(points: GridPoints, states: States, mapped: Mapped) -> None:
    """Find out how every state continues, and every state that this leads to.

    A state is followed towards each neighbouring point, and back again: only where the way back ends in the
    state it came from are both on one sheet. Steps are shortened where that fails; a sheet that cannot be
    followed any further ends in a fold there.
    """
    _connect_smooth(points, states)
    while len(states.waiting[0]):
        follow(points, states, *states.waiting, mapped)


def _connect_smooth(points: GridPoints, states: States) -> None:
    """Connect the only states of neighbouring points that are alike, or change as around them."""
    only = np.array([there[0] if len(there) == 1 else -1 for there in states.at_point])
    grid = only.reshape(points.shape)
    for axis in range(grid.ndim):
        before, after = (
            np.take(grid, np.arange(grid.shape[axis])[part], axis) for part in (slice(-1), slice(1, None))
        )
        both = (before >= 0) & (after >= 0)
        change = np.full(both.shape, np.inf)
        change[both] = apart(states.reached.take(before[both]), states.reached.take(after[both]))
        smooth = both & (change < NEAR + STEEPER * _beside(change, axis))
        states.connect(before[smooth], np.full(smooth.sum(), 2 * axis + 1), after[smooth])


def _beside(change: NDArray, axis: int) -> NDArray:
    """The smaller one of both next changes along an axis, zero where there is none."""
    padded = np.pad(change, [(1, 1) if each == axis else (0, 0) for each in range(change.ndim)], "edge")
    length = change.shape[axis]
    smaller = np.minimum(*(np.take(padded, np.arange(first, first + length), axis) for first in (0, 2)))
    return np.where(np.isfinite(smaller), smaller, 0.0)


@dataclass
class _Ways:
    """Ways of n states towards neighbouring points, and how far they are followed."""

    states: NDArray  # (n) where they begin
    sides: NDArray  # (n)
    first: NDArray  # (n) points
    second: NDArray  # (n) points
    share: NDArray  # (n) of the way that is followed
    step: NDArray  # (n) the next one, as a share
    here: Reached  # (n) so far
    before: Reached  # (n) a step before ...
    share_before: NDArray  # (n) ... where that was; NaN without

    def take(self, some: NDArray) -> "_Ways":
        """Some of them."""
        return _Ways(
            states=self.states[some],
            sides=self.sides[some],
            first=self.first[some],
            second=self.second[some],
            share=self.share[some],
            step=self.step[some],
            here=self.here.take(some),
            before=self.before.take(some),
            share_before=self.share_before[some],
        )


def follow(points: GridPoints, states: States, some: NDArray, sides: NDArray, mapped: Mapped) -> None:
    """Follow states (n) towards sides (n) until each has reached a neighbouring point or ends before."""
    ways = _begun(points, states, some, sides)
    for _ in range(ROUNDS):
        if not len(ways.states):
            return
        there = _stepped(points, ways, mapped)
        accepted, back = _leads_back(points, ways, there, mapped)
        _other_states(states, ways, there, back, accepted)
        _advance(ways, there, accepted)
        arrived, lost = ways.share >= 1.0, ~accepted & (ways.step < FINEST)
        _arrive(states, ways.take(arrived))
        _end(states, ways.take(lost & ~arrived))
        ways = ways.take(~(arrived | lost))
    _end(states, ways)


def _begun(points: GridPoints, states: States, some: NDArray, sides: NDArray) -> _Ways:
    """Ways from states, each with the state behind it as the step before, where one is known."""
    first = states.point[some]
    behind = states.continues[some, sides ^ 1]
    known = behind >= 0
    return _Ways(
        states=some,
        sides=sides,
        first=first,
        second=points.neighbours[first, sides],
        share=np.zeros(len(some)),
        step=np.ones(len(some)),
        here=states.reached.take(some),
        before=states.reached.take(np.where(known, behind, some)),
        share_before=np.where(known, -1.0, np.nan),
    )


def _stepped(points: GridPoints, ways: _Ways, mapped: Mapped) -> Reached:
    """States a step further, from an extrapolation of the last two."""
    aim = ways.share + ways.step
    slope = (ways.here.scaled - ways.before.scaled) / (ways.share - ways.share_before)[:, None]
    guess = ways.here.scaled + np.where(np.isfinite(slope), slope, 0.0) * ways.step[:, None]

    def balance(batch: NDArray):
        return points.between(ways.first[batch], ways.second[batch], aim[batch])

    every = np.arange(len(aim))
    return in_batches(balance, bounded(balance(every), ways.here.scaled, guess), by_newton, mapped)


def _leads_back(points: GridPoints, ways: _Ways, there: Reached, mapped: Mapped) -> tuple[NDArray, Reached]:
    """Whether a step (n) leads back to where it began; and what it leads back to, NaN where not tried."""
    change = apart(ways.here, there)
    accepted = change < NEAR
    doubtful = np.flatnonzero(there.converged & ~accepted)
    back = there.take(np.arange(len(there)))
    back.scaled[:] = np.nan
    if len(doubtful):
        tried = ways.take(doubtful)

        def balance(batch: NDArray):
            return points.between(tried.first[batch], tried.second[batch], tried.share[batch])

        found = in_batches(balance, there.scaled[doubtful], by_newton, mapped)
        for whole, part in zip(vars(back).values(), vars(found).values(), strict=True):
            whole[doubtful] = part
        accepted[doubtful] = apart(found, tried.here) < SAME
    return accepted, back


def _other_states(states: States, ways: _Ways, there: Reached, back: Reached, accepted: NDArray) -> None:
    """Add states of other sheets that steps of whole ways led to, at either end of these."""
    whole = ~accepted & (ways.share + ways.step >= 1.0)
    states.add(ways.second[whole], there.take(whole))
    begun = ~accepted & (ways.share == 0.0)
    states.add(ways.first[begun], back.take(begun))


def _advance(ways: _Ways, there: Reached, accepted: NDArray) -> None:
    """Take accepted steps, and shorten the others."""
    for which in ("scaled", "loads", "spin"):
        before, here, new = (getattr(each, which) for each in (ways.before, ways.here, there))
        before[accepted], here[accepted] = here[accepted], new[accepted]
    ways.share_before[accepted] = ways.share[accepted]
    ways.share[accepted] += ways.step[accepted]
    ways.step = np.where(accepted, np.minimum(2 * ways.step, 1.0 - ways.share), ways.step / 2)


def _arrive(states: States, ways: _Ways) -> None:
    """Connect states with those that their ways arrived at."""
    others = states.add(ways.second, ways.here)
    for state, side, other in zip(ways.states, ways.sides, others, strict=True):
        free = other >= 0 and states.continues[other, side ^ 1] in (UNKNOWN, state)
        if free:
            states.connect(*(np.array([each]) for each in (state, side, other)))
        else:  # it lost its stability on the way, or another sheet continues there
            states.continues[state, side], states.share[state, side] = ENDS, 1.0


def _end(states: States, ways: _Ways) -> None:
    """Take note of where states end, and of the last state before."""
    states.continues[ways.states, ways.sides] = ENDS
    states.share[ways.states, ways.sides] = ways.share + ways.step
    for state, side, share, scaled in zip(
        ways.states.tolist(), ways.sides.tolist(), ways.share, ways.here.scaled, strict=True
    ):
        states.last[state, side] = share, scaled
