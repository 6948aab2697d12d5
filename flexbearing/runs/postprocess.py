"""What follows from the end states of a run: quantities, lives, regimes, stresses, notes."""

from dataclasses import dataclass, field
from typing import Any, Literal

from flexbearing import findings
from flexbearing.build import clearance
from flexbearing.case.roller import Case
from flexbearing.coupling import LinearPair
from flexbearing.findings import Judged, declared
from flexbearing.progress import Report
from flexbearing.quantities.quantity import row
from flexbearing.results import Arrays, Recorder
from flexbearing.runs import judged, notes, roller_findings
from flexbearing.runs.several import SeveralEquilibria
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic import Equilibrium, RollerBearing
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
    solved: dict[str, SolvedRows] = field(default_factory=dict)  # by block
    several: dict[str, SeveralEquilibria | None] = field(default_factory=dict)  # by block that was examined

    def store(
        self,
        name: Literal["rigid", "flexible"],
        model: RollerBearing,
        state: Equilibrium,
        rings: LinearPair,
        *,
        converged: bool = True,
    ) -> None:
        """Write a block; lives, regimes, skew, stresses and notes are those of solutions only."""
        rows = SolvedRows([self.case], [model], state.cases, [rings], self.report, converged)
        self.blocks[name] = row(rows.block(), 0)
        self.record.block(name, self.blocks[name], converged=converged)
        if converged:
            self._add_solution(name, rows)

    def repeat_rigid(self) -> None:
        """Write the rigid solution as the flexible one, where no part is flexible."""
        self.record.block("flexible", self.blocks["rigid"])
        by_block: tuple[Any, ...] = (self.lives, self.regimes, self.of_state, self.values)
        for said in by_block:
            if "rigid" in said:
                said["flexible"] = said["rigid"]

    def _add_solution(self, name: Literal["rigid", "flexible"], rows: SolvedRows) -> None:
        """Collect what attributes say of a solution, and its notes."""
        self.solved[name] = rows
        if (life := rows.life[0]) is not None:
            self.lives[name] = life.record()
        if rows.roughness is not None:
            ratios = lambda_ratio(rows.states.minimum_film[0], rows.roughness[0])
            self.regimes[name] = dict(zip(("inner", "outer"), map(str, regime(ratios)), strict=True))
        self.of_state[name] = notes.of_solution(rows)
        self.values[name] = roller_findings.values(rows)
        if name == "flexible" and self.case.outputs.stresses:
            self._add_stresses(rows)
        self.notes.extend(rows.notes_of_probes)
        if self.record.others == "searched":
            self.several[name] = rows.other_equilibria(0)

    def _add_stresses(self, rows: SolvedRows) -> None:
        """Stresses come on top of a solution: what keeps them away is a note, and the solution stays."""
        from flexbearing.runs import fields
        from flexbearing.runs.part_fields import NoFields

        for race in fields.parts(self.case):
            try:
                record = rows.fields(race).record()
            except NoFields as problem:
                self.notes.append(information("no-stresses", f"no stresses: {problem}"))
            else:
                self.stresses[race] = record
                for quantity, of_bodies in fields.values(self.case, race, record).items():
                    self.values["flexible"].setdefault(quantity, {}).update(of_bodies)

    def _notes_on_several(self) -> list[Note]:
        """One for each block that is one of several equilibria; the last that was examined is the answer."""
        if self.record.others == "reported":
            answers = list(self.solved.values())[-1:]
            return [note for rows in answers if rows.several_likely[0] for note in notes.of_others(rows, 0)]
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
            every_note += notes.of_sliced_peak(list(self.solved.values())[-1])
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
