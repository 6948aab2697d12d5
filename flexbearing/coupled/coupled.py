"""A roller bearing as the coupling knows it."""

from collections.abc import Iterator
from dataclasses import dataclass

from numpy.typing import NDArray

from flexbearing.case.roller.numerics import Coupling
from flexbearing.coupled.attempts import FALLBACK
from flexbearing.coupling import RULES, PartnerFailed, RacewayPair, StoppingCriterion, fixed_point, newton
from flexbearing.coupling.acceleration import springs_between_raceways
from quasidynamic import Equilibrium, NotSolved, RollerBearing
from quasidynamic.solve.rollers.static_equilibrium import series_stiffness


@dataclass(frozen=True)
class BearingPartner:
    """The bearing as the coupling knows it: its failures carry the coupling's name."""

    model: RollerBearing

    def solve(self, start=None, deviation=None) -> Equilibrium:
        """Equilibrium between raceways of given deviations.

        Raises `PartnerFailed` when the bearing found no equilibrium.
        """
        try:
            return self.model.solve(start, deviation)
        except NotSolved as failure:
            raise PartnerFailed(str(failure), str(failure.outcome)) from failure

    def force_by_deviation(self, state: Equilibrium) -> NDArray:
        """Change of forces by deviations (2 Z M, 2 Z M) [N/m], as if rollers and ring could not move."""
        stiffness = series_stiffness(state.balance, state.unknowns)[0]
        return springs_between_raceways(stiffness, state.forces.shape[-1])

    def iterate(self, compliance, start, deviation) -> Iterator[Equilibrium]:
        """Newton iterates between elastic raceways.

        Raises `PartnerFailed` when the bearing found no equilibrium.
        """
        try:
            yield from self.model.iterate(compliance, start, deviation)
        except NotSolved as failure:
            raise PartnerFailed(str(failure), str(failure.outcome)) from failure


def equilibrium(bearing: BearingPartner, rings: RacewayPair, coupling: Coupling) -> Equilibrium:
    """Equilibrium of a bearing and its rings by newton, or where it fails by `iqn-ils`; nothing is stored.

    Raises `NotSolved` where neither converges; the message has those of both.
    """
    criterion = StoppingCriterion(tolerance=coupling.tolerance, limit=coupling.max_iterations)
    try:
        rigid, messages = bearing.solve(), []
    except PartnerFailed as failure:
        raise NotSolved(f"rigid raceways: {failure}") from failure
    for method in FALLBACK[:2]:
        given = bearing, rings, rigid, criterion
        *_, last = newton(*given) if method == "newton" else fixed_point(*given, RULES[method])
        if last.status == "converged":
            return last.state
        messages.append(f"{method}: {last.message or last.status}")
    raise NotSolved("no equilibrium of bearing and rings: " + "; ".join(messages))
