"""Stiffness of bearings with what carries their raceways; iterations of the coupling as quantities."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from flexbearing.coupling import Iteration, LinearPair
from flexbearing.coupling.partners import Compliance
from flexbearing.findings.running import STIFFNESS_IN_SERIES
from flexbearing.quantities.quantity import row, taken
from flexbearing.quantities.roller import LAYOUT
from quasidynamic import Equilibrium
from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import Unknowns
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.ring_stiffness import Tangent

IN_SERIES = STIFFNESS_IN_SERIES.limit


@dataclass(frozen=True)
class EndStates:
    """States of C cases with what their raceways add; cases first."""

    states: BearingStates
    rings: LinearPair

    @cached_property
    def elastic(self) -> BearingStates:
        """The states between elastic raceways, also where they were found between those of given shapes."""
        return between_elastic_raceways(self.states, self.rings)

    @property
    def between_raceways(self) -> Tangent:
        """Stiffness between raceways without their translation."""
        return self.elastic.tangent

    @cached_property
    def with_supports(self) -> Tangent:
        """Stiffness from base to shaft ends."""
        return with_supports(self.elastic, self.rings)

    @cached_property
    def series_error(self) -> NDArray:
        r"""How far bearing and supports in series are from the stiffness with supports (C) [-].

        .. math:: |k_{total} (1/k + \sum 1/k_o) - 1|

        One where a stiffness is not positive. Large where supports deform the rings by what the bearing
        carries, as lines do: then there are no two springs.
        """
        alone, total = (each.radial_stiffness for each in (self.between_raceways, self.with_supports))
        supports = sum(1.0 / each.support_stiffness for each in self.rings.raceways if each is not None)
        positive = (alone > 0) & (total > 0)
        return np.where(positive, np.abs(total * (1.0 / alone + supports) - 1.0), 1.0)

    @property
    def in_series(self) -> NDArray:
        """Where (C) bearing and supports are springs in series."""
        return self.series_error <= IN_SERIES

    @property
    def stiffness(self) -> NDArray | None:
        """Radial stiffness of the bearing alone (C) [N/m] along the load; None where there is none."""
        return self._where_in_series(self.between_raceways.radial_stiffness)

    @property
    def radial_matrix(self) -> NDArray | None:
        """The same (C, 2, 2) along y and z."""
        return self._where_in_series(self.between_raceways.radial_matrix)

    @property
    def support_stiffness(self) -> NDArray | None:
        """Stiffness of the outer ring's support (C) [N/m], the same in all cases; None where it is rigid."""
        outer = self.rings.outer
        if outer is None or not np.isfinite(outer.support_stiffness):
            return None
        return self._where_in_series(np.full(len(self.states.scaled), outer.support_stiffness))

    @property
    def support_stiffness_ratio(self) -> NDArray | None:
        """Stiffness of the outer ring's support over that of the bearing (C) [-]; None where it is rigid."""
        support, alone = self.support_stiffness, self.stiffness
        return None if support is None or alone is None else support / alone

    def _where_in_series(self, values: NDArray) -> NDArray | None:
        """Values (C, ...), not a number where they are none of springs in series; None where none is."""
        if not self.in_series.any():
            return None
        return np.where(self.in_series.reshape(-1, *(1 for _ in values.shape[1:])), values, np.nan)

    @property
    def support_translation(self) -> NDArray:
        """Rigid translation (C, 2, 2) of the raceways on their supports, by (y, z) [m]."""
        return self.rings.translation(self.states.forces)


def iteration(step: Iteration[Equilibrium], seconds: float) -> dict[str, NDArray]:
    """Quantities of an iteration of the coupling, which took some seconds."""
    parts = {"state": step.state.cases, "step": [step], "seconds": [seconds]}
    return row(taken(LAYOUT.datasets("iteration").values(), parts), 0)


def with_supports(states: BearingStates, rings: LinearPair) -> Tangent:
    """Tangent of states `between_elastic_raceways`, from base to shaft ends: with the elastic supports.

    Raceways that translate on their supports take the ring with them: approaches and forces stay. Freed of
    their translation, answers and loads are not of one kind, and the tangent is not symmetric; from base to
    shaft ends it is.
    """
    if rings.rigid:
        return states.tangent
    of_elastic = states.raceway_forces_by_load
    forces = np.zeros((*of_elastic.shape[:2], 2, *of_elastic.shape[3:]))
    forces[:, :, states.balance.layout.elastic_raceways] = of_elastic
    inner, outer = np.moveaxis(rings.translation_by(forces), -2, 0)
    response = states.tangent.response.copy()
    response[:, :2] += (outer - inner).swapaxes(1, 2)
    return replace(states.tangent, response=response)


def between_elastic_raceways(states: BearingStates, rings: LinearPair) -> BearingStates:
    """The same states between elastic raceways, also where they were found between those of given shapes."""
    if rings.rigid or states.balance.layout.elastic_raceways:
        return states
    return _elastic(states, states.balance, rings.compliance, states.unknowns)


def elastic(state: Equilibrium, rings: LinearPair) -> Equilibrium:
    """The same state between elastic raceways, balanced also where it was found between given shapes."""
    if rings.rigid or state.balance.layout.elastic_raceways:
        return state
    initial = rings.initial_deviation
    deviation = state.deviation if initial is None else state.deviation - initial
    unknowns = state.unknowns._replace(deviation=np.moveaxis(deviation, -1, 1)[:, :, None])
    between = _elastic(state.cases, replace(state.balance, deviation=initial), rings.compliance, unknowns)
    return replace(state, balance=between.balance, scaled=between.scaled[0])


def _elastic(
    states: BearingStates, balance: BearingBalance, compliance: Compliance, unknowns: Unknowns
) -> BearingStates:
    """States with other unknowns in equations that hold the compliance (Z, M, Z, M) of the raceways."""
    with_compliance = replace(balance, compliance=_matrices(states, compliance))
    return BearingStates(with_compliance, with_compliance.pack(unknowns), states.axial_modes)


def _matrices(states: BearingStates, compliance: Compliance) -> Compliance:
    """The compliance (Z, M, Z, M) of each raceway as a matrix (Z M, Z M)."""
    size = states.balance.layout.rollers * states.balance.roller.axial_modes
    inner, outer = (None if matrix is None else matrix.reshape(size, size) for matrix in compliance)
    return inner, outer
