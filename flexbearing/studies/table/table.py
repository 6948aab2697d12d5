"""The table of a study, a row for every variant."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from flexbearing.studies.plan import Row


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


@dataclass(frozen=True)
class Table:
    """What a study found."""

    name: str
    columns: tuple[Column, ...]  # keys, outputs, then status, message and seconds

    def __getitem__(self, heading: str) -> Column:
        """Column by its name or heading; KeyError names those that there are."""
        for column in self.columns:
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

    @property
    def failed(self) -> int:
        """Rows without an answer."""
        return len(self) - list(self["status"].values).count("converged")


def ends(rows: Sequence[Row]) -> tuple[Column, ...]:
    """Columns that say how each variant ended."""
    return (
        Column("status", "", tuple(row.status for row in rows)),
        Column("message", "", tuple(row.message for row in rows)),
        Column("seconds", "", tuple(row.seconds for row in rows)),
    )
