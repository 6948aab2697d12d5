"""States of the bearing as the quantities of a result file."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.coupled.initial_state import flat
from flexbearing.coupling import Iteration, LinearPair
from flexbearing.coupling.partners import Compliance
from flexbearing.coupling.raceway_pair import OUTWARD, radial
from flexbearing.quantities.quantity import taken
from flexbearing.quantities.roller import LAYOUT
from quasidynamic import Equilibrium
from quasidynamic.balance.rollers.unknowns import Unknowns
from quasidynamic.outcome.ring_stiffness import Tangent

MREV = 1e6  # revolutions


@dataclass(frozen=True)
class EndState:
    """An equilibrium with what its rings and the roughness of its surfaces add; inner first, outer second."""

    equilibrium: Equilibrium
    rings: LinearPair
    roughness: NDArray | None = None  # (2) composite [m]
    life_error: float | None = None  # estimated, over the life; None where nothing was estimated [-]

    @property
    def life(self) -> float:
        """Basic rating life [rev]."""
        return self.equilibrium.life * MREV

    @property
    def relative_speed(self) -> float:
        """Speed of the inner ring less that of the outer ring [rad/s]."""
        points = self.equilibrium.balance.points
        return float(points.inner_speed[0, 0] - points.outer_speed[0, 0])

    @cached_property
    def between_raceways(self) -> Tangent:
        """Stiffness between raceways freed of their translation."""
        return between_raceways(self.equilibrium, self.rings).tangent

    @cached_property
    def with_supports(self) -> Tangent:
        """Stiffness from base to shaft ends."""
        return supported(self.equilibrium, self.rings).tangent

    @property
    def support_translation(self) -> NDArray:
        """Rigid translation (2, 2) of the raceways on their supports, by (y, z) [m]."""
        return self.rings.translation(self.equilibrium.forces)

    @property
    def film_ratio(self) -> NDArray | None:
        """Film over roughness (2, Z), 0 without load; None where the roughness is not known."""
        return None if self.roughness is None else self.equilibrium.loaded_film / self.roughness[:, None]

    @property
    def unknowns(self) -> NDArray:
        """Where a neighbouring case may start (N)."""
        return flat(self.equilibrium)


def iteration(step: Iteration[Equilibrium], seconds: float) -> dict[str, NDArray]:
    """Quantities of an iteration of the coupling, which took some seconds."""
    solved = {"state": step.state, "step": step, "seconds": seconds}
    return taken(LAYOUT.datasets("iteration").values(), solved)


def block(end: EndState, **further: Any) -> dict[str, NDArray]:
    """Quantities of an end state, with those of its `skew` and modified `life` where these are given."""
    state = end.equilibrium
    solved = {"state": state, "end": end, "bearing": state.balance.roller.bearing, "losses": state.losses}
    return taken(LAYOUT.datasets("block").values(), solved | further)


def supported(state: Equilibrium, rings: LinearPair) -> Equilibrium:
    """The same state, its ring displacement counted from shaft ends to base: with the elastic supports.

    Between raceways freed of their translation, answers and loads are not of one kind, and the tangent
    is not symmetric; from base to shaft ends it is.
    """
    if rings.rigid:
        return state
    balance, unknowns = state.balance, state.unknowns
    moved = rings.translation(state.forces)  # (inner and outer raceway, y and z)
    deviation, ring = unknowns.deviation.copy(), unknowns.ring.copy()
    deviation[:, 0, 0] += radial(balance.roller.bearing.azimuths, moved.T).T
    ring[:2, 0, 0] += OUTWARD @ moved
    return _elastic(state, rings.absolute, unknowns._replace(ring=ring, deviation=deviation))


def between_raceways(state: Equilibrium, rings: LinearPair) -> Equilibrium:
    """The same state between elastic raceways, also where it was found between those of a given shape."""
    if rings.rigid or state.balance.layout.elastic_raceways:
        return state
    return _elastic(state, rings.compliance, state.unknowns)


def elastic(state: Equilibrium, rings: LinearPair) -> Equilibrium:
    """The same state between elastic raceways, balanced also where it was found between given shapes."""
    if rings.rigid or state.balance.layout.elastic_raceways:
        return state
    initial = rings.initial_deviation
    deviation = state.deviation if initial is None else state.deviation - initial
    unknowns = state.unknowns._replace(deviation=np.moveaxis(deviation, -1, 1)[:, :, None])
    between = replace(state, balance=replace(state.balance, deviation=initial))
    return _elastic(between, rings.compliance, unknowns)


def _elastic(state: Equilibrium, compliance: Compliance, unknowns: Unknowns) -> Equilibrium:
    """A state with other unknowns in equations that hold the compliance (Z, M, Z, M) of the raceways."""
    size = state.balance.layout.rollers * state.balance.roller.axial_modes
    inner, outer = (None if matrix is None else matrix.reshape(size, size) for matrix in compliance)
    balance = replace(state.balance, compliance=(inner, outer))
    return replace(state, balance=balance, scaled=balance.pack(unknowns)[0])
