"""The flexible end state of a similar case as the initial state of another."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.case.declarations import toml
from flexbearing.case.roller import Case
from flexbearing.coupling import Bearing, Structure
from flexbearing.results import Result
from quasidynamic import Equilibrium
from quasidynamic.balance.rollers.unknowns import BORDER, CAGE, Unknowns
from quasidynamic.outcome.bearing_states import BearingStates

SAME = ("bearing.cage.guidance", "bearing.cage.centre", "lubricant.film")  # what the unknowns mean
FIELDS = 5  # unknowns of a roller: approach, tilt, both films, spin


def flat(states: BearingStates) -> NDArray:
    """Unknowns (C, N) of states in SI units, in the order of the result file, however they were solved.

    N = 5 + 5 Z + 2 Z M: ring and cage, fields over the rollers, deviations of both raceways, given or not.
    """
    x, deviation = states.unknowns, states.deviation
    border = (x.ring[..., 0].T, x.cage_drift)
    fields = (x.approach, x.tilt, *x.film, x.spin_drift)
    return np.concatenate([*border, *fields, deviation.reshape(len(deviation), -1)], axis=1)


def unknowns(values: NDArray, rollers: int) -> Unknowns:
    """The unknowns that `flat` (N) was made of, all deviations among those of elastic raceways."""
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
    )


@dataclass(frozen=True)
class InitialState:
    """Where the coupling of a case may start."""

    source: str  # path of the result that it comes from
    unknowns: Unknowns  # of the flexible end state

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

    Raises
    ------
    BadCase
        where the case cannot start from another one, or not from this one; it says what differs
    """
    if problem := _of_case(case) or _of_result(start, case) or _differing(start, case):
        raise BadCase(f"start {start.place}: {problem}")
    values = start.flexible["unknowns"]
    return InitialState(start.place, unknowns(values, start.flexible["roller_azimuth"].size))


def _of_case(case: Case) -> str:
    """Why a case starts nowhere but between rigid raceways; empty where it can."""
    if case.coupling.method != "newton":
        return (
            f'coupling.method = "{case.coupling.method}" begins between rigid raceways; allowed is "newton"'
        )
    if case.accuracy.target is not None:
        return "accuracy.target chooses its own levels and starts; leave one of both out"
    if case.inner.kind == case.outer.kind == "rigid":
        return "every part of this case is rigid; a start is for flexible parts"
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
        ("bearing.rollers", rollers, case.bearing.rollers),
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
