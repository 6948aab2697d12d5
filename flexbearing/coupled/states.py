"""States of the bearing as the quantities of a result file."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.coupled.initial_state import flat
from flexbearing.coupling import Iteration, LinearPair
from flexbearing.coupling.partners import Compliance
from flexbearing.quantities.quantity import Quantity, taken
from flexbearing.quantities.roller import LAYOUT
from quasidynamic import Equilibrium
from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import Unknowns
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.rating_life import static_safety
from quasidynamic.outcome.ring_stiffness import Tangent
from quasidynamic.outcome.worst_line_contact import WorstLineContact

if TYPE_CHECKING:
    from quasidynamic.outcome.whole_roller import WholeRoller

MREV = 1e6  # revolutions


@dataclass(frozen=True)
class EndStates:
    """Equilibria of C cases with what their rings and the roughness of surfaces add; cases first."""

    states: BearingStates
    rings: LinearPair
    roughness: NDArray | None = None  # (C, 2) composite, or one for all cases [m]
    life_error: NDArray | None = None  # (C) estimated, over the life; None where nothing was estimated [-]
    edge_stress: NDArray | None = None  # (C, K) factor on the load of slices; None where the life takes none
    static_rating: NDArray | None = None  # (C) C_0 [N]; None where nobody asks for the static safety
    outer_mass: NDArray | None = None  # (C) of the outer ring with its bars [kg]; None where it is not known

    @property
    def life(self) -> NDArray:
        """Basic rating life (C) [rev]."""
        return self.states.life * MREV

    @property
    def raceway_life(self) -> NDArray:
        """Basic rating life (C, 2) of each raceway on its own [rev]."""
        return self.states.raceway_lives * MREV

    @cached_property
    def slice_pressure(self) -> NDArray:
        """Largest pressure (C, 2, Z, K) of each slice [Pa]; pressure goes with the root of the load."""
        pressure = self.states.slice_pressure
        return pressure if self.edge_stress is None else pressure * np.sqrt(self.edge_stress)[:, None, None]

    @property
    def peak_pressure(self) -> NDArray:
        """Largest pressure (C, 2) at the inner and outer raceway [Pa]."""
        if self.edge_stress is None:
            return self.states.peak_pressure
        return self.slice_pressure.max(axis=(2, 3))

    @property
    def worst(self) -> WorstLineContact:
        """Most pressed contact of each raceway (C, 2)."""
        states = self.states
        return WorstLineContact.under(self.peak_pressure, states.contact_radius, states.contact_modulus)

    @property
    def static_safety(self) -> NDArray | None:
        """C_0/P_0 (C) of ISO 76; None without a rating."""
        if self.static_rating is None:
            return None
        return static_safety(self.static_rating, np.hypot(*self.states.applied_load.T))

    @property
    def relative_speed(self) -> NDArray:
        """Speed of the inner ring less that of the outer ring (C) [rad/s]."""
        return self.states.balance.points.relative_speed[:, 0]

    @cached_property
    def elastic(self) -> BearingStates:
        """The states between elastic raceways, also where they were found between those of given shapes."""
        return between_elastic_raceways(self.states, self.rings)

    @property
    def between_raceways(self) -> Tangent:
        """Stiffness between raceways freed of their translation."""
        return self.elastic.tangent

    @cached_property
    def with_supports(self) -> Tangent:
        """Stiffness from base to shaft ends."""
        return with_supports(self.elastic, self.rings)

    @property
    def support_stiffness(self) -> NDArray | None:
        """Stiffness of the outer ring's support (C) [N/m], the same in all cases; None where it is rigid."""
        outer = self.rings.outer
        if outer is None or not np.isfinite(outer.support_stiffness):
            return None
        return np.full(len(self.relative_speed), outer.support_stiffness)

    @property
    def support_stiffness_ratio(self) -> NDArray | None:
        """Stiffness of the outer ring's support over that of the bearing (C) [-]; None where it is rigid."""
        support = self.support_stiffness
        return None if support is None else support / self.between_raceways.radial_stiffness

    @property
    def support_translation(self) -> NDArray:
        """Rigid translation (C, 2, 2) of the raceways on their supports, by (y, z) [m]."""
        return self.rings.translation(self.states.forces)

    @property
    def film_ratio(self) -> NDArray | None:
        """Film over roughness (C, 2, Z), 0 without load; None where the roughness is not known."""
        return None if self.roughness is None else self.states.loaded_film / self.roughness[..., None]


