"""The rollers on their way through a pitch: one position after the other, each from the one before."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.roller import Case
from flexbearing.coupled.attempts import CoupledBearing
from flexbearing.coupled.coupled import BearingPartner
from flexbearing.coupled.states import EndStates, InitialState, flat, unknowns
from flexbearing.coupling import LinearPair, PartnerFailed, RacewayPair
from flexbearing.outputs import outputs
from flexbearing.outputs.names import PROBE, numbered_by
from flexbearing.progress import Report
from flexbearing.quantities.roller import LAYOUT
from flexbearing.runs.solved_rows import QUANTITIES, SolvedRows
from quasidynamic import Equilibrium, RollerBearing
from quasidynamic.contact.line import EXPONENT
from quasidynamic.note import Note, danger, information

NOTED = 0.02  # change of the largest load that is reported in a case without accuracy.target (assumed)
WORTH_A_SOLVE = 0.5  # of that: the foreseen change errs by about as much
RIGID = LinearPair(None, None)
SHOWN = [  # on the page of a result; the error of a life is that of its case
    output
    for output in outputs(LAYOUT)
    if output.declared.label and not output.declared.section and output.declared.of != ("life_error",)
]
READ = {name: each for name, each in numbered_by(LAYOUT, PROBE).items() if name != "probe_azimuth"}
TOLD = 0.01  # change of load or life over a pitch that is reported in a case without accuracy.target
JUDGED = {"max_roller_load_N": "largest roller load", "life_L10_Mrev": "life"}


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
    threshold, largest = case.accuracy.target or NOTED, float(end.loads[0].max())
    if not largest > 0 or not _may_matter(case, end, WORTH_A_SOLVE * threshold):
        return ()
    in_space = rings.solved_in_full or case.accuracy.structure == "solid" or case.outer.kind == "step"
    moved = None if in_space else _half_a_pitch_further(case, model, rings)
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
    words = f"roller position: {words}; more positions give the range over a pitch"
    return (information("roller-position", words, {"operation.roller_positions": "8"}),)


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


def _half_a_pitch_further(case: Case, model: RollerBearing, rings: RacewayPair) -> Equilibrium | None:
    """From a load distribution: sooner than from rollers half a pitch away."""
    alone = case.model_copy(update={"coupling": case.coupling.model_copy(update={"fallback": False})})
    azimuth = model.bearing.first_roller_azimuth + np.pi / model.bearing.rollers
    moved = replace(model, bearing=replace(model.bearing, first_roller_azimuth=azimuth))
    try:
        return solved(alone, moved, rings.under(moved.bearing.azimuths))
    except PartnerFailed:
        return None


@dataclass(frozen=True)
class Position:
    """The bearing with its rollers at one position."""

    azimuth: float  # of the first roller [rad]
    values: Mapping[str, float]  # by the names of the summary; empty where it was not solved
    status: str
    message: str = ""


@dataclass(frozen=True)
class Passage:
    """All positions within a pitch, and the change of the largest load when the pitch is completed."""

    positions: tuple[Position, ...]
    target: float  # change worth a note [-]

    @property
    def solved(self) -> tuple[Position, ...]:
        """Positions that were solved; the first always is."""
        return tuple(position for position in self.positions if position.values)

    def record(self) -> dict[str, Any]:
        """What the result file says."""
        names = self.positions[0].values
        return {
            "azimuth_deg": [float(np.degrees(position.azimuth)) for position in self.positions],
            "status": [position.status for position in self.positions],
            "values": {
                name: [_finite(position.values.get(name)) for position in self.positions] for name in names
            },
            "mean_life_Mrev": _finite(
                float(1 / np.mean([1 / each.values["life_L10_Mrev"] for each in self.solved]))
            ),
        }

    def notes(self) -> Iterator[Note]:
        """Positions without a solution; how much the position matters."""
        failed = [position for position in self.positions if not position.values]
        if failed:
            yield danger(
                "unsolved-position",
                f"roller positions: {len(failed)} of {len(self.positions)} were not solved, the first of "
                f"them with a roller at {np.degrees(failed[0].azimuth):.3g} deg: {failed[0].message}",
            )
        ranges = {name: [position.values[name] for position in self.solved] for name in JUDGED}
        large = {name: values for name, values in ranges.items() if _spread(values) > self.target}
        if large:
            words = " and ".join(
                f"the {JUDGED[name]} from {min(values):,.5g} to {max(values):,.5g} {name.rpartition('_')[2]}"
                for name, values in large.items()
            )
            yield information(
                "roller-position", f"roller positions: on their way through a pitch rollers change {words}"
            )


def passage(
    case: Case, model: RollerBearing, rings: RacewayPair, first: Equilibrium, report: Report
) -> Passage:
    """Move the rollers through a pitch."""
    count = case.operation.roller_positions
    assert count is not None  # or there is no passage
    azimuth, pitch = model.bearing.first_roller_azimuth, 2 * np.pi / model.bearing.rollers
    near, positions = first, [Position(azimuth, _values(case, model, first, rings), "converged")]
    for place in range(1, count):
        at = azimuth + pitch * place / count
        report.stage(f"rollers at {np.degrees(at):.3g} deg, position {place + 1} of {count}", None)
        moved = replace(model, bearing=replace(model.bearing, first_roller_azimuth=at))
        try:
            moved_rings = rings.under(moved.bearing.azimuths)
            near = solved(case, moved, moved_rings, near)
            positions.append(Position(at, _values(case, moved, near, moved_rings), "converged"))
        except PartnerFailed as failure:
            positions.append(Position(at, {}, failure.ending or "not solved", str(failure)))
    return Passage(tuple(positions), case.accuracy.target or TOLD)


def solved(
    case: Case, model: RollerBearing, rings: RacewayPair, near: Equilibrium | None = None
) -> Equilibrium:
    """Solve the bearing with its rollers at another place, from a state near it where one is given.

    Raises `PartnerFailed` when no method converges.
    """
    partner, start = BearingPartner(model), None
    if rings.rigid:
        try:
            return partner.solve(start=near)
        except PartnerFailed:
            if near is None:
                raise
            return partner.solve()
    if near is not None and not rings.solved_in_full:  # which has no tangent to begin with
        state = unknowns(flat(near.cases)[0], model.bearing.all_rollers)
        start = InitialState("the position before", state).state
    *_, last = CoupledBearing(case.coupling, partner, rings, partner.solve(), start).attempts()
    if last.status != "converged":
        raise PartnerFailed(last.message, last.status)
    return last.state


def _values(case: Case, model: RollerBearing, state: Equilibrium, rings: RacewayPair) -> dict[str, float]:
    """Every single number that the page of a result shows, by its name in the summary."""
    tangent = RIGID if rings.rigid else rings.linearised(state.forces)
    names = dict.fromkeys(name for output in SHOWN for name in output.declared.of)
    block = SolvedRows.of(case, model, state, tangent).block(QUANTITIES[name] for name in (*names, *READ))
    known = (output for output in SHOWN if all(name in block for name in output.declared.of))
    return {output.key: float(output.numbers(block)[0]) for output in known} | dict(_readings(block))


def _readings(block: Mapping[str, NDArray]) -> Iterator[tuple[str, float]]:
    """Yield what each probe reads, by the names of the summary with its number from 1."""
    for name, quantity in READ.items():
        for number, value in enumerate(block.get(name, np.zeros((1, 0)))[0], 1):
            yield f"{quantity.summary[0].key}.{number}", float(quantity.for_people(value))


def _finite(value: float | None) -> float | None:
    return value if value is not None and np.isfinite(value) else None


def _spread(values: list[float]) -> float:
    """Largest less smallest over the smallest [-]; 0 where not all are finite."""
    finite: NDArray = np.array(values)
    if not np.isfinite(finite).all() or finite.min() <= 0:
        return 0.0
    return float(np.ptp(finite) / finite.min())
