"""A note: what a reader of a result must know besides its numbers."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Literal, get_args

Grade = Literal["danger", "outside validity", "information"]
GRADES: tuple[Grade, ...] = get_args(Grade)  # gravest first
Keys = Mapping[str, str]  # of the case that a note is about, with values to consider; empty for no value
NO_KEYS: Keys = {}


@dataclass(frozen=True)
class Note:
    """One thing worth knowing, with how grave it is.

    Attributes
    ----------
    grade : str
        "danger": whoever acts on the answer may be harmed by it; "outside validity": a law is used where its
        source does not reach; "information": all else
    code : str
        fixed name of its kind for programs, such as "contact-pressure"
    text : str
        what, where, and against which limit; names no key of the case
    keys : tuple of (str, str)
        keys of the case that it is about, each with a value to consider; empty for no value
    """

    grade: Grade
    code: str
    text: str
    keys: tuple[tuple[str, str], ...] = ()

    def record(self) -> dict[str, Any]:
        """Grade, code, text and keys for a file."""
        keys = {"keys": dict(self.keys)} if self.keys else {}
        return {"grade": self.grade, "code": self.code, "text": self.text, **keys}


def of_record(record: Mapping[str, Any]) -> Note:
    """The note of a record."""
    return Note(**{**record, "keys": tuple(record.get("keys", NO_KEYS).items())})


def danger(code: str, text: str, keys: Keys = NO_KEYS) -> Note:
    """A note of grade "danger"."""
    return Note("danger", code, text, tuple(keys.items()))


def outside(code: str, text: str, keys: Keys = NO_KEYS) -> Note:
    """A note of grade "outside validity"."""
    return Note("outside validity", code, text, tuple(keys.items()))


def information(code: str, text: str, keys: Keys = NO_KEYS) -> Note:
    """A note of grade "information"."""
    return Note("information", code, text, tuple(keys.items()))


def graded(notes: Iterable[Note]) -> list[Note]:
    """Every note once, by rank."""
    return sorted(dict.fromkeys(notes), key=lambda note: rank(note.code, note.grade))


def rank(code: str, grade: str) -> tuple[bool, int]:
    """The gravest first, a target that was missed before all others."""
    return code != "unmet-target", GRADES.index(grade)
