"""What a duty cycle does: lives against the required one, damage of each row."""

from collections.abc import Iterator
from typing import Any

from flexbearing.report.figure import Axis, Bars, Figure
from flexbearing.report.html.document import Cell, Number, Table
from flexbearing.report.html.effects import name
from flexbearing.report.html.table import ENDS, SHARES, StudyTable, words
from flexbearing.report.html.units import Units, printed, with_unit

DAMAGE, REQUIRED, LIFE = "damage_share", "required_life", "life"
MOST = 40  # rows that a figure shows, those with the largest share
_KEYS = 3  # that name a row


def duty_parts(table: StudyTable, cycles: StudyTable, units: Units) -> dict[str, Any]:
    """Parts of the report: one cycle as a list of its numbers, the shares of its rows, the worst of them."""
    one = len(cycles) == 1
    shares = table.column(DAMAGE) if one else None
    numbers = (shares.numbers if shares else None) or ()
    ordered = sorted(range(len(numbers)), key=lambda row: -numbers[row])
    return {
        "lives": _lives(cycles, units) if one else None,
        "over_required": _over_required(cycles, units) if one else None,
        "rows": _row_table(table, ordered[:MOST], units) if ordered else None,
        "figure": _figure(table, ordered[:MOST]) if ordered else None,
        "left": max(0, len(ordered) - MOST),
        "worst": str(ordered[0] + 1) if ordered else "",
        "worst_share": _number(table, DAMAGE, ordered[0], units, "rows") if ordered else None,
    }


def _number(table: StudyTable, column: str, row: int, units: Units, place: str) -> Number | None:
    found = table.column(column)
    if found is None or not found.numbers or not found.texts[row]:
        return None
    return units.number(found.numbers[row], found.unit, found.unit, ",.4g", f"{place}/{row}/{found.heading}")


def _over_required(cycles: StudyTable, units: Units) -> Number | None:
    """Life over the required one."""
    pair = [_number(cycles, column, 0, units, "duty") for column in (LIFE, REQUIRED)]
    if pair[0] is None or pair[1] is None:
        return None
    sizes = [
        found.numbers[0] for each in (LIFE, REQUIRED) if (found := cycles.column(each)) and found.numbers
    ]
    return units.number(sizes[0] / sizes[1], "", "", ".3g", f"ratio/{pair[0].of}:{pair[1].of}")


def _lives(cycles: StudyTable, units: Units) -> Table:
    """Numbers of the only cycle, those that are zero left out."""
    rows: list[tuple[Cell, ...]] = []
    for column in (column for column in cycles.columns if column.name not in ENDS):
        number = _number(cycles, column.name, 0, units, "duty") if column.numbers else None
        if column.numbers is None and column.texts[0]:
            rows.append((words(column.name), column.texts[0], ""))
        elif number is not None and number.size:
            rows.append((words(column.name), number, printed(number.unit)))
    return Table(("of the cycle", "value", "unit"), tuple(rows))


def _row_table(table: StudyTable, ordered: list[int], units: Units) -> Table:
    """Shares of the rows, the largest damage first, with what distinguishes them."""
    keys = table.axes[:_KEYS]
    columns = [*(column.name for column in keys), *SHARES, DAMAGE]
    known = [column for each in columns if (column := table.column(each))]
    head = [
        with_unit(name(column.name) if column in keys else words(column.name), units.of(column.unit))
        for column in known
    ]
    return Table(("row", *head), tuple((str(row + 1), *_cells(table, known, row, units)) for row in ordered))


def _cells(table: StudyTable, columns: list[Any], row: int, units: Units) -> Iterator[Cell]:
    for column in columns:
        yield _number(table, column.name, row, units, "rows") or column.texts[row]


def _figure(table: StudyTable, ordered: list[int]) -> Figure:
    """Damage share of each row as a bar."""
    shares = table.column(DAMAGE)
    assert shares is not None
    assert shares.numbers is not None
    bars = Bars(
        [f"row {row + 1}" for row in ordered],
        [float(f"{shares.numbers[row]:.6g}") for row in ordered],
        places=tuple(row + 1 for row in ordered),
        hover="%{x}: %{y} %<extra></extra>",
        of=shares.heading,
    )
    x, y = Axis(scale="category"), Axis("damage share [%]")
    return Figure("damage", "damage share of each row", x, y, (bars,))
