"""The search from several starts, with the optimisers of SciPy."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import count
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize
from scipy.stats import qmc

from flexbearing.optimise.evaluations import NotComputed, Point
from flexbearing.optimise.goals import DesignProblem, NotPositive, Numbers, Terms
from flexbearing.optimise.optimality import Optimality, optimality
from flexbearing.optimise.schema import Search

FEASIBLE = 1e-4  # how far a bound may be missed, over its size
RESTARTS = 3  # of an optimiser that stops before an optimum, with a new approximation of the curvature
SPARE = 5e-4  # margin up to which a constraint counts as used up, over the size of its bound
FLAT = 1e-2  # of the tolerance: change of the merit in an iteration at which the optimiser stops
MODELS = 10  # models of cobyqa that count as an iteration
PENALTY = 10.0  # by which the merit of a design without a result is below that of the start


class End(StrEnum):
    """How the search from a start ended."""

    CONVERGED = "converged"
    LIMIT = "iteration limit"
    STALLED = "stopped before an optimum"
    INFEASIBLE = "no point meets all constraints"
    NO_ANSWER = "not computed"


@dataclass(frozen=True)
class SearchResult:
    """Where the search from a start ended."""

    end: End
    start: Point
    point: Point
    numbers: Numbers | None  # with slopes; None where the design has no result
    merits: Terms | None
    margins: Terms | None
    optimality: Optimality | None
    message: str  # of the optimiser
    iterations: int

    @property
    def merit(self) -> float:
        """What was made large; minus infinity without a result."""
        return -np.inf if self.merits is None else float(self.merits.values.min())

    @property
    def missed(self) -> float:
        """How far the constraint that is missed most is missed, over its size; 0 where all are met."""
        return 0.0 if self.margins is None else max(0.0, -float(self.margins.values.min(initial=0.0)))


class Enough(Exception):
    """A start leads to an optimum that is no better than a known one."""

    def __init__(self, shares: NDArray, iterations: int):
        super().__init__("the optimum is no better than that of a former start")
        self.shares, self.iterations = shares, iterations


class Designs(Protocol):
    """Designs and what is wanted of them."""

    @property
    def wanted(self) -> DesignProblem:
        """What is searched."""
        ...

    def values(self, points: Sequence[Point]) -> list[Numbers | NotComputed]:
        """Outputs of designs."""
        ...

    def at(self, point: Point) -> Numbers:
        """Outputs of a design with their derivatives; raises NotComputed."""
        ...


@dataclass
class ScaledProblem:
    """The problem as an optimiser sees it: shares x of K variables, and of the worst of several terms t."""

    designs: Designs
    nearest: bool = False  # whether a point that meets all constraints is searched in place of the best
    about: tuple[NDArray, float] | None = None  # shares (K) and how far from each is searched; None: anywhere
    inside: float = 0.0  # margin of every constraint that is kept
    spare: float = SPARE  # margin up to which a constraint counts as used up
    most: int | None = None  # iterations, where they are fewer than those of the settings
    best: float = -np.inf  # merit of former starts: an optimum that is no better is not refined further

    @property
    def settings(self) -> Search:
        """How it is searched."""
        settings = self.designs.wanted.settings
        most = settings.iterations if self.most is None else min(self.most, settings.iterations)
        return settings.model_copy(update={"iterations": most})

    @property
    def limits(self) -> tuple[NDArray, NDArray]:
        """Least and largest shares (K)."""
        middle, reach = self.about or (np.zeros(len(self.designs.wanted.variables)), 1.0)
        return np.maximum(middle - reach, 0.0), np.minimum(middle + reach, 1.0)

    def point(self, shares: NDArray) -> Point:
        """The point at some shares of the ranges."""
        return tuple(
            each.value(share) for each, share in zip(self.designs.wanted.variables, shares, strict=True)
        )

    def shares(self, point: Point) -> NDArray:
        """Shares of a point."""
        both = zip(self.designs.wanted.variables, point, strict=True)
        return np.array([each.share(value) for each, value in both])

    def terms(self, numbers: Numbers) -> tuple[Terms, Terms]:
        """Merits (T) and margins (M) of a design."""
        merits = self.designs.wanted.goal.merits(numbers)
        margins = [bound.margins(numbers) for bound in self.designs.wanted.bounds]
        none = Terms(np.zeros(0), np.zeros((0, merits.slopes.shape[1])))
        joined = Terms(
            np.concatenate([none.values, *(each.values - self.inside for each in margins)]),
            np.vstack([none.slopes, *(each.slopes for each in margins)]),
        )
        return (joined, none) if self.nearest else (merits, joined)

    def values(self, shares: NDArray) -> tuple[NDArray, NDArray] | None:
        """Merits and margins; None of a design without a result."""
        (numbers,) = self.designs.values([self.point(shares)])
        if isinstance(numbers, NotComputed):
            return None
        merits, margins = self.terms(numbers)
        return merits.values, margins.values

    def slopes(self, shares: NDArray) -> tuple[NDArray, NDArray]:
        """Derivatives of merits (T, K) and margins (M, K)."""
        merits, margins = self.terms(self.designs.at(self.point(shares)))
        return merits.slopes, margins.slopes

    def is_enough(self, shares: NDArray) -> bool:
        """Whether a design is an optimum that is no better than the best of former starts."""
        merits, margins = self.terms(self.designs.at(self.point(shares)))
        if self.nearest or merits.values.min() > self.best:
            return False
        gain = optimality(merits, margins, shares, self.limits, self.spare).gain
        return gain <= self.settings.tolerance and margins.values.min(initial=0.0) >= -FEASIBLE


def starts(number: int, first: NDArray, seed: int) -> Iterator[NDArray]:
    """Yield shares (K) of the starts: the case itself, then points of a Sobol sequence."""
    yield np.clip(first, 0.0, 1.0)
    sequence = qmc.Sobol(len(first), seed=seed)  # pyright: ignore[reportCallIssue]
    sequence.fast_forward(1)  # the first point without scrambling is a corner
    for _ in range(number - 1):
        yield sequence.random(1)[0]


def search(problem: ScaledProblem, start: NDArray) -> SearchResult:
    """Search from one start; where constraints are not met at its end, first for a point that meets them."""
    found = _optimised(problem, start)
    if found.end is not End.INFEASIBLE:
        return found
    nearest = _optimised(replace(problem, nearest=True), problem.shares(found.point))
    there, used = problem.shares(nearest.point), found.iterations + nearest.iterations
    if nearest.merit < -FEASIBLE or used >= problem.settings.iterations:
        return replace(examined(problem, there, used, nearest.message), start=found.start)
    again = _optimised(problem, there, used)
    return replace(again, start=found.start)


def _optimised(problem: ScaledProblem, start: NDArray, used: int = 0) -> SearchResult:
    """What the optimiser finds from a start, called again where it stops before an optimum."""
    settings, shares, message, by_models = problem.settings, start, "", False
    (first,) = problem.designs.values([problem.point(start)])
    if isinstance(first, NotComputed):
        return _unknown(problem, start, str(first), used)
    for _ in range(RESTARTS):
        try:
            ended = _ended(problem, shares, settings.iterations - used)
        except NotComputed as why:
            message = str(why)
            break
        except Enough as end:
            shares, used, message = end.shares, used + end.iterations, str(end)
            break
        shares = np.clip(ended.x[: len(start)], *problem.limits)
        used, message = used + ended.nit, ended.message
        by_models = settings.method == "cobyqa" and ended.success
        found = examined(problem, shares, used, message, by_models)
        if found.end is End.CONVERGED or used >= settings.iterations or ended.nit <= 1:
            break
    return replace(examined(problem, shares, used, message, by_models), start=problem.point(start))


def _ended(problem: ScaledProblem, shares: NDArray, iterations: int) -> Any:
    """The answer of the optimiser: x holds the shares and t, the smallest merit."""
    settings, first = problem.settings, problem.values(shares)
    assert first is not None  # a search goes on where there is an answer
    low = float(first[0].min()) - PENALTY
    without_answer = np.concatenate([np.full(len(first[0]), low), np.full(len(first[1]), -PENALTY)])

    def constraints(x: NDArray) -> NDArray:
        values = problem.values(x[:-1])
        found = without_answer if values is None else np.concatenate(values)
        return found - np.where(np.arange(len(found)) < len(first[0]), x[-1], 0.0)

    number = count()

    def slopes(x: NDArray) -> NDArray:
        iteration = next(number)
        if problem.is_enough(x[:-1]):
            raise Enough(x[:-1], iteration)
        merits, margins = problem.slopes(x[:-1])
        by_t = np.concatenate([-np.ones(len(merits)), np.zeros(len(margins))])
        return np.column_stack([np.vstack([merits, margins]), by_t])

    begin, up = np.append(shares, first[0].min()), np.append(np.zeros(len(shares)), -1.0)
    bounds = [*zip(*problem.limits, strict=True), (None, 0.0 if problem.nearest else None)]
    constraint = {"type": "ineq", "fun": constraints}
    if settings.method == "cobyqa":
        options = {"maxiter": iterations * MODELS, "final_tr_radius": 1e-3, "initial_tr_radius": 0.1}
        return minimize(
            lambda x: -x[-1], begin, method="COBYQA", bounds=bounds, constraints=constraint, options=options
        )
    options = {"maxiter": iterations, "ftol": settings.tolerance * FLAT}
    constraint |= {"jac": slopes}
    return minimize(
        lambda x: -x[-1], begin, jac=lambda x: up, method="SLSQP", bounds=bounds, constraints=constraint,
        options=options,
    )  # fmt: skip


def examined(
    problem: ScaledProblem, shares: NDArray, iterations: int, message: str, by_models: bool = False
) -> SearchResult:
    """What stands at a point, and whether it is an optimum: by derivatives, or models without any."""
    point, settings = problem.point(shares), problem.settings
    try:
        numbers = problem.designs.at(point)
        merits, margins = problem.terms(numbers)
    except (NotComputed, NotPositive) as why:
        return _unknown(problem, shares, str(why), iterations)
    conditions = optimality(merits, margins, shares, problem.limits, problem.spare)
    if by_models or conditions.gain <= settings.tolerance:
        end = End.CONVERGED
    else:
        end = End.LIMIT if iterations >= settings.iterations else End.STALLED
    if margins.values.min(initial=0.0) < -FEASIBLE and end is not End.LIMIT:
        end = End.INFEASIBLE
    return SearchResult(end, point, point, numbers, merits, margins, conditions, message, iterations)


def _unknown(problem: ScaledProblem, shares: NDArray, why: str, iterations: int) -> SearchResult:
    """A point without a result."""
    point = problem.point(shares)
    return SearchResult(End.NO_ANSWER, point, point, None, None, None, None, why, iterations)
