"""What follows from the end states of a run: quantities, lives, regimes, stresses, notes."""

from dataclasses import dataclass, field
from typing import Any, Literal

from flexbearing import findings
from flexbearing.build import clearance
from flexbearing.case.roller import Case
from flexbearing.coupled import states
from flexbearing.coupled.states import EndState
from flexbearing.coupling import LinearPair
from flexbearing.findings import Judged, declared
from flexbearing.progress import Report
from flexbearing.results import Arrays, Recorder
from flexbearing.runs import bars, fields, half_space, judged, life, notes, skew, sliced_peak, subsurface
from flexbearing.runs.end_state import end_state
from flexbearing.runs.life_error import LifeError, estimated
from flexbearing.runs.life_of_state import MREV
from flexbearing.runs.part_fields import NoFields
from flexbearing.runs.several import SeveralEquilibria, between_flexible_raceways
from quasidynamic import Equilibrium
from quasidynamic.contact.film import lambda_ratio, regime
from quasidynamic.note import Note, graded, information


@dataclass(frozen=True)
class Postprocessing:
    """Records end states and collects what its root attributes say of them."""

    case: Case
    record: Recorder
    report: Report
    lives: dict[str, Any] = field(default_factory=dict)  # by block
    regimes: dict[str, Any] = field(default_factory=dict)  # by block
    notes: list[Note] = field(default_factory=list)  # of the run
    of_state: dict[str, tuple[Note, ...]] = field(default_factory=dict)  # by block
    values: dict[str, dict[str, Any]] = field(default_factory=dict)  # that findings judge, by block
    stresses: dict[str, Any] = field(default_factory=dict)  # by part
    blocks: dict[str, Arrays] = field(default_factory=dict)  # that were written
    solved: dict[str, EndState] = field(default_factory=dict)  # by block
    several: dict[str, SeveralEquilibria | None] = field(default_factory=dict)  # by block that was examined

    def store(
        self,
        name: Literal["rigid", "flexible"],
        state: Equilibrium,
        rings: LinearPair,
        *,
        converged: bool = True,
    ) -> None:
        """Write a block; lives, regimes, skew, stresses and notes are those of solutions only."""
        error = estimated(self.case, state, rings, self.report) if converged else LifeError(None)
        whole, of_whole = half_space.most_loaded(self.case, state) if converged else (None, ())
        end = end_state(self.case, state, rings, error=error.value, whole=whole)
        block = states.block(end, **self._of_solution(name, end)) if converged else states.block(end)
        if converged and name == "flexible" and self.case.outputs.stresses:
            self._add_stresses(block)
        if converged:
            self.of_state[name] += error.notes + of_whole
            self.solved[name] = end
        self.blocks[name] = block
        self.record.block(name, block, converged=converged)

    def repeat_rigid(self) -> None:
        """Write the rigid solution as the flexible one, where no part is flexible."""
        self.record.block("flexible", self.blocks["rigid"])
        by_block: tuple[Any, ...] = (self.lives, self.regimes, self.of_state, self.values)
        for said in by_block:
            if "rigid" in said:
                said["flexible"] = said["rigid"]

    def _of_solution(self, name: str, end: EndState) -> dict[str, Any]:
        """Modified life and skew of a solution, and other equilibria; its records and notes are collected."""
        state = end.equilibrium
        modified = life.modified(self.case, state, end.whole)
        skewed = skew.at(self.case, state)
        if modified:
            self.lives[name] = modified.record()
        if end.roughness is not None:
            words = (str(word) for word in regime(lambda_ratio(state.minimum_film, end.roughness)))
            self.regimes[name] = dict(zip(("inner", "outer"), words, strict=True))
        rated = modified.modified / MREV if modified else None
        self.of_state[name] = notes.of_state(self.case, state)
        self.values[name] = judged.of_rollers(self.case, end, rated)
        if skewed:
            self.of_state[name] += skew.notes(skewed, state, state.minimum_film)
        if not end.rings.rigid:
            self.add_equilibria(name, between_flexible_raceways(state, end.rings))
        nominal = bars.nominal_stresses(self.case, end)
        self.values[name] |= bars.values(self.case, nominal and nominal.largest)
        below = subsurface.of_rollers(self.case, end)
        return {"life": modified, "skew": skewed, "bars": nominal, "subsurface": below}

    def _add_stresses(self, block: Arrays) -> None:
        """Stresses come on top of a solution: what keeps them away is a note, and the solution stays."""
        for race in fields.parts(self.case):
            try:
                record = fields.fields(self.case, race, "flexible", block).record()
            except NoFields as problem:
                self.notes.append(information("no-stresses", f"no stresses: {problem}"))
            else:
                self.stresses[race] = record
                for quantity, of_bodies in fields.values(self.case, race, record).items():
                    self.values["flexible"].setdefault(quantity, {}).update(of_bodies)

    def add_equilibria(self, name: str, found: SeveralEquilibria | None) -> None:
        """Keep what was found beside the equilibrium of a block; None says that nothing was."""
        self.several[name] = found

    def _notes_on_several(self) -> list[Note]:
        """One for each block that is one of several equilibria; the last that was examined is the answer."""
        last = list(self.several)[-1:]
        return [found.note(answer=[name] == last) for name, found in self.several.items() if found]

    def _judged(self, of_clearance: dict[str, Any]) -> tuple[Judged, ...]:
        """What the last solution, which answers the case, is judged by."""
        if not self.values:
            return ()
        values = list(self.values.values())[-1] | {"clearance": judged.clearances(of_clearance)}
        return findings.evaluate(declared.OF_ROLLERS, values)

    def attributes(self) -> dict[str, Any]:
        """Root attributes that the end states decide."""
        solutions = list(self.of_state.values())  # the last one answers the case
        of_clearance = clearance.record(self.case)
        found = self._judged(of_clearance)
        every_note = [*notes.of_case(self.case), *self.notes, *judged.notes(found)]
        every_note += solutions[-1] if solutions else ()
        every_note += self._notes_on_several()
        if self.solved:  # once, of the answer
            every_note += sliced_peak.notes(self.case, list(self.solved.values())[-1])
        stresses = {"stresses": self.stresses} if self.case.outputs.stresses else {}
        records = {name: found.record() for name, found in self.several.items() if found and found.others}
        return {
            **stresses,
            **({"equilibria": records} if records else {}),
            "clearance": of_clearance,
            "findings": findings.records(found),
            "life": self.lives,
            "regimes": self.regimes,
            "notes": [note.record() for note in graded(every_note)],
        }
