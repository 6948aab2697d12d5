"""The rollers on their way through a pitch: one position after the other, each from the one before."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.roller import Case
from flexbearing.coupled.coupled import BearingPartner, CoupledBearing
from flexbearing.coupled.initial_state import InitialState, flat, unknowns
from flexbearing.coupling import LinearPair, PartnerFailed, RacewayPair
from flexbearing.outputs import outputs
from flexbearing.progress import Report
from flexbearing.quantities.roller import LAYOUT
from flexbearing.runs.solved_rows import QUANTITIES, SolvedRows
from quasidynamic import Equilibrium, RollerBearing
from quasidynamic.note import Note, danger, information

RIGID = LinearPair(None, None)
SHOWN = [  # on the page of a result; the error of a life is that of its case
    output
    for output in outputs(LAYOUT)
    if output.declared.label and not output.declared.section and output.declared.of != ("life_error",)
]
TOLD = 0.01  # change of load or life over a pitch that is reported in a case without accuracy.target
JUDGED = {"max_roller_load_N": "largest roller load", "life_L10_Mrev": "life"}


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

    @property
    def mean_life(self) -> float:
        """Life [10^6 revolutions] by equal damage of all solved positions, their harmonic mean."""
        return float(1 / np.mean([1 / position.values["life_L10_Mrev"] for position in self.solved]))

    def record(self) -> dict[str, Any]:
        """What the result file says."""
        names = self.positions[0].values
        return {
            "azimuth_deg": [float(np.degrees(position.azimuth)) for position in self.positions],
            "status": [position.status for position in self.positions],
            "values": {
                name: [_finite(position.values.get(name)) for position in self.positions] for name in names
            },
            "mean_life_Mrev": _finite(self.mean_life),
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
            near = solved_near(case, moved, moved_rings, near)
            positions.append(Position(at, _values(case, moved, near, moved_rings), "converged"))
        except PartnerFailed as failure:
            positions.append(Position(at, {}, failure.ending or "not solved", str(failure)))
    return Passage(tuple(positions), case.accuracy.target or TOLD)


def solved_near(case: Case, model: RollerBearing, rings: RacewayPair, near: Equilibrium) -> Equilibrium:
    """Solve the bearing with its rollers at another place.

    Raises
    ------
    PartnerFailed
        when no method converges
    """
    partner = BearingPartner(model)
    if rings.rigid:
        try:
            return partner.solve(start=near)
        except PartnerFailed:
            return partner.solve()
    warm = InitialState("the position before", unknowns(flat(near.cases)[0], model.bearing.rollers))
    start = None if rings.solved_in_full else warm  # which has no tangent to begin with
    *_, last = CoupledBearing(case, partner, rings, partner.solve(), start).attempts()
    if last.status != "converged":
        raise PartnerFailed(last.message, last.status)
    return last.state


def _values(case: Case, model: RollerBearing, state: Equilibrium, rings: RacewayPair) -> dict[str, float]:
    """Every single number that the page of a result shows, by its name in the summary."""
    tangent = RIGID if rings.rigid else rings.linearised(state.forces)
    names = dict.fromkeys(name for output in SHOWN for name in output.declared.of)
    block = SolvedRows.of(case, model, state, tangent).block(QUANTITIES[name] for name in names)
    known = (output for output in SHOWN if all(name in block for name in output.declared.of))
    return {output.key: float(output.numbers(block)[0]) for output in known}


def _finite(value: float | None) -> float | None:
    return value if value is not None and np.isfinite(value) else None


def _spread(values: list[float]) -> float:
    """Largest less smallest over the smallest [-]; 0 where not all are finite."""
    finite: NDArray = np.array(values)
    if not np.isfinite(finite).all() or finite.min() <= 0:
        return 0.0
    return float(np.ptp(finite) / finite.min())
