"""Cells of tables as spreadsheets write them: with commas, semicolons or tabs, and decimal commas."""

import csv
import re
from collections.abc import Iterator
from io import StringIO

from flexbearing.inputs.file import Unreadable

_NAMED = re.compile(r"sep=([,;\t])\s*", re.IGNORECASE)
_DECIMAL = re.compile(r"^([+-]?[0-9]*),([0-9]+)(?![0-9.,])")  # of a number that has no point


def cells(text: str, most: int) -> Iterator[list[str]]:
    """Yield the lines that are not empty; beside semicolons and tabs numbers may have decimal commas.

    Raises
    ------
    Unreadable
        for more cells than `most`, and a text that is no table
    """
    text, delimiter = _separated(text.lstrip("\r\n "))
    if text.count(delimiter) > most:  # before they fill the memory
        raise Unreadable(f"has more than {most} cells")
    try:
        for line in csv.reader(StringIO(text, newline=""), delimiter=delimiter, skipinitialspace=True):
            if any(map(str.strip, line)):
                each = (cell.strip() for cell in line)
                yield [*each] if delimiter == "," else [_DECIMAL.sub(r"\1.\2", cell) for cell in each]
    except csv.Error as problem:
        raise Unreadable(f"is no table: {problem}") from None


def _separated(text: str) -> tuple[str, str]:
    """The table without a line that names its separator, as spreadsheets write it, and this separator."""
    first, _, below = text.partition("\n")
    if named := _NAMED.fullmatch(first):
        return below, named[1]
    return text, next((each for each in "\t;" if each in first), ",")
