"""Findings of a row of a table: what its numbers exceed or lack, as data that a cell holds as JSON."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal

from flexbearing.findings.declared import is_declared, of_code
from flexbearing.findings.finding import DANGER, Grade, Record, by_code
from flexbearing.findings.load_limits import CHANGED_RATING
from flexbearing.findings.running import NO_MODIFIED_LIFE, PRESSED_ENDS
from flexbearing.findings.words import text as sentence

INFORMATION: Literal["information"] = "information"  # grade of what is neither a danger nor outside validity
DIGITS = 6  # of values and limits
_CODES = NO_MODIFIED_LIFE, PRESSED_ENDS.code, CHANGED_RATING.code


@dataclass(frozen=True)
class RowFinding:
    """A limit that a row does not keep, or, as a text, what else is to be known of its numbers."""

    code: str
    grade: Grade | Literal["information"]
    value: float | None = None  # in SI units; None of a text
    limit: float | None = None
    places: tuple[str, ...] = ()  # such as raceways
    text: str = ""  # of what has no declared limit

    __pydantic_config__ = {"extra": "forbid", "strict": True, "allow_inf_nan": False}  # noqa: RUF012

    def __post_init__(self):
        judged = None not in (self.value, self.limit) and is_declared(self.code, self.grade)
        if judged == bool(self.text):
            raise ValueError(f"{self.code}: needs a text, or numbers and a declared limit")

    def words(self, values: Iterable[float | None] = ()) -> str:
        """Its sentence with the grade, also with the range of values of several rows."""
        words = self.text or self._sentence([each for each in values if each is not None])
        return words if self.grade == INFORMATION else f"{self.grade}: {words}"

    def _sentence(self, values: Sequence[float]) -> str:
        assert self.value is not None  # as `__post_init__` requires
        assert self.limit is not None
        finding = of_code(self.code, self.grade)
        return sentence(finding, values or [self.value], self.limit, self.places, finding.source)


def information(code: str, text: str) -> RowFinding:
    """What is to be known of a row, and is no danger."""
    return RowFinding(code, INFORMATION, text=text)


def in_rows(code: str, grade: str) -> bool:
    """Whether rows report a finding or a note: dangers, and numbers that are absent or doubtful."""
    return grade == DANGER or code in _CODES


def of_records(records: Iterable[Record]) -> tuple[RowFinding, ...]:
    """Of a case's stored findings those that its row reports, one of each code."""
    reported = (each for each in records if each.broken and in_rows(each.code, each.grade))
    return tuple(
        RowFinding(worst.code, worst.grade, _rounded(worst.value), _rounded(worst.limit), places)
        for worst, places in by_code(reported)
    )


def _rounded(value: float | None) -> float | None:
    return None if value is None else float(f"{value:.{DIGITS}g}")


def words(findings: Iterable[RowFinding]) -> str:
    """All sentences, one after the other."""
    return "; ".join(each.words() for each in findings)


def by_sentence(noted: Iterable[tuple[int, RowFinding]]) -> Iterator[tuple[str, list[int]]]:
    """Findings of numbered rows in words, those with the same limit once with the range of their values."""
    alike: dict[tuple, tuple[RowFinding, list[tuple[int, float | None]]]] = {}
    for row, each in noted:
        kind = each.code, each.grade, each.limit, each.places, each.text
        alike.setdefault(kind, (each, []))[1].append((row, each.value))
    for each, those in alike.values():
        yield each.words(value for _, value in those), [row for row, _ in those]


def written(findings: Iterable[RowFinding]) -> str:
    """What a cell of a table, or a line of a journal, holds of them: JSON; empty where there are none."""
    found = tuple(findings)
    return _form().dump_json(found, exclude_defaults=True).decode() if found else ""


def read(cell: str) -> tuple[RowFinding, ...]:
    """Findings in a cell; raises ValueError where it holds something else."""
    return _form().validate_json(cell) if cell else ()


@cache
def _form() -> Any:
    """Their form in JSON, made where it is needed: `pydantic` takes a while."""
    from pydantic import TypeAdapter

    return TypeAdapter(tuple[RowFinding, ...])
