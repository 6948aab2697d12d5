"""The report of a study: outputs over what was varied, duty cycles, every row."""

from collections.abc import Iterator
from itertools import islice
from math import isnan

from flexbearing.printable import excerpt, printable
from flexbearing.report.html.document import Block, Cell, Document, Figure, Items, Section, Table, Words
from flexbearing.report.html.figures import COLOURS
from flexbearing.report.html.scatter import ScatterTables, scatter_blocks
from flexbearing.report.html.table import NOT_COMPUTED, StudyColumn, StudyTable
from flexbearing.report.html.units import METRIC, NOTHING, Units, converted, printed, with_unit

LINES = 12  # of a figure at most; more are points
MOST_ROWS = 2000  # of a table that a browser still shows at once
MOST_MESSAGES = 50  # of rows, and rows of each
LONGEST = 40  # characters of a list that a cell shows
SHORT = 4  # lines that a legend names within a figure of usual height
CONVERGED, RATED = "converged", "rated"  # by its ratings alone
ANSWERED = CONVERGED, RATED, "no damage"  # of a row that is idle
_STYLES = ("solid", "dash", "dot")


def of_study(
    table: StudyTable,
    cycles: StudyTable | None,
    units: Units = METRIC,
    scatter: ScatterTables | None = None,
) -> Document:
    """Collect the report of a study."""
    shown, scatter = table.first(MOST_ROWS), None if table.to_come else scatter
    sections = [
        ("verdict", "Verdict", tuple(_verdict(table))),
        ("duty", "Life under the duty cycle", tuple(_cycles(cycles, units)) if cycles else ()),
        ("scatter", "Scatter of the outputs", tuple(scatter_blocks(scatter, units)) if scatter else ()),
        ("varied", "What was varied", tuple(_varied(table, units))),
        *((f"over-{number}", f"Over {axis.heading}", tuple(_over(shown, axis, units, number)))
          for number, axis in enumerate(shown.axes)),
        ("rows", "Every row", tuple(_every_row(table, shown, units))),
    ]  # fmt: skip
    kept = tuple(Section(name, title, blocks) for name, title, blocks in sections if blocks)
    subtitle = f"{len(table)} variants, from {table.place.name}"
    return Document(
        f"Study: {printable(table.name)}", subtitle, kept, (f"{table.place.stem}.csv", table.text)
    )


def _every_row(table: StudyTable, shown: StudyTable, units: Units) -> Iterator[Block]:
    """The rows; of a large table the first ones."""
    if len(shown) < len(table):
        words = (
            f"The first {len(shown)} of {len(table)} rows are shown, here and in the figures over the keys"
        )
        yield Words((f"{words}; the table that this page hands out has all.",))
    yield _rows(shown, units, "rows")


def _verdict(table: StudyTable) -> Iterator[Block]:
    """How many rows have a result, and why others have none; dangers of those that do."""
    columns = {column.name: column.texts for column in table.columns}
    ends = [
        (status, printable(message))
        for status, message in zip(columns["status"], columns["message"], strict=True)
    ]
    failed = [
        (row, f"{status}: {message}")
        for row, (status, message) in enumerate(ends, 1)
        if status not in (*ANSWERED, NOT_COMPUTED)
    ]
    noted = [
        (row, message)
        for row, (status, message) in enumerate(ends, 1)
        if message and status in (CONVERGED, RATED)
    ]
    idle = sum(status == "no damage" for status, _ in ends)
    converged = len(table) - len(failed) - table.to_come - idle
    words = f"{converged} of {len(table)} variants converged{f', {idle} are idle' if idle else ''}."
    partial = (
        f"The table is partial: {table.to_come} are not computed; the same study started again adds them."
    )
    yield Words(
        (words, *([partial] if table.to_come else [])), "danger" if failed or table.to_come else "good"
    )
    for title, rows in (("Rows without a result", failed), ("Noted", noted)):
        if rows:
            yield Items(title, tuple(_by_message(rows)), "danger")


def _by_message(rows: list[tuple[int, str]]) -> Iterator[str]:
    """The first messages, each once with its first rows."""
    alike: dict[str, list[int]] = {}
    for row, message in rows:
        alike.setdefault(message, []).append(row)
    for message, numbers in islice(alike.items(), MOST_MESSAGES):
        shown = ", ".join(map(str, numbers[:MOST_MESSAGES]))
        more = f" and {len(numbers) - MOST_MESSAGES} more" if len(numbers) > MOST_MESSAGES else ""
        yield f"row{'s' if len(numbers) > 1 else ''} {shown}{more}: {message}"
    if len(alike) > MOST_MESSAGES:
        yield f"{len(alike) - MOST_MESSAGES} further messages, in the table"


