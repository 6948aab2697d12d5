"""The part of a report that compares two results."""

from dataclasses import replace
from math import isnan
from typing import Any

from flexbearing.case.declarations import by_path
from flexbearing.case.differing import differing
from flexbearing.differences.compared import Differing, compared
from flexbearing.report.figure import COLOURS, Figure
from flexbearing.report.html.document import Cell, Number, Table
from flexbearing.report.html.figures import around
from flexbearing.report.html.inputs import row_of_key
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import NOTHING, Units, printed
from flexbearing.results import Result


def parts(one: Result, other: Result, units: Units) -> dict[str, Any]:
    """Parts of the report that compare two results; raises `BadResult` if the kinds of bearing differ."""
    found = compared(one, other)
    readers = Reader(one, units), Reader(other, units)
    head = ("output", "A", "B", "unit", "B - A [%]", "error of both")
    return {
        "one": str(found.one),
        "other": str(found.other),
        "title": readers[1].attributes["title"],
        "keys": _keys(*readers),
        "figure": _loads(*readers),
        "outputs": Table(head, tuple(_row(each, units) for each in found.outputs), sortable=True),
    }


_STIFF = {"N/m": "kN/mm"}  # outputs in SI, as people read them


def _keys(one: Reader, other: Reader) -> Table:
    """Keys of the cases that differ."""
    known = by_path(one.result.family.case())
    rows: list[tuple[Cell, ...]] = []
    for key, values in differing(one.attributes["case_si"], other.attributes["case_si"]).items():
        both = [
            (key, NOTHING, "", "") if value is None else row_of_key(reader, known.get(key), key, value, place)
            for reader, value, place in zip((one, other), values, ("case", "other/case"), strict=True)
        ]
        rows.append((key, both[0][1], both[0][2], both[1][1], both[1][2]))
    return Table(("key", "A", "unit of A", "B", "unit of B"), tuple(rows))


def _loads(one: Reader, other: Reader) -> Figure | None:
    """The first figure of the rolling elements, of the last end states of both."""
    elements = one.result.family.report().elements
    if elements is None or not (one.last and other.last):
        return None
    title, names = next(iter(elements.figures.items()))
    both = [around(reader, title, names, elements.azimuth) for reader in (one, other)]
    lines = [
        replace(
            line,
            name=f"{'AB'[place]}: {line.name}",
            group="AB"[place],
            colour=COLOURS[place],
            dash="solid" if line.of.split("/")[1] == names[0] else "dot",
            of=("" if place == 0 else "other/") + line.of,
        )
        for place, (figure, reader) in enumerate(zip(both, (one, other), strict=True))
        for line in (figure.lines if figure else ())
        if line.of.startswith(f"{reader.last}/")
    ]
    if (first := both[0]) is None:
        return None
    marks = tuple(item for item in first.items if item not in first.lines)
    items, of_both = (*lines, *marks), f"{title} of A and B, last end states"
    return Figure("against-loads", of_both, first.x, first.y, items)


def _row(each: Differing, units: Units) -> tuple[Cell, ...]:
    numbers = [
        _number(each, value, units, place) for value, place in ((each.one, ""), (each.other, "other/"))
    ]
    change = "" if isnan(each.change) or not each.one else f"{100 * each.change / abs(each.one):+.3g}"
    error = (
        ""
        if isnan(each.error)
        else units.number(each.error, each.unit, _STIFF.get(each.unit, each.unit), ".2g", "").text
    )
    return each.name, *numbers, printed(numbers[0].unit), change, error


def _number(each: Differing, value: float, units: Units, place: str) -> Number:
    unit = "" if each.unit == "1" else each.unit
    people = _STIFF.get(unit, unit)
    return units.number(value, unit, people, ",.5g", f"{place}outputs/{each.name} [{each.unit}]")
