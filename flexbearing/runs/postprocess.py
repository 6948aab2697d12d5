"""What follows from the end states of a run: quantities, lives, regimes, stresses, notes."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

from flexbearing import findings
from flexbearing.build import clearance
from flexbearing.case.roller import Case
from flexbearing.coupling import LinearPair
from flexbearing.findings import Judged, declared
from flexbearing.life import life_rules
from flexbearing.progress import Report
from flexbearing.quantities.quantity import row
from flexbearing.results import Arrays, Recorder
from flexbearing.runs import judged, notes, roller_findings
from flexbearing.runs.several import SeveralEquilibria
from flexbearing.runs.solved_rows import SolvedRows
from quasidynamic import Equilibrium, RollerBearing
from quasidynamic.note import Note, graded, information

if TYPE_CHECKING:
    from flexbearing.runs.part_fields import Race


@dataclass(frozen=True)
class Postprocessing:
    """Records end states as tables of one row, and says of the last what its root attributes hold."""

    case: Case
    record: Recorder
    report: Report
    notes: list[Note] = field(default_factory=list)  # of the run
    stresses: "dict[Race, dict[str, Any]]" = field(default_factory=dict)  # by part
    blocks: dict[str, Arrays] = field(default_factory=dict)  # that were written
    solved: dict[str, SolvedRows] = field(default_factory=dict)  # by block; the last answers the case
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
        if not converged:
            return
        self.solved[name] = rows
        if name == "flexible" and self.case.outputs.stresses:
            self._add_stresses(rows)
        self.notes.extend(rows.notes_of_probes)
        if self.record.others == "searched":
            self.several[name] = rows.other_equilibria(0)

    def repeat_rigid(self) -> None:
        """Write the rigid solution as the flexible one, where no part is flexible."""
        self.record.block("flexible", self.blocks["rigid"])
        self.solved["flexible"] = self.solved["rigid"]

    def _add_stresses(self, rows: SolvedRows) -> None:
        """Stresses come on top of a solution: what keeps them away is a note, and the solution stays."""
        from flexbearing.runs import fields
        from flexbearing.runs.part_fields import NoFields

        for race in fields.parts(self.case):
            try:
                self.stresses[race] = rows.fields(race).record()
            except NoFields as problem:
                self.notes.append(information("no-stresses", f"no stresses: {problem}"))

    def _judged(self, rows: SolvedRows, of_clearance: dict[str, Any]) -> tuple[Judged, ...]:
        """What the answer is judged by."""
        values = roller_findings.values(rows) | {"clearance": judged.clearances(of_clearance)}
        if self.stresses:
            from flexbearing.runs import fields

            values |= fields.values(self.case, self.stresses)
        return findings.evaluate(declared.OF_ROLLERS, values)

    def _notes_on_several(self, answer: SolvedRows) -> list[Note]:
        """One for each block that is one of several equilibria; the last that was examined is the answer."""
        if self.record.others == "reported":
            return [*notes.of_others(answer, 0)] if answer.several_likely[0] else []
        last = list(self.several)[-1:]
        return [found.note(answer=[name] == last) for name, found in self.several.items() if found]

    def attributes(self) -> dict[str, Any]:
        """Root attributes that the end states decide."""
        of_clearance, found = clearance.record(self.case), ()
        every_note = [*notes.of_case(self.case), *self.notes]
        if self.solved:
            answer = list(self.solved.values())[-1]
            found = self._judged(answer, of_clearance)
            every_note += [*judged.notes(found), *notes.of_solution(answer)]
            every_note += [*self._notes_on_several(answer), *notes.of_sliced_peak(answer)]
        lives = {name: rows.life[0] for name, rows in self.solved.items()}
        records = {name: found.record() for name, found in self.several.items() if found and found.others}
        return {
            **({"stresses": self.stresses} if self.case.outputs.stresses else {}),
            **({"equilibria": records} if records else {}),
            "clearance": of_clearance,
            "findings": [*map(vars, findings.records(found))],
            "life": {name: life.record() for name, life in lives.items() if life is not None},
            **({"life_rule": life_rules.of_rollers(self.case)} if lives else {}),
            "regimes": {name: rows.regimes[0] for name, rows in self.solved.items() if rows.regimes[0]},
            "notes": [note.record() for note in graded(every_note)],
        }