def _cycles(cycles: StudyTable, units: Units) -> Iterator[Block]:
    """Lives of the cycles, each a row."""
    rule = "the sum over its rows of the share of the revolutions over the life"
    yield Words((f"Damage adds up by the rule of Palmgren and Miner: 1/L of a cycle is {rule}.",))
    shown = cycles.first(MOST_ROWS)
    if len(shown) < len(cycles):
        yield Words((f"The first {len(shown)} duty cycles are shown; the table has all.",))
    yield _rows(shown, units, "duty")


def _varied(table: StudyTable, units: Units) -> Iterator[Block]:
    """Every key with its values, or their range."""
    rows: list[tuple[Cell, ...]] = []
    for column in (column for column in table.columns if column.varied):
        values = column.distinct
        shown = ", ".join(_text(column, text, units) for text in values[:LINES])
        more = f" and {len(values) - LINES} more" if len(values) > LINES else ""
        rows.append((column.name, shown + more, printed(units.of(column.unit)), str(len(values))))
    if rows:
        yield Table("Keys of the case", ("key", "values", "unit", "how many"), tuple(rows))
    else:
        yield Words(("No column of the table is a key of a case.",))


def _text(column: StudyColumn, text: str, units: Units) -> str:
    if column.numbers is None:
        return excerpt(text, LONGEST) if column.listed else printable(text)
    return units.number(float(text) if text else None, column.unit, column.unit, ".5g", "").text


def _over(table: StudyTable, axis: StudyColumn, units: Units, number: int) -> Iterator[Figure]:
    """A figure for every output that changes, over one key."""
    families = _families(table, axis, units)
    for place, output in enumerate(table.outputs):
        if len(output.distinct) > 1:
            yield _figure(table, axis, output, families, units, f"over-{number}-{place}")


def _families(table: StudyTable, axis: StudyColumn, units: Units) -> dict[str, list[int]]:
    """Rows of each line: those that have all other keys in common; one of all, where there are too many.

    A key that changes with the axis, such as the speed of the rows of a duty cycle, parts no lines.
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
    """A key with its value, in few words: "radial load 5000 N"."""
    name = column.name.rpartition(".")[2].replace("_", " ")
    return f"{name} {_text(column, column.texts[row], units)} {printed(units.of(column.unit))}".strip()


def _figure(
    table: StudyTable,
    axis: StudyColumn,
    output: StudyColumn,
    families: dict[str, list[int]],
    units: Units,
    name: str,
) -> Figure:
    """An output over a key, a line for each family; points where families are too many."""
    joined = len(families) > 1 or len(table.axes) == 1
    traces = []
    for place, (label, rows) in enumerate(families.items()):
        ordered = sorted(rows, key=places.__getitem__) if (places := axis.numbers) else rows
        shown = printable(label).replace("<", "&lt;")
        traces.append({
            "type": "scatter", "mode": "lines+markers" if joined else "markers", "name": shown,
            "x": [_value(axis, row, units) for row in ordered],
            "y": [_value(output, row, units) for row in ordered],
            "customdata": [row + 1 for row in ordered],
            "marker": {"size": 7},
            "line": {"color": COLOURS[place % len(COLOURS)],
                     "dash": _STYLES[place // len(COLOURS) % len(_STYLES)]},
            "hovertemplate": f"row %{{customdata}}<br>%{{x}}: %{{y}}<extra>{shown}</extra>",
            "meta": output.heading,
        })  # fmt: skip
    words = output.name.replace("_", " ")
    layout = {
        "xaxis": {"title": {"text": with_unit(axis.name, units.of(axis.unit))}},
        "yaxis": {"title": {"text": with_unit(words, units.of(output.unit))}},
        "showlegend": len(families) > 1,
        "legend": {"orientation": "h", "y": 1.02, "yanchor": "bottom", "x": 0, "font": {"size": 11}},
    }
    return Figure(name, f"{words} over {axis.name}.", tuple(traces), layout, tall=len(families) > SHORT)


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
    head = (
        "row",
        *(with_unit(column.name.replace("_", " "), units.of(column.unit)) for column in table.columns),
    )
    rows = tuple(
        (str(row + 1), *(_cell(column, row, units, place) for column in table.columns))
        for row in range(len(table))
    )
    return Table(
        f"Table {printable(table.name)}",
        head,
        rows,
        f"{NOTHING}: no number. A click on a heading sorts.",
        sortable=True,
    )


def _cell(column: StudyColumn, row: int, units: Units, place: str) -> Cell:
    if column.numbers is None:
        return _text(column, column.texts[row], units)
    value = column.numbers[row] if column.texts[row] else None
    return units.number(value, column.unit, column.unit, ",.5g", f"{place}/{row}/{column.heading}")
