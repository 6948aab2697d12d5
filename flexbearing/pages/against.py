"""The part of a report that compares two results."""

from math import isnan
from typing import Any

from flexbearing.case.declarations import by_path
from flexbearing.case.differing import differing
from flexbearing.differences.compared import Differing, compared
from flexbearing.report.html.document import Cell, Figure, Number, Table
from flexbearing.report.html.figures import COLOURS, around
from flexbearing.report.html.inputs import row_of_key
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import NOTHING, Units, printed
from flexbearing.results import Result


def parts(one: Result, other: Result, units: Units) -> dict[str, Any]:
    """Parts of the report that compare two results.

    Raises
    ------
    BadResult
        if the kinds of bearing differ
    """
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
    traces = []
    for place, (figure, reader) in enumerate(zip(both, (one, other), strict=True)):
        for trace in figure.traces if figure else ():
            if trace["meta"].startswith(f"{reader.last}/"):
                colour = {"color": COLOURS[place]}
                dash = "solid" if trace["meta"].split("/")[1] == names[0] else "dot"
                kept = {"name": f"{'AB'[place]}: {trace['name']}", "legendgroup": "AB"[place]}
                marker = {**trace["marker"], **colour}
                meta = ("" if place == 0 else "other/") + trace["meta"]
                traces.append(
                    {**trace, **kept, "line": {**colour, "dash": dash}, "marker": marker, "meta": meta}
                )
    if both[0] is None:
        return None
    return Figure("against-loads", f"{title} of A and B, last end states", tuple(traces), both[0].layout)


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
