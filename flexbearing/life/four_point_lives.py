"""Lives of slow balls with two or four contacts, turning or oscillating."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import quasidynamic as qd
from flexbearing.case.as_written import BALL_SIZES, as_written
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.life.ball_lives import row_of
from flexbearing.life.life_of_state import MREV, LifeOfState, no_life, of_reliability, why_none
from flexbearing.life.rated_bearing import Rating
from quasidynamic import OutOfRange
from quasidynamic.note import Note
from quasidynamic.outcome.four_point_life import RatedArcs, arc_lives, four_point_life, guideline_life
from quasidynamic.outcome.life import reference_load
from quasidynamic.outcome.raceway_damage import POINT
from quasidynamic.outcome.rating_life import BALL_EXPONENT
from quasidynamic.parts.ball import BallRow


@dataclass(frozen=True)
class FourPointLives:
    """Lives at one state of the bearing [rev], those to and fro together."""

    basic: float  # L10r
    arcs: NDArray  # (G, 2) of each arc on its own, that of diagonal and race
    of_state: LifeOfState | None  # after the reliability; None where none is required
    rating: float  # [N] C_r or C_a of one diagonal
    relative_speed: float  # [rad/s], mean of its amount where rings oscillate
    oscillation: float | None  # [rad] from one end to the other

    @property
    def raceways(self) -> NDArray:
        """Of the inner and the outer ring (2), both arcs of which survive."""
        with np.errstate(divide="ignore"):  # no load, no damage: for ever
            return (self.arcs**-POINT.weibull).sum(axis=0) ** (-1 / POINT.weibull)

    @property
    def modified(self) -> float | None:
        """Life with the reliability of the case [rev]."""
        return None if self.of_state is None else self.of_state.modified

    @property
    def longest(self) -> float:
        """The most detailed life [rev]."""
        return self.basic if self.modified is None else self.modified

    @property
    def oscillations(self) -> float | None:
        """Of the basic life; each goes there and back."""
        return None if self.oscillation is None else self.basic * np.pi / self.oscillation

    @property
    def equivalent(self) -> float:
        """Load that gives the same life by the rating [N]."""
        return float(reference_load(self.basic / MREV, self.rating, BALL_EXPONENT))


def lives(case: FourPointCase, balls: qd.SlidingBalls) -> FourPointLives | None:
    """Lives under the loads of all balls; None without load, and where no rating or no row is known."""
    if case.operation.mode != "ring_load" or unrated(case):
        return None
    loads, arcs, angle = balls.load.transpose(2, 1, 0), rated_arcs(case), case.operation.oscillation
    if angle is not None and case.life.oscillation == "DG03":
        turning = four_point_life(loads, arcs), arc_lives(loads, arcs)
        basic, each = (guideline_life(life, arcs, angle) for life in turning)
    else:
        basic, each = four_point_life(loads, arcs, angle), arc_lives(loads, arcs, angle)
    if not np.isfinite(basic):
        return None
    state = None if case.life.is_basic else LifeOfState.of(basic, (), of_reliability(case.life.reliability))
    return FourPointLives(basic * MREV, each.T * MREV, state, arcs.rating, case.operation.speed, angle)


def rated_arcs(case: FourPointCase) -> RatedArcs:
    """One diagonal with the rating of the case, or that of ISO 281.

    Raises `OutOfRange` where ISO 281 has none: balls that are not of steel, angles and sizes beyond its
    tables.
    """
    materials = case.materials
    if case.life.dynamic_rating is None and not (materials.steel_balls or materials.hybrid):
        raise OutOfRange(
            f"balls of {materials.ball.youngs_modulus / 1e9:.4g} GPa: ISO 281 rates balls of steel; give "
            "life.dynamic_rating"
        )
    return _arcs(case, row(case), rating(case).value)


def row(case: FourPointCase) -> BallRow:
    """One diagonal as the standards see it: with the contact angle of the design, at any clearance."""
    own, diameter = case.bearing, case.bearing.ball.diameter
    return BallRow(
        balls=case.balls,
        ball_diameter=diameter,
        pitch_diameter=own.pitch_diameter,
        contact_angle=own.contact_angle,
        inner_conformity=own.inner.over(diameter),
        outer_conformity=own.outer.over(diameter),
    )


def rating(case: FourPointCase) -> Rating:
    """C_r or C_a of the case."""
    now, given = row(case), case.life.dynamic_rating
    then = now if given is None else row_of(now, as_written(case, "life.dynamic_rating", BALL_SIZES))
    return Rating(lambda balls: _arcs(case, balls).rating, now, given, now if then == now else then)


def _arcs(case: FourPointCase, balls: BallRow, given: float | None = None) -> RatedArcs:
    thrust = None if case.life.rating is None else case.life.rating == "thrust"
    return RatedArcs.of(balls, given, thrust)


def unrated(case: FourPointCase) -> str:
    """Why there is no dynamic rating; empty where there is one."""
    return why_none(lambda: rated_arcs(case).capacities)


def notes(case: FourPointCase) -> tuple[Note, ...]:
    """What keeps the life away."""
    if case.operation.mode != "ring_load":
        return ()
    return no_life(unrated(case), "", None)
