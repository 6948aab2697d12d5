"""Fatigue life of ball bearings whose balls have two or four contacts, turning or oscillating."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.outcome.ball_capacity import ball_dynamic_rating, ball_raceway_capacity
from quasidynamic.outcome.oscillation import critical_oscillation, guideline_factor, oscillating_damage
from quasidynamic.outcome.raceway_damage import POINT, raceway_damage
from quasidynamic.outcome.rating_life import BALL_EXPONENT
from quasidynamic.outcome.thrust_ball_capacity import (
    is_thrust,
    thrust_ball_dynamic_rating,
    thrust_ball_raceway_capacity,
)
from quasidynamic.parts.ball import BallRow

TURNING = (1.0, 0.0)  # of the inner and the outer ring: the load is at rest against the outer one


class RatedArcs(NamedTuple):
    """Balls of a bearing with one or two diagonals of arcs, and the rating of one diagonal."""

    row: BallRow
    rating: float  # [N] C_a of thrust bearings, else C_r
    thrust: bool

    @classmethod
    def of(cls, row: BallRow, rating: float | None = None, thrust: bool | None = None) -> "RatedArcs":
        """With a rating [N], that of ISO 281 if left out; radial or axial by the contact angle unless said.

        Source
        ------
        `is_thrust`, `ball_dynamic_rating`, `thrust_ball_dynamic_rating`.
        """
        axial = is_thrust(row) if thrust is None else thrust
        formula = thrust_ball_dynamic_rating if axial else ball_dynamic_rating
        return cls(row, formula(row) if rating is None else rating, axial)

    @property
    def capacities(self) -> tuple[float, float]:
        """Q_c of the inner and the outer arc of a diagonal [N]."""
        capacity = thrust_ball_raceway_capacity if self.thrust else ball_raceway_capacity
        return capacity(self.row, self.rating)


def arc_lives(loads: NDArray, arcs: RatedArcs, oscillation: float | None = None) -> NDArray:
    r"""Basic reference life of each arc on its own.

    .. math:: L_{10} = (Q_c/Q_e)^3,\quad Q_e = \Big(\frac1Z \sum_j Q_j^s\Big)^{1/s}

    with s = 3 of the inner ring, which turns against the load, and 10/3 of the outer one, which is at rest.
    Where the rings oscillate, the sums are those of `oscillating_damage`.

    Parameters
    ----------
    loads : array (2, G, Z)
        normal loads at the inner and the outer race [N], >= 0, of G diagonals
    arcs : RatedArcs
        for the capacities
    oscillation : float, optional
        angle from one end to the other [rad]; the rings turn on if left out

    Returns
    -------
    array (2, G)
        [10^6 revolutions] of one ring against the other, those to and fro together; infinite without load

    Source
    ------
    ISO/TS 16281 (2008), ball bearings, for each diagonal as for a row; `oscillating_damage`.

    Valid
    -----
    As the rating of the arcs; reliability 90 %, no lubrication factor.
    """
    return _life(_damages(loads, arcs, oscillation))


def four_point_life(loads: NDArray, arcs: RatedArcs, oscillation: float | None = None) -> float:
    r"""Basic reference life that all arcs survive together, with 90 % probability.

    .. math:: L_{10r} = \big\{\sum (Q_c/Q_e)^{-10/3}\big\}^{-9/10}

    over two arcs of each diagonal, in 10^6 revolutions, infinite without load; arguments as of `arc_lives`.

    Source
    ------
    ISO/TS 16281 (2008); that the arcs of both diagonals join the sum as those of two rows is read from it.

    Valid
    -----
    As `arc_lives`.
    """
    return float(_life(_damages(loads, arcs, oscillation).sum()))


def guideline_life(life: Any, arcs: RatedArcs, oscillation: float) -> Any:
    r"""Life of an oscillating bearing from that of a turning one, by the guideline of NREL.

    .. math:: L_{osc} = \frac{\theta}{180^\circ} \Big(\frac{C_{a,osc}}{C_a}\Big)^3 L_{10}

    In revolutions that are gone to and fro together, as the life L_10 of the turning bearing that it is made
    of; theta, from one end to the other [rad].

    Source
    ------
    Harris, Rumbarger and Butterfield, NREL DG03 (2009), see `guideline_factor`.

    Valid
    -----
    As `guideline_factor`.
    """
    factor = guideline_factor(oscillation, arcs.row.balls, arcs.row.diameter_ratio)
    return oscillation / np.pi * factor**BALL_EXPONENT * life


def _damages(loads: NDArray, arcs: RatedArcs, oscillation: float | None) -> NDArray:
    """Of the inner and the outer arc of each diagonal (2, G)."""
    capacities, each = arcs.capacities, np.asarray(loads, dtype=float)[..., None]
    if oscillation is None:
        sides = zip(each, capacities, TURNING, strict=True)
        return np.array([raceway_damage(load, capacity, share, POINT) for load, capacity, share in sides])
    critical = critical_oscillation(arcs.row.balls, arcs.row.diameter_ratio)
    sides = zip(each, capacities, critical, TURNING, strict=True)
    return np.array([
        oscillating_damage(load, capacity, oscillation, angle, bool(moves))
        for load, capacity, angle, moves in sides
    ])  # fmt: skip


def _life(damage: Any) -> Any:
    with np.errstate(divide="ignore"):  # no load, no damage: for ever
        return damage ** (-1 / POINT.weibull)
