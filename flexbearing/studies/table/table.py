"""The table of a study, a row for every variant, and what is drawn of it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import count, groupby
from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.case import BadCase
from flexbearing.findings.row import written
from flexbearing.outputs.names import ROLLER
from flexbearing.printable import excerpt
from flexbearing.report.figure import (
    COLOURS,
    DARK,
    GREY,
    Axis as DrawnAxis,
    Figure,
    Line as DrawnLine,
    Rule,
    is_wide,
)
from flexbearing.report.panels import picture
from flexbearing.studies.file import Axis
from flexbearing.studies.file.read import ENDS
from flexbearing.studies.plan import Row
from flexbearing.studies.plan.task import ANSWERED

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.figure import Figure as Page

Arrays = dict[str, tuple[tuple[str, ...], np.ndarray, dict[str, Any]]]  # by name: axes, values, attributes


@dataclass(frozen=True)
class Column:
    """A column with its unit."""

    name: str
    unit: str  # empty for texts and plain numbers
    values: Sequence[Any]  # row by row; NaN where there is no number
    varied: bool = False  # whether it is a key of the case

    @property
    def heading(self) -> str:
        """Name and unit, "life [h]"."""
        return f"{self.name} [{self.unit}]" if self.unit else self.name


def ends(rows: Sequence[Row]) -> tuple[Column, ...]:
    """Columns that say how each variant ended, and why some were not solved beside others."""
    own_runs = tuple(row.own_run for row in rows)
    return (
        *((Column("own_run", "", own_runs),) if any(own_runs) else ()),
        Column("status", "", tuple(row.status for row in rows)),
        Column("message", "", tuple(row.why for row in rows)),
        Column("findings", "", tuple(written(row.findings) for row in rows)),
        Column("seconds", "", tuple(row.seconds for row in rows)),
    )


@dataclass(frozen=True)
class Table:
    """What a study found."""

    name: str
    columns: tuple[Column, ...]  # keys, outputs, then status, message, findings and seconds
    axes: tuple[Axis, ...]  # crossed, the last one changes fastest
    cycles: "Table | None" = None  # lives under the duty cycle, where there is one
    arrays: tuple[Column, ...] = ()  # outputs roller by roller, a tuple of numbers in each row
    scatter: "tuple[Table, ...]" = ()  # of a sampled study: how outputs scatter, shares of keys, histograms
    missing: tuple[str, ...] = ()  # from the prediction of this scatter by derivatives, in words
    complaints: tuple[str, ...] = ()  # of workers about the cache of rings: no row is worse for it

    def __getitem__(self, heading: str) -> Column:
        """Column by its name or heading; KeyError names those that there are."""
        for column in (*self.columns, *self.arrays):
            if heading in (column.name, column.heading):
                return column
        raise KeyError(f"{heading}: there are {', '.join(column.heading for column in self.columns)}")

    def __len__(self) -> int:
        return len(self.columns[0].values)

    @property
    def rows(self) -> list[dict[str, Any]]:
        """Every row by the headings of the columns."""
        headings = [column.heading for column in self.columns]
        values = zip(*(column.values for column in self.columns), strict=True)
        return [dict(zip(headings, row, strict=True)) for row in values]

    def to_pandas(self) -> "pandas.DataFrame":
        """The table as a frame, columns by their headings."""
        from pandas import DataFrame

        return DataFrame({column.heading: column.values for column in self.columns})

    def to_xarray(self) -> "xarray.Dataset":
        """The table as arrays over its axes, with units; names are those of the columns."""
        import xarray

        return xarray.Dataset(*self.over_axes(), {"title": self.name})

    def over_axes(self) -> tuple[Arrays, Arrays]:
        """Outputs and keys as arrays over the axes."""
        shape, dimensions = [len(axis.rows) for axis in self.axes], tuple(axis.name for axis in self.axes)
        varied = {column.name: column for column in self.columns if column.varied}
        outputs = {
            column.name: (dimensions, _array(column).reshape(shape), _attributes(column))
            for column in self.columns
            if not column.varied
        } | {
            column.name: (
                (*dimensions, ROLLER),
                np.array(column.values, dtype=float).reshape([*shape, -1]),
                _attributes(column),
            )
            for column in self.arrays
        }
        keys = {
            key: ((axis.name,), _along(varied[key], number, shape), _attributes(varied[key]))
            for number, axis in enumerate(self.axes)
            for key in axis.keys
        } | {axis.name: _numbers(axis) for axis in self.axes if axis.name not in axis.keys}
        return outputs, keys

    def plot(self, *outputs: str) -> "Page":
        """Draw outputs over the first key, a line for each value of the others; the first ones by default."""
        return drawn_over_first_key(self, outputs)

    @property
    def failed(self) -> int:
        """Rows without a result."""
        return sum(status not in ANSWERED for status in self["status"].values)


@dataclass(frozen=True)
class Mark:
    """A printed or measured number."""

    y: str  # column of its panel
    low: float  # in the unit of the panel
    high: float  # the same as `low` but for a range
    x: Any  # in the unit of the axis; None where it is not known
    label: str


LABELLED = 16  # lines at most that the legend names
STYLES = ("solid", "circle"), ("dash", "square"), ("dot", "diamond")  # one after the other, with all colours
LONGEST = 100  # characters of a label: longer ones leave no place for the axes
MARKS = (DARK, "diamond"), (GREY, "x")  # of numbers from elsewhere, one after the other
EVEN = 1e-6  # by how much ratios of a logarithmic range differ
MOST = 6  # outputs that are drawn without being named


@dataclass(frozen=True)
class Plot:
    """Names of the columns that are drawn."""

    x: str
    lines: str | None  # key with a line for each of its values, beside those of other axes
    y: tuple[str, ...]
    rigid: tuple[str | None, ...]  # the same between rigid raceways
    marks: tuple[Mark, ...] = ()


def drawn_over_first_key(table: Table, outputs: Sequence[str]) -> "Page":
    """Draw outputs over the first key that varies, without names the first ones.

    Raises `BadCase` where no key varies.
    """
    varied = [column.name for column in table.columns if column.varied and len({*column.values}) > 1]
    named = [table[output].name for output in outputs] or [
        column.name for column in table.columns if not column.varied and column.name not in ENDS
    ][:MOST]
    if not varied:
        raise BadCase(f"{table.name}: no key varies, so there is nothing to draw outputs over.")
    return draw(table, Plot(varied[0], None, tuple(named), (None,) * len(named)))


def draw(table: Table, plot: Plot) -> "Page":
    """Draw outputs of a table, each in a panel over the same x."""
    figures = [_figure(table, plot, y, rigid) for y, rigid in zip(plot.y, plot.rigid, strict=True)]
    return picture(table.name, "", figures, size=(7.0, 2.6))


def _figure(table: Table, plot: Plot, y: str, rigid: str | None) -> Figure:
    """An output over x, with numbers from elsewhere."""
    x = table[plot.x]
    lines = [line for number, each in enumerate(_lines(table, plot, y, rigid)) for line in each.drawn(number)]
    linear = table[y] in table.arrays  # as loads are, which are next to nothing outside their zone
    values = np.array([value for line in lines for value in line.y], dtype=float)
    geometric = all(_is_geometric(line.x) for line in lines)
    texts = any(isinstance(value, str) for line in lines for value in line.x)
    step = 60.0 if x in table.arrays and x.unit == "deg" else None
    along = DrawnAxis(x.heading, "log" if geometric else "category" if texts else "linear", step=step)
    label = excerpt(table[y].heading.replace("_", " "), LONGEST)
    up = DrawnAxis(label, "log" if is_wide(values) and not linear else "linear")
    if rigid is not None:
        lines.append(DrawnLine([], [], "rigid raceways", DARK, "dash", ""))
    marks = (mark for mark in plot.marks if mark.y == y)
    return Figure(y, "", along, up, (*lines, *map(_mark, marks, count())))


def _mark(mark: Mark, number: int) -> DrawnLine | Rule:
    """A number from elsewhere: a point, a level across the panel where x is not known, or a range."""
    label, (grey, form) = excerpt(mark.label, LONGEST), MARKS[number % len(MARKS)]
    if mark.x is not None:
        return DrawnLine([mark.x] * 2, [mark.low, mark.high], label, grey, "solid", form, 8.0)
    if mark.low < mark.high:
        return Rule(mark.low, to=mark.high, level=True, name=label, colour=grey)
    return Rule(mark.low, level=True, name=label, colour=grey, dash="dot", width=1.6)


def _is_geometric(values: Sequence[Any]) -> bool:
    """Whether values are those of a logarithmic range."""
    if len(values) < 3 or isinstance(values[0], str) or min(values) <= 0:
        return False
    ratios = np.divide(values[1:], values[:-1])
    return bool(ratios[0] > 1 and np.ptp(ratios) < EVEN * ratios[0])


@dataclass(frozen=True)
class _Points:
    """Points that belong together, in the order of x."""

    label: str
    x: Sequence[Any]  # numbers or texts
    y: Sequence[float]  # NaN where there is none
    rigid: Sequence[float] | None = None  # the same between rigid raceways, drawn dashed
    joined: bool = True  # else points alone

    def drawn(self, number: int) -> Iterator[DrawnLine]:
        """The same as lines of a figure, the first ones with their names."""
        colour, style = COLOURS[number % len(COLOURS)], number // len(COLOURS) % len(STYLES)
        dash, mark = STYLES[style] if self.joined else ("", "circle")
        name = excerpt(self.label, LONGEST) or ("flexible" if self.rigid is not None else "")
        yield DrawnLine(self.x, self.y, name if number < LABELLED else "", colour, dash, mark, 3.5)
        if self.rigid is not None:
            dash, mark = ("dash", "") if self.joined else ("", "x")
            yield DrawnLine(self.x, self.rigid, "", colour, dash, mark, 4.0)


def _lines(table: Table, plot: Plot, y: str, rigid: str | None) -> Iterator[_Points]:
    if table[plot.x] in table.arrays:
        yield from _rows_of_rollers(table, plot, y, rigid)
        return
    keys = [table[key] for key in _grouping(table, plot)]
    x, varied = table[plot.x], table[plot.x].varied
    rows = sorted(range(len(table)), key=lambda row: (_place(keys, row), x.values[row]))
    for place, group in groupby(rows, key=lambda row: _place(keys, row)):
        places = list(group)
        yield _Points(
            label=_label(keys, place),
            x=[x.values[row] for row in places],
            y=[table[y].values[row] for row in places],
            rigid=None if rigid is None else [table[rigid].values[row] for row in places],
            joined=varied,
        )


def _rows_of_rollers(table: Table, plot: Plot, y: str, rigid: str | None) -> Iterator[_Points]:
    """A line for every row over the rollers, angles from -180 to 180 deg."""
    keys = [column for column in table.columns if column.varied]
    for row, places in enumerate(table[plot.x].values):
        if table[plot.x].unit == "deg":
            places = [(place + 180) % 360 - 180 for place in places]
        order = sorted(range(len(places)), key=places.__getitem__)
        values, of_rigid = table[y].values[row], None if rigid is None else table[rigid].values[row]
        yield _Points(
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


def _array(column: Column) -> np.ndarray:
    values = np.asarray(column.values)
    return values.astype(np.int8) if values.dtype == bool else values  # netCDF4 has no other flags


def _along(column: Column, number: int, shape: list[int]) -> np.ndarray:
    """Values of a key along its axis."""
    values = np.moveaxis(_array(column).reshape(shape), number, 0)
    return values.reshape(shape[number], -1)[:, 0]


def _attributes(column: Column) -> dict[str, Any]:
    return {"units": column.unit} if column.unit else {}


def _numbers(axis: Axis) -> tuple[tuple[str, ...], np.ndarray, dict[str, Any]]:
    """Rows of an axis of several keys, counted from 1 as messages do."""
    return (axis.name,), np.arange(1, len(axis.rows) + 1), {}
