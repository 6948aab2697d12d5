"""One bearing and its rings by two coupling methods: how far apart they end, and whether both are right."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.coupling import RULES, Iteration, RacewayPair, StoppingCriterion, fixed_point, newton

LIMIT = 200  # iterations
SAME = 1e-6  # loads of two methods that agree, over the largest
AGAIN = 1e-9  # loads of a method that begins at the state of the other, and stays
SMALL_CHANGE = 1e-10  # of loads where a state is solved again


@dataclass(frozen=True)
class TwoStates:
    """End states of newton and another method that differ."""

    by_other: float  # change of newton's loads where the other method begins there; infinite if it fails
    by_newton: float  # change of the other's loads where newton begins there
    names: str  # of both states

    @property
    def both_right(self) -> bool:
        """Whether each is an equilibrium for the other method, too."""
        return max(self.by_other, self.by_newton) <= AGAIN


def iterated(
    bearing, rings: RacewayPair, start, method: str, tolerance: float, limit: int = LIMIT
) -> Iterator[Iteration]:
    """Iterations of a method from a start."""
    given = bearing, rings, start, StoppingCriterion(tolerance=tolerance, limit=limit)
    return newton(*given) if method == "newton" else fixed_point(*given, RULES[method])


def solved_again(bearing, rings: RacewayPair, ours, other, method: str = "iqn-ils") -> TwoStates:
    """Each of two end states, newton's and that of another method, solved again by the other one.

    Parameters
    ----------
    bearing, rings : partners
    ours, other : Equilibrium
        end states of newton and of the method
    method : str
        its name
    """
    criterion = StoppingCriterion(tolerance=SMALL_CHANGE, limit=LIMIT)
    *_, by_newton = newton(bearing, rings, other, criterion)
    known = rings.linearised(ours.forces).deviation(ours.forces)
    rule = partial(from_deviation, known, RULES[method])
    *_, by_other = fixed_point(bearing, rings, ours, criterion, rule)
    return TwoStates(
        moved(by_other, ours.loads),
        moved(by_newton, other.loads),
        f"newton: {name(ours)} / {method}: {name(other)}",
    )


def from_deviation(deviation: NDArray, rule, history) -> NDArray:
    """Steps of a rule that begin at a known deviation."""
    if len(history.deviations) == 1:
        return deviation.ravel()
    known = replace(
        history,
        deviations=history.deviations[1:],
        residuals=history.residuals[1:],
        contacts=history.contacts[1:],
    )
    return rule(known)


def moved(last: Iteration, loads: NDArray) -> float:
    """How far a method that began at some loads ended from them; infinite where it did not converge."""
    return difference(last.state.loads, loads) if last.status == "converged" else float("inf")


def difference(loads: NDArray, others: NDArray) -> float:
    """Largest difference of a load over the largest load [-]."""
    return float(np.abs(loads - others).max() / others.max())


def name(state: Any) -> str:
    """An equilibrium in a few numbers."""
    load, slip = state.loads[0].max(), 100 * state.cage_slip
    return f"{load:.6g} N, cage slip {slip:.4g} %, life {state.life:.5g} Mrev"
