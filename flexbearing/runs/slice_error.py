"""What finer slices would change in the loads, slip, stiffness, pressure and torque of a solved case."""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from flexbearing.case.roller import Case
from flexbearing.coupled.coupled import BearingPartner
from flexbearing.coupled.states import EndStates
from flexbearing.coupling import PartnerFailed, RacewayPair, StoppingCriterion, newton
from flexbearing.quantities.roller import CAGE_SLIP
from quasidynamic import Equilibrium, RollerBearing
from quasidynamic.outcome.finer_life import ERROR_OVER_CHANGE, FINER


def record(
    case: Case, model: RollerBearing, rings: RacewayPair, end: Equilibrium
) -> dict[str, dict[str, Any]]:
    """Estimate errors by the slices: the largest change with 2 and 4 times as many, times 1.6."""
    if case.accuracy.target is not None or rings.solved_in_full or not end.loads.max() > 0:
        return {}
    counts = [times * model.slices for times in FINER]
    try:
        finer = [_solved(case, replace(model, slices=count), rings, end) for count in counts]
        numbers = [dict(_numbers(each, rings)) for each in (end, *finer)]
    except PartnerFailed:
        return {}
    value = numbers[0]
    changes = {
        name: [np.abs(other[name] - value[name]).max() / scale for other in numbers[1:]]
        for name in value
        if (scale := 1.0 if name == CAGE_SLIP.name else np.abs(value[name]).max()) > 0
    }
    errors = {name: ERROR_OVER_CHANGE * float(max(each)) for name, each in changes.items()}
    return {"slice_error": {"slices": counts, **{n: e for n, e in errors.items() if np.isfinite(e)}}}


def _solved(case: Case, model: RollerBearing, rings: RacewayPair, end: Equilibrium) -> Equilibrium:
    """The case with other slices, from its solution by Newton's method alone."""
    partner, coupling = BearingPartner(model), case.coupling
    if rings.rigid:
        return partner.solve(end)
    criterion = StoppingCriterion(tolerance=coupling.tolerance, limit=coupling.max_iterations)
    *_, last = newton(partner, rings, end, criterion)
    if last.status != "converged":
        raise PartnerFailed(last.message or last.status, last.ending)
    return last.state


def _numbers(state: Equilibrium, rings: RacewayPair) -> Iterator[tuple[str, Any]]:
    """The outputs whose errors are estimated."""
    end = EndStates(state.cases, rings.linearised(state.forces))
    yield "roller_load", state.loads
    yield CAGE_SLIP.name, state.cage_slip
    if end.stiffness is not None:
        yield "stiffness", end.between_raceways.radial_stiffness[0]
    yield "total_stiffness", end.with_supports.radial_stiffness[0]
    yield "peak_pressure", state.peak_pressure
    yield "driving_torque", state.driving_torque
