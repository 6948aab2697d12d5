"""The whole way from a grid of operating points to its states."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.maps.filled import one_state_each
from quasidynamic.maps.newton_states import Mapped
from quasidynamic.maps.other_sheets import search
from quasidynamic.maps.points import GridPoints
from quasidynamic.maps.sheets import connect_all
from quasidynamic.maps.states import ENDS, States


@dataclass(frozen=True)
class SolvedGrid:
    """All states that were found of the points of a grid."""

    points: GridPoints
    point: NDArray  # (S) of each state, rising
    scaled: NDArray  # (S, N) unknowns
    stable: NDArray  # (S) whether small disturbances of cage and spins decay
    continues: NDArray  # (S, 2 d) as which state down and up each axis; negative where it does not
    share: NDArray  # (S, 2 d) of the way on which it ends there; NaN elsewhere
    last: dict[
        tuple[int, int], tuple[float, NDArray]
    ]  # of states and sides that end: share and unknowns before
    rounds: int  # of searches for other sheets
    quiet: bool  # whether the last of them found nothing more

    @classmethod
    def of(cls, points: GridPoints, states: States, rounds: int = 0, quiet: bool = True) -> "SolvedGrid":
        """States in the order of their points."""
        order = np.argsort(states.point, kind="stable")
        renamed = np.empty(len(order), int)
        renamed[order] = np.arange(len(order))
        continues = states.continues[order]
        return cls(
            points=points,
            point=states.point[order],
            scaled=states.reached.scaled[order],
            stable=states.stable[order],
            continues=np.where(continues >= 0, renamed.take(continues, mode="clip"), continues),
            share=states.share[order],
            last={(int(renamed[state]), side): end for (state, side), end in states.last.items()},
            rounds=rounds,
            quiet=quiet,
        )

    @property
    def stable_count(self) -> NDArray:
        """Stable states at each point (C)."""
        return np.bincount(self.point[self.stable], minlength=len(self.points.bearings))

    @property
    def ends(self) -> tuple[NDArray, NDArray]:
        """Stable states (n), and sides (n) on which they end before the next point."""
        states, sides = np.nonzero((self.continues == ENDS) & self.stable[:, None])
        return states, sides


def solve(
    points: GridPoints, mapped: Mapped = map, tell: Callable[[str], None] = lambda stage: None
) -> SolvedGrid:
    """Find the states of all points; those where no solve converged have none.

    Every point has a state from those around it, or as a run finds it. Where the states of neighbouring
    points differ much, both are followed to the other point and back; where several are likely, others are
    searched, and each of them is followed over the grid.

    `mapped` is `map`, or one that shares calls among processes; `tell` is called with the name of each stage.

    Source
    ------
    Natural continuation along the lines of a grid (Allgower and Georg, Introduction to Numerical Continuation
    Methods, 2003), forth and back.

    Valid
    -----
    Sheets that are narrower than the grid may be missed, and folds that lie between the same two points.
    """
    tell("a state at every point")
    states = States(points, one_state_each(points, mapped), mapped)
    tell("sheets and their folds")
    connect_all(points, states, mapped)
    tell("other sheets")
    rounds, quiet = search(points, states, mapped, tell)
    return SolvedGrid.of(points, states, rounds, quiet)
