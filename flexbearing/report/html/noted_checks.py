"""Limits that the run judged by notes alone: shapes that do not fit into each other."""

from collections.abc import Iterator

from flexbearing.findings import DANGER
from flexbearing.findings.finding import AT_MOST
from flexbearing.report.html.check import BROKEN, BUILD, Check
from flexbearing.report.html.reader import Reader

_NOTED = {  # what, by the code of a note: limit, verdict, grade, what to do, who checks it
    "overlapping-dimensions": (
        "Dimensions of the cage", "no overlap", f"{BROKEN[BUILD, AT_MOST]}: see the note", BUILD,
        "correct the dimensions of the cage or of the ribs, which overlap", "",
    ),
    "truncated-contact": (
        "Contacts on the shoulders of races", "not cut off", f"{BROKEN[DANGER, AT_MOST]}: see the danger",
        DANGER, "", "",
    ),
    "shoulder-not-given": (
        "Contacts on the shoulders of races", "not cut off",
        "not checked: the height of the shoulders is not given, usual ones would cut contacts off",
        DANGER, "", "designer, with the height of the shoulders",
    ),
}  # fmt: skip


def checks(reader: Reader) -> Iterator[Check]:
    """A check for each of these notes."""
    for code, (what, limit, verdict, grade, do, who) in _NOTED.items():
        if code in reader.codes:
            yield Check(what, "", limit, verdict=verdict, grade=grade, do=do, who=who)
