"""What is asked of many cases at once, and what each of them answers."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from flexbearing.findings.running import NO_MODIFIED_LIFE, PRESSED_ENDS
from flexbearing.findings.strength import CHANGED_RATING
from quasidynamic.note import Note, graded

CONVERGED, BAD_INPUT = "converged", "bad input"
_IN_ROWS = NO_MODIFIED_LIFE, PRESSED_ENDS.code, CHANGED_RATING.code


@dataclass(frozen=True)
class Answer:
    """What a run of a case gives."""

    status: str  # "converged", or how it ended
    message: str  # of a run that converged notes of rows, see `in_rows`; else why it did not
    numbers: Mapping[str, float]  # by the texts of outputs; NaN or absent: the case does not have it
    own_run: str = ""  # why it was not solved beside others; empty: it was, or there were none


Alone = Callable[[int], Answer]  # the answer of a case, by its place, from a run of its own


def in_rows(grade: str, code: str) -> bool:
    """Whether a note is in the message of a row: dangers, and numbers that are absent or doubtful."""
    return grade == "danger" or code in _IN_ROWS


def message(notes: Iterable[Note]) -> str:
    """Message of a run that converged: notes for rows, one after the other."""
    return "; ".join(f"{note.grade}: {note.text}" for note in graded(notes) if in_rows(note.grade, note.code))
