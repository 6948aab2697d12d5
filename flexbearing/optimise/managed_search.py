"""The search on a cheap model whose outputs are corrected by the case, until the case says that it is best.

Each round searches the corrected model about the best design so far and computes the case with its
derivatives where that ends. Both models have the same values and derivatives there, so that a design which
is an optimum of the corrected model about itself is one of the case. A design that is no better in objective
or constraints than a former one is refused, and the next one searched closer.

Source
------
Alexandrov, Lewis, Gumbert, Green and Newman (2001), J. Aircraft 38, 1093: models of variable fidelity;
Fletcher and Leyffer (2002), Math. Program. 91, 239: the filter.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from flexbearing.optimise.correction import Corrected
from flexbearing.optimise.evaluations import NotComputed
from flexbearing.optimise.search import FEASIBLE, Designs, End, ScaledProblem, SearchResult, examined, search

MOST = 20  # iterations on the cheap model before the case is asked again
NEARER = 0.25  # of the last step, within which is searched after a design that is refused
LEAST = 1e-4  # largest change of a share that ends the search
SAME = 0.02  # largest difference of the shares up to which two starts lead to one optimum


@dataclass
class _Rounds:
    """The case, the cheap model, and what the case said so far."""

    problem: ScaledProblem  # of the case
    cheap: Designs
    filter: list[tuple[float, float]] = field(default_factory=list)  # missed and merit of accepted designs

    def ended(self, centre: SearchResult, start: NDArray, reach: float = 1.0) -> NDArray:
        """Shares at which the search on the cheap model ends, corrected by what is known of a design."""
        assert centre.numbers is not None  # where the search goes on
        corrected = Corrected(self.cheap, self.problem.designs, centre.point, centre.numbers)
        about = self.problem.shares(centre.point), reach
        try:
            found = search(ScaledProblem(corrected, about=about, inside=self.problem.spare, most=MOST), start)
        except NotComputed:  # by the cheap model, at the design that corrects it
            return start
        return self.problem.shares(found.point)

    def accepts(self, shares: NDArray) -> bool:
        """Whether no former design is as good in the objective and in the constraints."""
        values = self.problem.values(shares)
        if values is None:
            return False
        missed, merit = _missed(values[1]), float(values[0].min())
        return not any(other <= missed and best >= merit for other, best in self.filter)

    def examined(self, shares: NDArray, number: int) -> SearchResult:
        """What the case says of a design, with its derivatives."""
        found = examined(self.problem, shares, number, "the corrected surrogate promises no better design")
        if found.margins is not None:
            self.filter.append((_missed(found.margins.values), found.merit))
        return found


def _missed(margins: NDArray) -> float:
    """How far constraints are missed beyond what counts as met."""
    return max(0.0, -float(margins.min(initial=0.0)) - FEASIBLE)


def managed_search(
    problem: ScaledProblem, cheap: Designs, start: NDArray, known: Sequence[SearchResult] = ()
) -> SearchResult:
    """Search from one start."""
    begin = problem.point(start)
    converged = [each for each in known if each.end is End.CONVERGED]
    if converged:
        best = max(converged, key=lambda found: found.merit)
        start = _Rounds(problem, cheap).ended(best, start)
        if np.abs(start - problem.shares(best.point)).max() <= SAME:
            return replace(best, start=begin, iterations=0)
    return replace(from_design(problem, cheap, start, 1), start=begin)


def from_design(problem: ScaledProblem, cheap: Designs, shares: NDArray, iterations: int) -> SearchResult:
    """Go on from a design of the case."""
    rounds, reach = _Rounds(problem, cheap), 1.0
    centre = rounds.examined(shares, iterations)
    for number in range(iterations + 1, problem.settings.iterations + 1):
        if centre.end not in (End.STALLED, End.INFEASIBLE):
            break
        shares = rounds.ended(centre, problem.shares(centre.point), reach)
        step = float(np.abs(shares - problem.shares(centre.point)).max())
        if step <= LEAST:
            break
        found = rounds.examined(shares, number) if rounds.accepts(shares) else None
        if found is None or found.end is End.NO_ANSWER:
            reach = NEARER * step
        else:
            centre = found
    return centre
