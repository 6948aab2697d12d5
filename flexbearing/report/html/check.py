"""A number against its limit, with what follows where the limit is not kept."""

from dataclasses import dataclass

from flexbearing.report.html.document import Cell, Number
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed

MOST, LEAST = "most", "least"  # a limit from above, from below
DAMAGE, VALIDITY, BUILD, AIM = "damage", "validity", "build", "aim"  # what a limit is one of, the worst first
NOT_CHECKED = "not checked"
_BROKEN = {
    (DAMAGE, MOST): "EXCEEDED",
    (DAMAGE, LEAST): "NOT MET",
    (VALIDITY, MOST): "OUTSIDE VALIDITY",
    (VALIDITY, LEAST): "OUTSIDE VALIDITY",
    (BUILD, MOST): "CANNOT BE BUILT",
    (AIM, MOST): "ABOVE THE USUAL MAXIMUM",
    (AIM, LEAST): "BELOW THE USUAL MINIMUM",
}
CANNOT_BE_BUILT = _BROKEN[BUILD, MOST]
MISSED = {LEAST: "Below the usual minimum", MOST: "Above the usual maximum"}  # usual limits, by their side
_WORST_FIRST = (DAMAGE, VALIDITY, BUILD, AIM)


@dataclass(frozen=True)
class Limit:
    """A limit from above or from below."""

    value: float  # in the unit of the place of what it limits
    side: str  # MOST or LEAST
    words: str
    grade: str = DAMAGE


@dataclass(frozen=True)
class Check:
    """A number against its limit, or what nobody has compared yet."""

    what: str
    value: Cell = ""
    limit: str = ""
    share: Cell = ""
    used: float = 0.0  # share as a number [-], zero where there is none
    verdict: str = NOT_CHECKED
    grade: str = DAMAGE  # of its limit
    side: str = MOST
    urgent: bool = False  # has no limit here, and must be compared with one before the bearing is used
    do: str = ""  # what keeps a limit that is exceeded, or checks one that was not
    who: str = ""  # of what was not checked: who checks it, with what
    damaging: float = 0.0  # share of a limit of damage behind a usual one [-], zero where there is none

    @property
    def broken(self) -> bool:
        """Whether its limit is not kept."""
        return self.verdict.startswith(tuple(_BROKEN.values()))

    @property
    def unchecked(self) -> bool:
        """Whether it has no verdict."""
        return self.verdict.startswith(NOT_CHECKED)

    @property
    def damage(self) -> float:
        """Share of its limit of damage [-], zero where it has none."""
        return self.used if self.grade == DAMAGE else self.damaging

    @property
    def rank(self) -> tuple[bool, int, float]:
        """Limits that are not kept first, the worst grade before others; last what was not checked."""
        grade = _WORST_FIRST.index(self.grade) if self.broken else len(_WORST_FIRST)
        return self.unchecked, grade, -self.used


def against(reader: Reader, what: str, value: Number, number: float | None, limit: Limit) -> Check:
    """A number against a limit in the unit of its place in the file."""
    if number is None:
        return unchecked(what, "no number", "the author of the case: see the notes", value)
    met = number <= limit.value if limit.side == MOST else number >= limit.value
    used = number / limit.value if limit.side == MOST else limit.value / number if number else 0.0
    of = f"share/{limit.side}/{float(limit.value)!r}/{value.of}"
    share = reader.units.number(100 * used, "%", "%", ",.0f", of)
    verdict = "met" if met else _BROKEN[limit.grade, limit.side]
    return Check(what, value, limit.words, share, used, verdict, limit.grade, limit.side)


def unchecked(what: str, why: str, who: str, value: Cell = "", do: str = "") -> Check:
    """What has no verdict: why, and who gives one."""
    return Check(what, value, verdict=f"{NOT_CHECKED}: {why}", who=who, do=do)


def one(check: Check) -> str:
    """A limit with its value, or that it is not met."""
    if isinstance(check.value, str):
        return f"{check.what} (required: {check.limit})"
    return f"{check.what}: {text_of(check.value)}, {check.limit}"


def used(check: Check) -> str:
    """How much of a limit is used; of one from below, how many times the value is of it."""
    if check.side == LEAST and check.used:
        usual = "usual " if check.grade == AIM else ""
        return f"{1 / check.used:.3g} times the {usual}minimum"
    return f"{check.share.text} % of the limit" if isinstance(check.share, Number) else ""


def text_of(number: Number) -> str:
    """A number with its unit, for a sentence."""
    return f"{number.text} {printed(number.unit)}".strip()
