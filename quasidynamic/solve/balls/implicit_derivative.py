"""Derivatives of a ring on balls by parameters: implicit differentiation, nothing is solved again."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.balls.angular_contact import AngularBalance, moved
from quasidynamic.balance.balls.ball_position import Vectors
from quasidynamic.solve.balls.ball_equilibrium import resolved
from quasidynamic.solve.balls.ring_on_balls import followed


class Places(NamedTuple):
    """Places of ring and balls of one case."""

    ring: NDArray  # (1, 5) [m] rotations times R_i
    centres: Vectors  # (1, Z) [m] axial + i radial, from the outer groove centres

    def shifted(self, balance: AngularBalance, by: "Places", steps: float) -> "Places":
        """Places some steps away; a ring that is held is where another case holds it."""
        ring = np.where(balance.held, balance.place, self.ring + steps * by.ring)
        return Places(ring, self.centres + steps * by.centres)


def moved_places(
    balance: AngularBalance, places: Places, variants: Sequence[AngularBalance], weights: Sequence[float]
) -> Places:
    r"""Change of the places of an equilibrium by a parameter.

    Balls move by what the parameter leaves unbalanced on them, the ring by what it and they leave on it, and
    the balls follow the ring:

    .. math:: \Delta c = -E_c^{-1} E_p,\quad \Delta q = K^{-1} (R_p + R_c \Delta c),\quad
              c' = \Delta c + \frac{dc}{dq} \Delta q

    Parameters
    ----------
    balance : AngularBalance
        of one case
    places : Places
        its equilibrium
    variants : sequence of AngularBalance
        the same case with other values of the parameter
    weights : sequence of float
        whose sum of values of the variants is a derivative

    Returns
    -------
    Places
        derivatives; not a number where nothing holds the ring

    Source
    ------
    The implicit function theorem, balls eliminated from the ring; derived here.

    Valid
    -----
    Where the slopes of race control are exact, which those of Coulomb friction are not.
    """
    balls = balance.balls(balance.grooves(places.ring), places.centres)
    follow = followed(balls)
    ring = balance.ring(balls, follow)
    on_balls, on_ring, held = 0.0, 0.0, 0.0
    for variant, weight in zip(variants, weights, strict=True):
        there = np.where(variant.held, variant.place, places.ring)
        forces = variant.balls(variant.grooves(there), places.centres)
        on_balls = on_balls + weight * forces.excess
        on_ring = on_ring + weight * variant.ring(forces, follow).excess
        held = held + weight * np.where(variant.held, variant.place, 0.0)
    alone = -resolved(balls, np.asarray(on_balls))
    _, force, traction = moved(balls.by_ball, alone)
    left = np.where(balance.held, 0.0, on_ring - balance.on_ring(force, traction.real))
    step = np.array(held)
    free = np.flatnonzero(~balance.held[0])
    if len(free):
        step[0, free] = np.linalg.solve(ring.stiffness[0][np.ix_(free, free)], left[0, free])
    by_ring = np.where(balance.held, 0.0, step) @ balance.ring_to_groove.T
    return Places(step, alone + moved(follow, by_ring))
