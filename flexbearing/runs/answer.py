"""What is asked of many cases at once, and what each of them answers."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from flexbearing.findings import Record, RowFinding
from flexbearing.findings.row import in_rows, of_records, words
from flexbearing.findings.words import of_note
from flexbearing.printable import one_line
from quasidynamic.note import Note, graded, rank

CONVERGED, BAD_INPUT = "converged", "bad input"


@dataclass(frozen=True)
class Answer:
    """What a run of a case gives."""

    status: str  # "converged", or how it ended
    message: str  # why it did not converge; empty where it did
    numbers: Mapping[str, float]  # by the texts of outputs; NaN or absent: the case does not have it
    findings: tuple[RowFinding, ...] = ()  # of a run that converged
    own_run: str = ""  # why it was not solved beside others; empty: it was, or there were none

    @property
    def why(self) -> str:
        """Why a number is absent, as far as it is known."""
        return self.message or words(self.findings)


Alone = Callable[[int], Answer]  # the answer of a case, by its place, from a run of its own


def row_findings(records: Iterable[Record], notes: Iterable[Note]) -> tuple[RowFinding, ...]:
    """What the row of a converged case reports, the gravest first: findings, and notes of other codes."""
    found = of_records(records)
    judged = {each.code for each in found}
    others = (
        RowFinding(note.code, note.grade, text=one_line(of_note(note.record())))
        for note in graded(notes)
        if in_rows(note.code, note.grade) and note.code not in judged
    )
    return tuple(sorted((*found, *others), key=lambda each: rank(each.code, each.grade)))
