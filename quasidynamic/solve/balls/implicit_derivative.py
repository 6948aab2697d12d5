"""Derivatives of a ring on balls by parameters: implicit differentiation, nothing is solved again."""

from collections.abc import Sequence

import numpy as np

from quasidynamic.balance.balls.angular_contact import AngularBalance
from quasidynamic.balance.balls.elastic_grooves import ElasticGrooves
from quasidynamic.solve.balls.ring_in_elastic_grooves import Places, unmoved
from quasidynamic.solve.balls.ring_on_springs import stiffened_step

Equations = tuple[AngularBalance, ElasticGrooves]


def newton_step(equations: Equations, places: Places) -> Places:
    """Newton step of ring, grooves and balls of one case; not a number where nothing holds the ring."""
    balance, grooves = equations
    state = unmoved(balance, grooves, places)
    return state.steps(stiffened_step(balance, state.excess_after, state.stiffness, 0.0))


def moved_places(places: Places, variants: Sequence[Equations], weights: Sequence[float]) -> Places:
    r"""Change of the places of an equilibrium by a parameter: the weighted sum of Newton steps of variants.

    Balls move by what the parameter leaves unbalanced on them, grooves by what it and they leave between them
    and the displacement by the forces of the balls, the ring by what all leave on it; then grooves and balls
    follow it, see `ring_in_elastic_grooves`:

    .. math:: x' = -J^{-1} \frac{\partial r}{\partial p}
              = -\sum_k w_k\,J_k^{-1} r(x, p_k) + O(\Delta p^2)

    with the residual r of all, and its derivatives J by their places x, which the variants p_k have.

    Places are those of one case in equilibrium, and variants its balance and grooves with other values of the
    parameter, rigid rings as grooves of no compliance; the weighted sum of their values is a derivative.
    Derivatives are in m and N by the unit of the parameter.

    Source
    ------
    The implicit function theorem, balls eliminated from the grooves, both from the ring; derived here.

    Valid
    -----
    Where the slopes of race control are exact, which those of Coulomb friction are not.
    """
    total = Places(*(np.zeros_like(each) for each in places))
    for variant, weight in zip(variants, weights, strict=True):
        balance, _ = variant
        step = newton_step(variant, places.held(balance))
        total = total.further(weight, step.held(balance))  # whose places where it is held add up, too
    return total
