"""The card of a result, made of what the first page of its report is made of."""

from collections.abc import Iterator
from textwrap import shorten

from flexbearing.quantities.attributes import GRADES
from flexbearing.report.card.bearing import loads, rigid, stiffness
from flexbearing.report.card.card import Card, Item, Line
from flexbearing.report.card.case import computed, uncertain
from flexbearing.report.card.verdict import dangers, lives, usable
from flexbearing.report.html import origin
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import METRIC
from flexbearing.results import Result

_LONGEST = 400  # characters of why there is no answer
_ANSWERS = {
    "usable": usable, "danger": dangers, "life": lives, "load": loads, "bearing": stiffness, "rigid": rigid,
    "uncertain": uncertain,
}  # fmt: skip


def of_result(result: Result) -> Card:
    """What was computed, whether it can be used, and its main numbers; of no solution, why there is none."""
    reader = Reader(result, METRIC)
    solved = reader.attributes["status"] == "converged" and bool(reader.blocks)
    known = {"": computed, **(_ANSWERS if solved else {"danger": dangers}), "notes": _notes}
    lines = ((label, tuple(items(reader))) for label, items in known.items())
    return Card(
        reader.attributes["title"] or result.stem,
        tuple(Line(label, items) for label, items in lines if items),
        "" if solved else shorten(origin.ending(reader), _LONGEST, placeholder=" ..."),
    )


def _notes(reader: Reader) -> Iterator[Item]:
    """How many notes of each grade there are."""
    counts = {grade: len(reader.notes(grade)) for grade in GRADES}
    words = ", ".join(f"{count} {grade}" for grade, count in counts.items() if count)
    yield Item(words or "none")
