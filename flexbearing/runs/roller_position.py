"""How much the place of the rollers within a pitch matters, reported where one position alone is solved."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.roller import Case
from flexbearing.coupled.coupled import BearingPartner
from flexbearing.coupled.states import EndStates
from flexbearing.coupling import PartnerFailed, RacewayPair
from quasidynamic import Equilibrium, RollerBearing
from quasidynamic.contact.line import EXPONENT
from quasidynamic.note import Note, information

TOLD = 0.02  # change of the largest load that is reported in a case without accuracy.target (assumed)
WORTH_A_SOLVE = 0.5  # of that: the foreseen change errs by about as much


def load_half_a_pitch_further(azimuths: NDArray, loads: NDArray, direction: float) -> float:
    r"""Foresee the largest load with every roller half a pitch further, from the loads where they are.

    .. math:: Q' = f\,\Big(\tfrac{9}{16}(x_0 + x_1) - \tfrac{1}{16}(x_{-1} + x_2)\Big)_+^{10/9},
              \quad x = Q^{9/10}

    Approaches x between four neighbours by a cubic; f keeps the resultant along the load.

    Source
    ------
    Cubic interpolation at the middle of an interval; derived here.

    Valid
    -----
    Five loaded rollers or more: within 2 % of the largest load, also on cages of 7 to 24 bars; with three it
    exaggerates. Not where every roller stands alike to the bars.
    """
    approach = loads ** (1 / EXPONENT)
    before, after, beyond = (np.roll(approach, -shift) for shift in (-1, 1, 2))
    between = (9 * (approach + after) - before - beyond) / 16
    moved = np.maximum(between, 0.0) ** EXPONENT
    resultant = loads @ np.cos(azimuths - direction)
    there = moved @ np.cos(azimuths + np.pi / loads.size - direction)
    return float(moved.max() * resultant / there) if resultant > 0 and there > 0 else float("nan")


def notes(case: Case, model: RollerBearing, rings: RacewayPair, end: Equilibrium) -> tuple[Note, ...]:
    """A note where half a pitch changes the largest load by more than the target of the case."""
    threshold, largest = case.accuracy.target or TOLD, float(end.loads[0].max())
    if not largest > 0 or not _may_matter(case, end, WORTH_A_SOLVE * threshold):
        return ()
    moved = None if _in_space(case, rings) else _half_a_pitch_further(case, model, rings, end)
    if moved is None:
        words = "half a pitch of the rollers may change loads and life, and is not solved here"
    else:
        load, life = float(moved.loads[0].max()), moved.life
        if abs(load / largest - 1) <= threshold:
            return ()
        words = (
            f"with all rollers half a pitch further the largest roller load is {load:,.4g} N instead of "
            f"{largest:,.4g} N ({load / largest - 1:+.1%}), the basic life L10 {_life(life)} Mrev instead of "
            f"{_life(end.life)} Mrev ({life / end.life - 1:+.1%}), the radial stiffness along y and z "
            f"{_stiffnesses(moved, rings)} instead of {_stiffnesses(end, rings)} kN/mm"
        )
    asks = "operation.roller_positions = 8 gives the range over a pitch"
    return (information("roller-position", f"roller position: {words}; {asks}"),)


def _stiffnesses(state: Equilibrium, rings: RacewayPair) -> str:
    """Radial stiffness along y and z [kN/mm], supports included."""
    there = rings.under(state.balance.roller.bearing.azimuths)
    matrix = EndStates(state.cases, there.linearised(state.forces)).with_supports.radial_matrix[0]
    return " and ".join(f"{1e-6 * each:,.4g}" for each in np.diagonal(matrix))


def _life(turns: float) -> str:
    """A life with four digits, and all those before the decimal point."""
    return f"{turns:,.0f}" if turns >= 1e4 else f"{turns:,.4g}"


def _may_matter(case: Case, end: Equilibrium, change: float) -> bool:
    """Whether half a pitch may change the largest load by so much [-]."""
    if case.bearing.form_error is not None:
        return True  # waves as many as the rollers hide between them
    if case.outer.kind == "squirrel_cage" and case.outer.bars and case.outer.bars % case.bearing.rollers == 0:
        return True  # every roller stands alike to the bars, and no load shows them
    azimuths, loads = end.balance.roller.bearing.azimuths, end.loads[0]
    foreseen = load_half_a_pitch_further(azimuths, loads, case.operation.load_direction)
    return abs(foreseen / loads.max() - 1) > change


def _in_space(case: Case, rings: RacewayPair) -> bool:
    """Whether other rollers need another condensation of a whole solid."""
    return rings.solved_in_full or case.accuracy.structure == "solid" or case.outer.kind == "step"


def _half_a_pitch_further(
    case: Case, model: RollerBearing, rings: RacewayPair, end: Equilibrium
) -> Equilibrium | None:
    from flexbearing.runs.passage import solved_near

    alone = case.model_copy(update={"coupling": case.coupling.model_copy(update={"fallback": False})})
    azimuth = model.bearing.first_roller_azimuth + np.pi / model.bearing.rollers
    moved = replace(model, bearing=replace(model.bearing, first_roller_azimuth=azimuth))
    try:
        if rings.rigid:  # sooner from a load distribution than from half a pitch away
            return BearingPartner(moved).solve()
        return solved_near(alone, moved, rings.under(moved.bearing.azimuths), end)
    except PartnerFailed:
        return None