@dataclass(frozen=True)
class EndState:
    """An equilibrium with what its rings and the roughness of its surfaces add; inner first, outer second."""

    equilibrium: Equilibrium
    rings: LinearPair
    roughness: NDArray | None = None  # (2) composite [m]
    life_error: float | None = None  # estimated, over the life; None where nothing was estimated [-]
    whole: "WholeRoller | None" = None  # its most loaded roller on half-spaces; None where slices answer
    edge_stress: NDArray | None = None  # (K) factor on the load of slices; None where the life takes none
    static_rating: float | None = None  # C_0 [N]; None where nobody asks for the static safety
    outer_mass: float | None = None  # of the outer ring with its bars [kg]; None where it is not known

    @cached_property
    def cases(self) -> EndStates:
        """The same as an array of one case."""
        return EndStates(
            self.equilibrium.cases,
            self.rings,
            self.roughness,
            edge_stress=None if self.edge_stress is None else self.edge_stress[None],
            static_rating=None if self.static_rating is None else np.array([self.static_rating]),
        )

    @property
    def life(self) -> float:
        """Basic rating life [rev]."""
        return self.cases.life[0] if self.whole is None else self.whole.life * MREV

    @property
    def raceway_life(self) -> NDArray:
        """Basic rating life (2) of each raceway on its own [rev]."""
        return self.cases.raceway_life[0] if self.whole is None else self.whole.raceway_lives * MREV

    @property
    def peak_pressure(self) -> NDArray:
        """Largest pressure (2) at the inner and outer raceway [Pa]."""
        return self.cases.peak_pressure[0] if self.whole is None else self.whole.peak_pressure

    @property
    def slice_pressure(self) -> NDArray:
        """Largest pressure (2, Z, K) of each slice [Pa]; of half-spaces where they answer for a roller."""
        pressure = self.cases.slice_pressure[0]
        if self.whole is None:
            return pressure
        pressure = pressure.copy()
        pressure[:, self.whole.number] = self.whole.slice_pressure
        return pressure

    @property
    def worst(self) -> WorstLineContact:
        """Most pressed contact of each raceway (2)."""
        states = self.cases.states
        return WorstLineContact.under(self.peak_pressure, states.contact_radius[0], states.contact_modulus[0])

    @property
    def static_safety(self) -> float | None:
        """C_0/P_0 of ISO 76 [-]; None without a rating."""
        safety = self.cases.static_safety
        return None if safety is None else safety[0]

    @property
    def sliced_life(self) -> float:
        """Basic rating life by slices alone [rev]."""
        return self.cases.life[0]

    @property
    def relative_speed(self) -> float:
        """Speed of the inner ring less that of the outer ring [rad/s]."""
        return self.cases.relative_speed[0]

    @property
    def between_raceways(self) -> Tangent:
        """Stiffness between raceways freed of their translation."""
        return self.cases.between_raceways[0]

    @property
    def with_supports(self) -> Tangent:
        """Stiffness from base to shaft ends."""
        return self.cases.with_supports[0]

    @property
    def support_stiffness(self) -> float | None:
        """Stiffness of the outer ring's support [N/m]; None where it is rigid."""
        stiffness = self.cases.support_stiffness
        return None if stiffness is None else stiffness[0]

    @property
    def support_stiffness_ratio(self) -> float | None:
        """Stiffness of the outer ring's support over that of the bearing [-]; None where it is rigid."""
        ratio = self.cases.support_stiffness_ratio
        return None if ratio is None else ratio[0]

    @property
    def support_translation(self) -> NDArray:
        """Rigid translation (2, 2) of the raceways on their supports, by (y, z) [m]."""
        return self.cases.support_translation[0]

    @property
    def film_ratio(self) -> NDArray | None:
        """Film over roughness (2, Z), 0 without load; None where the roughness is not known."""
        ratio = self.cases.film_ratio
        return None if ratio is None else ratio[0]

    @property
    def unknowns(self) -> NDArray:
        """Where a neighbouring case may start (N)."""
        return flat(self.equilibrium)


def iteration(step: Iteration[Equilibrium], seconds: float) -> dict[str, NDArray]:
    """Quantities of an iteration of the coupling, which took some seconds."""
    solved = {"state": step.state, "step": step, "seconds": seconds}
    return taken(LAYOUT.datasets("iteration").values(), solved)


def block(
    end: EndState, wanted: Iterable[Quantity] = LAYOUT.datasets("block").values(), **further: Any
) -> dict[str, NDArray]:
    """Quantities of an end state, with those of its `skew` and modified `life` where these are given."""
    state = end.equilibrium
    solved = {"state": state, "end": end, "bearing": state.balance.roller.bearing, "losses": state.losses}
    if end.whole is not None:
        solved |= {"whole": end.whole, "sliced": end}
    return taken(wanted, solved | further)


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
