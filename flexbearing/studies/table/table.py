"""The table of a study, a row for every variant."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from flexbearing.studies.file import Axis
from flexbearing.studies.plan.task import ANSWERED
from flexbearing.studies.table.column import Column

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.figure import Figure


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
