"""The table of a study, a row for every variant."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from flexbearing.studies.file import Axis
from flexbearing.studies.plan import Row
from flexbearing.studies.plan.task import ANSWERED

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.figure import Figure


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
        Column("message", "", tuple(row.message for row in rows)),
        Column("seconds", "", tuple(row.seconds for row in rows)),
    )


@dataclass(frozen=True)
class Table:
    """What a study found."""

    name: str
    columns: tuple[Column, ...]  # keys, outputs, then status, message and seconds
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
        from flexbearing.studies.table.arrays import dataset

        return dataset(self.name, self.columns, self.axes, self.arrays)

    def plot(self, *outputs: str) -> "Figure":
        """Draw outputs over the first key, a line for each value of the others; the first ones by default."""
        from flexbearing.studies.table.plot import drawn_over_first_key

        return drawn_over_first_key(self, outputs)

    @property
    def failed(self) -> int:
        """Rows without a result."""
        return sum(status not in ANSWERED for status in self["status"].values)
