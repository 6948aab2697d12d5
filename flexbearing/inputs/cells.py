"""Cells of tables as spreadsheets write them: with commas, semicolons or tabs, and decimal commas."""

import csv
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from io import StringIO
from itertools import islice
from typing import Any

from flexbearing.inputs.file import Unreadable

_NAMED = re.compile(r"sep=([,;\t])\s*", re.IGNORECASE)
_DECIMAL = re.compile(r"^([+-]?[0-9]*),([0-9]+)(?![0-9.,])")  # of a number that has no point


def cells(text: str, most: int) -> Iterator[list[str]]:
    """Yield the lines that are not empty, see `numbered_cells`."""
    return (line for _, line in numbered_cells(text, most))


def numbered_cells(text: str, most: int) -> Iterator[tuple[int, list[str]]]:
    """Yield the lines that are not empty, each with its number in the file, from 1.

    Beside semicolons and tabs numbers may have decimal commas. A line that names the separator, as
    spreadsheets write it in front, is none of the table.

    Raises `Unreadable` for more cells than `most`, and a text that is no table.
    """
    first = text.lstrip("\r\n ").partition("\n")[0]
    named = _NAMED.fullmatch(first)
    delimiter = named[1] if named else next((each for each in "\t;" if each in first), ",")
    if text.count(delimiter) > most:  # before they fill the memory
        raise Unreadable(f"has more than {most} cells")
    try:
        lines = _filled(csv.reader(StringIO(text, newline=""), delimiter=delimiter, skipinitialspace=True))
        for number, line in islice(lines, 1 if named else 0, None):
            yield number, line if delimiter == "," else [_DECIMAL.sub(r"\1.\2", cell) for cell in line]
    except csv.Error as problem:
        raise Unreadable(f"is no table: {problem}") from None


def _filled(reader: Any) -> Iterator[tuple[int, list[str]]]:
    """Number of the first line of each row that is not empty, with its cells."""
    number = 1
    for row in reader:
        if any(map(str.strip, row)):
            yield number, [cell.strip() for cell in row]
        number = reader.line_num + 1  # a cell in quotes may go over several lines


LONGEST = 60  # characters of a heading in a message


def require_different(headings: Sequence[str]) -> None:
    """Refuse a heading that stands twice, before the cells below are looked at.

    Raises `Unreadable` naming the first one.
    """
    twice = next((name for name, count in Counter(headings).items() if count > 1), None)
    if twice is not None:
        raise Unreadable(f"has several columns {twice[:LONGEST]!r}; one of them is enough")
