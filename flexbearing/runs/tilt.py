"""How the shaft holds the inner ring, and what it would change if it held it otherwise."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from flexbearing.case.roller import Case
from flexbearing.coupled import states
from flexbearing.coupling import LinearPair
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic import Equilibrium, RollerBearing
from quasidynamic.note import Note, information
from quasidynamic.outcome.other_tilt import with_other_tilt

TOLD = 0.01  # change of load or life that is reported in a case without accuracy.target
OTHER = {"fixed": "free", "free": "fixed"}


@dataclass(frozen=True)
class TiltComparison:
    """The end state of a case beside an estimate of the one with the other `operation.tilt`."""

    case: Case
    state: Equilibrium
    other: SolvedRows | None = None  # one; None where it was not found, or no ring is flexible

    @classmethod
    def at(cls, case: Case, model: RollerBearing, state: Equilibrium, rings: LinearPair) -> "TiltComparison":
        """Compare at a solution between elastic raceways."""
        other = with_other_tilt(states.elastic(state, rings)) if np.isfinite(state.life) else None
        if other is None or not np.isfinite(other.life):
            return cls(case, state)
        return cls(case, state, SolvedRows.of(case, model, other, rings))

    def record(self) -> dict[str, Any]:
        """What the result file says."""
        if self.other is None:
            return {"inner_ring": self.case.operation.tilt}
        (state,) = self.other.each
        return {
            "inner_ring": self.case.operation.tilt,
            "otherwise": {
                "inner_ring": OTHER[self.case.operation.tilt],
                "max_roller_load_N": float(state.loads[0].max()),
                "life_L10_Mrev": float(state.life),
                "ring_moment_Nm": float(np.hypot(*state.ring_moment)),
                "ring_tilt_mrad": 1e3 * float(np.hypot(*state.ring_tilt)),
            }
            | _further(self.other),
        }

    def notes(self) -> tuple[Note, ...]:
        """A note where the choice changes loads or life by more than the target."""
        operation, threshold = self.case.operation, self.case.accuracy.target or TOLD
        if not np.isfinite(self.state.life):  # nothing carries load
            return ()
        if self.other is None:
            words = "could not be estimated near this end state"
        else:
            (other,) = self.other.each
            load = float(other.loads[0].max() / self.state.loads[0].max()) - 1
            life = other.life / self.state.life - 1
            if max(abs(load), abs(life)) <= threshold:
                return ()
            words = (
                f"would be {other.loads[0].max():,.5g} N ({load:+.1%}) and "
                f"{other.life:,.3g} Mrev ({life:+.0%})"
            )
        other = OTHER[operation.tilt]
        return (
            information(
                "tilt",
                f"tilt: {other} instead of {operation.tilt}, the largest roller load and the life {words}; "
                "how the shaft holds the inner ring must be known",
                {"operation.tilt": other},
            ),
        )


def _further(other: SolvedRows) -> dict[str, float]:
    """Radial stiffnesses along y and z, of the bearing alone and with supports, and largest stresses."""
    both = {"": other.end.radial_matrix, "total_": other.end.with_supports.radial_matrix}
    stiffnesses = {
        f"{which}stiffness_{axis}_N_per_m": float(matrix[0, place, place])
        for which, matrix in both.items()
        if matrix is not None
        for place, axis in enumerate("yz")
    }
    stressed = {"nominal_bar_stress_MPa": 1e-6 * float(other.bars.largest[0])} if other.bars else {}
    return stiffnesses | {"peak_pressure_MPa": 1e-6 * float(other.peak_pressure.max())} | stressed
