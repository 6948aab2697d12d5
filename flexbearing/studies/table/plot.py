"""What a study draws of its table."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING, Any

from flexbearing.studies.table.column import Column
from flexbearing.studies.table.table import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from flexbearing.report.studies.lines_figure import Line


@dataclass(frozen=True)
class Plot:
    """Names of the columns that are drawn."""

    x: str
    lines: str | None  # key with a line for each of its values, beside those of other axes
    y: tuple[str, ...]
    rigid: tuple[str | None, ...]  # the same between rigid raceways


def draw(table: Table, plot: Plot) -> "Figure":
    """Draw outputs of a table.

    Parameters
    ----------
    table : Table
        with the columns of the plot
    plot : Plot
        what is drawn

    Returns
    -------
    matplotlib.figure.Figure
    """
    from flexbearing.report.studies.lines_figure import Panel, draw_lines

    panels: list[Panel] = [
        Panel(table[y].heading, tuple(_lines(table, plot, y, rigid)))
        for y, rigid in zip(plot.y, plot.rigid, strict=True)
    ]
    return draw_lines(table.name, table[plot.x].heading, panels)


def _lines(table: Table, plot: Plot, y: str, rigid: str | None) -> Iterator["Line"]:
    from flexbearing.report.studies.lines_figure import Line

    keys = [table[key] for key in _grouping(table, plot)]
    x, varied = table[plot.x], table[plot.x].varied
    rows = sorted(range(len(table)), key=lambda row: (_place(keys, row), x.values[row]))
    for place, group in groupby(rows, key=lambda row: _place(keys, row)):
        places = list(group)
        yield Line(
            label=_label(keys, place),
            x=[x.values[row] for row in places],
            y=[table[y].values[row] for row in places],
            rigid=None if rigid is None else [table[rigid].values[row] for row in places],
            joined=varied,
        )


def _grouping(table: Table, plot: Plot) -> list[str]:
    """Keys with a line for each of their values: that of `lines`, and those that are crossed with x."""
    crossed = [
        key
        for axis in table.axes
        if table[plot.x].varied and plot.x not in axis.keys and len(axis.rows) > 1
        for key in axis.keys
    ]
    return list(dict.fromkeys([*([plot.lines] if plot.lines else []), *crossed]))


def _place(keys: Sequence[Column], row: int) -> tuple[Any, ...]:
    return tuple(column.values[row] for column in keys)


def _label(keys: Sequence[Column], place: tuple[Any, ...]) -> str:
    values = zip(keys, place, strict=True)
    return ", ".join(
        f"{column.name.rpartition('.')[2].replace('_', ' ')} {value:g} {column.unit}".strip()
        if isinstance(value, float)
        else f"{column.name.rpartition('.')[2].replace('_', ' ')} {value}"
        for column, value in values
    )
