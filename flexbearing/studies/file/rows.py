"""Variants written as a table: a CSV file whose header holds keys of the case, with units in brackets."""

import re
from collections.abc import Callable
from itertools import islice
from pathlib import Path
from typing import Any

from flexbearing import inputs
from flexbearing.case.text import Unreadable, setting_value
from flexbearing.inputs.file import VARIANTS
from flexbearing.printable import excerpt
from flexbearing.studies.file.values import MOST, BadValues

MOST_CELLS = 5_000_000  # each takes some 100 bytes of memory
HEADING = re.compile(r"\s*(?P<name>[^\[\]]*?)\s*(?:\[(?P<unit>[^\[\]]*)\])?\s*")
_HEADER = 'a header holds keys with units, such as "operation.radial_load [kN],operation.inner_speed [rpm]"'


def rows(file: Path, has_unit: Callable[[str], bool]) -> tuple[tuple[str, ...], tuple[tuple[Any, ...], ...]]:
    """Keys and rows of a table of variants; beside semicolons and tabs numbers may have decimal commas.

    Raises `BadValues` naming file, row and column.
    """
    try:
        return _rows(inputs.text(file, VARIANTS), has_unit)
    except (BadValues, Unreadable) as problem:
        raise BadValues(f'file = "{excerpt(file.name)}": {problem}') from None


def _rows(text: str, has_unit: Callable[[str], bool]) -> tuple[tuple[str, ...], tuple[tuple[Any, ...], ...]]:
    filled = inputs.cells(text, MOST_CELLS)
    columns = _columns(next(filled, []), has_unit)
    table = tuple(_row(line, number, columns) for number, line in enumerate(islice(filled, MOST), 1))
    if next(filled, None) is not None:
        raise BadValues(f"has more than {MOST} rows below its header, which is the most a study has")
    if not table:
        raise BadValues(f"has no rows below its header; a study has 1 to {MOST} variants")
    return tuple(key for key, _ in columns), table


def _columns(header: list[str], has_unit: Callable[[str], bool]) -> list[tuple[str, str]]:
    """Key and unit of each column."""
    if not header:
        raise BadValues(f"is empty; {_HEADER}")
    columns = [_heading(cell) for cell in header]
    inputs.require_different([key for key, _ in columns])
    for place, (key, unit) in enumerate(columns, 1):
        if not has_unit(key) and unit:
            raise BadValues(f"column {place}: {key} has no unit, found [{excerpt(unit)}]")
    return columns


def _heading(cell: str) -> tuple[str, str]:
    parts = HEADING.fullmatch(cell)
    if parts is None or not parts["name"]:
        raise BadValues(f"has {excerpt(cell)!r} in its header; {_HEADER}")
    return parts["name"], (parts["unit"] or "").strip()


def _row(line: list[str], number: int, columns: list[tuple[str, str]]) -> tuple[Any, ...]:
    if len(line) != len(columns):
        raise BadValues(f"row {number} has {len(line)} cells, the header has {len(columns)}")
    return tuple(_cell(cell, key, unit, number) for cell, (key, unit) in zip(line, columns, strict=True))


def _cell(cell: str, key: str, unit: str, number: int) -> Any:
    if not cell:
        return None  # as the case has it
    if unit:
        return f"{cell} {unit}"
    try:
        return setting_value(cell)
    except Unreadable as problem:
        raise BadValues(f"row {number}, {key}: {problem}") from None
