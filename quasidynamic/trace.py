"""Equilibria of one bearing over its load or speed, around folds; all that are there at one load."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from math import copysign, exp, isfinite, log, pi

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.operating_points import OperatingPoints
from quasidynamic.errors import NotSolved, OutOfRange
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.roller import RollerBearing, solve_many
from quasidynamic.solve.arclength import BranchEnd, BranchPoint, at_parameter, follow, solved_at
from quasidynamic.solve.rollers.parametric_balance import ParametricBalance, Tangents, between
from quasidynamic.solve.rollers.pseudo_time import growth_rates
from quasidynamic.solve.start import LumpedRollers, static_unknowns
from quasidynamic.solve.step_length import SolverOutcome

__all__ = ["PARAMETERS", "Branch", "BranchEnd", "TracedEquilibrium", "equilibria_at", "trace"]

PARAMETERS = ("radial_load", "inner_speed")
TRIAL_SLIPS = np.concatenate([np.geomspace(1e-6, 0.03, 28), np.linspace(0.05, 0.99, 24)])
SLIP_HALVINGS = 14
LOAD_RANGE = 3.0  # loads over that requested, and below it, between which a branch is searched
SAME_EQUILIBRIUM = 1e-5  # distance on the branch between two equilibria that are one


@dataclass(frozen=True)
class TracedEquilibrium:
    """An equilibrium on a branch."""

    value: float  # [N] radial load or [rad/s] speed
    equilibrium: Equilibrium
    fold: bool  # whether load or speed turns back here

    @property
    def slip(self) -> float:
        """Cage slip [-]."""
        return self.equilibrium.cage_slip

    @property
    def largest_load(self) -> float:
        """Largest roller load on the inner raceway [N]."""
        return float(self.equilibrium.loads[0].max())

    @cached_property
    def growth(self) -> float:
        """Growth rate [1/s] of the disturbance of cage and spins that decays least; zero at a fold."""
        if self.fold:
            return 0.0
        rates = growth_rates(self.equilibrium.balance, self.equilibrium.system)
        return float(np.real(rates).max())

    @property
    def stable(self) -> bool:
        """Whether small disturbances of cage and spins decay."""
        return self.growth < 0.0


@dataclass(frozen=True)
class Branch:
    """Equilibria in the order in which they follow each other."""

    over: str  # key of the operation that changes
    points: tuple[TracedEquilibrium, ...]
    end: BranchEnd  # why it was not followed further

    @property
    def folds(self) -> tuple[TracedEquilibrium, ...]:
        """Where load or speed turns back."""
        return tuple(point for point in self.points if point.fold)

    @property
    def values(self) -> NDArray:
        """Loads [N] or speeds [rad/s] of the points."""
        return np.array([point.value for point in self.points])

    @property
    def slip(self) -> NDArray:
        """Cage slip of the points [-]."""
        return np.array([point.slip for point in self.points])

    @property
    def largest_load(self) -> NDArray:
        """Largest roller loads of the points [N]."""
        return np.array([point.largest_load for point in self.points])

    @property
    def stable(self) -> NDArray:
        """Which points are stable; a fold is not."""
        return np.array([point.stable for point in self.points])


def trace(
    model: RollerBearing,
    *,
    over: str = "radial_load",
    span: tuple[float, float],
    start: Equilibrium | None = None,
    tangents: Tangents | None = None,
) -> Branch:
    """Follow the equilibria of a bearing over its load or speed, in one system with elastic raceways.

    Where traction falls with slip, a branch may turn back at a fold: the bearing has several
    equilibria at one load, and jumps from one to another when the load passes a fold. Other
    branches, not connected to this one inside the span, are not found; see `equilibria_at`.

    Raises `NotSolved` when there is no equilibrium to begin with; `OutOfRange` when the logarithm of the span
    makes no sense.
    """
    first, last = logarithms(model, over, span)
    begin = start or _changed(model, over, span[0]).solve()
    problem = _problem(model, over, span[0], begin.balance, None)
    state = problem.balance_at(first).pack(begin.unknowns)[0]
    if tangents is not None:
        compliance, _ = tangents(begin.forces)
        problem = _problem(model, over, span[0], between(begin.balance, compliance), tangents)
        whole = np.moveaxis(begin.deviation, -1, 1)[:, :, None]
        state = problem.balance_at(first).pack(begin.unknowns._replace(deviation=whole))[0]
    bounds = min(first, last), max(first, last)
    followed = follow(problem, state, first, bounds, upwards=last > first)
    if not followed.points:
        raise NotSolved(f"no equilibrium near the start of the branch at {over} = {span[0]:.6g}")
    exact = {first: span[0], last: span[1]}
    values = [exact.get(step.parameter, copysign(exp(step.parameter), span[0])) for step in followed.points]
    points = [
        TracedEquilibrium(value, _equilibrium(problem, step, model.axial_modes), step.fold)
        for value, step in zip(values, followed.points, strict=True)
    ]
    return Branch(over, tuple(points), followed.end)


def equilibria_at(model: RollerBearing) -> tuple[Equilibrium, ...]:
    """Find the equilibria of a bearing between rigid raceways at its one operating point.

    Newton's method starts at every slip where the torque of lumped rollers on the cage changes its
    sign; the branches through these solutions are followed over the load, as they may come back to it.

    Raises `NotSolved` when there is none; `OutOfRange` when the bearing has no load.
    """
    load = model.operation.radial_load
    parameter, _ = logarithms(model, "radial_load", (load, load * LOAD_RANGE))
    usual = solve_many([model])[0]
    problem = _problem(model, "radial_load", load, usual.balance, None)
    starts = [usual.scaled] if usual.status is SolverOutcome.CONVERGED else []
    starts += _lumped_starts(usual.balance)
    known: list[BranchPoint] = []
    for state in starts:
        solution = solved_at(problem, state, parameter)
        if solution is None or not _is_new(problem, solution, known):
            continue
        known += (point for point in _through(problem, solution) if _is_new(problem, point, known))
    if not known:
        raise NotSolved(usual.failure(), usual.status)
    equilibria = [_equilibrium(problem, point, model.axial_modes) for point in known]
    return tuple(sorted(equilibria, key=lambda state: state.cage_slip))


# -- the branch ------------------------------------------------------------------------------------


def logarithms(model: RollerBearing, over: str, span: tuple[float, float]) -> tuple[float, float]:
    """Logarithms of the sizes of both ends of a span.

    Raises `OutOfRange` where the way between both ends makes no sense.
    """
    if over not in PARAMETERS:
        raise OutOfRange(f'a branch over "{over}" is not followed; it can be {" or ".join(PARAMETERS)}')
    first, last = span
    if not (isfinite(first) and isfinite(last) and first * last > 0) or first == last:
        raise OutOfRange(f"{over} from {first:.6g} to {last:.6g}: both must be of one sign, and not the same")
    if over == "radial_load" and first < 0:
        raise OutOfRange(f"{over} from {first:.6g} to {last:.6g} N: a load is positive")
    if over == "inner_speed" and min(span) <= model.operation.outer_speed <= max(span):
        raise OutOfRange(
            f"{over} from {first * 30 / pi:.6g} to {last * 30 / pi:.6g} rpm goes through the outer speed: "
            "nothing rolls there"
        )
    return log(abs(first)), log(abs(last))


def _changed(model: RollerBearing, over: str, value: float) -> RollerBearing:
    return replace(model, operation=replace(model.operation, **{over: value}))


def _problem(
    model: RollerBearing, over: str, sign: float, balance: BearingBalance, tangents: Tangents | None
) -> ParametricBalance:
    def points(parameter: float) -> OperatingPoints:
        return OperatingPoints.of(_changed(model, over, copysign(exp(parameter), sign)).operation)

    return ParametricBalance(balance, points, tangents)


def _equilibrium(problem: ParametricBalance, step: BranchPoint, axial_modes: int) -> Equilibrium:
    balance, state = problem.near(step.state, step.parameter)
    return Equilibrium(balance, state, SolverOutcome.CONVERGED, step.corrections + 1, axial_modes)


# -- several at one load ---------------------------------------------------------------------------


def _is_new(problem: ParametricBalance, step: BranchPoint, known: list[BranchPoint]) -> bool:
    apart = [step.state - other.state for other in known]
    return all(np.sqrt(change @ (problem.weight * change)) > SAME_EQUILIBRIUM for change in apart)


def _through(problem: ParametricBalance, begin: BranchPoint) -> Iterator[BranchPoint]:
    """Places at the parameter of a solution on the branch through it, both ways, itself included."""
    yield begin
    parameter, reach = begin.parameter, log(LOAD_RANGE)
    for upwards in (True, False):
        branch = follow(problem, begin.state, parameter, (parameter - reach, parameter + reach), upwards)
        for before, after in pairwise(branch.points[1:]):
            if (before.parameter - parameter) * (after.parameter - parameter) <= 0:
                crossing = at_parameter(problem, before, after, parameter)
                if crossing is not None:
                    yield crossing


@np.errstate(all="ignore")  # a slip that is tried may be absurd
def _lumped_starts(balance: BearingBalance) -> list[NDArray]:
    """Scaled unknowns (N) at every slip where the torque of lumped rollers on the cage changes its sign."""
    places, drives = _sign_changes(balance)
    if not len(places):
        return []
    low, high, sense = TRIAL_SLIPS[places], TRIAL_SLIPS[places + 1], drives[places]
    copies = balance.take(np.zeros(len(places), int))
    lumped = LumpedRollers(copies)
    for _ in range(SLIP_HALVINGS):
        middle = np.sqrt(low * high)
        before = (lumped.at(middle)[2] > 0) == sense
        low, high = np.where(before, middle, low), np.where(before, high, middle)
    slip = np.sqrt(low * high)
    static = static_unknowns(copies, -copies.rolling_cage * slip[:, None])
    return list(copies.pack(static._replace(spin_drift=lumped.at(slip)[0])))


@np.errstate(all="ignore")
def _sign_changes(balance: BearingBalance) -> tuple[NDArray, NDArray]:
    """Places among `TRIAL_SLIPS` after which the torque on the cage changes its sign, and where it drives."""
    drives = LumpedRollers(balance.take(np.zeros(len(TRIAL_SLIPS), int))).at(TRIAL_SLIPS)[2] > 0
    return np.flatnonzero(drives[1:] != drives[:-1]), drives
