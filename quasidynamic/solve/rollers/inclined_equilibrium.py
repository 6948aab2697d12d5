"""Newton's method for a ring on inclined rollers that find their own balance."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.inclined import HELD, OUTER, RIB, SECTION, InclinedRollers, InclinedState
from quasidynamic.errors import NotSolved
from quasidynamic.solve.step_length import HALVINGS

TOLERANCE = 1e-11  # of the largest force: unbalanced force on the ring
ROLLER_SHARE = 0.1  # of that: what a roller may be out of balance
STEPS = 100  # of the ring, rarely more than twenty
ROLLER_STEPS = 100  # of the rollers at one place of the ring, rarely more than ten
FAR = 1.0  # [m] of an inner raceway that no roller meets
LONGEST = 0.02  # of the roller's length: a step in a gap, where nothing resists
FLOOR = 1e-9  # of the stiffness of a contact, which holds rollers and a ring that nothing touches
STIFFENING = 1e-2  # of the whole stiffness over the relative imbalance, as in `static_equilibrium`
TYPICAL = 1e-5  # [-] approach over the roller's length at which a contact has its usual stiffness


@dataclass(frozen=True)
class InclinedSolution:
    """Ring and rollers in balance."""

    state: InclinedState
    stiffness: NDArray  # (5, 5) [N/m] of the ring in its scaled displacements
    imbalance: float  # [-] largest unbalanced force over the largest force
    evaluations: int  # of all contacts
    floor: float  # [N/m] that holds rollers which nothing touches
    shape: NDArray | None = (
        None  # (2, Z, M + 1) [m] of elastic raceways: modes along normals, mean along them
    )


@dataclass
class _Search:
    """What a search has spent, and its scales."""

    model: InclinedRollers
    load: NDArray  # (5) [N]
    floor: float  # [N/m]
    longest: float  # [m]
    evaluations: int = 0

    def at(self, ring: NDArray, rollers: NDArray) -> InclinedState:
        self.evaluations += 1
        return self.model.at(ring, rollers)

    def placed(self, ring: NDArray, rollers: NDArray) -> NDArray:
        """Rollers (Z, 3) where they are sought, those that the cone does not touch in their balance."""
        model = self.model
        if (model.closed(ring, model.slid(ring, np.zeros_like(rollers))) > 0).all() or self.resting is None:
            return rollers
        resting = model.slid(ring, self.resting)
        return np.where(model.closed(ring, resting)[:, None] > 0, rollers, resting)

    @cached_property
    def resting(self) -> NDArray | None:
        """Rollers (1 or Z, 3) [m] on cup and rib alone, the ring at zero; None where one is not pressed.

        None between two ribs, where thrust of the ring presses rollers that its raceway does not touch, and
        without a rib.
        """
        model = self.model
        if model.opposite is not None or not model.rib_stiffness:
            return None
        ways = model.normals[[OUTER, RIB], :2]
        on_cup, on_rib = np.linalg.solve(ways.T, model.dead[:2])
        if min(on_cup, on_rib) <= 0:
            return None
        count = model.drops.shape[1]
        alone = replace(
            model,
            gap=FAR,
            rib_drop=0.0,
            sections=np.zeros((count, SECTION, HELD)),
            shifts=np.zeros((count, SECTION)),
        )
        approach = float(np.max(model.law.approach(on_cup / model.slices.length)))
        place = np.linalg.solve(
            ways, [approach + float(np.max(model.drops[OUTER])), (on_rib / model.rib_stiffness) ** (2 / 3)]
        )
        search = _Search(alone, 0 * self.load, self.floor, self.longest)
        start = search.at(np.zeros(HELD), np.tile([*place, 0.0], (count, 1)))
        found = _rollers_at_rest(search, start)
        self.evaluations += search.evaluations
        return found.rollers

    def largest(self, state: InclinedState) -> float:
        loads = np.abs(state.on_ring).max(), np.abs(self.model.dead).max(), np.abs(self.load).max()
        return float(max(loads))


def inclined_equilibrium(
    model: InclinedRollers, load: NDArray, held: NDArray, start: NDArray, rollers: NDArray | None = None
) -> InclinedSolution:
    """Place of the ring (5) where the rollers carry the load, their own balance within every place of it.

    Loads (5) [N] and displacements (5) [m] are those of `InclinedRollers`, of which `held` (5) stay where
    they start, `rollers` (Z, 3) where they begin. The energy is convex: from any start the steps lead to its
    lowest place.

    Raises `NotSolved` where the ring finds none.
    """
    law, length = model.law, float(np.max(model.slices.length))
    usual = float(np.min(law.coefficient)) * length * (TYPICAL * length) ** (1 / 9)
    search = _Search(model, load, FLOOR * usual, LONGEST * length)
    if rollers is None:
        rollers = np.full((len(model.sections), SECTION), 0.5) * (model.sections @ start + model.shifts)
    state = _rollers_at_rest(search, search.at(start, search.placed(start, rollers)))
    free = ~held
    for _ in range(STEPS):
        excess, largest = (load + _on(model, state))[free], search.largest(state)
        imbalance = float(np.abs(excess).max(initial=0.0) / largest) if largest else 0.0
        matrix, follow = _stiffness(search, state)
        if imbalance < TOLERANCE:
            _require_held(matrix[np.ix_(free, free)], search.floor)
            return InclinedSolution(state, matrix, imbalance, search.evaluations, search.floor)
        part = matrix[np.ix_(free, free)]
        stiffer = STIFFENING * min(imbalance, 1.0) * part.trace() + search.floor
        step = np.zeros(HELD)
        step[free] = np.linalg.solve(part + stiffer * np.eye(len(part)), excess)
        step /= max(np.abs(step).max() / search.longest, 1.0)
        state = _before_the_minimum(search, state, step, follow)
    raise NotSolved(
        f"the ring found no balance in {STEPS} steps: {imbalance:.1e} of the largest force is left; "
        f"{len(model.sections)} rollers",
        "iteration limit",
    )


def _require_held(matrix: NDArray, floor: float) -> None:
    """Refuse a place of the ring that nothing holds."""
    if matrix.size and np.linalg.eigvalsh(matrix).min() < floor:
        raise NotSolved(
            "nothing holds the ring in some direction: its place is undetermined; give a larger axial load, "
            "or hold it there (operation.displacement)",
            "undetermined",
        )


def _on(model: InclinedRollers, state: InclinedState) -> NDArray:
    """Force of all rollers on the ring (5) [N]."""
    return np.einsum("zde,zd->e", model.sections, state.on_ring)


def _held_stiffness(search: _Search, state: InclinedState) -> NDArray:
    return state.stiffness + search.floor * np.eye(SECTION)


def _stiffness(search: _Search, state: InclinedState) -> tuple[NDArray, NDArray]:
    """Stiffness of the ring (5, 5) [N/m] on rollers that follow it, and by how much they do (Z, 3, 5)."""
    sections = search.model.sections
    follow = np.linalg.solve(_held_stiffness(search, state), state.by_ring @ sections)
    own = np.einsum("zde,zdf->ef", sections, state.by_ring @ (sections - follow))
    return (own + own.T) / 2, follow


def _before_the_minimum(
    search: _Search, state: InclinedState, step: NDArray, follow: NDArray
) -> InclinedState:
    """State after a step of the ring, halved while it runs far past the lowest energy on its way."""
    uphill = -0.5 * float((search.load + _on(search.model, state)) @ step)
    moved = np.clip(follow @ step, -search.longest, search.longest)
    for halving in range(HALVINGS):
        part = 0.5**halving
        ring = state.ring + part * step
        trial = search.at(ring, search.placed(ring, state.rollers + part * moved))
        trial = _rollers_at_rest(search, trial)
        if float((search.load + _on(search.model, trial)) @ step) >= uphill:
            break
    return trial


def _rollers_at_rest(search: _Search, state: InclinedState) -> InclinedState:
    """Rollers in balance where the ring is, each by damped Newton steps."""
    for _ in range(ROLLER_STEPS):
        running = np.abs(state.excess).max(1) > ROLLER_SHARE * TOLERANCE * search.largest(state)
        if not running.any():
            return state
        step = np.linalg.solve(_held_stiffness(search, state), state.excess[..., None])[..., 0]
        step /= np.maximum(np.abs(step).max(1, keepdims=True) / search.longest, 1.0)
        step[~running] = 0.0
        state = _each_before_its_minimum(search, state, step)
    return state


def _each_before_its_minimum(search: _Search, state: InclinedState, step: NDArray) -> InclinedState:
    uphill, part = -0.5 * (state.excess * step).sum(1), np.ones((len(step), 1))
    for _ in range(HALVINGS):
        trial = search.at(state.ring, state.rollers + part * step)
        far = (trial.excess * step).sum(1) < uphill
        if not far.any():
            break
        part[far] /= 2
    return trial
