"""A roller bearing in equilibrium with its rings, and the same bearing with other values of a key."""

from dataclasses import dataclass

from numpy.typing import NDArray

from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.coupled import states
from flexbearing.coupled.coupled import BearingPartner, equilibrium
from flexbearing.coupling import LinearPair, PartnerFailed, RacewayPair
from flexbearing.derivatives.keys import Key, with_value
from flexbearing.derivatives.near_raceways import NearRaceways
from flexbearing.progress import Logged, Report
from flexbearing.rings.condensed import condensed_raceways
from quasidynamic import Equilibrium, NotSolved, RollerBearing
from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import Unknowns
from quasidynamic.solve.rollers.newton import newton
from quasidynamic.solve.rollers.parametric_balance import between
from quasidynamic.solve.step_length import SolverOutcome

APART_FROM_RINGS = (  # keys and tables that no ring knows
    "lubricant.", "life.", "bearing.cage.", "bearing.roughness.", "bearing.roller.drop",
    "bearing.form_error.", "bearing.ribs.", "operation.radial_load", "operation.axial_load",
    "operation.load_direction", "operation.moment",
    "operation.misalignment", "operation.carrier.", "operation.gravity",
)  # fmt: skip


@dataclass(frozen=True)
class Variant:
    """A case with its bearing and raceways near given forces."""

    case: Case
    model: RollerBearing
    pair: LinearPair

    @property
    def aligned(self) -> bool:
        """Whether no roller tilts: rigid raceways, symmetric rollers, and nothing that tilts the ring."""
        return self.pair.rigid and self.model.bearing.symmetric and not self.model.operation.tilts

    def balance(self, *, aligned: bool) -> BearingBalance:
        """Its equations."""
        balance = self.model.balance(aligned=aligned)
        if self.pair.rigid:
            return balance
        return between(balance, self.pair.compliance, self.pair.initial_deviation)


@dataclass(frozen=True)
class SolvedState:
    """A case in equilibrium; its unknowns are in SI units."""

    base: Variant
    rings: RacewayPair
    near: NearRaceways
    unknowns: Unknowns  # of one case, with the deviations of elastic raceways by their loads
    forces: NDArray  # (2, Z, M) of the rollers [N]

    def variant(self, key: Key, change: float) -> Variant:
        """The case with a key changed by so many steps.

        Raises `RingChanged` where the key gives a flexible ring other faces; `ImpossiblePart`, `OutOfRange`,
        `BadCase` where there is no such case.
        """
        if change == 0.0:
            return self.base
        case = with_value(self.base.case, key.path, key.value + change * key.step)
        if key.path.startswith(APART_FROM_RINGS) or self.rings.rigid:
            return Variant(case, roller_bearing.bearing(case), self.base.pair)
        case = self.near.meshed_alike(case)
        model = roller_bearing.bearing(case)
        return Variant(case, model, self.near.of(case, model.bearing.azimuths, self.forces))

    def moved(self, key: Key, change: float, by_step: NDArray | float = 0.0) -> "SolvedState":
        """The equilibrium with a key changed by so many steps, from unknowns that move (N) in each of them.

        Raises `NotSolved` where Newton's method does not reach it.
        """
        variant = self.variant(key, change)
        balance = variant.balance(aligned=variant.aligned)
        begin = balance.layout.joined(self.unknowns) + change * by_step
        *_, last = newton(balance, begin / balance.scales.unknown)
        if last.outcomes[0] is not SolverOutcome.CONVERGED:
            raise NotSolved(f"no equilibrium near {key.path}", last.outcomes[0])
        state = Equilibrium(
            balance, last.unknowns[0], last.outcomes[0], last.number, variant.model.axial_modes
        ).refined()
        return SolvedState(variant, self.rings, self.near, state.unknowns, state.forces)


def solved(case: Case, report: Report | None = None) -> SolvedState:
    """The equilibrium that a run of the case finds.

    Raises `BadCase` for a case whose answer is not the smooth function that is differentiated; `NotSolved`
    where there is no equilibrium.
    """
    _require_differentiable(case)
    model = roller_bearing.bearing(case)
    try:
        rings = condensed_raceways(case, model.bearing.azimuths, report or Logged())
        if rings.rigid:
            state, pair = model.solve(), LinearPair(None, None)
        else:
            state = equilibrium(BearingPartner(model), rings, case.coupling)
            pair = rings.linearised(state.forces)
            state = states.elastic(state, pair).refined()
    except PartnerFailed as failure:
        raise NotSolved(str(failure)) from failure
    near = NearRaceways(case, model.bearing.azimuths, state.forces, pair)
    return SolvedState(Variant(case, model, pair), rings, near, state.unknowns, state.forces)


def _require_differentiable(case: Case) -> None:
    refused = {
        "accuracy.target": (case.accuracy.target is not None, "chooses levels anew for every value of a key"),
        "bearing.contact": (case.bearing.contact == "half_space", "has another grid for every load"),
        "coupling.structure": (case.coupling.structure == "full", "has no tangent"),
    }
    for key, (given, why) in refused.items():
        if given:
            raise BadCase(f"{case.source.path}: {key} {why}; take the key out for derivatives.")
