"""Stiffness of bearings with what carries their raceways; iterations of the coupling as quantities."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.case.declarations import toml
from flexbearing.case.roller import Case
from flexbearing.coupling import Bearing, Iteration, LinearPair, Structure
from flexbearing.coupling.partners import Compliance
from flexbearing.findings.running import STIFFNESS_IN_SERIES
from flexbearing.quantities.quantity import row, taken
from flexbearing.quantities.roller import LAYOUT
from flexbearing.results import Result
from quasidynamic import Equilibrium
from quasidynamic.balance.rollers.bearing import BearingBalance
from quasidynamic.balance.rollers.unknowns import BORDER, CAGE, Unknowns
from quasidynamic.outcome.bearing_states import BearingStates
from quasidynamic.outcome.ring_stiffness import Tangent

SAME = ("bearing.cage.guidance", "bearing.cage.centre", "lubricant.film")  # what the unknowns mean
FIELDS = 5  # unknowns of a roller: approach, tilt, both films, spin
IN_SERIES = STIFFNESS_IN_SERIES.limit


def flat(states: BearingStates) -> NDArray:
    """Unknowns (C, N) of states in SI units, in the order of the result file, however they were solved.

    N = 5 + 5 Z + 2 Z M: ring and cage, fields over the rollers, deviations of both raceways, given or not.
    """
    x, deviation = states.unknowns, states.deviation
    border = (x.ring[..., 0].T, x.cage_drift)
    fields = (x.approach, x.tilt, *x.film, x.spin_drift)
    return np.concatenate([*border, *fields, deviation.reshape(len(deviation), -1)], axis=1)


def unknowns(values: NDArray, rollers: int, shift: float = 0.0) -> Unknowns:
    """The unknowns that `flat` (N) was made of, all deviations among those of elastic raceways.

    The axial shift [m] of a ring on ribs is a quantity of its own.
    """
    border, fields, deviation = np.split(values, [BORDER, BORDER + FIELDS * rollers])
    approach, tilt, inner, outer, spin = fields.reshape(FIELDS, 1, rollers)
    return Unknowns(
        ring=border[:CAGE, None, None],
        cage_drift=border[CAGE:, None],
        approach=approach,
        tilt=tilt,
        film=np.array([inner, outer]),
        spin_drift=spin,
        deviation=np.moveaxis(deviation.reshape(2, rollers, -1), -1, 1)[:, :, None],
        shift=np.full((1, 1), shift),
    )


@dataclass(frozen=True)
class InitialState:
    """Where the coupling of a case may start."""

    source: str  # path of the result that it comes from
    unknowns: Unknowns  # of the flexible end state
    rigid: Unknowns | None = None  # of the state between rigid raceways, where a case starts from that, too

    def state(self, bearing: Bearing[Equilibrium], rings: Structure, rigid: Equilibrium) -> Equilibrium:
        """The unknowns in the equations of this case."""
        no_compliance = np.zeros((rigid.balance.layout.rollers, rigid.axial_modes) * 2)
        start = _put(next(bearing.iterate((no_compliance, no_compliance), rigid, None)), self.unknowns)
        linear = rings.linearised(start.forces)
        if linear.initial_deviation is None:
            return start
        # deviations among the unknowns are those by the roller forces alone
        initial = np.moveaxis(linear.initial_deviation, -1, 1)[:, :, None]
        by_load = self.unknowns._replace(deviation=self.unknowns.deviation - initial)
        return _put(next(bearing.iterate(linear.compliance, start, linear.initial_deviation)), by_load)


def _put(state: Equilibrium, x: Unknowns) -> Equilibrium:
    """A state with other unknowns."""
    return replace(state, scaled=state.balance.pack(x)[0])


def initial_state(start: Result, case: Case) -> InitialState:
    """The end state that a case shall start from.

    Raises `BadCase` where the case cannot start from another one, or not from this one; it says what differs.
    """
    if problem := _of_case(case) or _of_result(start, case) or _differing(start, case):
        raise BadCase(f"start {start.place}: {problem}")
    return InitialState(start.place, _unknowns(start.flexible))


def neighbouring_state(result: Result, case: Case) -> InitialState | None:
    """Both states of a case that differs little; None where its unknowns are others."""
    if _of_coupling(case) or _of_result(result, case) or _differing(result, case):
        return None
    return InitialState(result.place, _unknowns(result.flexible), _unknowns(result.rigid))


def _unknowns(block: Mapping[str, Any]) -> Unknowns:
    return unknowns(block["unknowns"], block["roller_azimuth"].size, block.get("ring_shift", 0.0))


def _of_case(case: Case) -> str:
    """Why a case starts nowhere but between rigid raceways; empty where it can."""
    if case.inner.kind == case.outer.kind == "rigid":
        return "every part of this case is rigid; a start is for flexible parts"
    return _of_coupling(case)


def _of_coupling(case: Case) -> str:
    """Why the way that a case is solved begins elsewhere; empty where it does not."""
    if case.coupling.method != "newton":
        return (
            f'coupling.method = "{case.coupling.method}" begins between rigid raceways; allowed is "newton"'
        )
    if case.accuracy.target is not None:
        return "accuracy.target chooses its own levels and starts; leave one of both out"
    return ""


def _of_result(result: Result, case: Case) -> str:
    """Why no case can start from a result; empty where one can."""
    if result.kind != case.kind:
        return f'it is of kind = "{result.kind}"; allowed is kind = "{case.kind}"'
    if result.attributes["status"] != "converged":
        return f"it did not converge ({result.attributes['status']}); allowed is a converged result"
    return ""


def _differing(result: Result, case: Case) -> str:
    """What makes the unknowns of a result other ones than those of a case; empty where nothing does."""
    block, this, other = result.flexible, case.model_dump(), result.attributes["case_si"]
    rollers = block["roller_azimuth"].size
    modes, rest = divmod(block["unknowns"].size - BORDER - FIELDS * rollers, 2 * rollers)
    pairs = [
        ("bearing.rollers", rollers, case.bearing.all_rollers),
        ("accuracy.slices", block["slice_position"].size, case.accuracy.slices),
        ("accuracy.axial_shapes", "no whole number" if rest else modes, case.accuracy.axial_shapes),
        *((key, _at(other, key), _at(this, key)) for key in SAME),
    ]
    differences = [
        f"{key} = {toml(other_value)} there, {toml(this_value)} here"
        for key, other_value, this_value in pairs
        if other_value != this_value
    ]
    return "; ".join([*differences, "allowed is the same in both"]) if differences else ""


def _at(case: Any, key: str) -> Any:
    """A key of a case that is dumped as tables; None where a case of other make has none."""
    for name in key.split("."):
        case = case.get(name) if isinstance(case, Mapping) else None
    return case


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
