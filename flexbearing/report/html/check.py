"""A number against its limit, with what follows where the limit is not kept."""

from dataclasses import dataclass

from flexbearing.findings import DANGER, OUTSIDE, USUAL
from flexbearing.findings.finding import AT_LEAST, AT_MOST
from flexbearing.report.html.document import Cell, Number
from flexbearing.report.html.units import printed

BUILD = "build"  # grade of dimensions that overlap
NOT_CHECKED = "not checked"
BROKEN = {
    (DANGER, AT_MOST): "EXCEEDED",
    (DANGER, AT_LEAST): "NOT MET",
    (OUTSIDE, AT_MOST): "OUTSIDE VALIDITY",
    (OUTSIDE, AT_LEAST): "OUTSIDE VALIDITY",
    (BUILD, AT_MOST): "CANNOT BE BUILT",
    (USUAL, AT_MOST): "ABOVE THE USUAL MAXIMUM",
    (USUAL, AT_LEAST): "BELOW THE USUAL MINIMUM",
}
MISSED = {AT_LEAST: "Below the usual minimum", AT_MOST: "Above the usual maximum"}  # usual limits, by side
WORST_FIRST = (DANGER, OUTSIDE, BUILD, USUAL)


@dataclass(frozen=True)
class Check:
    """A number against its limit, or what nobody has compared yet."""

    what: str
    value: Cell = ""
    limit: str = ""
    share: Cell = ""
    used: float = 0.0  # share as a number [-], zero where there is none
    verdict: str = NOT_CHECKED
    grade: str = DANGER  # of its limit
    side: str = AT_MOST
    place: str = ""  # of the finding
    urgent: bool = False  # has no limit here, and must be compared with one before the bearing is used
    do: str = ""  # what keeps a limit that is exceeded, or checks one that was not
    who: str = ""  # of what was not checked: who checks it, with what
    damaging: float = 0.0  # share of a limit of damage behind a usual one [-], zero where there is none

    @property
    def broken(self) -> bool:
        """Whether its limit is not kept."""
        return self.verdict.startswith(tuple(BROKEN.values()))

    @property
    def unchecked(self) -> bool:
        """Whether it has no verdict."""
        return self.verdict.startswith(NOT_CHECKED)

    @property
    def damage(self) -> float:
        """Share of its limit of damage [-], zero where it has none."""
        return self.used if self.grade == DANGER else self.damaging

    @property
    def rank(self) -> tuple[bool, int, float]:
        """Limits that are not kept first, the worst grade before others; last what was not checked."""
        grade = WORST_FIRST.index(self.grade) if self.broken else len(WORST_FIRST)
        return self.unchecked, grade, -self.used


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
    if check.side == AT_LEAST and check.used:
        usual = "usual " if check.grade == USUAL else ""
        return f"{1 / check.used:.3g} times the {usual}minimum"
    return f"{check.share.text} % of the limit" if isinstance(check.share, Number) else ""


def text_of(number: Number) -> str:
    """A number with its unit, for a sentence."""
    return f"{number.text} {printed(number.unit)}".strip()
