"""A bearing with fast balls as the coupling knows it, between grooves on supports that only push."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexbearing.coupling import PartnerFailed, StoppingCriterion, newton
from flexbearing.coupling.partners import Compliance
from flexbearing.rings.grooves import SupportedGrooves
from quasidynamic import AngularContactBallBearing, AngularContactState, NotSolved, RingOperation
from quasidynamic.balance.balls.elastic_grooves import ElasticGroove, ElasticGrooves, StationShares

CRITERION = StoppingCriterion(tolerance=1e-8, limit=100)


@dataclass(frozen=True)
class BallState:
    """Balls in balance, with their forces on the stations of both grooves."""

    between: AngularContactState
    forces: NDArray  # (2, Z, K) [N] loads by shares of stations, tractions by their slopes
    residual: float = 0.0
    status: str = "converged"

    @classmethod
    def of(cls, state: AngularContactState, angles: NDArray) -> "BallState":
        """Balls in a state, stations at angles (2, K) [rad]."""
        at = state.contact_angles
        normal, tangent = np.stack([np.sin(at), np.cos(at)], -1), np.stack([np.cos(at), -np.sin(at)], -1)
        pressed = state.loads[..., None] * normal + state.tractions[..., None] * tangent
        by_vector = [StationShares.of(*race).by_vector for race in zip(angles, at, strict=True)]
        return cls(state, (np.array(by_vector) @ pressed[..., None])[..., 0])

    def failure(self) -> str:
        """None: balls are in balance."""
        return ""

    def refined(self) -> "BallState":
        """The same: nothing is left to improve."""
        return self


@dataclass(frozen=True)
class BallPartner:
    """Balls at an operating point."""

    model: AngularContactBallBearing
    operation: RingOperation
    angles: NDArray  # (2, K) [rad] of the stations

    def between(self, grooves: ElasticGrooves | None) -> BallState:
        """Balance between grooves.

        Raises
        ------
        PartnerFailed
            where there is none
        """
        try:
            return BallState.of(self.model.solve(self.operation, grooves), self.angles)
        except NotSolved as failure:
            raise PartnerFailed(str(failure), str(failure.outcome)) from failure

    def iterate(
        self, compliance: Compliance, start: BallState, deviation: NDArray | None
    ) -> Iterator[BallState]:
        """The start, then the balance between grooves of such compliance; raises `PartnerFailed`."""
        yield start
        initial = np.zeros_like(start.forces) if deviation is None else deviation
        races = zip(self.angles, compliance, initial, strict=True)
        yield self.between(
            ElasticGrooves(*(None if C is None else ElasticGroove(at, C, moved) for at, C, moved in races))
        )


def equilibrium(
    model: AngularContactBallBearing, operation: RingOperation, grooves: SupportedGrooves
) -> AngularContactState:
    """Balance of balls, ring and supports.

    Raises
    ------
    NotSolved
        where there is none
    """
    begin = BallState.of(model.solve(operation), grooves.angles)
    *_, last = newton(BallPartner(model, operation, grooves.angles), grooves.raceways, begin, CRITERION)
    if last.status != "converged":
        raise NotSolved(last.message or f"ring and supports: {last.status}", "not solved")
    return last.state.between
