"""A bearing near its equilibrium, the tilt of its inner ring held where it was free, or free where held."""

from dataclasses import replace

import numpy as np

from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.solve.rollers import bordered_system
from quasidynamic.solve.rollers.newton import bounded
from quasidynamic.solve.step_length import SolverOutcome

MOST_STEPS = 8  # two where the same rollers stay loaded
SMALL = 1e-3  # residual, of the reference force: loads within about as much


def with_other_tilt(state: Equilibrium) -> Equilibrium | None:
    """Estimate the equilibrium of a ring whose tilt is held instead of free, or free instead of held.

    Newton steps from the equilibrium, without a search for loaded rollers: two of them cost less than a tenth
    of a solve, and raceways stay as elastic as they are there. A ring that is held has no slope, one that is
    free no moment [N m].

    The state is of one case between elastic raceways, balanced. The other one is unbalanced by a thousandth
    of the reference force at most; None where the steps did not get there.

    Source
    ------
    Newton's method on the balances of the bearing.

    Valid
    -----
    Raceways whose compliance does not depend on the load: parts that lift off stay where they are.
    """
    if state.balance.roller.axial_modes == 1:
        return None
    points = state.balance.points
    none = np.zeros_like(points.moment_y)
    balance = replace(
        state.balance,
        points=replace(
            points, free_tilt=~points.free_tilt, moment_y=none, moment_z=none, slope_y=none, slope_z=none
        ),
    )
    scaled = balance.pack(state.unknowns)
    system = balance.evaluate(scaled, state.system.response)  # rollers do not know who holds the ring
    for step in range(MOST_STEPS):
        size = np.abs(system.residual).max()
        if not np.isfinite(size):
            return None
        if size <= SMALL:
            states = BearingStates(balance, scaled, state.axial_modes)
            states.know(system)
            return Equilibrium.of(states, SolverOutcome.CONVERGED, step)
        change = bordered_system.solve(balance, system, -system.residual[..., None])[..., 0]
        scaled = bounded(balance, scaled, scaled + change)
        system = balance.evaluate(scaled)
    return None
