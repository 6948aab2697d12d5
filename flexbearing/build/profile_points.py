"""Points of a profile, read from a CSV file."""

import csv
import re
import stat
from functools import lru_cache
from io import StringIO
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.excerpt import excerpt
from flexbearing.units import BadUnit, UnknownUnit, unit
from quasidynamic import ImpossiblePart

LARGEST = 2**20  # bytes
COLUMNS = ("position", "drop")
HEADING = re.compile(r"\s*(position|drop)\s*\[([^\[\]]+)\]\s*")
_HEADER = 'a header holds "position [mm]" and "drop [um]", each with a unit of length'


def points(file: Path) -> tuple[NDArray, NDArray]:
    """Positions and drops (n) [m] of a file with two columns, parted by commas or semicolons.

    Raises
    ------
    ImpossiblePart
        where it cannot be read, or is no such table
    """
    try:
        about = file.stat()
        if not stat.S_ISREG(about.st_mode):  # devices and pipes may have no end
            raise ImpossiblePart("is no file of points")
        return _read(file, about.st_mtime_ns, about.st_size)
    except OSError as problem:
        raise ImpossiblePart(f'"{excerpt(file.name)}" cannot be read: {problem.strerror}') from problem
    except ImpossiblePart as problem:
        raise ImpossiblePart(f'"{excerpt(file.name)}" {problem}') from problem


@lru_cache(maxsize=64)  # variants of a case have it in common
def _read(file: Path, _changed: int, _size: int) -> tuple[NDArray, NDArray]:
    with file.open("rb") as opened:
        content = opened.read(LARGEST + 1)
    if len(content) > LARGEST:
        raise ImpossiblePart(f"is larger than {LARGEST >> 20} MiB")
    header, rows = _cells(content)
    scales = dict(map(_heading, header))
    if len(header) != len(COLUMNS) or set(scales) != set(COLUMNS):
        raise ImpossiblePart(f"has {len(header)} columns: {_HEADER}")
    try:
        table = np.array(rows, float).reshape(-1, len(COLUMNS))
    except ValueError as problem:
        raise ImpossiblePart(f"has rows that are not two numbers: {problem}") from None
    of = dict(zip((_heading(cell)[0] for cell in header), table.T, strict=True))
    return of["position"] * scales["position"], of["drop"] * scales["drop"]


def _cells(content: bytes) -> tuple[list[str], list[list[str]]]:
    """Header and rows."""
    try:
        text = content.decode("utf-8-sig")
        lines = csv.reader(StringIO(text), delimiter=";" if ";" in text else ",")
        header, *rows = (line for line in lines if any(map(str.strip, line)))
    except (ValueError, csv.Error):
        raise ImpossiblePart(f"is no table in UTF-8: {_HEADER}") from None
    return header, rows


def _heading(cell: str) -> tuple[str, float]:
    """Quantity of a column, and its unit in metres."""
    parts = HEADING.fullmatch(cell)
    try:
        given = None if parts is None else unit(parts[2].strip())
    except (BadUnit, UnknownUnit):
        given = None
    if parts is None or given is None or given.powers != unit("m").powers:
        raise ImpossiblePart(f"has a column {excerpt(cell)!r}: {_HEADER}")
    return parts[1], given.scale
