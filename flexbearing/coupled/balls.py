"""A bearing with fast balls as the coupling knows it."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.coupling import MethodsOfCoupling
from flexbearing.coupled.attempts import CoupledBearing, NotCoupled, nearest, records, summary
from flexbearing.coupling import Iteration, PartnerFailed
from flexbearing.coupling.partners import Compliance
from flexbearing.coupling.raceway_pair import OUTWARD
from flexbearing.progress import Report
from flexbearing.quantities.angular_contact import LAYOUT
from flexbearing.quantities.quantity import row, taken
from flexbearing.results import Recorder
from flexbearing.rings.grooves import GroovePair
from quasidynamic import AngularContactBallBearing, AngularContactState, NotSolved, RingOperation
from quasidynamic.balance.balls.angular_contact import race_contacts
from quasidynamic.balance.balls.elastic_grooves import ElasticGroove, ElasticGrooves, StationShares


@dataclass
class CouplingRecord:
    """Where a run stores and reports iterations, and what it then says of them."""

    record: Recorder
    report: Report
    attributes: dict[str, Any] = field(default_factory=dict)  # of the result file
    nearest: AngularContactState | None = None  # state of the attempt that came nearest to an equilibrium


@dataclass(frozen=True)
class BallState:
    """Balls in balance, or on the way to it, with their forces on the stations of both grooves."""

    between: AngularContactState
    forces: NDArray  # (2, Z, K) [N] loads by shares of stations, tractions by their slopes
    status: str = "converged"
    rest: "Iterator[BallState]" = field(default_factory=lambda: iter(()), compare=False)  # that follow

    @classmethod
    def of(cls, state: AngularContactState, angles: NDArray, status: str = "converged") -> "BallState":
        """Balls in a state, stations at angles (2, K) [rad]."""
        of_races = zip(angles, state.contact_angles, state.loads, state.section_forces, strict=True)
        return cls(state, np.array([station_forces(*race) for race in of_races]), status)

    @property
    def loads(self) -> NDArray:
        """Loads (2, Z) [N] of the balls on both races."""
        return self.between.loads

    @property
    def deviation(self) -> NDArray | None:
        """None at the stations (2, Z, K) [m] of rigid grooves; not known of others."""
        return np.zeros_like(self.forces) if self.between.groove_displacement is None else None

    @property
    def residual(self) -> float:
        """Largest unbalanced force over the largest force [-]."""
        return self.between.imbalance

    def failure(self) -> str:
        """None: balls are in balance."""
        return ""

    def refined(self) -> "BallState":
        """The balance to which further steps lead; raises `PartnerFailed`."""
        *_, last = self, *self.rest
        return last


def station_forces(angles: NDArray, at: NDArray, loads: NDArray, section_forces: NDArray) -> NDArray:
    """Forces (..., K) [N] of contacts at angles (...) on stations at `angles` (K) [rad] of one race.

    Loads (...) by shares of stations, forces (...) along the section of the groove by their slopes.
    """
    normal, tangent = np.stack([np.sin(at), np.cos(at)], -1), np.stack([np.cos(at), -np.sin(at)], -1)
    pressed = loads[..., None] * normal + section_forces[..., None] * tangent
    return (StationShares.of(angles, at).by_vector @ pressed[..., None])[..., 0]


@dataclass(frozen=True)
class BallPartner:
    """Balls at an operating point."""

    model: AngularContactBallBearing
    operation: RingOperation
    angles: NDArray  # (2, K) [rad] of the stations

    def solve(self, start: BallState | None = None, deviation: NDArray | None = None) -> BallState:
        """Balance between grooves of given deviations (2, Z, K) [m].

        Raises `PartnerFailed` where there is none.
        """
        grooves = None
        if deviation is not None:
            stiff = np.zeros(deviation.shape[1:] * 2)
            grooves = self._grooves((stiff, stiff), deviation)
        try:
            return BallState.of(self.model.solve(self.operation, grooves), self.angles)
        except NotSolved as failure:
            raise PartnerFailed(str(failure), str(failure.outcome)) from failure

    def iterate(
        self, compliance: Compliance, start: BallState, deviation: NDArray | None
    ) -> Iterator[BallState]:
        """The start, then Newton iterates between grooves of such compliance; raises `PartnerFailed`.

        They begin from rigid grooves: of those after another start the last one alone follows it.
        """
        yield start
        grooves = self._grooves(compliance, np.zeros_like(start.forces) if deviation is None else deviation)
        states = self._iterates(grooves)
        for state in states:
            if state.status or start.between.groove_displacement is None:
                yield replace(state, rest=states)

    def force_by_deviation(self, state: BallState) -> NDArray:
        """Change of forces by deviations (2 Z K, 2 Z K) [N/m].

        Balls are springs along their inner contacts, angles stay, the ring is in balance where it is free.
        """
        loads, at = state.loads, state.between.contact_angles
        balance = self.model.equations([self.operation])
        coefficients = np.array([[contact.coefficient] for contact in race_contacts(self.model.bearing)])
        contacts = 1.5 * np.cbrt(coefficients**2 * loads)
        springs = contacts.prod(0) / np.maximum(contacts.sum(0), np.finfo(float).tiny)
        along = np.exp(1j * at[0])[:, None] * -1j * balance.ring_to_groove
        approach = along.real[:, ~balance.held[0]]
        pressing = springs[:, None] * approach
        released = pressing @ np.linalg.pinv(approach.T @ pressing) @ pressing.T
        shares = np.array([StationShares.of(*race).share for race in zip(self.angles, at, strict=True)])
        by_approach = released - np.diag(springs)
        by_deviation = np.einsum("rjk,ji,s,sil->rjksil", shares, by_approach, OUTWARD, shares)
        return by_deviation.reshape(shares.size, -1)

    def _grooves(self, compliance: Compliance, initial: NDArray) -> ElasticGrooves:
        races = zip(self.angles, compliance, initial, strict=True)
        return ElasticGrooves(*(None if C is None else ElasticGroove(at, C, moved) for at, C, moved in races))

    def _iterates(self, grooves: ElasticGrooves) -> Iterator[BallState]:
        try:
            for state, last in self.model.iterate(self.operation, grooves):
                yield BallState.of(state, self.angles, "converged" if last else "")
        except NotSolved as failure:
            raise PartnerFailed(str(failure), str(failure.outcome)) from failure


def equilibrium(
    coupling: MethodsOfCoupling,
    model: AngularContactBallBearing,
    operation: RingOperation,
    grooves: GroovePair,
    run: CouplingRecord | None = None,
) -> AngularContactState:
    """Balance of balls, ring and what carries its grooves; iterations are stored for a run.

    Raises `NotCoupled` where there is none.
    """
    partner, raceways = BallPartner(model, operation, grooves.angles), grooves.raceways
    rounded = replace(model, bearing=replace(model.bearing, approaches=()))  # a cam needs rings that give way
    rigid = BallState.of(rounded.solve(operation), grooves.angles)
    coupled = CoupledBearing(coupling, partner, raceways, rigid)
    attempts = coupled.solve(run.record, run.report, values) if run else list(coupled.attempts())
    last, best = attempts[-1], nearest(attempts) if run else None
    if run:
        run.attributes = records(attempts)
        run.nearest = best and best.state.between
    if last.status != "converged":
        raise NotCoupled(summary(attempts, best), last.ending, last.status)
    if run:
        raceways.linearised(last.state.forces)  # of which the figures are then
        run.attributes["structure"] = raceways.figures()
    return last.state.between


def values(step: Iteration[BallState], seconds: float) -> dict[str, NDArray]:
    """Quantities of an iteration of the coupling, which took some seconds."""
    state = step.state.between
    if state.groove_displacement is None:  # a method failed where it began, between rigid grooves
        state = replace(state, groove_displacement=np.zeros((*state.loads.shape, 2)))
    parts = {"state": [state], "step": [step], "seconds": [seconds]}
    return row(taken(LAYOUT.datasets("iteration").values(), parts), 0)
