"""Load distribution of rollers between rigid rings: Newton's method on the convex energy of the contacts."""

import numpy as np

from quasidynamic.balance.rollers.rigid_rings import RigidRings, RigidRingState
from quasidynamic.errors import NotSolved
from quasidynamic.solve.step_length import before_the_minimum

TOLERANCE = 1e-11  # of the largest force: unbalanced force on the ring
STEPS = 60  # rarely more than ten: the energy is convex
STIFFENING = 1e-2  # of the whole stiffness over the relative imbalance, where no roller resists a direction


def balanced(rings: RigidRings) -> tuple[RigidRingState, int]:
    """State in which the rollers carry the load, and the number of evaluations.

    A direction in which hardly anything resists, such as sideways on a single roller, is stiffened
    as long as forces are out of balance; close to balance the step is that of Newton.

    Raises
    ------
    NotSolved
        when the iteration limit is reached
    """
    state, evaluations, n = rings.at(rings.first_place()), 1, rings.load.size
    for _ in range(STEPS):
        imbalance = rings.imbalance(state)
        if imbalance < TOLERANCE:
            return state, evaluations
        matrix = state.stiffness.reshape(n, n)
        stiffer = STIFFENING * min(imbalance, 1.0) * matrix.trace()
        step = np.linalg.solve(matrix + stiffer * np.eye(n), state.excess.ravel())
        state, trials = before_the_minimum(rings.at, state, step.reshape(state.excess.shape))
        evaluations += trials
    raise NotSolved(
        f"the ring found no static balance in {STEPS} steps: {imbalance:.1e} of the largest force is left; "
        f"load {np.hypot(*rings.load[:, 0]):.4g} N, {len(rings.normal)} rollers",
        "iteration limit",
    )
