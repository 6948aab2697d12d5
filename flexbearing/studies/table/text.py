"""The table as CSV."""

import csv
from io import StringIO
from math import isnan
from typing import Any

from flexbearing.studies.table.table import Table


def csv_text(table: Table) -> str:
    """Write a table as CSV.

    Parameters
    ----------
    table : Table
        whatever it holds

    Returns
    -------
    str
        headings with units, then the rows; nothing stands where there is no number
    """
    file = StringIO(newline="")
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow(column.heading for column in table.columns)
    writer.writerows(zip(*(map(_cell, column.values) for column in table.columns), strict=True))
    return file.getvalue()


def _cell(value: Any) -> Any:
    return "" if isinstance(value, float) and isnan(value) else value
