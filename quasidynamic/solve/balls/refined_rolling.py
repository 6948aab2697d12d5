"""Motion of a ball with stick and slip on three grids, which tell the error of the finest one."""

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
SAFETY = 1.25  # Roache (1994), J. Fluids Eng. 116, 405-413
STUCK = 0.03  # of the cells of a contact; calibrated: fewer stick at poles of spin and lines of no slip alone
STICKING_ORDER, SLIDING_ORDER = 1.0, 1.5  # of the error; calibrated: medians of 50 balls are 1.2 and 2
FEWEST = 3  # cells along and across of the coarsest grid


@dataclass(frozen=True)
class RefinedRolling:
    """A ball on a grid and on those of half and of a quarter of the cells in each direction."""

    fine: RollingMotion
    coarse_torques: tuple[float, float]  # [N m] half, a quarter of the cells

    @property
    def torque(self) -> float:
        """Torque on the finest grid [N m]."""
        return self.fine.power

    @property
    def order(self) -> float:
        """Order of the error of the torque: displacements change by leaps where material begins to stick."""
        sticks = self.fine.rolled.stick_share.max() > STUCK
        return STICKING_ORDER if sticks else SLIDING_ORDER

    @property
    def grid_error(self) -> float:
        r"""Error of the torque by the cells [N m].

        .. math:: 1.25\, \frac{\max(|M - M_2|, |M_2 - M_4|/2^p)}{2^p - 1}

        with the torques M_2 and M_4 of half and a quarter of the cells, p = `order`: errors of several causes
        may cancel in one of the changes, hardly in both.

        Source
        ------
        Roache (1994), J. Fluids Eng. 116, 405-413, with the second change added.
        """
        half, quarter = self.coarse_torques
        change = max(abs(self.torque - half), abs(half - quarter) / 2**self.order)
        return SAFETY * change / (2**self.order - 1)

    @property
    def extrapolated_torque(self) -> float:
        """Torque on cells of no size, by Richardson's extrapolation with `order` [N m]."""
        return self.torque + (self.torque - self.coarse_torques[0]) / (2**self.order - 1)


def refined_rolling(
    ball_on: Callable[[tuple[int, int]], RollingBall],
    model: RollingModel,
    cells: tuple[int, int],
    motion: NDArray,
) -> RefinedRolling:
    """Ball with stick and slip, in balance on the grid of half the cells and then on the finest.

    The coarsest grid takes the motion of half the cells: where friction is in balance the torque hardly
    changes with the motion, and few cells may have no balance.

    Raises `OutOfRange` when the cells cannot be halved twice; `NotSolved` when no balance is found, see
    `rolling_motion`.
    """
    law, (quarter, half, fine) = LAWS[model], map(ball_on, _refined(cells))
    start, slopes = None, None
    if model == "kalker":
        with suppress(NotSolved):  # full sliding is a start, too, farther away
            near = rolling_motion(half, FASTSIM, motion)
            motion, start, slopes = near.motion, near.rolled.traction, near.slopes
    coarse = rolling_motion(half, law, motion, start, slopes)
    coarsest = kept_motion(quarter, law, coarse.motion, _near(quarter, model, coarse.motion))
    finest = rolling_motion(fine, law, coarse.motion, _near(fine, model, coarse.motion), coarse.slopes)
    return _refined_rolling(coarsest, coarse, finest)


def refined_kept_motion(
    ball_on: Callable[[tuple[int, int]], RollingBall],
    model: RollingModel,
    cells: tuple[int, int],
    motion: NDArray,
) -> RefinedRolling:
    """Ball with stick and slip that moves as is given, on the same grids.

    Raises `OutOfRange` when the cells cannot be halved twice, or the material is at rest in a contact;
    `NotSolved` when a contact is not solved.
    """
    balls = map(ball_on, _refined(cells))
    return _refined_rolling(
        *(kept_motion(ball, LAWS[model], motion, _near(ball, model, motion)) for ball in balls)
    )


def _refined(cells: tuple[int, int]) -> list[tuple[int, int]]:
    """Cells of the three grids, from the coarsest."""
    if any(number % 4 or number < 4 * FEWEST for number in cells):
        raise OutOfRange(f"cells = {cells} of a contact must be multiples of four, at least {4 * FEWEST}")
    return [(cells[0] // part, cells[1] // part) for part in (4, 2, 1)]


def _near(ball: RollingBall, model: RollingModel, motion: NDArray) -> NDArray | None:
    """Tractions near those of a motion, for laws that want some to start from."""
    return FASTSIM.friction(ball.contacts, ball.creep(motion)).traction if model == "kalker" else None


def _refined_rolling(quarter: RollingMotion, half: RollingMotion, fine: RollingMotion) -> RefinedRolling:
    return RefinedRolling(_without_transforms(fine), (half.power, quarter.power))


def _without_transforms(motion: RollingMotion) -> RollingMotion:
    """Return the same without the transforms that only a search needs."""
    contacts = replace(motion.ball.contacts)
    return replace(
        motion, ball=replace(motion.ball, contacts=contacts), rolled=replace(motion.rolled, contacts=contacts)
    )
