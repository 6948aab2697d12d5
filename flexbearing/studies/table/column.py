"""The columns of a table."""

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


def ends(rows: Sequence[Row]) -> tuple[Column, ...]:
    """Columns that say how each variant ended, and why some were not solved beside others."""
    own_runs = tuple(row.own_run for row in rows)
    return (
        *((Column("own_run", "", own_runs),) if any(own_runs) else ()),
        Column("status", "", tuple(row.status for row in rows)),
        Column("message", "", tuple(row.message for row in rows)),
        Column("seconds", "", tuple(row.seconds for row in rows)),
    )
