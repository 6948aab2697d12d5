"""Stiffness: what holds each ring, and the matrix over five directions."""

import numpy as np

from flexbearing.report.html.document import Cell, Number, Table
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import NOTHING, with_unit

_ZERO = 1e-10  # of the diagonal: what rounding leaves of nothing
_FORCES = ("force along x", "force along y", "force along z", "moment about y", "moment about z")
_BY = ("along x", "along y", "along z", "about y", "about z")
_UNITS = (("N/m", "kN/mm"), ("N/rad", "kN/rad"), ("N m/m", "kN m/m"), ("N m/rad", "kN m/rad"))
_SUPPORT = "support_stiffness_N_per_m"


def supported(reader: Reader) -> bool:
    """Whether a ring is on a support that gives way."""
    block = reader.blocks[reader.last]
    if "stiffness" not in block and "total_stiffness" in block:  # no springs in series
        return True
    structure = reader.attributes.get("structure") or {}
    return len(reader.blocks) > 1 and any(figures.get(_SUPPORT) is not None for figures in structure.values())


def supports(reader: Reader) -> Table | None:
    """Stiffness of what holds each ring, alone, with its error and the size of its mesh."""
    rows: list[tuple[Cell, ...]] = []
    for part, figures in (reader.attributes.get("structure") or {}).items():
        path = f"structure/{part}"
        cells = [
            NOTHING if figures.get(name) is None else
            reader.of_attribute(f"{path}/{name}", "N/m", "kN/mm", ",.4g")
            for name in (_SUPPORT, "support_stiffness_error_N_per_m")
        ]  # fmt: skip
        rows.append((part, *cells, reader.of_attribute(f"{path}/unknowns", "", "", ",d")))
    unit = reader.units.of("kN/mm")
    head = ("ring", with_unit("support alone", unit), with_unit("its error", unit), "unknowns")
    return Table(head, tuple(rows)) if rows else None


def matrix(reader: Reader) -> Table | None:
    """The matrix of the last end state, with a unit for each of its four parts."""
    if "stiffness_matrix" not in reader.blocks.get(reader.last, {}):
        return None
    rows: list[tuple[Cell, ...]] = [
        (force, *(entry(reader, row, column) for column in range(5))) for row, force in enumerate(_FORCES)
    ]
    return Table(("load", *_BY), tuple(rows))


def units(reader: Reader) -> list[str]:
    """Units of the four parts of the matrix: forces, then moments, by displacements and by rotations."""
    return [reader.units.of(people) for _, people in _UNITS]


def entry(reader: Reader, row: int, column: int) -> Number:
    """An entry of the matrix of the last end state; what rounding leaves of nothing is printed as zero."""
    matrix = reader.blocks[reader.last]["stiffness_matrix"]
    stored, people = _UNITS[2 * (row > 2) + (column > 2)]
    value, scale = float(matrix[row, column]), np.sqrt(abs(matrix[row, row] * matrix[column, column]))
    digits = ".0f" if abs(value) <= _ZERO * scale else ".4g"
    place = f"{reader.last}/stiffness_matrix/{row}/{column}"
    return reader.units.number(value, stored, people, digits, place)
