"""The report of a study: outputs over what was varied, duty cycles, every row."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import islice
from math import isnan
from typing import Any

from flexbearing.findings.row import RowFinding, by_sentence
from flexbearing.printable import excerpt, printable
from flexbearing.report.figure import COLOURS, Axis, Figure, Line
from flexbearing.report.html.document import Cell, Document, Table
from flexbearing.report.html.duty import duty_parts
from flexbearing.report.html.effects import name
from flexbearing.report.html.scatter import ScatterTables, scatter_parts
from flexbearing.report.html.table import ENDS, MOST_ROWS, NOT_COMPUTED, StudyColumn, StudyTable, words
from flexbearing.report.html.units import METRIC, Units, converted, printed, with_unit

LINES = 12  # of a figure at most; more are points
MOST_MESSAGES = 50  # of rows, and rows of each
FIGURES = 12  # that are shown; others on request
LONGEST = 40  # characters of a list that a cell shows
SHORT = 4  # lines that a legend names within a figure of usual height
CONVERGED, RATED, IDLE = "converged", "rated", "no damage"  # status of rows with an answer
_STYLES = ("solid", "dash", "dot")


def of_study(
    table: StudyTable,
    cycles: StudyTable | None,
    units: Units = METRIC,
    scatter: ScatterTables | None = None,
) -> Document:
    """Collect the report of a study."""
    shown, scatter = table.first(MOST_ROWS), None if table.to_come else scatter
    drawn = _drawn(shown, cycles, scatter, units)
    parts = {
        **_endings(table),
        "count": len(table.statuses),
        "file": table.place.name,
        "shown": len(shown),
        "varied": _varied(table, units),
        "figures": drawn[:FIGURES],
        "further_figures": drawn[FIGURES:],
        "duty": duty_parts(shown, cycles.first(MOST_ROWS), units) if cycles else None,
        "cycles": _rows(cycles.first(MOST_ROWS), units, "duty") if cycles and len(cycles) > 1 else None,
        "cycles_count": len(cycles) if cycles else 0,
        "scatter": scatter_parts(scatter, units) if scatter else None,
        "rows": _rows(shown, units, "rows"),
    }
    download = (f"{table.place.stem}.csv", table.text) if table.text else None
    return Document("study.html.j2", f"Study: {printable(table.name)}", parts, download)


def _drawn(
    table: StudyTable, cycles: StudyTable | None, scatter: ScatterTables | None, units: Units
) -> list[Figure]:
    """A figure for each output over the first key; of duty cycles for each life; none of a sample.

    The rows of a duty cycle change together: their keys are no axes.
    """
    drawn = table if cycles is None else cycles.first(MOST_ROWS)
    if scatter is not None or not drawn.axes:
        return []
    axis = drawn.axes[0]
    families = _families(drawn, axis, units)
    outputs = [output for output in drawn.outputs if len(output.distinct) > 1]
    return [_figure(drawn, axis, output, families, units, f"over-{place}")
            for place, output in enumerate(outputs)]  # fmt: skip


def _endings(table: StudyTable) -> dict[str, Any]:
    """How many rows have a result, and why others have none; findings of those that do."""
    failed: dict[str, list[int]] = {}
    noted: list[tuple[int, RowFinding]] = []
    ends = zip(table.statuses, table.messages, table.findings, strict=True)
    for row, (status, message, findings) in enumerate(ends, 1):
        if status in (CONVERGED, RATED):
            noted += ((row, each) for each in findings)
        elif status not in (IDLE, NOT_COMPUTED):
            failed.setdefault(f"{status}: {message}", []).append(row)
    idle = table.statuses.count(IDLE)
    return {
        "converged": len(table.statuses) - sum(map(len, failed.values())) - table.to_come - idle,
        "idle": idle,
        "to_come": table.to_come,
        "failed": [*_by_message(failed)],
        "noted": [*_by_message(dict(by_sentence(noted)))],
    }


def _by_message(alike: Mapping[str, list[int]]) -> Iterator[str]:
    """The first messages, each with its first rows."""
    for message, numbers in islice(alike.items(), MOST_MESSAGES):
        shown = ", ".join(map(str, numbers[:MOST_MESSAGES]))
        more = f" and {len(numbers) - MOST_MESSAGES} more" if len(numbers) > MOST_MESSAGES else ""
        yield f"row{'s' if len(numbers) > 1 else ''} {shown}{more}: {printable(message)}"
    if len(alike) > MOST_MESSAGES:
        yield f"{len(alike) - MOST_MESSAGES} further messages, in the table"


def _varied(table: StudyTable, units: Units) -> Table:
    """Every key with its values."""
    rows: list[tuple[Cell, ...]] = []
    for column in (column for column in table.columns if column.varied):
        values = column.distinct
        shown = ", ".join(_text(column, text, units) for text in values[:LINES])
        more = f" and {len(values) - LINES} more" if len(values) > LINES else ""
        rows.append((column.name, name(column.name), shown + more, printed(units.of(column.unit))))
    return Table(("key", "meaning", "values", "unit"), tuple(rows))


def _text(column: StudyColumn, text: str, units: Units) -> str:
    if column.numbers is None:
        return excerpt(text, LONGEST) if column.listed else printable(text)
    return units.number(float(text) if text else None, column.unit, column.unit, ".5g", "").text


def _families(table: StudyTable, axis: StudyColumn, units: Units) -> dict[str, list[int]]:
    """Rows of each line: those that have all other keys in common; one of all, where there are too many.

    A key that changes with the axis parts no lines.
    """
    others = [
        column
        for column in table.axes
        if len(set(zip(axis.texts, column.texts, strict=True))) > len(axis.distinct)
    ]
    lines: dict[str, list[int]] = {}
    for row in range(len(table)):
        label = ", ".join(_named(column, row, units) for column in others)
        lines.setdefault(label, []).append(row)
    return lines if len(lines) <= LINES else {"": list(range(len(table)))}


def _named(column: StudyColumn, row: int, units: Units) -> str:
    """A key in words with its value: "radial load 5000 N"."""
    value = f"{_text(column, column.texts[row], units)} {printed(units.of(column.unit))}"
    return f"{name(column.name)} {value}".strip()


def _figure(
    table: StudyTable,
    axis: StudyColumn,
    output: StudyColumn,
    families: dict[str, list[int]],
    units: Units,
    element: str,
) -> Figure:
    """An output over a key, a line for each family; points where families are too many."""
    joined = len(families) > 1 or len(table.axes) == 1
    lines = []
    for place, (label, rows) in enumerate(families.items()):
        ordered = sorted(rows, key=places.__getitem__) if (places := axis.numbers) else rows
        shown = printable(label)
        lines.append(Line(
            [_value(axis, row, units) for row in ordered], [_value(output, row, units) for row in ordered],
            shown, COLOURS[place % len(COLOURS)],
            _STYLES[place // len(COLOURS) % len(_STYLES)] if joined else "", size=7.0,
            places=tuple(row + 1 for row in ordered), of=output.heading,
            hover=f"row %{{customdata}}<br>%{{x}}: %{{y}}<extra>{shown.replace('<', '&lt;')}</extra>",
        ))  # fmt: skip
    x, y = (
        Axis(with_unit(label, units.of(column.unit)), "category" if column.numbers is None else "linear")
        for label, column in ((name(axis.name), axis), (words(output.name), output))
    )
    title = f"{words(output.name)} over {name(axis.name)}"
    return Figure(element, title, x, y, tuple(lines), tall=len(families) > SHORT)


def _value(column: StudyColumn, row: int, units: Units) -> float | str | None:
    """A cell as a figure takes it."""
    if column.numbers is None:
        return printable(column.texts[row])
    value = column.numbers[row]
    if isnan(value) or abs(value) == float("inf"):
        return None
    return float(f"{converted(value, column.unit, units.of(column.unit)):.6g}")


def _rows(table: StudyTable, units: Units, place: str) -> Table:
    """Every row of a table, to be sorted by any column."""
    columns = [column for column in table.columns if column.name != ENDS[2]]  # the message has them in words
    head = ("row", *(with_unit(column.name.replace("_", " "), units.of(column.unit)) for column in columns))
    rows = tuple((str(row + 1), *_cells(columns, row, units, place)) for row in range(len(table)))
    return Table(head, rows, sortable=True)


def _cells(columns: Sequence[StudyColumn], row: int, units: Units, place: str) -> Iterator[Cell]:
    for column in columns:
        if column.numbers is None:
            yield _text(column, column.texts[row], units)
        else:
            value = column.numbers[row] if column.texts[row] else None
            yield units.number(value, column.unit, column.unit, ",.5g", f"{place}/{row}/{column.heading}")
