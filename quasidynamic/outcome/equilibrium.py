"""A solved state of the bearing, in physical units."""

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.bearing import BearingBalance, Linearisation
from quasidynamic.balance.rollers.roller import RollerState
from quasidynamic.balance.rollers.unknowns import CAGE, SHIFT, TILT_Z, Unknowns, Y, Z
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.solve.rollers.newton import bounded, step
from quasidynamic.solve.step_length import SolverOutcome


@dataclass(frozen=True)
class Equilibrium:
    """One state of an iteration, and how that ended; its quantities are row 0 of a table of one state."""

    balance: BearingBalance  # of one case
    scaled: NDArray  # (N) unknowns
    status: SolverOutcome  # empty while iterating; otherwise how the solve ended
    number: int  # evaluations it took
    axial_modes: int  # M, axial modes that loads are handed on with

    @classmethod
    def of(cls, states: BearingStates, status: SolverOutcome, number: int) -> "Equilibrium":
        """The state of a single case, with what is known of it."""
        state = cls(states.balance, states.scaled[0], status, number, states.axial_modes)
        state.__dict__["cases"] = states
        return state

    @cached_property
    def cases(self) -> BearingStates:
        """The same as an array of one case."""
        return BearingStates(self.balance, self.scaled[None], self.axial_modes)

    # -- the state in numbers ------------------------------------------------------------------

    @property
    def system(self) -> Linearisation:
        """Residual and derivatives."""
        return self.cases.system

    @property
    def unknowns(self) -> Unknowns:
        """Unknowns in SI units; fields have an axis of one case."""
        return self.cases.unknowns

    @property
    def residual(self) -> float:
        """Largest unbalanced force over the reference force [-]."""
        return float(self.cases.residual[0])

    @property
    def unbalanced(self) -> tuple[float, float]:
        """Largest force [N] and largest moment [N m] that are not balanced."""
        residual = np.abs(self.system.residual * self.balance.scales.residual)[0]
        first, spin = self.balance.layout.field(0), self.balance.layout.field(-1)
        moments = [residual[TILT_Z : CAGE + 1], residual[spin]]
        if self.balance.roller.axial_modes > 1:
            moments.append(residual[self.balance.layout.field(1)])
        forces = [residual[[Y, Z]], residual[SHIFT : self.balance.layout.border], residual[first]]
        return float(np.concatenate(forces).max()), float(np.concatenate(moments).max())

    def failure(self) -> str:
        """Say how the solve ended and how far it came."""
        if self.status is SolverOutcome.UNDETERMINED:
            return (
                "neither load nor moment, and clearance: no roller touches the inner ring, "
                "the cage is at rest and the ring position is undetermined"
            )
        force, moment = self.unbalanced
        if not np.isfinite([force, moment]).all():
            return (
                f"{self.status} after {self.number} evaluations without finite forces at an outer force of "
                f"{self.balance.scales.force[0, 0]:.4g} N, as from a wrong unit of load, speed or size"
            )
        return (
            f"{self.status} after {self.number} evaluations, "
            f"{force:.2g} N and {moment:.2g} N m unbalanced; "
            f"the largest outer force is {self.balance.scales.force[0, 0]:.4g} N"
        )

    def refined(self) -> "Equilibrium":
        """State after another step of Newton's method, where that is closer to balance."""
        with np.errstate(all="ignore"):  # a step from a singular matrix is not finite, and not taken
            change = step(self.balance, self.system)
            further = replace(self, scaled=bounded(self.balance, self.scaled[None], self.scaled + change)[0])
            return further if further.residual < self.residual else self

    # -- quantities ----------------------------------------------------------------------------

    @property
    def rollers(self) -> RollerState:
        """Forces and speeds at the rollers; arrays have an axis of one case before that of the rollers."""
        return self.system.state

    @property
    def loads(self) -> NDArray:
        """Loads (2, Z) [N] of the rollers on the raceways."""
        return self.cases.loads[0]

    @property
    def forces(self) -> NDArray:
        """Forces (2, Z, M) [N] of the rollers on the raceways; [..., 0] is the load."""
        return self.cases.forces[0]

    @property
    def deviation(self) -> NDArray:
        """Outward deviations (2, Z, M) [m] of the raceways by axial modes."""
        return self.cases.deviation[0]

    def __getattr__(self, name: str) -> Any:
        """Every other quantity: row 0 of that of `BearingStates`."""
        if name.startswith("_"):  # requested by copies and pickles before there is any state
            raise AttributeError(name)
        return _first(getattr(self.cases, name))


def _first(values: Any) -> Any:
    """Row 0 of a quantity, or of each of several; None of one that there is not."""
    if isinstance(values, tuple):
        return getattr(type(values), "_make", tuple)(each[0] for each in values)
    return None if values is None else values[0]


@dataclass(frozen=True)
class Batch:
    """Bearings that differ in numbers only, as they were solved side by side: C of them."""

    places: NDArray  # (C) among all bearings
    states: BearingStates  # of C cases
    outcomes: tuple[SolverOutcome, ...]  # (C) how each solve ended
    evaluations: NDArray  # (C) that it took
    ways: tuple[str, ...] = ()  # (C) by which way, where there are several
    doubtful: NDArray | None = None  # (C) whether several equilibria are likely; None where not asked yet

    def __len__(self) -> int:
        return len(self.outcomes)

    def take(self, cases: NDArray) -> "Batch":
        """Some of the cases."""
        outcomes = tuple(self.outcomes[case] for case in cases)
        doubtful = None if self.doubtful is None else self.doubtful[cases]
        return Batch(
            self.places[cases], self.states.take(cases), outcomes, self.evaluations[cases], doubtful=doubtful
        )

    def __getitem__(self, case: int) -> Equilibrium:
        one = self.states if len(self) == 1 else self.states.take(np.array([case]))
        number = int(self.evaluations[case])
        return Equilibrium.of(one, self.outcomes[case], number)


@dataclass(frozen=True)
class Equilibria:
    """Equilibria of many bearings, in their order; a single one is made when it is requested."""

    batches: tuple[Batch, ...]

    @cached_property
    def _places(self) -> list[tuple[Batch, int]]:
        """Batch of every bearing, and its case there."""
        placed = [
            (int(place), batch, case) for batch in self.batches for case, place in enumerate(batch.places)
        ]
        return [(batch, case) for _, batch, case in sorted(placed, key=lambda one: one[0])]

    def __len__(self) -> int:
        return sum(len(batch) for batch in self.batches)

    def __iter__(self) -> Iterator[Equilibrium]:
        return (batch[case] for batch, case in self._places)

    def __getitem__(self, case: int) -> Equilibrium:
        batch, case = self._places[case]
        return batch[case]

    @property
    def unsolved(self) -> tuple[int, ...]:
        """Bearings for which no equilibrium was reached."""
        outcomes = [batch.outcomes[case] for batch, case in self._places]
        return tuple(i for i, outcome in enumerate(outcomes) if outcome is not SolverOutcome.CONVERGED)

    @property
    def evaluations(self) -> NDArray:
        """Evaluations (bearings) that the solves took."""
        return self.in_order(lambda batch: batch.evaluations)

    @property
    def ways(self) -> Counter[str]:
        """How many bearings were solved by which way, where there are several."""
        return Counter(way for batch in self.batches for way in batch.ways)

    def in_order(self, of_batch: Callable[[Batch], NDArray]) -> NDArray:
        """Values (bearings, ...) in the order of the bearings from those (C, ...) of every batch."""
        values = np.concatenate([of_batch(batch) for batch in self.batches])
        return values[np.argsort(np.concatenate([batch.places for batch in self.batches]))]
