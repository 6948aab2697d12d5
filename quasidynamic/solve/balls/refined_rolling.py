"""Motion of a ball with stick and slip on two grids, which tell the error of the finer one."""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Literal

from numpy.typing import NDArray

from quasidynamic.balance.balls.rolling_ball import RollingBall
from quasidynamic.contact.rolling.fastsim import FASTSIM
from quasidynamic.contact.rolling.full_sliding import FULL_SLIDING
from quasidynamic.contact.rolling.kalker import KALKER
from quasidynamic.contact.rolling.rolling_contact import RollingLaw
from quasidynamic.errors import NotSolved, OutOfRange
from quasidynamic.solve.balls.rolling_motion import RollingMotion, kept_motion, rolling_motion

RollingModel = Literal["full_sliding", "fastsim", "kalker"]  # friction of contacts on a grid
LAWS: dict[RollingModel, RollingLaw] = {"full_sliding": FULL_SLIDING, "fastsim": FASTSIM, "kalker": KALKER}
SAFETY = 1.25  # Roache (1994), J. Fluids Eng. 116, 405-413; the error is of first order or better
FEWEST = 4  # cells along and across of the coarser grid


@dataclass(frozen=True)
class RefinedRolling:
    """A ball on a grid and on one of half the cells in each direction."""

    fine: RollingMotion
    coarse_torque: float  # [N m]

    @property
    def torque(self) -> float:
        """Torque on the finer grid [N m]."""
        return self.fine.power

    @property
    def grid_error(self) -> float:
        """Error of the torque by the cells [N m]: its change from the coarser grid, times `SAFETY`."""
        return SAFETY * abs(self.fine.power - self.coarse_torque)

    @property
    def extrapolated_torque(self) -> float:
        """Torque on cells of no size, if its error is of first order (Richardson) [N m]."""
        return 2 * self.fine.power - self.coarse_torque


def refined_rolling(
    ball_on: Callable[[tuple[int, int]], RollingBall],
    model: RollingModel,
    cells: tuple[int, int],
    motion: NDArray,
) -> RefinedRolling:
    """Ball with stick and slip, first on the coarser grid.

    Parameters
    ----------
    ball_on : callable
        the ball on a number of cells along and across the rolling direction
    model : {"full_sliding", "fastsim", "kalker"}
        friction of the contacts
    cells : pair of int
        of the finer grid, even
    motion : array (4)
        of full sliding, to start from: outer ring, ball axial, radial, about the rolling direction

    Returns
    -------
    RefinedRolling

    Raises
    ------
    OutOfRange
        when the cells cannot be halved
    NotSolved
        when no balance is found, see `rolling_motion`
    """
    law, coarse_ball = LAWS[model], ball_on(_halved(cells))
    start, slopes = None, None
    if model == "kalker":
        with suppress(NotSolved):  # full sliding is a start, too, farther away
            near = rolling_motion(coarse_ball, FASTSIM, motion)
            motion, start, slopes = near.motion, near.rolled.traction, near.slopes
    coarse = rolling_motion(coarse_ball, law, motion, start, slopes)
    ball = ball_on(cells)
    start = FASTSIM.friction(ball.contacts, ball.creep(coarse.motion)).traction if model == "kalker" else None
    fine = rolling_motion(ball, law, coarse.motion, start, coarse.slopes)
    return RefinedRolling(_lean(fine), coarse.power)


def refined_kept_motion(
    ball_on: Callable[[tuple[int, int]], RollingBall],
    model: RollingModel,
    cells: tuple[int, int],
    motion: NDArray,
) -> RefinedRolling:
    """Ball with stick and slip that moves as is given, on both grids.

    Parameters
    ----------
    ball_on : callable
        the ball on a number of cells along and across the rolling direction
    model : {"full_sliding", "fastsim", "kalker"}
        friction of the contacts
    cells : pair of int
        of the finer grid, even
    motion : array (4)
        outer ring, ball axial, radial, about the rolling direction

    Returns
    -------
    RefinedRolling

    Raises
    ------
    OutOfRange
        when the cells cannot be halved, or the material stands still in a contact
    NotSolved
        when a contact is not solved
    """
    states = []
    for ball in (ball_on(_halved(cells)), ball_on(cells)):
        near = FASTSIM.friction(ball.contacts, ball.creep(motion)).traction if model == "kalker" else None
        states.append(kept_motion(ball, LAWS[model], motion, near))
    coarse, fine = states
    return RefinedRolling(_lean(fine), coarse.power)


def _halved(cells: tuple[int, int]) -> tuple[int, int]:
    """Cells of the coarser grid."""
    if any(number % 2 or number < 2 * FEWEST for number in cells):
        raise OutOfRange(f"cells = {cells} of a contact must be even numbers of at least {2 * FEWEST}")
    return cells[0] // 2, cells[1] // 2


def _lean(motion: RollingMotion) -> RollingMotion:
    """Return the same without the transforms that only a search needs."""
    contacts = replace(motion.ball.contacts)
    return replace(
        motion, ball=replace(motion.ball, contacts=contacts), rolled=replace(motion.rolled, contacts=contacts)
    )
