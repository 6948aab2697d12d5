"""Two results beside each other: a part of a report, and text."""

from collections.abc import Iterator
from dataclasses import replace
from math import isnan
from typing import Any

from rich.console import RenderableType
from rich.text import Text

from flexbearing.case.declarations import by_path
from flexbearing.case.differing import differing
from flexbearing.differences.compared import Compared, Differing, compared
from flexbearing.findings import of_code
from flexbearing.printable import excerpt
from flexbearing.report.figure import COLOURS, Figure
from flexbearing.report.html.document import Cell, Number, Table
from flexbearing.report.html.figures import around
from flexbearing.report.html.inputs import row_of_key
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import METRIC, NOTHING, Units, printed
from flexbearing.report.sections import plain, titled
from flexbearing.results import Result


def parts(one: Result, other: Result, units: Units) -> dict[str, Any]:
    """Parts of the report that compare two results; raises `BadResult` if the kinds of bearing differ."""
    found = compared(one, other)
    readers = Reader(one, units), Reader(other, units)
    return {
        "one": str(found.one),
        "other": str(found.other),
        "title": readers[1].attributes["title"],
        "keys": _keys(*readers),
        "figure": _loads(*readers),
        "outputs": _outputs(found, units),
    }


def sections(one: Result, other: Result) -> Iterator[RenderableType]:
    """Keys and limits that differ, outputs that differ, and what is known of their errors, as text."""
    found, keys = compared(one, other), _keys(Reader(one, METRIC), Reader(other, METRIC))
    yield Text(f"A  {found.one}\nB  {found.other}\n", style="bold")
    yield Text("Keys of the cases that differ" if keys.rows else "The cases have the same keys and values.")
    for key, *sides in keys.rows:
        texts = [plain(cell) for cell in sides]
        values = (excerpt(" ".join(filter(None, texts[place : place + 2]))) for place in (0, 2))
        yield Text(f"  {key}: {' | '.join(values)}")
    for each in found.findings:
        name = ", ".join(filter(None, (of_code(each.code, each.grade).label, each.place)))
        yield Text(f"Limit of {name} ({each.source}): {each.one or 'none'} | {each.other or 'none'}")
    yield Text("")
    if not found.outputs:
        yield Text("No output differs by more than its estimated error.")
    yield from titled("Outputs that differ by more than their estimated errors", _outputs(found, METRIC))
    if found.within_error:
        names = ", ".join(each.name for each in found.within_error)
        yield Text(f"Within the estimated errors of both: {names}.")
    if found.without_estimate:
        count = len(found.without_estimate)
        yield Text(
            f"{count} outputs have no estimate: of them every difference beyond rounding is shown. "
            "--json names them."
        )


def _outputs(found: Compared, units: Units) -> Table:
    head = ("output", "A", "B", "unit", "B - A [%]", "error of both")
    return Table(head, tuple(_row(each, units) for each in found.outputs), sortable=True)


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
