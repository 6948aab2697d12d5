"""A note: what a reader of a result must know besides its numbers."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal, get_args

Grade = Literal["danger", "outside validity", "information"]
GRADES: tuple[Grade, ...] = get_args(Grade)  # gravest first


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
        what, where, and against which limit
    """

    grade: Grade
    code: str
    text: str

    def record(self) -> dict[str, str]:
        """Grade, code and text for a file."""
        return {"grade": self.grade, "code": self.code, "text": self.text}


def danger(code: str, text: str) -> Note:
    """A note of grade "danger"."""
    return Note("danger", code, text)


def outside(code: str, text: str) -> Note:
    """A note of grade "outside validity"."""
    return Note("outside validity", code, text)


def information(code: str, text: str) -> Note:
    """A note of grade "information"."""
    return Note("information", code, text)


def graded(notes: Iterable[Note]) -> list[Note]:
    """Every note once, by rank."""
    return sorted(dict.fromkeys(notes), key=lambda note: rank(note.code, note.grade))


def rank(code: str, grade: str) -> tuple[bool, int]:
    """The gravest first, a target that was missed before all others."""
    return code != "unmet-target", GRADES.index(grade)
