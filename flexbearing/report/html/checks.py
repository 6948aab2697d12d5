"""Findings of a result as rows of a report: a number, its limit, its verdict; the gravest first."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

from flexbearing.findings import DANGER, MET, NOT_CHECKED, OUTSIDE, USUAL, Record, gravest, of_code
from flexbearing.findings.finding import AT_LEAST, AT_MOST
from flexbearing.findings.load_limits import CONTACT_PRESSURE, YIELD_STRESS
from flexbearing.findings.running import CLEARANCE, PEAK_AT_ENDS, REQUIRED_LIFE, SHORT_LIFE
from flexbearing.findings.words import settings
from flexbearing.report.html import effects
from flexbearing.report.html.document import Cell, Number
from flexbearing.report.html.lives import lives
from flexbearing.report.html.reader import Reader, once
from flexbearing.report.html.units import printed, units_in_words

BUILD = "build"  # grade of dimensions that overlap
BROKEN = {
    (DANGER, AT_MOST): "EXCEEDED",
    (DANGER, AT_LEAST): "NOT MET",
    (OUTSIDE, AT_MOST): "OUTSIDE VALIDITY",
    (OUTSIDE, AT_LEAST): "OUTSIDE VALIDITY",
    (BUILD, AT_MOST): "CANNOT BE BUILT",
    (USUAL, AT_MOST): "ABOVE THE USUAL MAXIMUM",
    (USUAL, AT_LEAST): "BELOW THE USUAL MINIMUM",
}
WORST_FIRST = (DANGER, OUTSIDE, BUILD, USUAL)
JUDGED = {  # answer and reason, by the worst grade of what is not kept
    DANGER: ("No", "a limit of damage is exceeded"),
    OUTSIDE: ("Not assured", "a law is used outside its range"),
    BUILD: ("Not as drawn", "dimensions overlap"),
    USUAL: ("Only with a reason", "a usual minimum or maximum is not kept"),
    "": ("Yes, as far as checked", ""),
}
MET_BY_SLICES = "met by slices"  # which have no pressure at the ends of rollers
SHOULDERS = "Shoulders of races"
NOTED = {  # shapes that do not fit, judged by notes alone: what, limit, grade, whether it is broken
    "overlapping-dimensions": ("Cage dimensions", "no overlap", BUILD, True),
    "truncated-contact": (SHOULDERS, "not cut off", DANGER, True),
    "shoulder-not-given": (SHOULDERS, "not cut off", DANGER, False),
}
FIRST = 8  # results on the first page


@dataclass(frozen=True)
class Check:
    """A number against its limit."""

    what: str
    value: Cell = ""
    limit: str = ""
    source: str = ""  # of the limit
    share: Cell = ""
    used: float = 0.0  # share as a number [-], zero where there is none
    verdict: str = NOT_CHECKED
    grade: str = DANGER  # of its limit
    side: str = AT_MOST
    place: str = ""  # of the finding
    code: str = ""
    meaning: str = ""  # what follows where it is not kept
    action: str = ""  # what keeps it
    keys: str = ""  # of the case that do

    @property
    def broken(self) -> bool:
        """Whether its limit is not kept."""
        return self.verdict in BROKEN.values()

    @property
    def unchecked(self) -> bool:
        """Whether it has no verdict."""
        return self.verdict == NOT_CHECKED

    @property
    def urgent(self) -> bool:
        """Whether it has no limit here, and must be compared with one before the bearing is used."""
        return self.unchecked and self.code == YIELD_STRESS.code

    @property
    def rank(self) -> tuple[bool, int, float]:
        """Limits that are not kept first, the worst grade before others; last what was not checked."""
        grade = WORST_FIRST.index(self.grade) if self.broken else len(WORST_FIRST)
        return self.unchecked, grade, -self.used


def text_of(number: Number) -> str:
    """A number with its unit."""
    return f"{number.text} {printed(number.unit)}".strip()


def used(check: Check) -> str:
    """How much of a limit is used; of one from below, how many times the value is of it."""
    if check.side == AT_LEAST and check.used:
        usual = "usual " if check.grade == USUAL else ""
        return f"{1 / check.used:.3g} times the {usual}minimum"
    return f"{check.share.text} % of the limit" if isinstance(check.share, Number) else ""


@once
def ranked(reader: Reader) -> tuple[Check, ...]:
    """Every check, the nearest to its limit first; what was not checked last."""
    return tuple(sorted((*_of_findings(reader), *_noted(reader)), key=lambda each: each.rank))


def judged(reader: Reader) -> tuple[str, str]:
    """Whether the bearing can be used, and why not."""
    unmet = [check for check in ranked(reader) if check.broken]
    broken = {check.grade for check in unmet}
    if reader.notes(DANGER) and DANGER not in broken:
        return "No", "see the dangers"
    if {check.code for check in unmet if check.grade == DANGER} == {REQUIRED_LIFE.code}:
        return "No", "the required life is not reached"
    worst = next((each for each in WORST_FIRST if each in broken), "")
    (answer, why), further = JUDGED[worst], BUILD in broken and worst in (DANGER, OUTSIDE)
    return answer, f"{why}; {JUDGED[BUILD][1]}" if further else why


def verdict(reader: Reader, code: str) -> str:
    """Whether the limit of a code is kept; empty where nothing was judged by it."""
    found = [record for record in reader.findings if record.code == code]
    return gravest(found).verdict if found else ""


def missed_at_low_end(reader: Reader) -> bool:
    """Whether the required life is reached, but not by the low end of the range of the life."""
    span, code = effects.span(reader), REQUIRED_LIFE.code
    met = [record for record in reader.findings if record.code == code and record.verdict == MET]
    return bool(span and met and span.squares[0] * met[0].value < (met[0].limit or 0.0))


def first_and_further(reader: Reader) -> tuple[tuple[Check, ...], tuple[Check, ...]]:
    """The results of the first page, one of each code, with the life before others; the rest of them."""
    checks = [check for check in ranked(reader) if check.code not in (REQUIRED_LIFE.code, SHORT_LIFE.code)
              or (check.code == SHORT_LIFE.code and check.broken)]  # fmt: skip
    codes: dict[str, Check] = {}
    for check in sorted(checks, key=lambda each: (not each.broken, not each.urgent, each.rank)):
        codes.setdefault(check.code, check)
    first = [*_life(reader), *codes.values()][:FIRST]
    return tuple(first), tuple(check for check in checks if check not in first)


def _life(reader: Reader) -> Iterator[Check]:
    """The life of the case against the required one."""
    life = next((each for each in lives(reader) if each.chosen), None)
    if life is None:
        return
    none = Check("", limit="not given", source=REQUIRED_LIFE.source)
    required = next((each for each in ranked(reader) if each.code == REQUIRED_LIFE.code), none)
    yield replace(required, what=life.name, value=life.hours or life.turns, code=REQUIRED_LIFE.code)


def _of_findings(reader: Reader) -> Iterator[Check]:
    """A check for every finding; of one code and place, of that to act on first."""
    groups: dict[tuple[str, str], list[Record]] = {}
    for record in reader.findings:
        if record.broken or not of_code(record.code, record.grade).of_model:
            groups.setdefault((record.code, record.place), []).append(record)
    for records in groups.values():
        yield _check(reader, gravest(records))


def _check(reader: Reader, record: Record) -> Check:
    finding, at = of_code(record.code, record.grade), f"findings/{reader.findings.index(record)}"
    what = ", ".join(filter(None, (finding.label[0].upper() + finding.label[1:], record.place)))
    value = reader.of_attribute(f"{at}/value", finding.unit, finding.shown, ",.4g")
    if record.verdict == NOT_CHECKED:
        return Check(what, value, place=record.place, code=record.code)
    limit = reader.of_attribute(f"{at}/limit", finding.unit, finding.shown, ",.4g")
    broken, share = record.broken, record.share or 0.0
    preload = broken and record.code == CLEARANCE.code  # which may be intended
    at_ends = record.code == CONTACT_PRESSURE.code and not broken and bool(PEAK_AT_ENDS & reader.codes)
    return Check(
        what,
        value,
        f"{record.side} {text_of(limit)}",
        record.source,
        "" if record.share is None else reader.of_attribute(f"{at}/share", "", "%", ",.0f"),
        share,
        "preload" if preload else _verdict(record, at_ends),
        record.grade,
        record.side,
        record.place,
        record.code,
        units_in_words(finding.meaning) if broken else "",
        units_in_words(finding.action.format(share=share)) if broken else "",
        settings(dict(finding.keys)) if broken else "",
    )


def _verdict(record: Record, at_ends: bool) -> str:
    if record.broken:
        return BROKEN[record.grade, record.side]
    return MET_BY_SLICES if at_ends else "met"


def _noted(reader: Reader) -> Iterator[Check]:
    for code, (what, limit, grade, broken) in NOTED.items():
        if code in reader.codes:
            verdict = BROKEN[grade, AT_MOST] if broken else NOT_CHECKED
            note = next(each["text"] for each in reader.attributes["notes"] if each["code"] == code)
            yield Check(
                what, "", limit, verdict=verdict, grade=grade, code=code, meaning=units_in_words(note)
            )
