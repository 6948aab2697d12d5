"""A limit with its source, and numbers judged by it, cases first."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

Grade = Literal["danger", "outside validity", "usual"]
DANGER, OUTSIDE, USUAL = "danger", "outside validity", "usual"
GRADES: tuple[Grade, ...] = (DANGER, OUTSIDE, USUAL)  # gravest first
MET, NOT_MET, NOT_CHECKED = "met", "not met", "not checked"
AT_MOST, AT_LEAST = "at most", "at least"


@dataclass(frozen=True, kw_only=True)
class Finding:
    """A limit of one quantity, and what follows where it is not kept."""

    code: str  # of its note
    label: str  # of the quantity, for people
    quantity: str  # name among the values
    grade: Grade
    source: str  # of the limit
    meaning: str  # what happens beyond it
    action: str  # what keeps it; {share} stands for the share of the limit
    keys: tuple[tuple[str, str], ...] = ()  # of the case that act, with values
    at_most: float | None = None  # one of both, in SI units
    at_least: float | None = None
    times: str = ""  # value that the limit is a multiple of, such as a rating
    unit: str = ""  # SI
    shown: str = ""  # for people
    noted: bool = True  # whether a note says that it is not kept; all are in the checks of a report
    of_model: bool = False  # about the model or its inputs, not the bearing: no check where it is kept

    def __post_init__(self):
        if (self.at_most is None) == (self.at_least is None):
            raise ValueError(f"finding {self.code}: needs one of at_most and at_least")

    @property
    def limit(self) -> float:
        """Its number, without what it is a multiple of."""
        return self.at_least if self.at_most is None else self.at_most  # type: ignore[return-value]

    @property
    def side(self) -> str:
        """Whether the limit is from above or from below."""
        return AT_LEAST if self.at_most is None else AT_MOST


@dataclass(frozen=True, kw_only=True)
class Record:
    """What is stored of a finding of one case."""

    code: str
    grade: Grade
    quantity: str
    place: str
    value: float  # in SI units, as the limit
    side: str
    limit: float | None  # None where the case gives none
    source: str  # of the limit
    share: float | None  # of the limit; None where it means nothing
    verdict: str

    @property
    def broken(self) -> bool:
        """Whether the limit is not kept."""
        return self.verdict == NOT_MET


@dataclass(frozen=True)
class Judged:
    """Numbers (C) of cases against the limit of a finding."""

    finding: Finding
    place: str  # of several, such as a raceway; else empty
    value: NDArray
    limit: NDArray  # NaN where it is not known

    @cached_property
    def broken(self) -> NDArray:
        """Whether the limit is not kept; not where value or limit is not known."""
        return self.value > self.limit if self.finding.side == AT_MOST else self.value < self.limit

    @cached_property
    def share(self) -> NDArray:
        """Value over a limit from above, limit from below over value [-]."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return self.value / self.limit if self.finding.side == AT_MOST else self.limit / self.value

    def record(self, case: int = 0) -> Record:
        """The same of one case."""
        value, limit, share = (float(each[case]) for each in (self.value, self.limit, self.share))
        known, verdict = np.isfinite(limit), NOT_MET if self.broken[case] else MET
        return Record(
            code=self.finding.code,
            grade=self.finding.grade,
            quantity=self.finding.quantity,
            place=self.place,
            value=value,
            side=self.finding.side,
            limit=limit if known else None,
            source=self.finding.source,
            share=share if limit and not self.finding.of_model and np.isfinite(share) else None,
            verdict=verdict if known else NOT_CHECKED,
        )


def evaluate(findings: Iterable[Finding], values: Mapping[str, Any]) -> tuple[Judged, ...]:
    """Judge values of cases."""
    return tuple(
        judged for finding in findings for judged in _by_place(finding, values, values.get(finding.quantity))
    )


def _by_place(finding: Finding, values: Mapping[str, Any], given: Any) -> Iterable[Judged]:
    for place, value in (given if isinstance(given, Mapping) else {"": given}).items():
        if value is not None:
            base = values.get(finding.times) if finding.times else 1.0
            base = base.get(place) if isinstance(base, Mapping) else base
            limit = finding.limit * np.asarray(base, dtype=float)  # None is NaN
            yield Judged(finding, place, *np.broadcast_arrays(np.atleast_1d(value), limit))


def records(judged: Iterable[Judged], case: int = 0) -> list[Record]:
    """What is stored of one case; values without bound, such as a life without load, have no place in it."""
    return [each.record(case) for each in judged if np.isfinite(each.value[case])]


def stored(attributes: Mapping[str, Any]) -> tuple[Record, ...]:
    """Records among the attributes of a result; none where it has no solution."""
    return tuple(Record(**each) for each in attributes.get("findings") or ())


def gravest(records: Iterable[Record]) -> Record:
    """The first of some records to act on: the gravest that is not kept, else the nearest to its limit."""
    return min(records, key=_rank)


def by_code(records: Iterable[Record]) -> Iterator[tuple[Record, tuple[str, ...]]]:
    """The gravest record of each code, with the places of those of its grade."""
    groups: dict[str, list[Record]] = {}
    for record in records:
        groups.setdefault(record.code, []).append(record)
    for group in groups.values():
        worst = gravest(group)
        places = (each.place for each in group if each.grade == worst.grade)
        yield worst, tuple(filter(None, dict.fromkeys(places)))


def _rank(record: Record) -> tuple[bool, int, float]:
    return not record.broken, GRADES.index(record.grade) if record.broken else 0, -(record.share or 0.0)
