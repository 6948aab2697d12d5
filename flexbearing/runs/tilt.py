"""How the shaft holds the inner ring, and what it would change if it held it otherwise."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from flexbearing.case.roller import Case
from flexbearing.coupled import states
from flexbearing.coupling import LinearPair
from flexbearing.runs import bars
from flexbearing.runs.end_state import end_state
from quasidynamic import Equilibrium
from quasidynamic.note import Note, information
from quasidynamic.outcome.other_tilt import with_other_tilt

TOLD = 0.01  # change of load or life that is told in a case without accuracy.target
OTHER = {"fixed": "free", "free": "fixed"}


@dataclass(frozen=True)
class TiltComparison:
    """The end state of a case beside an estimate of the one with the other `operation.tilt`."""

    case: Case
    state: Equilibrium
    other: Equilibrium | None = None  # None where it was not found, or no ring is flexible
    rings: LinearPair | None = None  # of both

    @classmethod
    def at(cls, case: Case, state: Equilibrium, rings: LinearPair) -> "TiltComparison":
        """Compare at a solution between elastic raceways."""
        other = with_other_tilt(states.elastic(state, rings)) if np.isfinite(state.life) else None
        return cls(case, state, other if other is not None and np.isfinite(other.life) else None, rings)

    def record(self) -> dict[str, Any]:
        """What the result file says."""
        if self.other is None:
            return {"inner_ring": self.case.operation.tilt}
        return {
            "inner_ring": self.case.operation.tilt,
            "otherwise": {
                "inner_ring": OTHER[self.case.operation.tilt],
                "max_roller_load_N": float(self.other.loads[0].max()),
                "life_L10_Mrev": float(self.other.life),
                "ring_moment_Nm": float(np.hypot(*self.other.ring_moment)),
                "ring_tilt_mrad": 1e3 * float(np.hypot(*self.other.ring_tilt)),
            }
            | self._further(self.other),
        }

    def _further(self, other: Equilibrium) -> dict[str, float]:
        """Radial stiffnesses along y and z, of the bearing alone and with supports, and largest stresses."""
        if self.rings is None:
            return {}
        end = end_state(self.case, other, self.rings)
        both = {"": end.between_raceways, "total_": end.with_supports}
        stiffnesses = {
            f"{which}stiffness_{axis}_N_per_m": float(tangent.radial_matrix[place, place])
            for which, tangent in both.items()
            for place, axis in enumerate("yz")
        }
        nominal = bars.nominal_stresses(self.case, end)
        stressed = {"nominal_bar_stress_MPa": 1e-6 * float(nominal.largest)} if nominal else {}
        return stiffnesses | {"peak_pressure_MPa": 1e-6 * float(end.peak_pressure.max())} | stressed

    def notes(self) -> tuple[Note, ...]:
        """A note where the choice changes loads or life by more than the target."""
        operation, told = self.case.operation, self.case.accuracy.target or TOLD
        if not np.isfinite(self.state.life):  # nothing carries load
            return ()
        if self.other is None:
            words = "could not be estimated near this end state"
        else:
            load = float(self.other.loads[0].max() / self.state.loads[0].max()) - 1
            life = self.other.life / self.state.life - 1
            if max(abs(load), abs(life)) <= told:
                return ()
            words = (
                f"would be {self.other.loads[0].max():,.5g} N ({load:+.1%}) and "
                f"{self.other.life:,.3g} Mrev ({life:+.0%})"
            )
        instead = f'operation.tilt = "{OTHER[operation.tilt]}" instead of "{operation.tilt}"'
        return (
            information(
                "tilt",
                f"tilt: with {instead} the largest roller load and the life {words}; "
                "how the shaft holds the inner ring must be known",
            ),
        )
