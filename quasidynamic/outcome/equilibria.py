"""Equilibria of many bearings, as they were solved side by side."""

from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.solve.outcome import SolverOutcome


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
