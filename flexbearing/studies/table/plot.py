"""What a study draws of its table."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING, Any, Protocol

from flexbearing.case import BadCase
from flexbearing.studies.file import Axis
from flexbearing.studies.file.read import ENDS
from flexbearing.studies.table.column import Column
from flexbearing.studies.table.marks import Mark

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from flexbearing.report.studies.lines_figure import Line, Printed

MOST = 6  # outputs that are drawn without being named


class Table(Protocol):
    """What is drawn of a `flexbearing.studies.table.Table`."""

    @property
    def name(self) -> str:
        """Of the study."""
        ...

    @property
    def columns(self) -> tuple[Column, ...]:
        """Keys and outputs."""
        ...

    @property
    def axes(self) -> tuple[Axis, ...]:
        """Crossed keys."""
        ...

    @property
    def arrays(self) -> tuple[Column, ...]:
        """Outputs roller by roller."""
        ...

    def __getitem__(self, heading: str) -> Column: ...

    def __len__(self) -> int: ...


@dataclass(frozen=True)
class Plot:
    """Names of the columns that are drawn."""

    x: str
    lines: str | None  # key with a line for each of its values, beside those of other axes
    y: tuple[str, ...]
    rigid: tuple[str | None, ...]  # the same between rigid raceways
    marks: tuple[Mark, ...] = ()


def drawn_over_first_key(table: Table, outputs: Sequence[str]) -> "Figure":
    """Draw outputs over the first key that varies, without names the first ones.

    Raises
    ------
    BadCase
        where no key varies
    """
    varied = [column.name for column in table.columns if column.varied and len({*column.values}) > 1]
    named = [table[output].name for output in outputs] or [
        column.name for column in table.columns if not column.varied and column.name not in ENDS
    ][:MOST]
    if not varied:
        raise BadCase(f"{table.name}: no key varies, so there is nothing to draw outputs over.")
    return draw(table, Plot(varied[0], None, tuple(named), (None,) * len(named)))


def draw(table: Table, plot: Plot) -> "Figure":
    """Draw outputs of a table."""
    from flexbearing.report.studies.lines_figure import Panel, draw_lines

    panels: list[Panel] = [
        Panel(
            table[y].heading,
            tuple(_lines(table, plot, y, rigid)),
            tuple(_printed(plot, y)),
            linear=table[y] in table.arrays,
        )
        for y, rigid in zip(plot.y, plot.rigid, strict=True)
    ]
    return draw_lines(table.name, table[plot.x].heading, panels)


def _printed(plot: Plot, y: str) -> Iterator["Printed"]:
    from flexbearing.report.studies.lines_figure import Printed

    for mark in plot.marks:
        if mark.y == y:
            yield Printed(mark.label, mark.low, mark.high, mark.x)


def _lines(table: Table, plot: Plot, y: str, rigid: str | None) -> Iterator["Line"]:
    from flexbearing.report.studies.lines_figure import Line

    if table[plot.x] in table.arrays:
        yield from _rows_of_rollers(table, plot, y, rigid)
        return
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


def _rows_of_rollers(table: Table, plot: Plot, y: str, rigid: str | None) -> Iterator["Line"]:
    """A line for every row over the rollers, angles from -180 to 180 deg."""
    from flexbearing.report.studies.lines_figure import Line

    keys = [column for column in table.columns if column.varied]
    for row, places in enumerate(table[plot.x].values):
        if table[plot.x].unit == "deg":
            places = [(place + 180) % 360 - 180 for place in places]
        order = sorted(range(len(places)), key=places.__getitem__)
        values, of_rigid = table[y].values[row], None if rigid is None else table[rigid].values[row]
        yield Line(
            label=_label(keys, _place(keys, row)),
            x=[places[at] for at in order],
            y=[values[at] for at in order],
            rigid=None if of_rigid is None else [of_rigid[at] for at in order],
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
        value if column.name == "title" else f"{_words(column)} {_in_words(value)} {column.unit}".strip()
        for column, value in values
    )


def _words(column: Column) -> str:
    return column.name.rpartition(".")[2].replace("_", " ")


def _in_words(value: Any) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)
