"""The section of a report that compares two results."""

from collections.abc import Iterator
from math import isnan

from flexbearing.case.declarations import by_path
from flexbearing.case.differing import differing
from flexbearing.differences.compared import Compared, Differing, compared
from flexbearing.report.html.document import Block, Cell, Figure, Number, Section, Table, Words
from flexbearing.report.html.figures import COLOURS, around
from flexbearing.report.html.inputs import row_of_key
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import NOTHING, Units, printed
from flexbearing.results import Result


def section(one: Result, other: Result, units: Units) -> Section:
    """Compare two results in a section of a report.

    Raises
    ------
    BadResult
        if the kinds of bearing differ
    """
    found = compared(one, other)
    readers = Reader(one, units), Reader(other, units)
    return Section("against", f"Against {other.stem}", tuple(_blocks(found, *readers)))


def _blocks(found: Compared, one: Reader, other: Reader) -> Iterator[Block]:
    yield Words((f"A is {found.one}, B is {found.other}: {other.attributes['title']}.",))
    yield from _keys(one, other)
    yield from _loads(one, other)
    if found.outputs:
        head = ("output", "A", "B", "unit", "B - A [%]", "error of both")
        rows = tuple(_row(each, one.units) for each in found.outputs)
        yield Table(
            "Outputs that differ by more than their estimated errors", head, rows, _NOTE, sortable=True
        )
    else:
        yield Words(("No output differs by more than its estimated error.",))
    if found.within_error:
        names = ", ".join(each.name for each in found.within_error)
        yield Words((f"Within the estimated errors of both: {names}.",))


_STIFF = {"N/m": "kN/mm"}  # outputs in SI, as people read them
_NOTE = "Without an estimated error every difference beyond rounding is shown."


def _keys(one: Reader, other: Reader) -> Iterator[Block]:
    """Keys of the cases that differ."""
    known = by_path(one.result.family.case())
    rows: list[tuple[Cell, ...]] = []
    for key, values in differing(one.attributes["case_si"], other.attributes["case_si"]).items():
        both = [
            (key, NOTHING, "", "") if value is None else row_of_key(reader, known.get(key), key, value, place)
            for reader, value, place in zip((one, other), values, ("case", "other/case"), strict=True)
        ]
        rows.append((key, both[0][1], both[0][2], both[1][1], both[1][2]))
    if rows:
        yield Table("Keys of the cases that differ", ("key", "A", "unit of A", "B", "unit of B"), tuple(rows))
    else:
        yield Words(("The cases have the same keys and values.",))


def _loads(one: Reader, other: Reader) -> Iterator[Figure]:
    """The first figure of the rolling elements, of the last end states of both."""
    elements = one.result.family.report().elements
    if elements is None or not (one.last and other.last):
        return
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
    if both[0] is not None:
        yield Figure(
            "against-loads",
            f"{title.capitalize()} of A and B, last end states.",
            tuple(traces),
            both[0].layout,
        )


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
