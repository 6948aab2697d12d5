"""Rows as the text of a CSV file, the one form in which the program writes them."""

import csv
from collections.abc import Iterable
from functools import lru_cache
from io import StringIO
from math import isnan
from typing import Any

from flexbearing.printable import printable

_FORMULA = ("=", "+", "-", "@", "\t", "\r")  # what a spreadsheet takes for the beginning of a formula


def as_csv(rows: Iterable[Iterable[Any]]) -> str:
    r"""Rows with a comma between cells; nothing stands where a cell is None or not a number.

    A text that a spreadsheet would compute stands behind an apostrophe, as OWASP (CSV injection) recommends.

    >>> as_csv([["load [N]", "note"], [1.5, "=1+1"], [float("nan"), "a\x1b[0m"]])
    "load [N],note\n1.5,'=1+1\n,a\\x1b[0m\n"
    """
    file = StringIO(newline="")
    csv.writer(file, lineterminator="\n").writerows(map(as_cell, row) for row in rows)
    return file.getvalue()


def as_cell(value: Any) -> Any:
    """A value as a cell contains it."""
    if isinstance(value, float):
        return "" if isnan(value) else value
    return _text(value) if isinstance(value, str) else value


@lru_cache(maxsize=1024)  # the same few texts in the rows of a study
def _text(text: str) -> str:
    return f"'{printable(text)}" if text.startswith(_FORMULA) else printable(text)
