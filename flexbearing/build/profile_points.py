"""Points of a profile, read from a CSV file."""

import re
from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from flexbearing import inputs
from flexbearing.inputs.file import POINTS
from flexbearing.printable import excerpt
from flexbearing.units import BadUnit, UnknownUnit, unit
from quasidynamic import ImpossiblePart

COLUMNS = ("position", "drop")
HEADING = re.compile(r"\s*(position|drop)\s*\[([^\[\]]+)\]\s*")
_HEADER = 'a header holds "position [mm]" and "drop [um]", each with a unit of length'


def points(file: Path) -> tuple[NDArray, NDArray]:
    """Positions and drops (n) [m] of a file with two columns, a table as `inputs.cells` reads it.

    Raises `ImpossiblePart` where it cannot be read, or is no such table.
    """
    try:
        return _read(inputs.stamp(file))
    except (ImpossiblePart, inputs.Unreadable, inputs.BadNumber) as problem:
        raise ImpossiblePart(f'"{excerpt(file.name)}": {problem}') from problem


@lru_cache(maxsize=64)  # variants of a case have it in common
def _read(stamp: inputs.Stamp) -> tuple[NDArray, NDArray]:
    lines = inputs.cells(inputs.text(stamp.path, POINTS), POINTS)
    header, rows = next(lines, []), [*lines]
    scales = dict(map(_heading, header))
    if len(header) != len(COLUMNS) or set(scales) != set(COLUMNS):
        raise ImpossiblePart(f"has {len(header)} columns: {_HEADER}")
    if short := next((row for row in rows if len(row) != len(COLUMNS)), None):
        raise ImpossiblePart(f"has a row of {len(short)} numbers, not {len(COLUMNS)}")
    table = np.array([[inputs.number(cell) for cell in row] for row in rows]).reshape(-1, len(COLUMNS))
    of = dict(zip((_heading(cell)[0] for cell in header), table.T, strict=True))
    return of["position"] * scales["position"], of["drop"] * scales["drop"]


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
